// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <climits>
#include <cstdlib>
#include <memory>
#include <new>

#include "straightedge/host/image_file.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace straightedge {
namespace {

Result<std::string> encode(const void* data, Size size, std::ptrdiff_t stride, int channels) try {
  if (stride > INT_MAX) return Failure{Problem::bad_option, "the image's rows are too far apart for PNG"};
  if (std::int64_t{size.width} * size.height > max_image_pixels) {
    return Failure{Problem::bad_option, "the image has more than 2^28 pixels"};
  }
  int length = 0;
  const std::unique_ptr<unsigned char, void (*)(void*)> png(
      stbi_write_png_to_mem(static_cast<const unsigned char*>(data), static_cast<int>(stride), size.width,
                            size.height, channels, &length),
      std::free);
  if (png == nullptr || length < 1)
    return Failure{Problem::cannot_write, "the image does not fit into memory"};
  return std::string(reinterpret_cast<const char*>(png.get()), static_cast<std::size_t>(length));
} catch (const std::bad_alloc&) {
  return Failure{Problem::cannot_write, "the image does not fit into memory"};
}

}  // namespace

Result<std::string> encode_png(GrayView image) {
  if (!image.valid()) return Failure{Problem::bad_option, "there is no image to write"};
  return encode(image.data, image.size(), image.stride, 1);
}

Result<std::string> encode_png(ImageView<const Rgb> image) {
  static_assert(sizeof(Rgb) == 3);
  if (!image.valid()) return Failure{Problem::bad_option, "there is no image to write"};
  return encode(image.data, image.size(), image.stride, 3);
}

}  // namespace straightedge
