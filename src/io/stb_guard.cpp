// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/stb_guard.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace straightedge::io {
namespace {

/// Reads past the end give zero, as stb's do.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : bytes_(bytes) {}
  std::size_t size() const { return bytes_.size(); }
  std::uint32_t at(std::size_t i) const {
    return i < bytes_.size() ? static_cast<unsigned char>(bytes_[i]) : 0u;
  }
  std::uint32_t big16(std::size_t i) const { return at(i) << 8 | at(i + 1); }
  std::uint32_t little16(std::size_t i) const { return at(i) | at(i + 1) << 8; }
  std::uint32_t little32(std::size_t i) const { return little16(i) | little16(i + 2) << 16; }

 private:
  std::string_view bytes_;
};

/// One segment holds several tables: a byte, 16 counts of codes, then as many values.
bool huffman_tables_fit(const Bytes& bytes, std::size_t begin, std::size_t end) {
  for (std::size_t at = begin; at < end;) {
    std::uint32_t codes = 0;
    for (std::size_t i = 1; i <= 16; ++i) codes += bytes.at(at + i);
    if (codes > 256) return false;
    at += 17 + codes;
  }
  return true;
}

/// Rows are padded to four bytes, the last one need not be.
bool bmp_is_whole(const Bytes& bytes, std::uint64_t width, std::uint64_t height) {
  const bool old = bytes.little32(14) == 12;
  const std::uint64_t bits = width * bytes.little16(old ? 24 : 28);
  return bytes.size() >= bytes.little32(10) + (bits + 31) / 32 * 4 * (height - 1) + (bits + 7) / 8;
}

/// Packed rows need at least one packet for every 128 pixels.
bool tga_is_whole(const Bytes& bytes, std::uint64_t width, std::uint64_t height) {
  const bool packed = (bytes.at(2) & 8) != 0;
  const std::uint64_t pixels = width * height;
  const std::uint64_t pixel_bytes = (bytes.at(16) + 7) / 8;
  const std::uint64_t map_bytes = std::uint64_t{bytes.little16(5)} * ((bytes.at(7) + 7) / 8);
  const std::uint64_t content = packed ? (pixels + 127) / 128 * (1 + pixel_bytes) : pixels * pixel_bytes;
  return bytes.size() >= 18 + bytes.at(0) + map_bytes + content;
}

}  // namespace

bool jpeg_tables_fit(std::string_view file) noexcept {
  const Bytes bytes(file);
  if (bytes.at(0) != 0xFF) return true;
  // Every marker that stb may come to is met: segments are skipped by their length, all else byte by byte.
  std::size_t at = 0;
  while (at < bytes.size()) {
    if (bytes.at(at++) != 0xFF) continue;
    while (bytes.at(at) == 0xFF) ++at;
    const std::uint32_t marker = bytes.at(at++);
    const bool stands_alone = marker <= 0x01 || (marker >= 0xD0 && marker <= 0xD9);
    if (stands_alone) continue;
    const std::size_t end = at + std::max(bytes.big16(at), 2u);
    if (marker == 0xC4 && !huffman_tables_fit(bytes, at + 2, end)) return false;
    at = end;
  }
  return true;
}

bool is_whole(std::string_view file, Size size) noexcept {
  const Bytes bytes(file);
  if (bytes.at(0) == 0x89 || bytes.at(0) == 0xFF) return true;
  const auto width = static_cast<std::uint64_t>(size.width);
  const auto height = static_cast<std::uint64_t>(size.height);
  return file.starts_with("BM") ? bmp_is_whole(bytes, width, height) : tga_is_whole(bytes, width, height);
}

}  // namespace straightedge::io
