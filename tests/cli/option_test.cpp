// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "run_program.hpp"
#include "straightedge/host/kernels.hpp"
#include "straightedge/host/map_file.hpp"
#include "support/catch.hpp"

namespace {

/// Refuses as usage, names the option, leaves nothing behind.
void refused(const std::vector<std::string>& arguments, const std::string& option) {
  const TemporaryFolder folder;
  const std::string picture = folder.put("room.pgm", room_pgm()).string();
  std::vector<std::string> whole = {arguments[0], picture};
  whole.insert(whole.end(), arguments.begin() + 1, arguments.end());
  const std::string command = arguments[0];
  if (command == "edges") whole.insert(whole.end(), {"-o", (folder / "e.png").string()});
  if (command == "lines") whole.insert(whole.end(), {"-o", (folder / "m.xml").string()});
  std::string line;
  for (const std::string& word : whole) line += word + " ";
  INFO(line);
  refusal(run_program(whole), 2, option);
  CHECK(names_in(folder) == std::vector<std::string>{"room.pgm"});
}

}  // namespace

TEST_CASE("numbers that are none, or out of their range") {
  for (const std::string text :
       {"nan", "inf", "-inf", "NaN", "50x", "5O", "", " ", "1e999", "0x10", "50,5", "--high"}) {
    refused({"edges", "--low", text}, "--low");
    refused({"lines", "--max-gap", text}, "--max-gap");
    refused({"hough", "--rho", text}, "--rho");
  }
  for (const std::string text : {"-1", "1.5", "nan", "18446744073709551616", "1e3", ""}) {
    refused({"edges", "--seed", text}, "--seed");
    refused({"edges", "--threads", text}, "--threads");
    refused({"lines", "--threshold", text}, "--threshold");
  }
  refused({"edges", "--sigma", "-0.1"}, "--sigma");
  refused({"edges", "--sigma", "50.1"}, "--sigma");
  refused({"edges", "--low", "-1"}, "--low");
  refused({"edges", "--aperture", "4"}, "--aperture");
  refused({"edges", "--threads", "1025"}, "--threads");
  refused({"lines", "--min-length", "2.9"}, "--min-length");
  refused({"lines", "--window", "181"}, "--window");
  refused({"lines", "--resolution", "0"}, "--resolution");
  refused({"lines", "--resolution", "-0.05"}, "--resolution");
  refused({"lines", "--picture", "painting"}, "--picture");
  refused({"hough", "--threshold", "0"}, "--threshold");
  refused({"hough", "--threshold", "2147483648"}, "--threshold");
  refused({"hough", "--theta", "0"}, "--theta");
  refused({"hough", "--method", "best"}, "--method");
  refused({"hough", "--method", "randomized", "--confidence", "1"}, "--confidence");
}

TEST_CASE("the sentence for a number says the range") {
  const Run run = run_program({"edges", fixture("images/coins.png"), "-o", "-", "--sigma", "99"});
  CHECK(run.err == "straightedge: --sigma: \"99\" is not a number 0 to 50 (see straightedge edges --help)\n");
}

TEST_CASE("origins are two numbers and an angle") {
  for (const std::string text :
       {"", "1", "1,2", "1,2,3,4", "1,2,nan", "a,b,c", "1,2,361", "1;2;3", "1,2,3,"}) {
    refused({"lines", "--resolution", "0.05", "--origin", text}, "--origin");
  }
}

TEST_CASE("options that contradict each other or the input") {
  refused({"edges", "--low", "200", "--high", "100"}, "--low 200 is above --high 100");
  refused({"edges", "--low", "160"}, "--low 160 is above --high 150");
  refused({"lines", "--low", "200", "--high", "100"}, "--low 200 is above --high 100");
  refused({"edges", "--auto-thresholds", "--low", "20"}, "--auto-thresholds");
  refused({"lines", "--origin", "1,2,3"}, "--origin needs --resolution");
  refused({"lines", "--metres"}, "--metres needs --resolution");
  refused({"lines", "--threshold", "20"}, "--threshold is not for --method follow");
  refused({"lines", "--window", "20", "--method", "follow"}, "--window is not for --method follow");
  refused({"lines", "--fast", "--method", "progressive"}, "--fast is for --method follow alone");
  refused({"hough", "--method", "standard", "--min-theta", "2", "--max-theta", "1"}, "--min-theta");
  refused({"hough", "--method", "standard", "--min-length", "20"},
          "--min-length is not for --method standard");
  refused({"hough", "--generator", "opencv", "--method", "randomized"}, "--generator is not for");
  refused({"hough", "--pair-radius", "20"}, "--pair-radius is not for --method progressive");
  refused({"hough", "--method", "randomized", "--pair-radius", "5"}, "--pair-min-distance 10 is not below");
  const std::string map = fixture("maps/mrpt/map.yaml");
  const TemporaryFolder folder;
  const std::string xml = (folder / "m.xml").string();
  refusal(run_program({"lines", map, "-o", xml, "--resolution", "0.1"}), 2, "--resolution");
  refusal(run_program({"lines", map, "-o", xml, "--negate"}), 2, "--negate");
  refusal(run_program({"lines", map, "-o", xml, "--picture", "photo"}), 2, "--picture");
  CHECK(names_in(folder).empty());
}

TEST_CASE("arguments that are missing, unknown or given twice") {
  refusal(run_program({}), 2, "straightedge --help");
  refusal(run_program({"draw"}), 2, "draw");
  refusal(run_program({"lines"}), 2, "IMAGE|MAP.yaml is required");
  refusal(run_program({"lines", "a.png"}), 2, "--output");
  refused({"edges", "--what"}, "--what");
  refused({"edges", "--low", "10", "--low", "20"}, "--low");
  refused({"edges", "second.png"}, "second.png");
}

TEST_CASE("an accumulator without end is refused") {
  const TemporaryFolder folder;
  const std::string picture = folder.put("room.pgm", room_pgm()).string();
  const Run run = run_program({"hough", picture, "--rho", "0.001", "--theta", "0.00001"});
  refusal(run, 5, picture);
}

TEST_CASE("a minimum length beyond the picture gives an empty result") {
  const TemporaryFolder folder;
  const std::string picture = folder.put("room.pgm", room_pgm()).string();
  const std::string xml = (folder / "m.xml").string(), edges = (folder / "e.png").string();
  CHECK(run_program({"lines", picture, "-o", xml, "--min-length", "5000"}).code == 0);
  const auto map = straightedge::read_line_map(xml);
  REQUIRE(map);
  CHECK(map->lines.empty());
  CHECK(run_program({"edges", picture, "-o", edges}).code == 0);
  for (const std::string method : {"progressive", "randomized"}) {
    const Run run = run_program({"hough", edges, "--method", method, "--min-length", "5000"});
    CHECK(run.code == 0);
    CHECK(run.out == "x0,y0,x1,y1,votes\n");
  }
}

TEST_CASE("numbers are read and written alike in a locale with decimal commas") {
  const TemporaryFolder folder;
  const std::string picture = folder.put("room.pgm", room_pgm()).string();
  const std::vector<std::string> arguments = {"lines", picture, "-o", "-", "--sigma", "1.25", "--quiet"};
  const Run plain = run_program(arguments);
  CHECK(plain.code == 0);
  const Run german = run_program(arguments, {.locale = "de_DE.UTF-8"});
  CHECK(german.code == 0);
  CHECK(german.out == plain.out);
  CHECK(plain.out.find("sigma 1.25") != std::string::npos);
}

TEST_CASE("kernels are forced by name, and no picture changes") {
  const std::string picture = fixture("images/coins.png");
  const std::vector<std::string> arguments = {"edges", picture, "-o", "-", "--low", "30", "--high", "90"};
  const Run best = run_program(arguments);
  CHECK(best.code == 0);
  for (const straightedge::KernelSet& set : straightedge::kernel_sets()) {
    const Run forced = run_program(arguments, {.kernels = std::string(set.name)});
    CHECK(forced.code == 0);
    CHECK(forced.out == best.out);
    CHECK(forced.err.find("; kernels " + std::string(set.name) + ")") != std::string::npos);
  }
  for (const std::string command : {"edges", "lines"}) {
    const Run unknown = run_program({command, picture, "-o", "-"}, {.kernels = "mmx"});
    CHECK(refusal(unknown, 2, "STRAIGHTEDGE_KERNELS").find("\"mmx\"; it has plain") != std::string::npos);
  }
}

TEST_CASE("any number of threads gives the same picture of edges") {
  const std::string picture = fixture("images/building.jpg");
  const Run one = run_program({"edges", picture, "-o", "-"});
  REQUIRE(one.code == 0);
  for (const std::string threads : {"0", "1", "2", "7", "1024"}) {
    const Run run = run_program({"edges", picture, "-o", "-", "--threads", threads});
    CHECK(run.code == 0);
    CHECK(run.out == one.out);
    CHECK(run.err == one.err);
  }
}
