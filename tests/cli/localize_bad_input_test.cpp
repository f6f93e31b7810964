// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "localize_run.hpp"
#include "straightedge/host/map_file.hpp"
#include "support/catch.hpp"
#include "support/replaced.hpp"

using namespace straightedge;
using namespace localize_run;

namespace {

const std::string scan_1 = "SCAN 1 0 0 0 3 1 80 3 1 2 3\n";

/// A map, a log, and a run that must be refused and leave nothing behind.
struct BadRun : MapFolder {
  BadRun() { put("scans.txt", scan_1); }
  std::string scans() const { return file("scans.txt"); }

  std::string refused(int code, const std::string& name, const std::vector<std::string>& more = {}) const {
    const std::vector<std::string> before = names_in(*this);
    std::vector<std::string> arguments = {"localize", map(), scans(), "-o", file("t.txt")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const std::string sentence = refusal(run_program(arguments), code, name);
    CHECK(names_in(*this) == before);
    return sentence;
  }
  void refused_scans(const std::string& text, const std::string& words) const {
    put("scans.txt", text);
    CHECK(refused(5, "scans.txt").find(words) != std::string::npos);
  }
  void refused_map(const std::string& xml, const std::string& words) const {
    put("map.xml", xml);
    CHECK(refused(5, "map.xml").find(words) != std::string::npos);
  }
};

}  // namespace

TEST_CASE("logs that are none, each in one sentence with the line") {
  const BadRun run;
  run.refused_scans("", "holds no laser scan");
  run.refused_scans("ODOM 1 2 3 4\n", "holds no laser scan");
  run.refused_scans(std::string(1000, '\xFF'), "holds no laser scan");
  run.refused_scans(scan_1 + "SCAN 2 0 0 0 3 1 80 3 1 2\n", "line 2: the record ends before its range");
  run.refused_scans(scan_1 + "SCAN 2 0 0 0 3 1 80 nan 1 2\n", "line 2: the number of beams is 'nan'");
  run.refused_scans(scan_1 + "SCAN 2 0 0 0 3 1 80 4000000000 1 2\n",
                    "line 2: the number of beams is '4000000000'");
  run.refused_scans(scan_1 + "SCAN 0 0 0 0 3 1 80 3 1 2 3\n", "line 2: time 0 comes after 1");
  run.refused_scans("FLASER 2 1 2 0 0 0 0 0 0 5 h 5\nFLASER 2 1 2 0 0 0 0 0 0 2 h 5\n",
                    "line 2: time 2 comes after 5");
  run.refused_scans(scan_1 + "hello\n", "line 2: 'hello' is no record");
  const std::string packed = bytes_of(corridor);
  run.refused_scans(packed.substr(0, packed.size() / 2), "is cut short");
  std::string damaged = packed;
  damaged[packed.size() / 2] ^= 0x55;
  run.refused_scans(damaged, "gzip data");
  std::filesystem::remove(run.scans());
  run.refused(3, "scans.txt");
}

TEST_CASE("maps that no robot can be found in") {
  const BadRun run;
  const std::string good = bytes_of(run.map());
  std::string pixels = good;
  const std::size_t resolution = pixels.find(" resolution=");
  pixels.erase(resolution, pixels.find("/>", resolution) - resolution);
  run.refused_map(pixels, "does not say how many metres a pixel is");
  LineMap empty = *line_map_from_xml(good, "map.xml");
  empty.lines.clear();
  run.refused_map(*line_map_to_xml(empty), "holds no line to localize by");
  run.refused_map("<map", "");
  run.refused_map(replaced(good, "kind=\"lines\"", "kind=\"planes\""), "");
  std::filesystem::remove(run.map());
  run.refused(3, "map.xml");
}

TEST_CASE("a truth that is none") {
  const BadRun run;
  const std::string file = run.file("truth.txt");
  run.put("truth.txt", "1 2 3 4\n2 3 4\n");
  CHECK(run.refused(5, file, {"--truth", file}).find("line 2: has 3 numbers") != std::string::npos);
  run.put("truth.txt", "");
  run.refused(5, file, {"--truth", file});
  run.refused(3, "none.txt", {"--truth", run.file("none.txt")});
}

TEST_CASE("options of localize that are out of range or do not fit") {
  const BadRun run;
  for (const auto& [option, value] :
       {std::pair("--start", "1 2"), std::pair("--start", "1 2 3 4"), std::pair("--start", "nan 0 0"),
        std::pair("--start", "1 2 x"), std::pair("--start", "2e8 0 0"), std::pair("--start", "0 0 1e5"),
        std::pair("--laser", ""), std::pair("--laser", "inf 0 0"), std::pair("--max-range", "-1"),
        std::pair("--max-range", "nan"), std::pair("--noise", "0"), std::pair("--noise", "2"),
        std::pair("--lines", "lsd"), std::pair("--association", "x"), std::pair("--gate", "0"),
        std::pair("--odometry", "x"), std::pair("--min-length", "0"), std::pair("--explain-scan", "-1"),
        std::pair("--seed", "-1")})
    run.refused(2, option, {option, value});
  for (const char* sigma : {"0 1", "1 0", "-1 1", "1", "1 2 3", "101 1", "1 181", "nan 1"})
    run.refused(2, "--start-sigma", {"--start", "0 0 0", "--start-sigma", sigma});
  run.refused(2, "--start-sigma", {"--start-sigma", "1 1"});
  run.refused(2, "--explain-scan", {"--explain-scan", "1"});
  run.refused(2, "--explain-scan", {"--explain", run.file("ex"), "--explain-scan", "2"});
  run.refused(2, "scans.txt", {"--odometry", "flaser"});
  refusal(run_program({"localize", "-", "-", "-o", run.file("t.txt")}), 2, "standard input");
  refusal(run_program({"localize", run.map(), run.scans()}), 2, "--output");
}

TEST_CASE("outputs of localize that cannot be, before any work") {
  const BadRun run;
  run.refused(2, "r.png", {"--svg", run.file("r.png")});
  run.refused(2, "t.txt", {"--covariance", run.file("t.txt")});
  run.refused(2, "scans.txt", {"--covariance", run.scans()});
  run.refused(2, "map.xml", {"--covariance", run.map()});
  run.put("truth.txt", "1 0 0 0\n");
  run.refused(2, "truth.txt", {"--truth", run.file("truth.txt"), "--covariance", run.file("truth.txt")});
  run.refused(4, "none", {"--covariance", run.file("none/c.txt")});
  run.refused(2, "--json", {"--covariance", "-", "--json"});
  run.refused(4, "scans.txt", {"--explain", run.scans()});
}
