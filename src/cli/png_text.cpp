// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/png_text.hpp"

#include <cstddef>
#include <cstdint>

namespace straightedge::cli {
namespace {

// Signature, then the chunk IHDR: length, kind, 13 bytes, check sum.
constexpr std::size_t header_end = 8 + 4 + 4 + 13 + 4;

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 255);
  return bytes;
}

/// CRC-32 of PNG (ISO 3309), bit by bit: the text is short.
std::uint32_t check_sum(const std::string& bytes) {
  std::uint32_t crc = 0xFFFFFFFFu;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (0xEDB88320u & (0u - (crc & 1u)));
  }
  return ~crc;
}

}  // namespace

std::string with_png_text(const std::string& png, const std::string& text) {
  if (png.size() < header_end) return png;
  // Keyword, not compressed, no language, no translated keyword; the text is UTF-8.
  const std::string data = std::string("Software") + std::string(5, '\0') + text;
  const std::string chunk = "iTXt" + data;
  const std::string whole =
      big_endian(static_cast<std::uint32_t>(data.size())) + chunk + big_endian(check_sum(chunk));
  return png.substr(0, header_end) + whole + png.substr(header_end);
}

}  // namespace straightedge::cli
