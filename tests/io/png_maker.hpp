// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

/// PNG files of any header and content, made byte by byte: chunks with their check sums around stored (not
/// compressed) data. Oracles for the reader, and headers that no writer would write.
namespace png_maker {

inline std::string big_endian(std::uint32_t value) {
  return {static_cast<char>(value >> 24), static_cast<char>(value >> 16), static_cast<char>(value >> 8),
          static_cast<char>(value)};
}

inline std::string chunk(const std::string& kind, const std::string& data) {
  std::uint32_t crc = 0xFFFFFFFFu;
  for (const char c : kind + data) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (0xEDB88320u & (0u - (crc & 1)));
  }
  return big_endian(static_cast<std::uint32_t>(data.size())) + kind + data + big_endian(~crc);
}

/// A zlib stream of one stored block; for less than 65536 bytes.
inline std::string stored(const std::string& data) {
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  for (const char c : data) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  const auto size = static_cast<std::uint32_t>(data.size());
  std::string block = "\x78\x01\x01";
  block += static_cast<char>(size & 255);
  block += static_cast<char>(size >> 8);
  block += static_cast<char>(~size & 255);
  block += static_cast<char>(~size >> 8 & 255);
  return block + data + big_endian(b << 16 | a);
}

enum Colour { gray = 0, rgb = 2, palette = 3, gray_alpha = 4, rgb_alpha = 6 };

/// `rows`: the raw bytes of all rows, each led by its filter byte; of all passes with interlace 1.
inline std::string png(std::uint32_t width, std::uint32_t height, int depth, Colour colour,
                       const std::string& rows, const std::string& extra_chunks = "", int interlace = 0) {
  std::string header = big_endian(width) + big_endian(height);
  header += static_cast<char>(depth);
  header += static_cast<char>(colour);
  header += std::string(2, '\0') + static_cast<char>(interlace);
  return "\x89PNG\r\n\x1A\n" + chunk("IHDR", header) + extra_chunks + chunk("IDAT", stored(rows)) +
         chunk("IEND", "");
}

}  // namespace png_maker
