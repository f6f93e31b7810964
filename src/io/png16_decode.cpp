// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <png.h>

#include <bit>
#include <csetjmp>
#include <cstring>
#include <vector>

#include "io/image_size.hpp"
#include "io/png16.hpp"

namespace straightedge::io {
namespace {

constexpr std::string_view signature = "\x89PNG\r\n\x1A\n";
constexpr std::size_t header_length = 33;  ///< signature, then the IHDR chunk with its check sum

Failure bad(const std::string& name, const std::string& what) {
  return {Problem::bad_content, name + ": " + what};
}

std::uint32_t big_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = at; i < at + 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

const char* kind_of(int colour_type) {
  switch (colour_type) {
    case PNG_COLOR_TYPE_GRAY:
      return "gray picture";
    case PNG_COLOR_TYPE_GRAY_ALPHA:
      return "gray picture with transparency";
    case PNG_COLOR_TYPE_PALETTE:
      return "picture with a palette";
    default:
      return "colour picture";
  }
}

/// What the header promises, before libpng gets to see it or memory is taken.
Result<Size> checked_header(std::string_view bytes, const std::string& name) {
  if (bytes.size() < header_length) return bad(name, "is truncated: it ends in its PNG header");
  if (bytes.substr(12, 4) != "IHDR") return bad(name, "has a broken PNG header");
  const int depth = static_cast<unsigned char>(bytes[24]);
  const int colour = static_cast<unsigned char>(bytes[25]);
  if (depth != 16 || colour != PNG_COLOR_TYPE_GRAY) {
    return bad(name, (depth == 8 ? "is an " : "is a ") + std::to_string(depth) + "-bit " + kind_of(colour) +
                         "; depth is one 16-bit gray value a pixel");
  }
  const auto size = checked_size(big_endian(bytes, 16), big_endian(bytes, 20), name);
  if (!size) return size;
  // Deflate makes at most 1032 bytes of one, so a short file cannot be a large picture.
  const auto pixels = static_cast<std::uint64_t>(size->width) * static_cast<std::uint64_t>(size->height);
  if (2 * pixels / 1032 > bytes.size()) return bad(name, "is truncated");
  return size;
}

/// libpng leaves by longjmp, which runs no destructors: nothing between the jump and its target may own
/// anything. Whatever does own lives in the caller of the functions that set the jump.
struct Reading {
  png_structp png = nullptr;
  png_infop info = nullptr;
  const char* data = nullptr;
  std::size_t left = 0;
  char message[128] = {};

  explicit Reading(std::string_view bytes) : data(bytes.data()), left(bytes.size()) {}
  ~Reading() { png_destroy_read_struct(&png, &info, nullptr); }
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;
};

void keep_message(png_structp png, png_const_charp text) {
  auto* reading = static_cast<Reading*>(png_get_error_ptr(png));
  std::strncpy(reading->message, text, sizeof reading->message - 1);
  png_longjmp(png, 1);
}

void pass_over_warning(png_structp, png_const_charp) {}

void give_bytes(png_structp png, png_bytep target, std::size_t count) {
  auto* reading = static_cast<Reading*>(png_get_io_ptr(png));
  if (count > reading->left) png_error(png, "it is truncated");
  std::memcpy(target, reading->data, count);
  reading->data += count;
  reading->left -= count;
}

bool read_header(Reading& reading, Size size) {
  if (setjmp(png_jmpbuf(reading.png))) return false;
  png_set_read_fn(reading.png, &reading, give_bytes);
  png_set_user_limits(reading.png, static_cast<png_uint_32>(size.width),
                      static_cast<png_uint_32>(size.height));
  png_read_info(reading.png, reading.info);
  if constexpr (std::endian::native == std::endian::little) png_set_swap(reading.png);
  png_set_interlace_handling(reading.png);
  png_read_update_info(reading.png, reading.info);
  return true;
}

bool read_rows(Reading& reading, png_bytepp rows) {
  if (setjmp(png_jmpbuf(reading.png))) return false;
  png_read_image(reading.png, rows);
  png_read_end(reading.png, nullptr);
  return true;
}

}  // namespace

bool is_png(std::string_view bytes) noexcept {
  return bytes.starts_with(signature);
}

Result<Image<std::uint16_t>> decode_png16(std::string_view bytes, const std::string& name) {
  const auto size = checked_header(bytes, name);
  if (!size) return size.failure();
  Reading reading(bytes);
  const auto unreadable = [&] {
    return bad(name, std::string("is not a PNG that can be read (") + reading.message + ")");
  };
  reading.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reading, keep_message, pass_over_warning);
  if (reading.png != nullptr) reading.info = png_create_info_struct(reading.png);
  if (reading.info == nullptr) return Failure{Problem::cannot_read, name + ": does not fit into memory"};
  if (!read_header(reading, *size)) return unreadable();

  Image<std::uint16_t> raw(*size);
  std::vector<png_bytep> rows;
  rows.reserve(static_cast<std::size_t>(size->height));
  for (std::int32_t y = 0; y < size->height; ++y)
    rows.push_back(reinterpret_cast<png_bytep>(raw.view().row(y)));
  if (!read_rows(reading, rows.data())) return unreadable();
  return raw;
}

}  // namespace straightedge::io
