// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <vector>

#include "canny/row_forms.hpp"
#include "straightedge/host/kernels.hpp"
#include "support/catch.hpp"

using namespace row_forms;

namespace {

// A row with what the kernels may touch beyond its ends, and guards beyond that. It begins at any address
// that its numbers may begin at.
template <class T>
class Row {
 public:
  explicit Row(int width) : width_(width), elements_(outside + steps(width) + outside, guard) {}

  T* data() { return elements_.data() + outside; }
  const T* data() const { return elements_.data() + outside; }
  bool same_as(const Row& other) const { return std::equal(data(), data() + width_, other.data()); }
  /// Nothing was written left of the row, or right of the room that it has.
  bool guards_intact() const {
    const auto is_guard = [](T value) { return value == guard; };
    const auto end = elements_.end() - outside;
    return std::all_of(elements_.begin(), elements_.begin() + outside, is_guard) &&
           std::all_of(end, elements_.end(), is_guard);
  }

 private:
  static constexpr int outside = 67;
  static constexpr T guard = 93;
  static std::size_t steps(int width) {
    return (static_cast<std::size_t>(width) + canny_row_step - 1) / canny_row_step * canny_row_step;
  }
  int width_;
  std::vector<T> elements_;
};

// Pixels of one kind a picture: noise, black and white, a ramp, few grays.
std::uint8_t pixel(Pcg32& random, int kind, int x) {
  switch (kind) {
    case 0:
      return static_cast<std::uint8_t>(random.below(256));
    case 1:
      return random.below(2) == 0 ? 0 : 255;
    case 2:
      return static_cast<std::uint8_t>(std::min(255, x * 3));
    default:
      return static_cast<std::uint8_t>(100 + random.below(3));
  }
}

struct GrayRows {
  std::vector<std::vector<std::uint8_t>> memory;
  std::vector<const std::uint8_t*> rows;
};

GrayRows gray_rows(Pcg32& random, int count, int width) {
  GrayRows gray;
  const int kind = static_cast<int>(random.below(4));
  for (int y = 0; y < count; ++y) {
    const int shift = static_cast<int>(random.below(5)), length = width + 140;
    auto& row = gray.memory.emplace_back(static_cast<std::size_t>(length));
    for (int x = 0; x < length; ++x) row[static_cast<std::size_t>(x)] = pixel(random, kind, x);
    gray.rows.push_back(row.data() + 16 + shift);
  }
  return gray;
}

template <class M>
void check_gradient(CannyRowKernels::Gradient<M> fast, CannyRowKernels::Gradient<M> plain, int side,
                    int width, Pcg32& random) {
  const GrayRows gray = gray_rows(random, side, width);
  std::vector<std::int16_t> scratch(2 * static_cast<std::size_t>(width + side));
  Row<std::int16_t> dx(width), dy(width), plain_dx(width), plain_dy(width);
  Row<M> magnitude(width), plain_magnitude(width);
  fast(gray.rows.data(), scratch.data(), dx.data(), dy.data(), magnitude.data(), width);
  plain(gray.rows.data(), scratch.data(), plain_dx.data(), plain_dy.data(), plain_magnitude.data(), width);
  CHECK(dx.same_as(plain_dx));
  CHECK(dy.same_as(plain_dy));
  CHECK(magnitude.same_as(plain_magnitude));
  CHECK((dx.guards_intact() && dy.guards_intact() && magnitude.guards_intact()));
}

// Gradients and magnitudes that belong together only where they are 0; from few values, so that ties are
// common.
template <class M>
void check_suppress(CannyRowKernels::Suppress<M> fast, CannyRowKernels::Suppress<M> plain, M largest,
                    int width, Pcg32& random) {
  const std::uint32_t steepest = random.below(2) == 0 ? 12240 : 1 + random.below(12240);
  const std::uint32_t values = random.below(2) == 0 ? 3 : largest + 1;
  Row<std::int16_t> dx(width), dy(width);
  std::vector<Row<M>> magnitude(3, Row<M>(width));
  for (int x = -1; x <= width; ++x) {
    for (auto& row : magnitude) row.data()[x] = static_cast<M>(random.below(values));
    if (x < 0 || x == width) continue;
    const auto gradient = [&] {
      const std::uint32_t extreme = random.below(8);
      const std::uint32_t size = extreme < 2 ? extreme * steepest : random.below(steepest + 1);
      const auto rise = static_cast<std::int32_t>(size);
      return static_cast<std::int16_t>(random.below(2) == 0 ? rise : -rise);
    };
    dx.data()[x] = gradient();
    dy.data()[x] = gradient();
    if (dx.data()[x] == 0 && dy.data()[x] == 0) magnitude[1].data()[x] = 0;
  }
  const int thresholds[] = {-1,       0, 1, static_cast<int>(random.below(values)), static_cast<int>(largest),
                            INT32_MAX};
  MagnitudeThresholds limits{thresholds[random.below(6)], thresholds[random.below(6)]};
  if (limits.low > limits.high) std::swap(limits.low, limits.high);
  const MagnitudeRows<M> rows{magnitude[0].data(), magnitude[1].data(), magnitude[2].data(), dx.data(),
                              dy.data()};
  Row<std::uint8_t> classes(width), plain_classes(width);
  CAPTURE(limits.low, limits.high, steepest, values);
  CHECK(fast(rows, limits, classes.data(), width) == plain(rows, limits, plain_classes.data(), width));
  CHECK(classes.same_as(plain_classes));
  CHECK(classes.guards_intact());
}

void check_blur(const CannyRowKernels& fast, const CannyRowKernels& plain, int tap_count, int width,
                Pcg32& random) {
  const GrayRows gray = gray_rows(random, tap_count, width);
  std::vector<std::uint16_t> taps(static_cast<std::size_t>(tap_count));
  REQUIRE(make_gaussian_kernel(tap_count / 6.0, taps) == Status::ok);
  Row<std::uint16_t> sums(width), plain_sums(width);
  fast.blur_down(gray.rows.data(), taps.data(), tap_count, sums.data(), width);
  plain.blur_down(gray.rows.data(), taps.data(), tap_count, plain_sums.data(), width);
  CHECK(sums.same_as(plain_sums));
  CHECK(sums.guards_intact());

  std::vector<std::uint16_t> any(static_cast<std::size_t>(width + tap_count) + 2 * canny_row_step);
  for (auto& sum : any) sum = static_cast<std::uint16_t>(random.below(8) == 0 ? 65280 : random.below(65281));
  Row<std::uint8_t> blurred(width), plain_blurred(width);
  fast.blur_along(any.data() + tap_count / 2, taps.data(), tap_count, blurred.data(), width);
  plain.blur_along(any.data() + tap_count / 2, taps.data(), tap_count, plain_blurred.data(), width);
  CHECK(blurred.same_as(plain_blurred));
  CHECK(blurred.guards_intact());
}

template <class Check>
void for_all_widths(const Check& check) {
  for (const KernelSet& set : kernel_sets()) {
    for (int width = 1; width <= 200; ++width) {
      Pcg32 random(static_cast<std::uint64_t>(width), 41);
      CAPTURE(std::string(set.name), width);
      for (int round = 0; round < 8; ++round) check(*set.canny_rows, width, random);
    }
  }
}

}  // namespace

TEST_CASE("every set of kernels: gradients equal the plain ones") {
  const CannyRowKernels& plain = plain_canny_row_kernels;
  for_all_widths([&](const CannyRowKernels& fast, int width, Pcg32& random) {
    for (int i = 0; i < 3; ++i) {
      const int side = 3 + 2 * i;
      check_gradient(fast.gradient_l1[i], plain.gradient_l1[i], side, width, random);
      check_gradient(fast.gradient_l2[i], plain.gradient_l2[i], side, width, random);
    }
  });
}

TEST_CASE("every set of kernels: suppression equals the plain one") {
  const CannyRowKernels& plain = plain_canny_row_kernels;
  for_all_widths([&](const CannyRowKernels& fast, int width, Pcg32& random) {
    check_suppress<std::uint16_t>(fast.suppress_l1, plain.suppress_l1, 24480, width, random);
    check_suppress<std::uint32_t>(fast.suppress_l2, plain.suppress_l2, (1U << 29U) - 1, width, random);
  });
}

TEST_CASE("every set of kernels: the blur equals the plain one") {
  for_all_widths([&](const CannyRowKernels& fast, int width, Pcg32& random) {
    const int tap_count = 3 + 2 * static_cast<int>(random.below(7));
    check_blur(fast, plain_canny_row_kernels, tap_count, width, random);
  });
}
