// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/depth_file.hpp"

#include <climits>
#include <new>

#include "io/netpbm.hpp"
#include "io/png16.hpp"
#include "io/read_bytes.hpp"
#include "straightedge/host/atomic_file.hpp"

namespace straightedge {
namespace {

std::string to_text(Size size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

}  // namespace

Result<Image<std::uint16_t>> decode_depth_image(std::string_view bytes, const std::string& name) try {
  if (bytes.empty()) return Failure{Problem::bad_content, name + ": is empty"};
  if (io::is_png(bytes)) return io::decode_png16(bytes, name);
  if (io::is_netpbm(bytes)) return io::decode_netpbm16(bytes, name);
  return Failure{Problem::bad_content, name + ": is neither a 16-bit gray PNG nor a 16-bit PGM"};
} catch (const std::bad_alloc&) {
  return Failure{Problem::cannot_read, name + ": does not fit into memory"};
}

Result<Image<std::uint16_t>> read_depth_image(const std::filesystem::path& file) {
  const auto bytes = io::read_bytes(file, INT_MAX);
  if (!bytes) return bytes.failure();
  return decode_depth_image(*bytes, file.string());
}

Result<Image<std::uint16_t>> read_depth_frame(const std::filesystem::path& file, const DepthCamera& camera) {
  auto raw = read_depth_image(file);
  if (!raw) return raw;
  if (camera.size && *camera.size != raw->size()) {
    return Failure{Problem::bad_content, file.string() + ": has " + to_text(raw->size()) +
                                             " pixels, and the camera has " + to_text(*camera.size)};
  }
  if (camera.distortion.none()) return raw;
  return undistorted(*raw, camera);
}

Result<Done> write_png16(const std::filesystem::path& file, ImageView<const std::uint16_t> image) {
  const auto png = io::encode_png16(image);
  if (!png) return Failure{png.failure().problem, file.string() + ": " + png.failure().sentence};
  return write_file_atomically(file, *png);
}

}  // namespace straightedge
