// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "straightedge/host/plane_leaves.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge {

/// The leaves of a plane map as a file, so that maps can be continued and merged exactly.
///
/// All numbers are variable-length integers: seven bits a byte, the lowest first, the upper bit set on all
/// but the last; signed ones as 2 n or −2 n − 1. The same leaves give the same bytes.
///  1. "SEleaves", then the version (1), quanta a metre, bits of a leaf's side: another grid is refused.
///  2. Frames, number of leaves.
///  3. The leaves by ascending key, each: difference of its Morton code from the last one's, surface,
///     readings, weight, x, y, z, xx, xy, xz, yy, yz, zz, nx, ny, nz, tilt, residual, sightings, spacing.
/// About 60 bytes a leaf.
std::string plane_leaves_to_bytes(const PlaneLeaves& leaves);

/// bad_content: another format, a higher version, another grid, truncated or superfluous bytes, keys that do
/// not ascend, sums that no readings can have. Memory is taken as leaves are read, not as they are promised.
/// `name` stands for the file in the sentence.
Result<PlaneLeaves> plane_leaves_from_bytes(std::string_view bytes, const std::string& name);

Result<Done> write_plane_leaves(const std::filesystem::path& file, const PlaneLeaves& leaves);
Result<PlaneLeaves> read_plane_leaves(const std::filesystem::path& file);

}  // namespace straightedge
