// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "planes_room.hpp"
#include "straightedge/host/depth_file.hpp"
#include "support/catch.hpp"

using namespace straightedge;
namespace fs = std::filesystem;

namespace {

struct ExplainedRoom : TemporaryFolder {
  ExplainedRoom() { planes_room::write_sequence(*this / "room", 0, 0); }
  std::string frame() const { return (*this / "room" / "depth" / "0.png").string(); }
  std::string out() const { return (*this / "out").string(); }
  std::string page() const { return bytes_of(*this / "out" / "index.html"); }
  /// The frame where no camera is near.
  std::string lonely() const {
    fs::create_directories(*this / "a" / "b");
    fs::copy_file(frame(), *this / "a" / "b" / "0.png", fs::copy_options::overwrite_existing);
    return (*this / "a" / "b" / "0.png").string();
  }
  std::string camera() const { return (*this / "room" / "camera.json").string(); }
};

}  // namespace

TEST_CASE("explain knows a depth frame by its content") {
  const ExplainedRoom room;
  const Run run = run_program({"explain", room.frame(), "-o", room.out(), "--json", "--quiet"});
  INFO(run.err);
  REQUIRE(run.code == 0);
  CHECK(run.err.empty());
  const auto numbers = nlohmann::json::parse(run.out);
  CHECK(numbers["kind"] == "depth");
  CHECK(numbers["options"] == "method ransac");
  CHECK(numbers["width"] == 160);
  CHECK(room.page().find("From depth frame to planes: 0.png") != std::string::npos);
  CHECK(room.page().find(room.path().string()) == std::string::npos);

  const Run hough = run_program({"explain", room.frame(), "-o", room.out(), "--method", "hough"});
  CHECK(hough.code == 0);
  CHECK(hough.err.find("index.html") != std::string::npos);
  CHECK(fs::exists(room / "out" / "patches.png"));
  CHECK_FALSE(fs::exists(room / "out" / "boxes.png"));
}

TEST_CASE("explain takes 8 bits for a picture, and 16 if told so") {
  const ExplainedRoom room;
  const auto picture = room.put("room/depth/picture.pgm", room_pgm()).string();
  const Run run = run_program({"explain", picture, "-o", room.out(), "--json", "--quiet"});
  REQUIRE(run.code == 0);
  CHECK(nlohmann::json::parse(run.out)["kind"] == "picture");
  CHECK(room.page().find("From picture to line map") != std::string::npos);
  const Run told =
      run_program({"explain", room.frame(), "-o", room.out(), "--picture", "photo", "--json", "--quiet"});
  REQUIRE(told.code == 0);
  CHECK(nlohmann::json::parse(told.out)["kind"] == "picture");
}

TEST_CASE("a depth frame to explain comes from standard input, too") {
  const ExplainedRoom room;
  const Run run = run_program({"explain", "-", "-o", room.out(), "--camera", room.camera()},
                              {.standard_input = room.lonely()});
  INFO(run.err);
  CHECK(run.code == 0);
  CHECK(room.page().find("From depth frame to planes") != std::string::npos);
}

TEST_CASE("what explain cannot use is one sentence and no trace") {
  const ExplainedRoom room;
  const std::string lonely = room.lonely();
  const auto picture = room.put("picture.pgm", room_pgm()).string();
  const auto refused = [&](std::vector<std::string> arguments, int code, const std::string& name,
                           const std::string& words) {
    arguments.insert(arguments.begin(), "explain");
    arguments.insert(arguments.end(), {"-o", room.out()});
    INFO(words);
    CHECK(refusal(run_program(arguments), code, name).find(words) != std::string::npos);
    CHECK_FALSE(fs::exists(room.out()));
  };
  refused({lonely}, 2, lonely, "its camera is not known");
  refused({lonely, "--camera", "none.json"}, 3, "none.json", "cannot be");
  refused({room.frame(), "--low", "30"}, 2, "--low", "is for pictures");
  refused({room.frame(), "--method", "progressive"}, 2, room.frame(), "ransac or hough");
  refused({picture, "--camera", room.camera()}, 2, "--camera", "is for depth frames");
  refused({picture, "--method", "ransac"}, 2, picture, "depth frames");
  const auto small = room.put("small.json", R"({"fx":1,"fy":1,"cx":0,"cy":0,"width":7,"height":7})").string();
  refused({lonely, "--camera", small}, 5, lonely, "size");
  const std::string bytes = bytes_of(lonely);
  const auto cut = room.put("cut.png", bytes.substr(0, bytes.size() / 2)).string();
  refused({cut, "--camera", room.camera()}, 5, cut, "");
}

TEST_CASE("a frame without a single reading is explained") {
  const ExplainedRoom room;
  REQUIRE(write_png16(room / "room" / "empty.png", Image<std::uint16_t>(Size{160, 120})));
  const std::string method = GENERATE("ransac", "hough");
  const Run run =
      run_program({"explain", (room / "room" / "empty.png").string(), "-o", room.out(), "--method", method});
  INFO(run.err);
  CHECK(run.code == 0);
  CHECK(room.page().find("there is no plane in this frame") != std::string::npos);
}
