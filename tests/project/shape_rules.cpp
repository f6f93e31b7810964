// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "source_rules.hpp"

namespace project {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_file = 300;
constexpr std::size_t longest_public_header = 150;
constexpr std::size_t longest_function = 60;

bool has_licence_lines(const std::vector<std::string>& lines) {
  const std::size_t head = std::min<std::size_t>(lines.size(), 3);  // a script has its interpreter first
  bool copyright = false, licence = false;
  for (std::size_t i = 0; i < head; ++i) {
    copyright = copyright || lines[i].find("SPDX-FileCopyrightText: ") != std::string::npos;
    licence = licence || lines[i].find("SPDX-License-Identifier: MIT") != std::string::npos;
  }
  return copyright && licence;
}

// The format of the code puts a function's first line and its closing brace at column 0, its body further
// right, so that counting lines needs no parser.
void check_functions(const std::string& name, const std::vector<std::string>& lines,
                     std::vector<Breach>& breaches) {
  std::size_t start = 0;
  bool in_body = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    if (line.empty() || line[0] == '#' || line.starts_with("//")) continue;
    const bool at_margin = line[0] != ' ' && line[0] != '}';
    if (at_margin && !in_body) start = i;
    if (line.starts_with("namespace")) continue;
    if (line.ends_with("{")) in_body = true;
    if (line[0] != '}') continue;
    if (line == "}" && i + 1 - start > longest_function) {
      breaches.push_back({name, start + 1, "a function of " + std::to_string(i + 1 - start) + " lines"});
    }
    in_body = false;
  }
}

void check_marks(const std::string& name, const std::vector<std::string>& lines,
                 std::vector<Breach>& breaches) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const std::string mark : {"TO"
                                   "DO",
                                   "FIX"
                                   "ME",
                                   "XX"
                                   "X:"}) {
      if (lines[i].find(mark) != std::string::npos) breaches.push_back({name, i + 1, "unfinished: " + mark});
    }
  }
}

}  // namespace

std::vector<Breach> shape_breaches(const fs::path& root) {
  std::vector<Breach> breaches;
  const auto check = [&](const fs::path& file) {
    const std::string name = fs::relative(file, root).generic_string();
    const std::vector<std::string> lines = lines_of(file);
    if (!has_licence_lines(lines)) breaches.push_back({name, 1, "the two SPDX lines are missing"});
    check_marks(name, lines, breaches);
    const bool code = name.ends_with(".cpp") || name.ends_with(".hpp");
    const std::size_t longest = name.starts_with("include/") ? longest_public_header : longest_file;
    if (code && lines.size() > longest) {
      breaches.push_back({name, lines.size(), "longer than " + std::to_string(longest) + " lines"});
    }
    if (name.starts_with("src/") && code) check_functions(name, lines, breaches);
  };
  for (const char* folder : {"src", "include", "tests", "bench", "examples", "firmware", "cmake", "scripts"}) {
    const auto files =
        files_below(root / folder, {".cpp", ".hpp", ".cmake", ".in", ".sh", ".py", "CMakeLists.txt"});
    for (const fs::path& file : files) {
      if (!file.string().ends_with(".pc.in")) check(file);
    }
  }
  check(root / "CMakeLists.txt");
  return breaches;
}

}  // namespace project
