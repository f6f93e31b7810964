// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <set>

#include "run_program.hpp"
#include "support/catch.hpp"

namespace {

const std::vector<std::string> commands = {"edges",    "hough", "lines", "explain", "planes",
                                           "localize", "merge", "show",  "validate"};

struct HelpOption {
  std::string name;   ///< "--low"
  std::string whole;  ///< all of its lines
};

/// The options of a help text: a line that begins with a dash in column 2, and those below it that are
/// indented.
std::vector<HelpOption> options_of(const std::string& help) {
  std::vector<HelpOption> options;
  std::size_t at = 0;
  while (at < help.size()) {
    const std::size_t end = help.find('\n', at);
    const std::string line = help.substr(at, end - at);
    at = end + 1;
    if (line.starts_with("  -")) {
      const std::size_t name = line.find("--");
      options.push_back({line.substr(name, line.find_first_of(" =", name) - name), line});
    } else if (line.starts_with("   ") && !options.empty()) {
      options.back().whole += line;
    }
  }
  return options;
}

}  // namespace

TEST_CASE("help and version are data") {
  for (const std::string& command : commands) {
    const Run help = run_program({command, "--help"});
    CHECK(help.code == 0);
    CHECK(help.err.empty());
    CHECK(help.out.find("Exit codes: 0 done") != std::string::npos);
    const Run version = run_program({command, "--version"});
    CHECK(version.code == 0);
    CHECK(version.out == "straightedge " STRAIGHTEDGE_VERSION "\n");
  }
  CHECK(run_program({"--version"}).out == "straightedge " STRAIGHTEDGE_VERSION "\n");
  const std::string help = run_program({"--help"}).out;
  for (const std::string& command : commands) CHECK(help.find("\n  " + command + " ") != std::string::npos);
}

TEST_CASE("every option is in the help with its unit and default") {
  const std::set<std::string> flags = {"--help",   "--quiet",  "--json",   "--version",
                                       "--l2",     "--metres", "--negate", "--auto-thresholds",
                                       "--strict", "--fast"};
  const std::set<std::string> without_default = {
      "--output",      "--svg",     "--png",           "--csv",    "--name",
      "--description", "--created", "--labels",        "--ply",    "--ply-polygons",
      "--html",        "--leaves",  "--leaves-output", "--camera", "--trajectory",
      "--covariance",  "--truth",   "--explain",       "--start",  "--laser"};
  for (const std::string& command : commands) {
    const auto options = options_of(run_program({command, "--help"}).out);
    std::set<std::string> names;
    for (const HelpOption& option : options) {
      INFO(command << ": " << option.whole);
      names.insert(option.name);
      if (flags.contains(option.name)) continue;
      const std::size_t unit = option.whole.find(option.name) + option.name.size() + 1;
      CHECK((std::isupper(static_cast<unsigned char>(option.whole[unit])) != 0 ||
             option.whole.find('|') != std::string::npos || option.name == "--aperture"));
      if (!without_default.contains(option.name)) CHECK(option.whole.find('=') != std::string::npos);
    }
    for (const char* everywhere : {"--seed", "--quiet", "--json", "--version", "--help"}) {
      CHECK(names.contains(everywhere));
    }
  }
}

TEST_CASE("the reference names every command and every option") {
  const std::string page = bytes_of(STRAIGHTEDGE_DOCS "/program.md");
  REQUIRE_FALSE(page.empty());
  for (const std::string& command : commands) {
    const std::size_t from = page.find("\n## `" + command);
    INFO(command);
    REQUIRE(from != std::string::npos);
    const std::string section = page.substr(from, page.find("\n## ", from + 1) - from);
    const std::string common = page.substr(page.find("\n## Everywhere"));
    for (const HelpOption& option : options_of(run_program({command, "--help"}).out)) {
      INFO(command << " " << option.name);
      const std::string quoted = "`" + option.name;
      CHECK((section.find(quoted) != std::string::npos || common.find(quoted) != std::string::npos));
    }
  }
}
