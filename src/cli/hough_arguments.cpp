// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/hough_arguments.hpp"

#include <algorithm>
#include <utility>

#include "cli/number_option.hpp"
#include "io/number_text.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge::cli {
namespace {

constexpr std::uint64_t max_votes = 2147483647;

using enum HoughMethod;

}  // namespace

std::string name_of(HoughMethod method) {
  if (method == standard) return "standard";
  return method == progressive ? "progressive" : "randomized";
}

CLI::Option* add_method(CLI::App& command, HoughMethod& method) {
  return add_choice<HoughMethod>(
      command, "--method", method,
      {{"standard", standard}, {"progressive", progressive}, {"randomized", randomized}},
      "every pixel votes; random pixels vote until a line stands out; random pairs vote");
}

void HoughArguments::only_for(std::vector<HoughMethod> methods, CLI::Option* option) {
  restrictions.push_back({option, std::move(methods)});
}

void HoughArguments::add_to(CLI::App& command) {
  HoughOptions& o = options;
  add_method(command, o.method);
  add_real(command, "--rho", o.rho_step, {1e-3, 1e5}, "PX", "width of a cell of the accumulator");
  add_real(command, "--theta", o.theta_step, {1e-5, pi}, "RADIANS", "angle of a cell of the accumulator");
  only_for({standard, progressive},
           add_whole(command, "--threshold", o.threshold, {1, max_votes}, "VOTES",
                     "what makes a line: standard more than it, progressive at least it"));
  only_for({progressive, randomized},
           add_real(command, "--min-length", o.min_length, {0, 1e9}, "PX", "shorter segments are dropped"));
  only_for({progressive, randomized},
           add_real(command, "--max-gap", o.max_gap, {0, 1e9}, "PX", "longer holes end a segment"));
  only_for({standard}, add_real(command, "--min-theta", o.min_theta, {0, pi}, "RADIANS",
                                "standard: smallest angle looked at"));
  only_for({standard}, add_real(command, "--max-theta", o.max_theta, {0, pi}, "RADIANS",
                                "standard: where the angles end"));
  only_for({progressive}, add_choice<HoughGenerator>(
                              command, "--generator", o.generator,
                              {{"pcg32", HoughGenerator::pcg32}, {"opencv", HoughGenerator::opencv}},
                              "progressive: our own chance, by --seed, or the numbers and habits of OpenCV"));
  add_randomized(command);
}

void HoughArguments::add_randomized(CLI::App& command) {
  HoughOptions& o = options;
  const std::vector<CLI::Option*> added = {
      add_real(command, "--half-width", o.half_width, {0.5, 100}, "PX",
               "randomized: of the strip in which a line's pixels are read"),
      add_real(command, "--min-support", o.min_support, {0, 1}, "SHARE",
               "randomized: of a segment's steps that edge pixels carry"),
      add_real(command, "--pair-radius", o.pair_radius, {0, 1e5}, "PX",
               "randomized: distance of a pair, at most; 0 = any"),
      add_real(command, "--pair-min-distance", o.pair_min_distance, {1, 1e5}, "PX",
               "randomized: distance of a pair, at least; below --pair-radius"),
      add_whole(command, "--pair-threshold", o.pair_threshold, {1, max_votes}, "VOTES",
                "randomized: votes of pairs that make a line"),
      add_real(command, "--confidence", o.confidence, {0, 1, false}, "PROBABILITY",
               "randomized: that a line of --min-length is not left behind"),
      add_whole(command, "--max-draws", o.max_draws, {1, UINT64_MAX}, "PAIRS",
                "randomized: drawing ends here at the latest")};
  for (CLI::Option* const option : added) only_for({randomized}, option);
}

Result<Done> HoughArguments::check() const {
  for (const auto& [option, methods] : restrictions) {
    const bool looked_at = std::find(methods.begin(), methods.end(), options.method) != methods.end();
    if (looked_at || option->count() == 0) continue;
    return Failure{Problem::bad_option,
                   option->get_name() + " is not for --method " + name_of(options.method)};
  }
  if (options.min_theta >= options.max_theta) {
    return Failure{Problem::bad_option, "--min-theta " + io::to_text(options.min_theta) +
                                            " is not below --max-theta " + io::to_text(options.max_theta)};
  }
  if (options.pair_radius != 0 && options.pair_min_distance >= options.pair_radius) {
    return Failure{Problem::bad_option, "--pair-min-distance " + io::to_text(options.pair_min_distance) +
                                            " is not below --pair-radius " +
                                            io::to_text(options.pair_radius)};
  }
  return Done{};
}

std::string words_of(const HoughOptions& o) {
  const auto number = [](const char* name, auto value) {
    return std::string(", ") + name + " " + io::to_text(value);
  };
  std::string words = "method " + name_of(o.method) + ", seed " + io::to_text(o.seed) +
                      number("rho", o.rho_step) + number("theta", o.theta_step);
  if (o.method == standard) {
    return words + number("threshold", o.threshold) + number("min-theta", o.min_theta) +
           number("max-theta", o.max_theta);
  }
  words += number("min-length", o.min_length) + number("max-gap", o.max_gap);
  if (o.method == progressive) {
    return words + number("threshold", o.threshold) + ", generator " +
           (o.generator == HoughGenerator::pcg32 ? "pcg32" : "opencv");
  }
  return words + number("half-width", o.half_width) + number("min-support", o.min_support) +
         number("pair-radius", o.pair_radius) + number("pair-min-distance", o.pair_min_distance) +
         number("pair-threshold", o.pair_threshold) + number("confidence", o.confidence) +
         number("max-draws", o.max_draws);
}

}  // namespace straightedge::cli
