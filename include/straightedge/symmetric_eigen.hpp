// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "straightedge/vector3.hpp"

namespace straightedge {

/// Eigenvalues, smallest first, and unit vectors for them, each orthogonal to the others. The sign of a
/// vector is such that its coordinate of largest size (of equals the first) is positive; the three need not
/// be right-handed.
struct SymmetricEigen {
  std::array<double, 3> values{};
  std::array<Vector3, 3> vectors{Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};
};

/// Eigenvalues and eigenvectors of a symmetric 3x3 matrix, given by its upper triangle row by row:
/// xx, xy, xz, yy, yz, zz.
///
/// 1. Scale by a power of two, so that the largest entry lies in [1, 2): no square overflows.
/// 2. Up to eight sweeps of three Jacobi rotations, each of which makes one entry off the diagonal zero. The
///    rotation is the smaller one of the two that do, so that vectors follow their axes. Entries
///    below 1e-20 of the scale are zero; nearly always four or five sweeps are enough.
/// 3. Sort by eigenvalue (equal ones stay in the order of their axes) and fix the signs.
///
/// C. G. J. Jacobi, "Über ein leichtes Verfahren die in der Theorie der Säcularstörungen vorkommenden
/// Gleichungen numerisch aufzulösen", Journal für die reine und angewandte Mathematik 30, 1846,
/// doi:10.1515/crll.1846.30.51. H. Rutishauser, "The Jacobi method for real symmetric matrices", Numerische
/// Mathematik 9, 1966, doi:10.1007/BF02165223.
///
/// Errors of the values are some 1e-16 of the largest one. Additions, products, quotients and square roots
/// in a fixed order: the same bits on every machine. Constant time and memory. An entry that is not
/// finite gives three NaN and the axes.
SymmetricEigen symmetric_eigen(const std::array<double, 6>& upper) noexcept;

}  // namespace straightedge
