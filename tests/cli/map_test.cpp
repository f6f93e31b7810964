// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/random_line_map.hpp"
#include "run_program.hpp"
#include "straightedge/host/map_file.hpp"
#include "support/catch.hpp"
#include "support/replaced.hpp"

using namespace straightedge;

namespace {

std::string good() {
  return *line_map_to_xml(small_line_map());
}

/// Both commands that read maps refuse it; nothing is left behind.
void refused(const std::string& xml, const std::string& words, int code = 5) {
  const TemporaryFolder folder;
  const std::string file = folder.put("bad.xml", xml).string();
  INFO(words);
  CHECK(refusal(run_program({"validate", file}), code, file).find(words) != std::string::npos);
  CHECK(refusal(run_program({"show", file, "-o", (folder / "m.svg").string()}), code, file).find(words) !=
        std::string::npos);
  CHECK(names_in(folder) == std::vector<std::string>{"bad.xml"});
}

}  // namespace

TEST_CASE("maps that are wrong") {
  refused("", "empty");
  refused("no xml", "");
  refused(good().substr(0, good().size() / 2), "not well-formed");
  refused(replaced(good(), "version=\"1\" kind", "version=\"2\" kind"), "newer version");
  refused(replaced(good(), "kind=\"lines\"", "kind=\"rooms\""), "kind");
  refused(replaced(good(), "kind=\"lines\"", "kind=\"planes\""), "");
  refused("<svg/>", "is not a straightedge-map");
  refused(replaced(good(), "rho=\"101.25\"", "rho=\"nan\""), "line 3");
  refused(replaced(good(), "<line id=\"5\"", "<line id=\"3\""), "another line has the same id");
  refused(replaced(good(), "var-theta=\"2.9e-06\"", "var-theta=\"-1\""), "positive semi-definite");
  refused(replaced(good(), "y1=\"101.25\" pixels=\"30\"", "y1=\"101.5\""), "off its line");
  refused("<!DOCTYPE map>" + good(), "document type");
}

TEST_CASE("maps that are missing") {
  const TemporaryFolder folder;
  const std::string file = (folder / "none.xml").string();
  refusal(run_program({"validate", file}), 3, file);
  refusal(run_program({"show", file, "-o", (folder / "m.svg").string()}), 3, file);
  refusal(run_program({"validate", folder.path().string()}), 3, folder.path().string());
}

TEST_CASE("validate tells every breach, a line each") {
  const TemporaryFolder folder;
  std::string text = replaced(good(), "rho=\"101.25\"", "rho=\"-101.25\"");
  text = replaced(text, "x0=\"20\"", "x0=\"21\"");
  const std::string file = folder.put("bad.xml", text).string();
  const Run run = run_program({"validate", file});
  CHECK(run.code == 5);
  CHECK(run.out.empty());
  CHECK(run.err == "straightedge: " + file + ":6: line 3: rho is negative (-101.25)\n" +
                       "straightedge: " + file + ":12: line 5, segment 12: an end lies 1 off its line\n");
}

TEST_CASE("a good map is valid and drawn") {
  const TemporaryFolder folder;
  const std::string file = folder.put("good.xml", good()).string();
  const Run run = run_program({"validate", file});
  CHECK(run.code == 0);
  CHECK(run.out.empty());
  CHECK(run.err == file + ": valid, 2 lines, 3 segments\n");
  CHECK(run_program({"validate", file, "--quiet"}).err.empty());
  const std::string svg = (folder / "m.svg").string();
  CHECK(run_program({"show", file, "-o", svg}).code == 0);
  CHECK(bytes_of(svg).find("<svg") != std::string::npos);
  CHECK(run_program({"show", file, "-o", "-", "--quiet"}).out == bytes_of(svg));
  CHECK(run_program({"show", "-", "-o", "-", "--quiet"}, {.standard_input = file}).out == bytes_of(svg));
}
