// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "cli/planes_run.hpp"

namespace straightedge::cli {

/// What was found, for people; several lines. `written`: names of the files, empty for none.
std::string words_of(const PlanesRun& run, const PlanesArguments& arguments, const std::string& written);

/// The numbers of the result as one JSON object.
std::string json_of(const PlanesRun& run, const PlanesArguments& arguments);

}  // namespace straightedge::cli
