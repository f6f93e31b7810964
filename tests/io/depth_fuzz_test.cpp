// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <random>
#include <string>

#include "catch.hpp"
#include "mutated.hpp"
#include "png_maker.hpp"
#include "sequence_maker.hpp"
#include "straightedge/host/camera_file.hpp"
#include "straightedge/host/depth_file.hpp"
#include "straightedge/host/depth_sequence.hpp"
#include "straightedge/host/trajectory.hpp"

using namespace straightedge;

namespace {

constexpr std::uint32_t seed = 61;

/// A PNG whose check sums are right whatever happened to its header and its pixels, so that decoding begins.
std::string png_with_mutated_chunks(std::mt19937& generator) {
  const std::string pixels = png_maker::stored(std::string(6 * 9, '\2'));
  std::string header = png_maker::big_endian(4) + png_maker::big_endian(6) + "\x10" + std::string(4, '\0');
  if (generator() % 4 == 0) header = mutated(header, generator);
  if (header.size() > 12) header[12] = static_cast<char>(generator() % 2);  // interlaced or not
  return "\x89PNG\r\n\x1A\n" + png_maker::chunk("IHDR", header) +
         png_maker::chunk("IDAT", generator() % 2 == 0 ? mutated(pixels, generator) : pixels) +
         png_maker::chunk("IEND", "");
}

}  // namespace

TEST_CASE("mutated depth pictures are read or refused") {
  std::mt19937 generator(seed);
  const TemporaryFolder folder;
  Image<std::uint16_t> picture({16, 12}, 1000);
  picture.at(3, 3) = 7;
  REQUIRE(write_png16(folder / "a.png", picture));
  const std::string files[] = {bytes_of(folder / "a.png"), "P5 # c\n4 3 65535\nabcdefghijklmnopqrstuvwx",
                               "P2 4 3 1000\n1 2 3 4 5 6 7 8 9 10 11 12\n"};
  int read = 0;
  for (int round = 0; round < 6000; ++round) {
    const std::string bytes =
        round % 4 == 3 ? png_with_mutated_chunks(generator) : mutated(files[round % 4], generator);
    const auto image = decode_depth_image(bytes, "x.png");
    if (!image) {
      expect_sentence(image.failure(), seed, round);
      continue;
    }
    ++read;
    REQUIRE(image->width() > 0);
    REQUIRE(image->height() > 0);
  }
  CHECK(read > 300);
}

TEST_CASE("mutated cameras and trajectories are read or refused") {
  std::mt19937 generator(seed);
  const TemporaryFolder folder;
  const std::string json =
      R"({"fx":525.0,"fy":-525,"cx":319.5,"cy":239.5,"depth_scale":5e3,"width":640,"height":480,"k1":0.1})";
  const std::string matrix = SequenceMaker::matrix(1) + SequenceMaker::matrix(2);
  const std::string files[] = {json, "525 0 319.5\n0 525 239.5\n0 0 1\n",
                               "# t\n" + SequenceMaker::tum({{1, 2}, {2, 3}}), matrix,
                               "0 0 1\n" + SequenceMaker::matrix(4)};
  int read = 0;
  for (int round = 0; round < 5000; ++round) {
    const auto file = folder.put("x.txt", mutated(files[round % 5], generator));
    INFO("seed " << seed << ", round " << round);
    const auto camera = read_camera(file);
    if (!camera) {
      expect_sentence(camera.failure(), seed, round);
    } else {
      REQUIRE(camera->pinhole.valid());
      REQUIRE(camera->units_per_metre > 0);
    }
    const auto poses = read_trajectory(file);
    if (!poses) {
      expect_sentence(poses.failure(), seed, round);
      continue;
    }
    ++read;
    REQUIRE_FALSE(poses->empty());
    for (const TimedPose& pose : *poses) {
      REQUIRE(finite(pose.pose.translation));
      REQUIRE(squared_length(pose.pose.turned({1, 0, 0})) == Approx(1));
    }
  }
  CHECK(read > 50);
}

TEST_CASE("mutated sequences are opened or refused") {
  std::mt19937 generator(seed);
  const SequenceMaker made;
  const std::string list = "1 depth/1.png\n2 depth/2.png\n3 depth/3.png\n";
  const std::string path = SequenceMaker::tum({{1, 1}, {2, 2}, {3, 3}});
  for (const int n : {1, 2, 3}) made.frame("depth/" + std::to_string(n) + ".png");
  for (int round = 0; round < 1500; ++round) {
    made.text("depth.txt", round % 2 == 0 ? mutated(list, generator) : list);
    made.text("groundtruth.txt", round % 2 == 0 ? path : mutated(path, generator));
    const auto sequence = open_depth_sequence(made.path(), {});
    if (!sequence) {
      expect_sentence(sequence.failure(), seed, round);
      continue;
    }
    INFO("seed " << seed << ", round " << round);
    for (const SequenceFrame& frame : sequence->frames) REQUIRE((frame.pose || !frame.problem.empty()));
  }
}
