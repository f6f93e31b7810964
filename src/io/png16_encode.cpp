// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <png.h>

#include <bit>
#include <csetjmp>
#include <cstring>
#include <new>

#include "io/png16.hpp"
#include "straightedge/host/image_file.hpp"

namespace straightedge::io {
namespace {

/// As in reading: libpng leaves by longjmp, so what owns memory lives above the functions that set the jump.
struct Writing {
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::string bytes;

  Writing() = default;
  ~Writing() { png_destroy_write_struct(&png, &info); }
  Writing(const Writing&) = delete;
  Writing& operator=(const Writing&) = delete;
};

void leave(png_structp png, png_const_charp) {
  png_longjmp(png, 1);
}

void pass_over_warning(png_structp, png_const_charp) {}

bool appended(std::string& bytes, png_const_bytep data, std::size_t count) noexcept try {
  bytes.append(reinterpret_cast<const char*>(data), count);
  return true;
} catch (const std::bad_alloc&) {
  return false;
}

// No exception may pass through libpng, and no jump may leave a handler.
void take_bytes(png_structp png, png_bytep data, std::size_t count) {
  auto* writing = static_cast<Writing*>(png_get_io_ptr(png));
  if (!appended(writing->bytes, data, count)) png_error(png, "no memory");
}

void flush_nothing(png_structp) {}

bool write_all(Writing& writing, ImageView<const std::uint16_t> image) {
  if (setjmp(png_jmpbuf(writing.png))) return false;
  png_set_write_fn(writing.png, &writing, take_bytes, flush_nothing);
  png_set_IHDR(writing.png, writing.info, static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), 16, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  // Spelled out, so that no library's own defaults change the bytes.
  png_set_compression_level(writing.png, 6);
  png_set_filter(writing.png, PNG_FILTER_TYPE_BASE, PNG_ALL_FILTERS);
  png_write_info(writing.png, writing.info);
  if constexpr (std::endian::native == std::endian::little) png_set_swap(writing.png);
  for (std::int32_t y = 0; y < image.height; ++y)
    png_write_row(writing.png, reinterpret_cast<png_const_bytep>(image.row(y)));
  png_write_end(writing.png, nullptr);
  return true;
}

}  // namespace

Result<std::string> encode_png16(ImageView<const std::uint16_t> image) {
  if (!image.valid()) return Failure{Problem::bad_option, "there is no image to write"};
  if (std::int64_t{image.width} * image.height > max_image_pixels)
    return Failure{Problem::bad_option, "the image has more than 2^28 pixels"};
  Writing writing;
  writing.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &writing, leave, pass_over_warning);
  if (writing.png != nullptr) writing.info = png_create_info_struct(writing.png);
  if (writing.info == nullptr || !write_all(writing, image))
    return Failure{Problem::cannot_write, "the image does not fit into memory"};
  return std::move(writing.bytes);
}

}  // namespace straightedge::io
