// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "io/png_maker.hpp"
#include "run_program.hpp"
#include "straightedge/host/map_file.hpp"
#include "support/catch.hpp"

using straightedge::read_line_map;

namespace {

/// Every command that reads pictures, with an output in the folder.
std::vector<std::vector<std::string>> readers_of(const std::string& picture, const TemporaryFolder& folder) {
  return {{"edges", picture, "-o", (folder / "e.png").string()},
          {"hough", picture, "--csv", (folder / "h.csv").string()},
          {"lines", picture, "-o", (folder / "m.xml").string(), "--svg", (folder / "m.svg").string(), "--png",
           (folder / "m.png").string(), "--csv", (folder / "m.csv").string()},
          {"explain", picture, "-o", (folder / "explained").string()}};
}

void refused_everywhere(const std::string& picture, int code, const TemporaryFolder& folder) {
  const auto before = names_in(folder);
  for (const auto& arguments : readers_of(picture, folder)) {
    INFO(arguments[0] << " " << picture);
    refusal(run_program(arguments), code, picture);
    CHECK(names_in(folder) == before);
  }
}

/// Done, with a line map of no lines.
void empty_everywhere(const std::string& picture, const TemporaryFolder& folder) {
  for (const auto& arguments : readers_of(picture, folder)) {
    const Run run = run_program(arguments);
    INFO(arguments[0] << " " << picture << ": " << run.err);
    CHECK(run.code == 0);
    CHECK(run.out.empty());
  }
  const auto map = read_line_map(folder / "m.xml");
  REQUIRE(map);
  CHECK(map->lines.empty());
  CHECK(bytes_of(folder / "h.csv") == "x0,y0,x1,y1,votes\n");
}

}  // namespace

TEST_CASE("pictures that cannot be opened") {
  const TemporaryFolder folder;
  refused_everywhere((folder / "missing.png").string(), 3, folder);
  refused_everywhere(folder.path().string(), 3, folder);
  CHECK(names_in(folder).empty());
}

TEST_CASE("pictures that are empty, cut short or none") {
  const TemporaryFolder folder;
  refused_everywhere(folder.put("empty.png", "").string(), 5, folder);
  refused_everywhere(folder.put("text.png", "This is no picture.\n").string(), 5, folder);
  refused_everywhere(folder.put("zeros.jpg", std::string(1000, '\0')).string(), 5, folder);
  refused_everywhere(folder.put("short.pgm", room_pgm().substr(0, 20000)).string(), 5, folder);
  const std::string photo = bytes_of(fixture("images/coins.png"));
  refused_everywhere(folder.put("short.png", photo.substr(0, photo.size() / 2)).string(), 5, folder);
}

TEST_CASE("pictures that are too large are refused by their header") {
  const TemporaryFolder folder;
  refused_everywhere(folder.put("huge.pgm", pgm_header(20000, 20000)).string(), 5, folder);
  refused_everywhere(
      folder.put("huge.png", png_maker::png(20000, 20000, 8, png_maker::gray, "none")).string(), 5, folder);
  refused_everywhere(folder.put("endless.pgm", "P5\n99999999999999999999 1\n255\n").string(), 5, folder);
  refused_everywhere(folder.put("wide.pgm", pgm(40000, 2, 200)).string(), 5, folder);
}

TEST_CASE("too little memory gives a sentence, not a crash") {
#if !defined(__SANITIZE_ADDRESS__)
  const TemporaryFolder folder;
  const std::string picture = folder.put("large.pgm", pgm(3000, 3000, 0)).string();
  const std::vector<std::vector<std::string>> commands = {
      {"edges", picture, "-o", (folder / "e.png").string()},
      {"hough", picture, "--csv", (folder / "h.csv").string()},
      {"lines", picture, "-o", (folder / "m.xml").string()}};
  for (const std::size_t megabytes : {20u, 40u, 80u, 120u, 160u}) {
    for (const auto& arguments : commands) {
      const Run run = run_program(arguments, {.address_space = megabytes << 20});
      INFO(arguments[0] << " in " << megabytes << " MB: " << run.code << " " << run.err);
      CHECK((run.code == 0 || run.code == 3 || run.code == 70));
      if (run.code != 0) CHECK(run.err.starts_with("straightedge: "));
      if (run.code != 0) CHECK(run.err.find(picture) != std::string::npos);
      if (run.code != 0) CHECK(run.err.find("memory") != std::string::npos);
    }
  }
#endif
}

TEST_CASE("pictures with nothing in them") {
  const TemporaryFolder folder;
  const auto [width, height] =
      GENERATE(std::pair{1, 1}, std::pair{1, 57}, std::pair{57, 1}, std::pair{64, 48});
  for (const int value : {0, 128, 255}) {
    // A binary image that is white has an edge in every pixel, so the raw transform wants a black one.
    const std::string picture = folder.put("blank.pgm", pgm(width, height, value)).string();
    const auto readers = readers_of(picture, folder);
    for (const auto& arguments : readers) {
      const Run run = run_program(arguments);
      INFO(arguments[0] << " " << width << " x " << height << " of " << value << ": " << run.err);
      CHECK(run.code == 0);
    }
    CHECK(read_line_map(folder / "m.xml")->lines.empty());
  }
  empty_everywhere(folder.put("black.pgm", pgm(width, height, 0)).string(), folder);
}

TEST_CASE("16-bit pictures and colour with alpha are read") {
  const TemporaryFolder folder;
  constexpr int width = 90, height = 60;
  std::string deep, colour;
  for (int y = 0; y < height; ++y) {
    deep += '\0';
    colour += '\0';
    for (int x = 0; x < width; ++x) {
      const bool wall = x >= 20 && x < 70 && y >= 25 && y < 35;
      const char level = static_cast<char>(wall ? 10 : 250);
      deep += std::string{level, '\x7F'};
      colour += std::string{level, level, level, static_cast<char>(x)};
    }
  }
  const auto lines_of = [&](const std::string& name, const std::string& bytes) {
    const std::string picture = folder.put(name, bytes).string();
    const Run run = run_program({"lines", picture, "-o", "-", "--quiet", "--name", "same", "--picture", "map",
                                 "--furniture-size", "0"});
    INFO(run.err);
    CHECK(run.code == 0);
    CHECK(run.out.find("<line ") != std::string::npos);
    return run.out.substr(run.out.find("<line "));
  };
  const std::string from_deep =
      lines_of("deep.png", png_maker::png(width, height, 16, png_maker::gray, deep));
  CHECK(from_deep == lines_of("alpha.png", png_maker::png(width, height, 8, png_maker::rgb_alpha, colour)));
}

TEST_CASE("ROS maps that are wrong name the file that is") {
  const TemporaryFolder folder;
  const std::string head =
      "resolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.2\n";
  const std::string xml = (folder / "m.xml").string();
  const auto refuse = [&](const std::string& yaml, int code, const std::string& name) {
    const std::string map = folder.put("map.yaml", yaml).string();
    const auto before = names_in(folder);
    refusal(run_program({"lines", map, "-o", xml}), code, name);
    CHECK(names_in(folder) == before);
  };
  refuse("", 5, "map.yaml");
  refuse("image: [", 5, "map.yaml");
  refuse(head, 5, "map.yaml");
  refuse("image: gone.png\n" + head, 3, "gone.png");
  folder.put("text.png", "no picture");
  refuse("image: text.png\n" + head, 5, "text.png");
  refuse("image: text.png\nresolution: .nan\n" + head, 5, "map.yaml");
  refusal(run_program({"lines", (folder / "none.yaml").string(), "-o", xml}), 3, "none.yaml");
}
