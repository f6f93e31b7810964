// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "straightedge/host/result.hpp"

namespace straightedge::cli {

/// A file that the user asked for.
struct Output {
  std::string option;     ///< that named it, such as "--svg"
  std::string path;       ///< "-" is standard output
  std::string extension;  ///< that its name must have, such as ".svg"; empty: any
  std::string bytes;      ///< what will be in it
  std::function<Result<Done>(const std::filesystem::path&)> write = {};  ///< in place of bytes
};

/// What can be said before any work is done: names and extensions, two outputs in one place, an output that
/// would replace an input (`bad_option`); folders that are missing or closed (`cannot_write`).
/// `json`: standard output is taken by the numbers.
Result<Done> check_outputs(std::span<const Output> outputs, const std::vector<std::filesystem::path>& inputs,
                           bool json);

/// Each file whole or not at all. When one cannot be written the sentence says which ones are there already.
Result<Done> write_outputs(std::span<const Output> outputs);

/// "a.xml, a.svg", for people; standard output by that name.
std::string names_of(std::span<const Output> outputs);

/// The file to open for an argument; "-" is standard input.
std::filesystem::path input_path(const std::string& argument);

/// The letters A to Z made small, whatever the locale.
std::string lower_case(std::string text);

/// What files say about their input: no folders.
std::string base_name(const std::filesystem::path& input);

}  // namespace straightedge::cli
