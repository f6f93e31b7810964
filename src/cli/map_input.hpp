// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>

#include "straightedge/host/line_map.hpp"
#include "straightedge/host/plane_map.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge::cli {

using AnyMap = std::variant<LineMap, PlaneMap>;

/// The map in a file, of whichever kind; read once, so that it may be a pipe.
Result<AnyMap> read_any_map(const std::filesystem::path& file);

/// "2 lines, 3 segments" or "5 planes, 9 polygons".
std::string words_of(const AnyMap& map);

/// Puts the same counts into --json's object.
void add_counts(nlohmann::ordered_json& numbers, const AnyMap& map);

}  // namespace straightedge::cli
