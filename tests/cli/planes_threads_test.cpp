// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "planes_room.hpp"
#include "straightedge/host/depth_file.hpp"
#include "straightedge/host/kernels.hpp"
#include "support/catch.hpp"

namespace {

const std::vector<std::string> thread_counts = {"1", "2", "3", "8", "0"};

/// All that a run gives back: bytes of files, words, numbers.
struct Outcome {
  int code = 0;
  std::string out, err, xml, leaves, label;

  bool operator==(const Outcome&) const = default;
};

Outcome outcome_of(const TemporaryFolder& folder, const std::string& threads,
                   const std::vector<std::string>& more = {}, const RunSettings& settings = {}) {
  const std::string xml = (folder / "m.xml").string(), leaves = (folder / "m.leaves").string();
  const std::string labels = (folder / "labels").string();
  std::vector<std::string> arguments = {"planes",   (folder / "room").string(),
                                        "-o",       xml,
                                        "--leaves", leaves,
                                        "--labels", labels,
                                        "--json",   "--threads",
                                        threads};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Run run = run_program(arguments, settings);
  Outcome outcome{run.code,      run.out,          run.err,
                  bytes_of(xml), bytes_of(leaves), bytes_of(folder / "labels" / "1.png")};
  for (const char* name : {"m.xml", "m.leaves", "labels"}) std::filesystem::remove_all(folder / name);
  return outcome;
}

}  // namespace

TEST_CASE("any number of threads gives the same bytes") {
  const TemporaryFolder folder;
  planes_room::write_sequence(folder / "room");
  const Outcome one = outcome_of(folder, "1");
  CHECK(one.code == 0);
  CHECK(one.xml.find("<plane ") != std::string::npos);
  CHECK_FALSE(one.leaves.empty());
  CHECK_FALSE(one.label.empty());
  CHECK(nlohmann::json::parse(one.out)["frames"] == planes_room::frames);
  for (const std::string& threads : thread_counts) {
    INFO(threads);
    CHECK(outcome_of(folder, threads) == one);
  }
}

TEST_CASE("any set of kernels gives the same bytes") {
  const TemporaryFolder folder;
  planes_room::write_sequence(folder / "room");
  const Outcome best = outcome_of(folder, "1");
  for (const straightedge::KernelSet& set : straightedge::kernel_sets()) {
    INFO(set.name);
    CHECK(outcome_of(folder, "2", {}, {.kernels = std::string(set.name)}) == best);
  }
}

TEST_CASE("a broken frame in the middle is told the same by any number of threads") {
  const TemporaryFolder folder;
  planes_room::write_sequence(folder / "room");
  folder.put("room/depth/2.png", "no picture");
  folder.put("room/depth/4.png", "");
  const Outcome skipped = outcome_of(folder, "1");
  CHECK(skipped.code == 0);
  CHECK(nlohmann::json::parse(skipped.out)["skipped"].size() == 2);
  CHECK(skipped.err.find("2.png") < skipped.err.find("4.png"));
  const Outcome strict = outcome_of(folder, "1", {"--strict"});
  CHECK(strict.code == 5);
  CHECK(strict.err.find("2.png") != std::string::npos);
  CHECK(strict.xml.empty());
  for (const std::string& threads : thread_counts) {
    INFO(threads);
    CHECK(outcome_of(folder, threads) == skipped);
    CHECK(outcome_of(folder, threads, {"--strict"}) == strict);
  }
}

TEST_CASE("the first good frame says the size, whatever comes before it") {
  const TemporaryFolder folder;
  planes_room::write_sequence(folder / "room");
  folder.put("room/depth/0.png", "no picture");
  straightedge::Image<std::uint16_t> small({8, 6}, 1000);
  REQUIRE(straightedge::write_png16(folder / "room" / "depth" / "3.png", small));
  const Outcome one = outcome_of(folder, "1");
  CHECK(one.code == 0);
  CHECK(nlohmann::json::parse(one.out)["skipped"].size() == 2);
  for (const std::string& threads : thread_counts) CHECK(outcome_of(folder, threads) == one);
}
