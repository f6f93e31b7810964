// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/plane_leaves_file.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>

#include "io/read_bytes.hpp"
#include "map/plane_key.hpp"
#include "straightedge/host/atomic_file.hpp"

namespace straightedge {
namespace {

constexpr std::string_view magic = "SEleaves";
constexpr std::uint64_t version = 1;
constexpr std::size_t largest_file = std::size_t{1} << 36U;

constexpr std::array signed_sums = {&PlaneLeafSums::weight, &PlaneLeafSums::x,    &PlaneLeafSums::y,
                                    &PlaneLeafSums::z,      &PlaneLeafSums::xx,   &PlaneLeafSums::xy,
                                    &PlaneLeafSums::xz,     &PlaneLeafSums::yy,   &PlaneLeafSums::yz,
                                    &PlaneLeafSums::zz,     &PlaneLeafSums::nx,   &PlaneLeafSums::ny,
                                    &PlaneLeafSums::nz,     &PlaneLeafSums::tilt, &PlaneLeafSums::residual};

void put(std::string& bytes, std::uint64_t value) {
  for (; value >= 128; value >>= 7U) bytes.push_back(static_cast<char>((value & 127U) | 128U));
  bytes.push_back(static_cast<char>(value));
}

void put_signed(std::string& bytes, std::int64_t value) {
  const auto twice = static_cast<std::uint64_t>(value) << 1U;
  put(bytes, value < 0 ? ~twice : twice);
}

/// Takes numbers from the front; after a fault all are 0 and `good` is false.
struct Reader {
  std::string_view rest;
  bool good = true;

  std::uint64_t number() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64 && !rest.empty(); shift += 7) {
      const auto byte = static_cast<unsigned char>(rest.front());
      rest.remove_prefix(1);
      const std::uint64_t bits = byte & 127U;
      if (shift == 63 && bits > 1) break;
      value |= bits << shift;
      if (byte < 128 && (byte != 0 || shift == 0)) return value;
      if (byte < 128) break;  // a longer form of a shorter number
    }
    good = false;
    return 0;
  }
  std::uint64_t number(std::uint64_t most) {
    const std::uint64_t value = number();
    good = good && value <= most;
    return good ? value : 0;
  }
  std::int64_t signed_number() {
    const std::uint64_t value = number();
    const auto half = static_cast<std::int64_t>(value >> 1U);
    return (value & 1U) != 0 ? -half - 1 : half;
  }
};

/// Within what readings can add up to; sums that pass cannot overflow when a map is read out.
bool possible(const PlaneLeafSums& s) {
  if (s.readings == 0 || s.readings > plane_grid::most_readings) return false;
  const auto n = static_cast<std::int64_t>(s.readings);
  if (s.weight < n || s.weight > n * plane_grid::most_weight) return false;
  constexpr std::int64_t half = plane_grid::leaf_side / 2;
  const auto within = [&](std::int64_t sum, std::int64_t each) {
    return sum >= -s.weight * each && sum <= s.weight * each;
  };
  const auto square = [&](std::int64_t sum) { return sum >= 0 && within(sum, half * half); };
  constexpr std::int64_t unit = 1 << 14;
  if (!within(s.nx, unit) || !within(s.ny, unit) || !within(s.nz, unit)) return false;
  const std::int64_t largest = std::max({std::abs(s.nx), std::abs(s.ny), std::abs(s.nz)});
  return within(s.x, half) && within(s.y, half) && within(s.z, half) && square(s.xx) && square(s.yy) &&
         square(s.zz) && within(s.xy, half * half) && within(s.xz, half * half) &&
         within(s.yz, half * half) && largest >= s.weight * (unit / 4) && s.tilt >= 0 &&
         within(s.tilt, plane_grid::most_tilt) && s.residual >= 0 &&
         s.residual <= n * (std::int64_t{1} << 30U);
}

bool read_leaf(Reader& reader, PlaneLeaf& leaf) {
  constexpr std::uint64_t leaf_end = std::uint64_t{1} << (3U * plane_grid::axis_bits);
  const PlaneLeafKey last = leaf.key;
  const std::uint64_t step = reader.number(leaf_end);
  leaf.key.leaf += step;
  leaf.key.surface = static_cast<std::uint32_t>(reader.number(surface_bins - 1));
  PlaneLeafSums& s = leaf.sums;
  const bool first = s.readings == 0;
  s.readings = reader.number(plane_grid::most_readings);
  for (const auto sum : signed_sums) s.*sum = reader.signed_number();
  s.sightings = static_cast<std::uint32_t>(reader.number(std::numeric_limits<std::uint32_t>::max()));
  s.spacing = static_cast<std::uint16_t>(reader.number(plane_grid::no_spacing));
  return reader.good && leaf.key.leaf < leaf_end && (first || last < leaf.key) && possible(s);
}

}  // namespace

std::string plane_leaves_to_bytes(const PlaneLeaves& leaves) {
  std::string bytes(magic);
  put(bytes, version);
  put(bytes, static_cast<std::uint64_t>(plane_grid::quanta_per_m));
  put(bytes, plane_grid::leaf_bits);
  put(bytes, leaves.frames);
  put(bytes, leaves.size());
  std::uint64_t last = 0;
  for (const PlaneLeaf& leaf : leaves.sorted()) {
    put(bytes, leaf.key.leaf - last);
    last = leaf.key.leaf;
    put(bytes, leaf.key.surface);
    put(bytes, leaf.sums.readings);
    for (const auto sum : signed_sums) put_signed(bytes, leaf.sums.*sum);
    put(bytes, leaf.sums.sightings);
    put(bytes, leaf.sums.spacing);
  }
  return bytes;
}

Result<PlaneLeaves> plane_leaves_from_bytes(std::string_view bytes, const std::string& name) {
  const auto refuse = [&](const std::string& what) {
    return Failure{Problem::bad_content, name + ": " + what};
  };
  if (!bytes.starts_with(magic)) return refuse("this is no file of a plane map's leaves");
  Reader reader{bytes.substr(magic.size())};
  if (const std::uint64_t found = reader.number(); !reader.good || found == 0 || found > version)
    return refuse("leaves of version " + std::to_string(found) + "; this program reads version 1");
  const bool same_grid = reader.number() == static_cast<std::uint64_t>(plane_grid::quanta_per_m) &&
                         reader.number() == static_cast<std::uint64_t>(plane_grid::leaf_bits);
  if (!same_grid) return refuse("the leaves lie on another grid");
  PlaneLeaves leaves;
  leaves.frames = reader.number(std::uint64_t{1} << 62U);
  const std::uint64_t count = reader.number(std::numeric_limits<std::uint32_t>::max() - 1);
  PlaneLeaf leaf;
  for (std::uint64_t i = 0; i < count && reader.good; ++i) {
    if (!read_leaf(reader, leaf))
      return refuse("leaf " + std::to_string(i + 1) + " of " + std::to_string(count) +
                    " is cut off or wrong");
    leaves.at(leaves.place(leaf.key)) = leaf.sums;
    leaves.note_fullest(leaf.sums.readings);
  }
  if (!reader.good) return refuse("the file is cut off");
  if (!reader.rest.empty()) return refuse("there is more in the file than its leaves");
  return leaves;
}

Result<Done> write_plane_leaves(const std::filesystem::path& file, const PlaneLeaves& leaves) {
  return write_file_atomically(file, plane_leaves_to_bytes(leaves));
}

Result<PlaneLeaves> read_plane_leaves(const std::filesystem::path& file) {
  const auto bytes = io::read_bytes(file, largest_file);
  if (!bytes) return bytes.failure();
  return plane_leaves_from_bytes(*bytes, file.string());
}

}  // namespace straightedge
