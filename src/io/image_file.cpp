// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/image_file.hpp"

#include <climits>
#include <new>

#include "io/netpbm.hpp"
#include "io/read_bytes.hpp"
#include "io/stb_decode.hpp"
#include "straightedge/host/atomic_file.hpp"

namespace straightedge {
namespace {

template <class Pixel>
Result<Done> write_encoded(const std::filesystem::path& file, ImageView<const Pixel> image) {
  const auto png = encode_png(image);
  if (!png) return Failure{png.failure().problem, file.string() + ": " + png.failure().sentence};
  return write_file_atomically(file, *png);
}

}  // namespace

Result<Image<std::uint8_t>> decode_gray_image(std::string_view bytes, const std::string& name) try {
  if (bytes.empty()) return Failure{Problem::bad_content, name + ": is empty"};
  return io::is_netpbm(bytes) ? io::decode_netpbm(bytes, name) : io::decode_by_stb(bytes, name);
} catch (const std::bad_alloc&) {
  return Failure{Problem::cannot_read, name + ": does not fit into memory"};
}

Result<Image<std::uint8_t>> read_gray_image(const std::filesystem::path& file) {
  const auto bytes = io::read_bytes(file, INT_MAX);
  if (!bytes) return bytes.failure();
  return decode_gray_image(*bytes, file.string());
}

Result<Done> write_png(const std::filesystem::path& file, GrayView image) {
  return write_encoded(file, image);
}

Result<Done> write_png(const std::filesystem::path& file, ImageView<const Rgb> image) {
  return write_encoded(file, image);
}

}  // namespace straightedge
