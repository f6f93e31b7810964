// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include "straightedge/canny.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge::cli {

/// The options of the edge detector, for the commands that begin with it. The object must stay where it is
/// until the arguments are parsed.
struct CannyArguments {
  explicit CannyArguments(const CannyOptions& defaults) : given(defaults) {}

  void add_to(CLI::App& command);
  /// Fails with `bad_option` where two options contradict each other.
  Result<CannyOptions> options() const;

 private:
  CannyOptions given;
  bool l2 = false;
  bool automatic = false;
  CLI::Option* low = nullptr;
  CLI::Option* high = nullptr;
};

/// "sigma 1.4, aperture 3, norm L1, low 50, high 150".
std::string words_of(const CannyOptions& options);

}  // namespace straightedge::cli
