// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "straightedge/depth_kernels.hpp"
#include "straightedge/depth_view.hpp"
#include "straightedge/image.hpp"
#include "straightedge/plane_fit.hpp"
#include "straightedge/status.hpp"

/// Planes in inverse depth.
///
/// With the ray r = ((u−cx)/fx, (v−cy)/fy, 1) of a pixel, a plane n·X = d seen from the origin is
///     1/z = (n·r)/d = a u + b v + c:
/// linear in the pixel, with noise that is the same at every range (see plane_gate.hpp). Least squares in 1/z
/// is therefore the most likely plane, where the orthogonal fit of the points is not.
namespace straightedge {

/// 1/z = a u + b v + c, 1/metre; u column, v row.
struct InverseDepthPlane {
  double a = 0, b = 0, c = 0;

  constexpr double at(double u, double v) const noexcept { return a * u + b * v + c; }
  constexpr bool operator==(const InverseDepthPlane&) const noexcept = default;
};

/// Sums over pixels, u and v relative to an origin that the caller keeps in mind.
struct InverseDepthMoments {
  double n = 0;
  double u = 0, v = 0;
  double uu = 0, uv = 0, vv = 0;
  double q = 0, uq = 0, vq = 0, qq = 0;  ///< q = 1/z

  constexpr void add(double pu, double pv, double pq) noexcept {
    n += 1;
    u += pu;
    v += pv;
    uu += pu * pu;
    uv += pu * pv;
    vv += pv * pv;
    q += pq;
    uq += pu * pq;
    vq += pv * pq;
    qq += pq * pq;
  }
  constexpr void add(const InverseDepthMoments& o) noexcept {
    n += o.n;
    u += o.u;
    v += o.v;
    uu += o.uu;
    uv += o.uv;
    vv += o.vv;
    q += o.q;
    uq += o.uq;
    vq += o.vq;
    qq += o.qq;
  }
  /// Takes out pixels that are in the sums.
  constexpr void subtract(const InverseDepthMoments& o) noexcept {
    n -= o.n;
    u -= o.u;
    v -= o.v;
    uu -= o.uu;
    uv -= o.uv;
    vv -= o.vv;
    q -= o.q;
    uq -= o.uq;
    vq -= o.vq;
    qq -= o.qq;
  }
  /// The same pixels counted from an origin that lies at (ou, ov) of the present one.
  constexpr InverseDepthMoments seen_from(double ou, double ov) const noexcept {
    InverseDepthMoments m = *this;
    m.u = u - n * ou;
    m.v = v - n * ov;
    m.uu = uu - 2 * ou * u + n * ou * ou;
    m.uv = uv - ou * v - ov * u + n * ou * ov;
    m.vv = vv - 2 * ov * v + n * ov * ov;
    m.uq = uq - ou * q;
    m.vq = vq - ov * q;
    return m;
  }
};

struct InverseDepthFit {
  InverseDepthPlane plane;
  /// Upper triangle, row by row, of the covariance of (a, b, c).
  std::array<double, 6> covariance{};
  double mean_u = 0, mean_v = 0;  ///< of the pixels
  double n = 0;
  double rms = 0;  ///< of the residuals, 1/metre
};

/// Least squares in 1/z.
///
/// 1. Means of u, v, q; second moments about them.
/// 2. Slopes (a, b) from the 2x2 normal equations, c from the means.
/// 3. Covariance sigma² A⁻¹ of (a, b, c), sigma being the noise of one pixel's 1/z. Real sensors' noise is
///    shared by neighbours: pass a sigma that is enlarged for it, or add a floor (plane_fit.hpp).
///
/// The moments' origin must be pixel (0, 0). invalid_option: fewer than three pixels, all on one line of
/// the picture, sums that are not numbers, or a sigma that is not above 0. `fit` is left alone then.
Status fit_inverse_depth(const InverseDepthMoments& moments, double sigma, InverseDepthFit& fit) noexcept;

/// The plane in the camera's frame, with its covariance by linear propagation. `centroid` of the result is
/// where the ray of the mean pixel meets the plane; `weight` n/sigma_z² there. invalid_option: a plane
/// through the optical centre or behind the camera, which no camera sees, or numbers that are not finite;
/// `plane` is left alone then.
Status to_plane_fit(const InverseDepthFit& fit, double sigma, const PinholeCamera& camera,
                    PlaneFit& plane) noexcept;

/// The other way: the coefficients of a plane with distance > 0. A plane through the optical centre gives
/// three zeros.
InverseDepthPlane to_inverse_depth(const Plane& plane, const PinholeCamera& camera) noexcept;

/// 1/z of every pixel, 0 where there is no reading: float(1/metres_per_unit) / raw, rounded once. Row by row;
/// `out` has the size of `depth.raw`, else size_mismatch. invalid_image: a view or camera that makes no
/// sense. invalid_option: metres_per_unit outside 1e-38 to 1e30, which a float cannot follow.
Status inverse_depth_image(const DepthView& depth, ImageView<float> out,
                           const DepthKernels& kernels = plain_depth_kernels) noexcept;

}  // namespace straightedge
