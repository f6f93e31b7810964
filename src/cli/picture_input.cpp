// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/picture_input.hpp"

#include <unistd.h>

#include <string>

#include "io/number_text.hpp"
#include "straightedge/host/image_file.hpp"

namespace straightedge::cli {
namespace {

constexpr std::int32_t longest_side = 32767;  // pixels; what the Hough transform's numbers hold

std::string gigabytes(double bytes) {
  return io::to_text(bytes / 1e9, 1) + " GB";
}

Result<Image<std::uint8_t>> small_enough(Result<Image<std::uint8_t>> picture,
                                         const std::filesystem::path& file) {
  if (!picture) return picture;
  if (picture->width() <= longest_side && picture->height() <= longest_side) return picture;
  return Failure{Problem::bad_content, file.string() + ": is " + io::to_text(picture->width()) + " x " +
                                           io::to_text(picture->height()) + " pixels, and a side may have " +
                                           io::to_text(longest_side)};
}

}  // namespace

Result<Image<std::uint8_t>> read_picture(const std::filesystem::path& file) {
  return small_enough(read_gray_image(file), file);
}

Result<Image<std::uint8_t>> decode_picture(std::string_view bytes, const std::filesystem::path& file) {
  return small_enough(decode_gray_image(bytes, file.string()), file);
}

Result<Done> check_memory(const std::filesystem::path& file, std::size_t bytes) {
  const long pages = ::sysconf(_SC_PHYS_PAGES), page = ::sysconf(_SC_PAGESIZE);
  const double memory = static_cast<double>(pages) * static_cast<double>(page);
  if (pages <= 0 || page <= 0 || static_cast<double>(bytes) <= memory) return Done{};
  return Failure{Problem::bad_content, file.string() + ": is too large for this machine; the work needs " +
                                           gigabytes(static_cast<double>(bytes)) +
                                           " of memory, and there are " + gigabytes(memory)};
}

}  // namespace straightedge::cli
