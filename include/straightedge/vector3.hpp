// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/square_root.hpp"

namespace straightedge {

/// A point or a direction in space.
struct Vector3 {
  double x = 0, y = 0, z = 0;

  constexpr bool operator==(const Vector3&) const noexcept = default;
};

constexpr Vector3 operator+(const Vector3& a, const Vector3& b) noexcept {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Vector3 operator-(const Vector3& a, const Vector3& b) noexcept {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Vector3 operator-(const Vector3& a) noexcept {
  return {-a.x, -a.y, -a.z};
}
constexpr Vector3 operator*(double s, const Vector3& a) noexcept {
  return {s * a.x, s * a.y, s * a.z};
}
constexpr double dot(const Vector3& a, const Vector3& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Vector3 cross(const Vector3& a, const Vector3& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr double squared_length(const Vector3& a) noexcept {
  return dot(a, a);
}
inline double length(const Vector3& a) noexcept {
  return square_root(dot(a, a));
}
/// Unit length; the null vector stays what it is.
inline Vector3 normalized(const Vector3& a) noexcept {
  const double l = length(a);
  return l > 0 ? (1 / l) * a : a;
}
/// Every coordinate is a number, and finite.
constexpr bool finite(const Vector3& a) noexcept {
  return a.x - a.x == 0 && a.y - a.y == 0 && a.z - a.z == 0;
}

}  // namespace straightedge
