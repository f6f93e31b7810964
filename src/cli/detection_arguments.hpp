// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/canny_arguments.hpp"
#include "cli/command.hpp"
#include "straightedge/host/line_map_builder.hpp"

namespace straightedge::cli {

/// What decides which lines are found, for the commands that go the whole way from a picture to a map. The
/// object must stay where it is until the arguments are parsed.
struct DetectionArguments {
  void add_to(CLI::App& command);
  /// All but --method, for a command whose own has more words; it calls set_method.
  void add_without_method(CLI::App& command);
  /// Fails with `bad_option` where options contradict each other or the method.
  Result<LineMapOptions> options(std::uint64_t seed) const;

  PictureKind picture() const { return given.picture; }
  /// --method is a Hough transform.
  bool votes() const { return method.has_value(); }
  void set_method(HoughMethod asked) { method = asked; }

 private:
  void add_picture(CLI::App& command);
  void add_the_rest(CLI::App& command);

  LineMapOptions given;               // all but what the next three know
  std::optional<HoughMethod> method;  // none: edges are followed
  HoughOptions hough = line_map_hough;
  CannyArguments canny{LineMapOptions{}.canny};
  std::vector<CLI::Option*> for_votes;
};

/// The name of the method that --method takes.
std::string method_of(const LineMapOptions& options);

/// The options that have an effect in words, of votes the seed included.
std::string words_of(const LineMapOptions& options);

}  // namespace straightedge::cli
