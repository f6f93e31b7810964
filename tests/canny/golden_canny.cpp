// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstring>
#include <map>
#include <string>

#include "canny/row_forms.hpp"
#include "straightedge/gray.hpp"
#include "support/catch.hpp"
#include "support/file_bytes.hpp"
#include "support/golden.hpp"

using namespace row_forms;
using support::GoldenRecord;

namespace {

const std::string folder = STRAIGHTEDGE_FIXTURES "/golden/canny/";

Border border_of(const GoldenRecord& record) {
  const std::string_view name = record.text("border");
  if (name == "constant") return Border::constant;
  if (name == "replicate") return Border::replicate;
  return name == "reflect" ? Border::reflect : Border::reflect_101;
}

GrayImage image_of(const GoldenRecord& record) {
  const Size size{record.integer("width"), record.integer("height")};
  const std::string pgm = record.text("file").empty()
                              ? std::string()
                              : support::file_bytes(folder + std::string(record.text("file")));
  const std::string_view pixels = pgm.empty() ? record.bytes : support::pgm_pixels(pgm);
  REQUIRE(pixels.size() == hysteresis_stack_size(size));
  GrayImage image(size, 11);
  const auto width = static_cast<std::size_t>(size.width);
  for (int y = 0; y < size.height; ++y) {
    std::memcpy(image.view().row(y), pixels.data() + static_cast<std::size_t>(y) * width, width);
  }
  return image;
}

// The record's window of what we made must be the record's bytes.
template <class T>
bool window_equals(const support::GuardedImage<T>& made, const GoldenRecord& record) {
  const int x0 = record.integer("x"), y0 = record.integer("y"), width = record.integer("width");
  std::string bytes;
  for (int y = y0; y < y0 + record.integer("height"); ++y) {
    for (int x = x0; x < x0 + width; ++x) {
      const int value = made.at(x, y);
      bytes.push_back(static_cast<char>(value & 255));
      if (sizeof(T) == 2) bytes.push_back(static_cast<char>((value >> 8) & 255));
    }
  }
  return bytes == record.bytes;
}

bool blur_equals(const GrayImage& image, const GoldenRecord& record) {
  const double sigma = record.number("sigma");
  const int size = record.integer("size") == 0 ? gaussian_size(sigma) : record.integer("size");
  GrayImage blurred(image.size());
  REQUIRE(blur(image.view(), kernel(size, sigma), border_of(record), blurred.view()) == Status::ok);
  return window_equals(blurred, record);
}

bool sobel_equals(const GrayImage& image, const GoldenRecord& record) {
  GradientImage dx(image.size()), dy(image.size());
  REQUIRE(gradient(image.view(), record.integer("aperture"), border_of(record), GradientScale::clamp,
                   dx.view(), dy.view()) == Status::ok);
  return window_equals(record.text("axis") == "x" ? dx : dy, record);
}

bool canny_equals(const GrayImage& image, const GoldenRecord& record) {
  const CannyOptions options{.sigma = record.number("sigma"),
                             .aperture = record.integer("aperture"),
                             .norm = record.text("norm") == "l2" ? GradientNorm::l2 : GradientNorm::l1,
                             .low = record.number("low"),
                             .high = record.number("high")};
  const GrayImage edges = edges_of(image, options);
  CHECK(fused(image, options).edges == edges);
  CHECK(by_rows(image, options).edges == edges);
  std::string bits((hysteresis_stack_size(image.size()) + 7) / 8, '\0');
  std::size_t i = 0;
  for (int y = 0; y < image.size().height; ++y) {
    for (int x = 0; x < image.size().width; ++x, ++i) {
      if (edges.at(x, y) == 255) bits[i / 8] = static_cast<char>(bits[i / 8] | (128 >> (i % 8)));
      if (edges.at(x, y) != 255 && edges.at(x, y) != 0) return false;
    }
  }
  return bits == record.bytes;
}

// Compares every record of the file and gives back how many there were of each kind.
std::map<std::string, int> compare(const std::string& name) {
  const std::string file = support::file_bytes(folder + name);
  REQUIRE_FALSE(file.empty());
  support::GoldenReader reader(file);
  GoldenRecord record;
  GrayImage image({1, 1});
  std::string image_name;
  std::map<std::string, int> count;
  while (reader.next(record)) {
    const std::string kind(record.kind());
    ++count[kind];
    if (kind == "image") {
      image = image_of(record);
      image_name = record.text("name");
      continue;
    }
    CAPTURE(image_name, std::string(record.line));
    if (kind == "blur") CHECK(blur_equals(image, record));
    if (kind == "sobel") CHECK(sobel_equals(image, record));
    if (kind == "canny") CHECK(canny_equals(image, record));
  }
  CHECK_FALSE(reader.broken());
  return count;
}

}  // namespace

TEST_CASE("photographs and drawings: blur, gradient and edges are OpenCV's") {
  const std::map<std::string, int> count = compare("pictures.golden");
  CHECK(count == std::map<std::string, int>{{"image", 13}, {"blur", 104}, {"sobel", 156}, {"canny", 234}});
}

TEST_CASE("small and odd sizes: blur, gradient and edges are OpenCV's") {
  const std::map<std::string, int> count = compare("small.golden");
  CHECK(count.at("image") == 81 + 18);
  CHECK(count.at("blur") >= 7 * 99);
  CHECK(count.at("sobel") >= 6 * 99);
  CHECK(count.at("canny") >= 36 * 99);
}

TEST_CASE("gray values are OpenCV's") {
  const std::string file = support::file_bytes(folder + "gray.golden");
  support::GoldenReader reader(file);
  const std::map<std::string, PixelFormat, std::less<>> formats = {{"rgb", PixelFormat::rgb},
                                                                   {"bgr", PixelFormat::bgr},
                                                                   {"rgba", PixelFormat::rgba},
                                                                   {"bgra", PixelFormat::bgra}};
  GoldenRecord color, gray;
  int pairs = 0;
  for (; reader.next(color) && reader.next(gray); ++pairs) {
    const int width = color.integer("width"), height = color.integer("height");
    const PixelFormat format = formats.find(color.text("order"))->second;
    std::vector<std::uint8_t> made(gray.bytes.size());
    const ColorView view{reinterpret_cast<const std::uint8_t*>(color.bytes.data()), width, height,
                         std::ptrdiff_t{width} * channels(format), format};
    REQUIRE(gray_from_color(view, {made.data(), {width, height}}) == Status::ok);
    CHECK(std::memcmp(made.data(), gray.bytes.data(), made.size()) == 0);
  }
  CHECK(pairs == 4);
  CHECK_FALSE(reader.broken());
}
