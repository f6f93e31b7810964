// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/magnitude.hpp"

/// Options of Canny with their pieces of a row's name.
namespace same_bits {

struct NamedSigma {
  double sigma;
  const char* name;
};
inline constexpr NamedSigma sigmas[] = {
    {0, ".sigma0"}, {0.7, ".sigma0.7"}, {1.4, ".sigma1.4"}, {3.25, ".sigma3.25"}, {50, ".sigma50"}};

struct NamedAperture {
  int aperture;
  const char* name;
};
inline constexpr NamedAperture apertures[] = {{3, ".aperture3"}, {5, ".aperture5"}, {7, ".aperture7"}};

struct NamedNorm {
  straightedge::GradientNorm norm;
  const char* name;
};
inline constexpr NamedNorm norms[] = {{straightedge::GradientNorm::l1, ".l1"},
                                      {straightedge::GradientNorm::l2, ".l2"}};

}  // namespace same_bits
