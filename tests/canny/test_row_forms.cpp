// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <limits>

#include "canny/row_forms.hpp"
#include "support/catch.hpp"

using namespace row_forms;

namespace {

constexpr Size qvga{320, 240};
constexpr Size vga{640, 480};
constexpr CannyOptions no_blur{.sigma = 0};

// Bytes a pixel, in thousandths.
constexpr std::size_t per_mille(std::size_t bytes, Size size) {
  return bytes * 1000 / static_cast<std::size_t>(size.width * size.height);
}

// The budgets, at the sizes that microcontrollers use.
static_assert(per_mille(FusedCanny::workspace_bytes(qvga, {}), qvga) <= 220);
static_assert(per_mille(FusedCanny::workspace_bytes(vga, {}), vga) <= 90);
static_assert(per_mille(CannyRows::workspace_bytes(qvga, {}), qvga) <= 500);
static_assert(per_mille(CannyRows::workspace_bytes(qvga, no_blur), qvga) <= 450);
static_assert(per_mille(CannyRows::workspace_bytes(vga, {}), vga) <= 370);

struct Forms {
  Status fused;
  Status rows;
};

Forms prepare_both(Size size, const CannyOptions& options, const CannyRowOptions& rows = {},
                   std::size_t missing = 0) {
  const std::size_t fused_bytes = FusedCanny::workspace_bytes(size, options, rows);
  const std::size_t row_bytes = CannyRows::workspace_bytes(size, options, rows);
  GuardedWorkspace fused_memory(fused_bytes), row_memory(row_bytes);
  FusedCanny fused;
  CannyRows by_row;
  const Forms status{
      FusedCanny::prepare(fused, size, options,
                          fused_memory.bytes().first(std::max(fused_bytes, missing) - missing), rows),
      CannyRows::prepare(by_row, size, options,
                         row_memory.bytes().first(std::max(row_bytes, missing) - missing), rows)};
  CHECK((by_row.begin() == Status::ok) == (status.rows == Status::ok));
  CHECK((fused_bytes == 0) == (status.fused != Status::ok && missing == 0));
  CHECK((row_bytes == 0) == (status.rows != Status::ok && missing == 0));
  CHECK(fused_memory.guards_intact());
  CHECK(row_memory.guards_intact());
  return status;
}

void check_refused(Size size, const CannyOptions& options, Status expected,
                   const CannyRowOptions& rows = {}) {
  const Forms status = prepare_both(size, options, rows);
  CHECK(status.fused == expected);
  CHECK(status.rows == expected);
}

// A prepared detector for rows.
struct RowDetector {
  explicit RowDetector(Size size, const CannyOptions& options = {})
      : workspace(CannyRows::workspace_bytes(size, options)) {
    REQUIRE(CannyRows::prepare(canny, size, options, workspace.bytes()) == Status::ok);
  }
  GuardedWorkspace workspace;
  CannyRows canny;
};

}  // namespace

TEST_CASE("row forms refuse what Canny refuses, and automatic thresholds") {
  constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
  check_refused({20, 10}, {}, Status::ok);
  check_refused({20, 10}, {.sigma = nan_value}, Status::invalid_option);
  check_refused({20, 10}, {.aperture = 4}, Status::invalid_option);
  check_refused({20, 10}, {.low = 2, .high = 1}, Status::invalid_option);
  check_refused({20, 10}, {.thresholds = CannyThresholds::automatic}, Status::invalid_option);
  check_refused({20, 10}, {}, Status::invalid_option, {.worklist = 0});
  check_refused({0, 10}, {}, Status::invalid_image);
  check_refused({10, -1}, {}, Status::invalid_image);
  check_refused({1 << 16, 1 << 15}, {}, Status::too_large);
  check_refused({INT32_MAX, 1}, {}, Status::too_large);
}

TEST_CASE("row forms refuse to be without kernels") {
  std::vector<std::byte> memory(100000);
  FusedCanny fused;
  CannyRows by_row;
  CHECK(FusedCanny::prepare(fused, {20, 10}, {}, memory, {.kernels = nullptr}) == Status::invalid_option);
  CHECK(CannyRows::prepare(by_row, {20, 10}, {}, memory, {.kernels = nullptr}) == Status::invalid_option);
  CHECK(by_row.begin() == Status::not_prepared);
}

TEST_CASE("row forms: a workspace that is one byte short is refused") {
  for (const CannyOptions& options : {CannyOptions{}, no_blur, CannyOptions{.sigma = 3, .aperture = 7}}) {
    const Forms status = prepare_both({33, 17}, options, {}, 1);
    CHECK(status.fused == Status::workspace_too_small);
    CHECK(status.rows == Status::workspace_too_small);
  }
  FusedCanny fused;
  CHECK(FusedCanny::prepare(fused, {33, 17}, {}, {}) == Status::workspace_too_small);
  const GrayImage gray({33, 17});
  GrayImage edges({33, 17}, 5, std::uint8_t{9});
  CHECK(fused.run(gray.view(), edges.view()).status == Status::not_prepared);
  CHECK(edges == GrayImage({33, 17}, 5, std::uint8_t{9}));
}

TEST_CASE("row forms: a worklist longer than the picture costs nothing") {
  const Size size{10, 5};
  CHECK(FusedCanny::workspace_bytes(size, {}, {.worklist = 50}) ==
        FusedCanny::workspace_bytes(size, {}, {.worklist = UINT32_MAX}));
  CHECK(CannyRows::workspace_bytes(size, {}, {.worklist = 50}) ==
        CannyRows::workspace_bytes(size, {}, {.worklist = UINT32_MAX}));
}

TEST_CASE("fused Canny: views that do not fit leave the edges alone") {
  GuardedWorkspace workspace(FusedCanny::workspace_bytes({20, 10}, {}));
  FusedCanny canny;
  REQUIRE(FusedCanny::prepare(canny, {20, 10}, {}, workspace.bytes()) == Status::ok);
  const GrayImage gray({20, 10}), other({21, 10});
  GrayImage edges({20, 10}, 5, std::uint8_t{9}), other_edges({20, 11});
  CHECK(canny.run(GrayView(), edges.view()).status == Status::invalid_image);
  CHECK(canny.run(gray.view(), ImageView<std::uint8_t>()).status == Status::invalid_image);
  CHECK(canny.run(other.view(), edges.view()).status == Status::size_mismatch);
  CHECK(canny.run(gray.view(), other_edges.view()).status == Status::size_mismatch);
  CHECK(edges == GrayImage({20, 10}, 5, std::uint8_t{9}));
}

TEST_CASE("fused Canny: edges may be written over the picture, and runs do not remember") {
  for (const double sigma : {0.0, 1.4, 20.0}) {
    Pcg32 random(51);
    const CannyOptions options{.sigma = sigma, .aperture = 5};
    GuardedWorkspace workspace(FusedCanny::workspace_bytes({50, 40}, options));
    FusedCanny canny;
    REQUIRE(FusedCanny::prepare(canny, {50, 40}, options, workspace.bytes()) == Status::ok);
    for (int i = 0; i < 3; ++i) {
      const GrayImage gray = support::random_scene({50, 40}, random);
      GrayImage in_place = gray;
      REQUIRE(canny.run(in_place.view(), in_place.view()).status == Status::ok);
      CHECK(in_place == by_planes(gray, options).edges);
      CHECK(in_place.guards_intact());
    }
    CHECK(workspace.guards_intact());
  }
}

TEST_CASE("Canny by rows: calls in the wrong order") {
  Pcg32 random(52);
  const GrayImage gray = support::random_scene({30, 4}, random);
  GrayImage edges({30, 4}, 5, std::uint8_t{9});
  CannyRows unprepared;
  CHECK(unprepared.begin() == Status::not_prepared);
  CHECK(push(unprepared, gray, 0) == Status::not_prepared);
  CHECK(unprepared.finish().status == Status::not_prepared);
  CHECK(read(unprepared, edges) == Status::not_prepared);
  CHECK_FALSE(unprepared.is_edge(0, 0));

  RowDetector detector({30, 4});
  CannyRows& canny = detector.canny;
  CHECK(push(canny, gray, 0) == Status::not_prepared);
  CHECK(canny.finish().status == Status::not_prepared);
  REQUIRE(canny.begin() == Status::ok);
  for (int y = 0; y < 4; ++y) {
    CHECK(canny.finish().status == Status::size_mismatch);  // rows are missing
    CHECK(read(canny, edges) == Status::not_prepared);
    REQUIRE(push(canny, gray, y) == Status::ok);
  }
  CHECK(push(canny, gray, 0) == Status::size_mismatch);  // one too many
  CHECK_FALSE(canny.is_edge(0, 0));
  CHECK(edges == GrayImage({30, 4}, 5, std::uint8_t{9}));
  const CannyResult result = canny.finish();
  CHECK(result.status == Status::ok);
  CHECK(canny.finish().status == Status::not_prepared);
  CHECK(push(canny, gray, 0) == Status::not_prepared);
  REQUIRE(read(canny, edges) == Status::ok);
  CHECK(same({edges, result}, by_planes(gray, {})));
  CHECK(detector.workspace.guards_intact());
}

TEST_CASE("Canny by rows: rows that do not fit change nothing") {
  Pcg32 random(53);
  const GrayImage gray = support::random_scene({30, 12}, random);
  RowDetector detector({30, 12});
  const std::vector<std::uint8_t> noise(31, std::uint8_t{200});
  REQUIRE(detector.canny.begin() == Status::ok);
  for (int y = 0; y < 12; ++y) {
    CHECK(detector.canny.push_row({}) == Status::invalid_image);
    CHECK(detector.canny.push_row(noise) == Status::size_mismatch);
    CHECK(detector.canny.push_row(std::span(noise).first(29)) == Status::size_mismatch);
    REQUIRE(push(detector.canny, gray, y) == Status::ok);
  }
  const CannyResult result = detector.canny.finish();
  GrayImage edges({30, 12});
  REQUIRE(read(detector.canny, edges) == Status::ok);
  CHECK(same({edges, result}, by_planes(gray, {})));
}

TEST_CASE("Canny by rows: what reading refuses, and single pixels") {
  Pcg32 random(54);
  const GrayImage gray = support::random_scene({37, 20}, random);
  RowDetector detector({37, 20}, no_blur);
  REQUIRE(detector.canny.begin() == Status::ok);
  for (int y = 0; y < 20; ++y) REQUIRE(push(detector.canny, gray, y) == Status::ok);
  REQUIRE(detector.canny.finish().status == Status::ok);
  std::vector<std::uint8_t> row(38, std::uint8_t{9});
  const std::span<std::uint8_t> fitting = std::span(row).first(37);
  CHECK(detector.canny.read_row(-1, fitting) == Status::size_mismatch);
  CHECK(detector.canny.read_row(20, fitting) == Status::size_mismatch);
  CHECK(detector.canny.read_row(0, row) == Status::size_mismatch);
  CHECK(detector.canny.read_row(0, {}) == Status::invalid_image);
  CHECK(row == std::vector<std::uint8_t>(38, std::uint8_t{9}));
  const GrayImage expected = by_planes(gray, no_blur).edges;
  for (int y = -1; y <= 20; ++y) {
    for (int x = -1; x <= 37; ++x) {
      const bool edge = expected.view().contains(x, y) && expected.at(x, y) == 255;
      CHECK(detector.canny.is_edge(x, y) == edge);
    }
  }
}

TEST_CASE("Canny by rows: a picture may be given up, and pictures do not remember") {
  Pcg32 random(55);
  RowDetector detector({41, 23});
  for (int i = 0; i < 6; ++i) {
    const GrayImage gray = support::random_scene({41, 23}, random);
    REQUIRE(detector.canny.begin() == Status::ok);
    const int rows = i % 2 == 0 ? 23 : 3 * i;
    for (int y = 0; y < rows; ++y) REQUIRE(push(detector.canny, gray, y) == Status::ok);
    if (rows < 23) continue;
    const CannyResult result = detector.canny.finish();
    GrayImage edges({41, 23});
    REQUIRE(read(detector.canny, edges) == Status::ok);
    CHECK(same({edges, result}, by_planes(gray, {})));
  }
}

TEST_CASE("row forms use the kernels they are given") {
  static int calls;
  calls = 0;
  CannyRowKernels counting = plain_canny_row_kernels;
  counting.suppress_l1 = [](const MagnitudeRows<std::uint16_t>& rows, MagnitudeThresholds limits,
                            std::uint8_t* classes, std::int32_t width) noexcept {
    ++calls;
    return plain_canny_row_kernels.suppress_l1(rows, limits, classes, width);
  };
  const GrayImage gray({20, 10}, 5, std::uint8_t{40});
  CHECK(same(fused(gray, {}, {.kernels = &counting}), by_planes(gray, {})));
  CHECK(calls == 10);
  CHECK(same(by_rows(gray, {}, {.kernels = &counting}), by_planes(gray, {})));
  CHECK(calls == 20);
}
