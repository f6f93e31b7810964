// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/stb_decode.hpp"

#include <climits>
#include <cstdlib>
#include <memory>

#include "io/image_size.hpp"
#include "io/stb_guard.hpp"
#include "straightedge/gray.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
// Corrupt files make stb read memory that it never wrote: zeros give the same picture every time.
#define STBI_MALLOC(size) std::calloc(1, size)
#define STBI_REALLOC(old, size) std::realloc(old, size)
#define STBI_FREE(old) std::free(old)
// Corrupt files must not end the program in debug builds either.
#define STBI_ASSERT(condition) static_cast<void>(0)
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace straightedge::io {
namespace {

Failure unreadable(const std::string& name, const char* reason) {
  return {Problem::bad_content, name + ": is not an image that can be read (" +
                                    (reason != nullptr ? reason : "unknown reason") + ")"};
}

/// One or two channels are gray (and alpha), three or four are colour (and alpha).
Status to_gray(const std::uint8_t* values, int channels, ImageView<std::uint8_t> gray) {
  const Size size = gray.size();
  if (channels == 2) {
    for (std::int32_t y = 0; y < size.height; ++y) {
      for (std::int32_t x = 0; x < size.width; ++x, values += 2) gray.at(x, y) = *values;
    }
    return Status::ok;
  }
  const PixelFormat formats[] = {PixelFormat::gray, PixelFormat::gray, PixelFormat::rgb, PixelFormat::rgba};
  return gray_from_color(
      {values, size.width, size.height, std::ptrdiff_t{size.width} * channels, formats[channels - 1]}, gray);
}

}  // namespace

Result<Image<std::uint8_t>> decode_by_stb(std::string_view bytes, const std::string& name) {
  if (bytes.size() > INT_MAX) return Failure{Problem::bad_content, name + ": is longer than 2 GB"};
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int length = static_cast<int>(bytes.size());
  int width = 0;
  int height = 0;
  int channels = 0;
  if (!jpeg_tables_fit(bytes)) return unreadable(name, "a Huffman table has too many codes");
  if (stbi_info_from_memory(data, length, &width, &height, &channels) == 0)
    return unreadable(name, stbi_failure_reason());
  const auto size = checked_size(width, height, name);
  if (!size) return size.failure();
  if (!is_whole(bytes, *size)) return unreadable(name, "it is truncated");

  // The 8-bit entry keeps the upper byte of 16-bit values; zero wanted channels leaves colour to us.
  const std::unique_ptr<stbi_uc, void (*)(void*)> values(
      stbi_load_from_memory(data, length, &width, &height, &channels, 0), stbi_image_free);
  if (values == nullptr) return unreadable(name, stbi_failure_reason());
  if (Size{width, height} != *size)
    return Failure{Problem::bad_content, name + ": contradicts its own header"};
  Image<std::uint8_t> gray(*size);
  if (const Status status = to_gray(values.get(), channels, gray.view()); status != Status::ok) {
    return Failure{Problem::internal, name + ": " + to_string(status)};
  }
  return gray;
}

}  // namespace straightedge::io
