// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/canny_arguments.hpp"

#include <string>

#include "cli/number_option.hpp"
#include "io/number_text.hpp"

namespace straightedge::cli {

void CannyArguments::add_to(CLI::App& command) {
  add_real(command, "--sigma", given.sigma, {0, max_gaussian_sigma}, "PX",
           "Gaussian blur before the gradient, 0 = none");
  add_choice<int>(command, "--aperture", given.aperture, {{"3", 3}, {"5", 5}, {"7", 7}},
                  "side of the Sobel operator, pixels");
  command.add_flag("--l2", l2, "Euclidean length of the gradient in place of |dx| + |dy|");
  const std::string unit = "GRADIENT";
  low = add_real(command, "--low", given.low, {0, 1e9}, unit,
                 "weak edges are above it, in gray levels of an unscaled Sobel");
  high = add_real(command, "--high", given.high, {0, 1e9}, unit, "strong edges are above it");
  command.add_flag("--auto-thresholds", automatic, "--low and --high from the noise in the image");
}

Result<CannyOptions> CannyArguments::options() const {
  CannyOptions options = given;
  if (l2) options.norm = GradientNorm::l2;
  if (automatic && (low->count() > 0 || high->count() > 0)) {
    return Failure{Problem::bad_option, "--auto-thresholds and --low or --high contradict each other"};
  }
  if (automatic) options.thresholds = CannyThresholds::automatic;
  if (!automatic && options.low > options.high) {
    return Failure{Problem::bad_option,
                   "--low " + io::to_text(options.low) + " is above --high " + io::to_text(options.high)};
  }
  return options;
}

std::string words_of(const CannyOptions& options) {
  std::string words = "sigma " + io::to_text(options.sigma) + ", aperture " + io::to_text(options.aperture) +
                      ", norm " + (options.norm == GradientNorm::l1 ? "L1" : "L2");
  if (options.thresholds == CannyThresholds::automatic) return words + ", automatic thresholds";
  return words + ", low " + io::to_text(options.low) + ", high " + io::to_text(options.high);
}

}  // namespace straightedge::cli
