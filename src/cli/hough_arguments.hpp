// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "straightedge/host/result.hpp"
#include "straightedge/hough_options.hpp"

namespace straightedge::cli {

/// All options of the Hough transform, as `hough` takes them. The object must stay where it is until the
/// arguments are parsed; `options.seed` is left alone.
struct HoughArguments {
  HoughOptions options;

  void add_to(CLI::App& command);
  /// `bad_option` for an option that the method does not look at, and where two options contradict each
  /// other.
  Result<Done> check() const;

 private:
  void add_randomized(CLI::App& command);
  void only_for(std::vector<HoughMethod> methods, CLI::Option* option);

  struct Restriction {
    CLI::Option* option = nullptr;
    std::vector<HoughMethod> methods;
  };
  std::vector<Restriction> restrictions;
};

std::string name_of(HoughMethod method);

/// The --method option.
CLI::Option* add_method(CLI::App& command, HoughMethod& method);

/// The options that the method looks at, in words, seed included.
std::string words_of(const HoughOptions& options);

}  // namespace straightedge::cli
