// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "golden_hough.hpp"

#include <cstdio>
#include <cstring>

namespace straightedge::test {
namespace {

/// Numbers from a file, in the machine's order, which is the file's: little endian.
struct Reader {
  std::FILE* file = nullptr;
  bool good = true;

  void bytes(void* to, std::size_t count) {
    good = good && std::fread(to, 1, count, file) == count;
    if (!good) std::memset(to, 0, count);
  }
  template <class T>
  T number() {
    T value{};
    bytes(&value, sizeof value);
    return value;
  }
};

GoldenImage read_image(Reader& in) {
  char name[33] = {};
  in.bytes(name, 32);
  const int width = in.number<std::uint16_t>();
  const int height = in.number<std::uint16_t>();
  GoldenImage image{name, Image<std::uint8_t>({width, height})};
  for (int y = 0; y < height; ++y) {
    std::uint8_t bits = 0;
    for (int x = 0; x < width; ++x, bits = static_cast<std::uint8_t>(bits << 1)) {
      if (x % 8 == 0) bits = in.number<std::uint8_t>();
      image.edges.at(x, y) = (bits & 0x80) != 0 ? 255 : 0;
    }
  }
  return image;
}

GoldenLines read_case(Reader& in) {
  GoldenLines lines;
  HoughOptions& o = lines.options;
  lines.image = in.number<std::uint16_t>();
  const bool standard = in.number<std::uint16_t>() == 0;
  o.method = standard ? HoughMethod::standard : HoughMethod::progressive;
  o.generator = HoughGenerator::opencv;
  o.threshold = in.number<std::int32_t>();
  o.rho_step = in.number<double>();
  o.theta_step = in.number<double>();
  (standard ? o.min_theta : o.min_length) = in.number<double>();
  (standard ? o.max_theta : o.max_gap) = in.number<double>();
  in.number<double>();
  const auto count = in.number<std::uint32_t>();
  in.good = in.good && in.number<std::uint32_t>() == (standard ? 12 : 8);
  for (std::uint32_t i = 0; i < count && in.good; ++i) {
    if (standard) {
      const auto rho = in.number<float>();
      const auto theta = in.number<float>();
      lines.peaks.push_back({rho, theta, in.number<std::int32_t>()});
    } else {
      std::uint16_t ends[4];
      in.bytes(ends, sizeof ends);
      lines.segments.push_back({ends[0], ends[1], ends[2], ends[3]});
    }
  }
  return lines;
}

}  // namespace

GoldenHough read_golden_hough(const char* file) {
  GoldenHough golden;
  Reader in{std::fopen(file, "rb")};
  if (in.file == nullptr) return golden;
  char magic[4] = {};
  in.bytes(magic, 4);
  in.good = in.good && std::memcmp(magic, "SEHG", 4) == 0 && in.number<std::uint32_t>() == 1;
  for (auto n = in.number<std::uint32_t>(); n > 0 && in.good; --n) golden.images.push_back(read_image(in));
  for (auto n = in.number<std::uint32_t>(); n > 0 && in.good; --n) golden.cases.push_back(read_case(in));
  golden.good = in.good && std::fgetc(in.file) == EOF;
  std::fclose(in.file);
  return golden;
}

}  // namespace straightedge::test
