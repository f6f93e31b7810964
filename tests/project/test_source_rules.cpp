// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <fstream>

#include "source_rules.hpp"
#include "support/catch.hpp"

namespace {

namespace fs = std::filesystem;

const std::string spdx =
    "// SPDX-FileCopyrightText: 2026 Straightedge contributors\n// SPDX-License-Identifier: MIT\n";

/// A small source tree in a folder of its own that goes away with the object.
class SampleTree {
 public:
  SampleTree() : root_(fs::temp_directory_path() / ("straightedge-rules-" + std::to_string(getpid()))) {
    fs::remove_all(root_);
    write("CMakeLists.txt", spdx);
    write("include/straightedge/image.hpp", spdx);
    write("include/straightedge/canny.hpp", spdx + "#include \"straightedge/image.hpp\"\n");
    write("include/straightedge/host/map_file.hpp", spdx + "#include <string>\n");
    write("include/straightedge/host/canny.hpp",
          spdx + "#include <memory>\n#include \"straightedge/canny.hpp\"\n");
    write("src/canny/canny.cpp", spdx + "#include \"straightedge/canny.hpp\"\n#include <cstdint>\n");
    write("src/io/map_file.cpp", spdx + "#include <tinyxml2.h>\n#include \"straightedge/image.hpp\"\n");
  }
  ~SampleTree() { fs::remove_all(root_); }
  SampleTree(const SampleTree&) = delete;
  SampleTree& operator=(const SampleTree&) = delete;

  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((root_ / name).parent_path());
    std::ofstream(root_ / name) << text;
  }
  const fs::path& root() const { return root_; }

 private:
  fs::path root_;
};

std::string listed(const std::vector<project::Breach>& breaches) {
  std::string text;
  for (const auto& breach : breaches) {
    text += breach.file + ":" + std::to_string(breach.line) + ": " + breach.sentence + "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("modules include only what the table of the tree allows") {
  CHECK(listed(project::include_breaches(STRAIGHTEDGE_ROOT)) == "");
}

TEST_CASE("every file has its licence lines, its size and no unfinished mark") {
  CHECK(listed(project::shape_breaches(STRAIGHTEDGE_ROOT)) == "");
}

TEST_CASE("a tree that keeps the rules has no breach") {
  const SampleTree tree;
  CHECK(listed(project::include_breaches(tree.root())) == "");
  CHECK(listed(project::shape_breaches(tree.root())) == "");
}

TEST_CASE("each include that is not allowed is found") {
  const SampleTree tree;
  const auto [file, line] = GENERATE(table<std::string, std::string>({
      {"src/canny/bad.cpp", "#include <vector>"},
      {"src/canny/bad.cpp", "#include <cmath>"},
      {"src/canny/bad.cpp", "  #  include <string>"},
      {"src/canny/bad.cpp", "#include \"straightedge/host/map_file.hpp\""},
      {"src/canny/bad.cpp", "#include <immintrin.h>"},
      {"src/base/bad.cpp", "#include \"straightedge/canny.hpp\""},
      {"src/base/bad.cpp", "#include \"canny/canny.cpp\""},
      {"src/base/bad.cpp", "#include \"nowhere.hpp\""},
      {"src/map/bad.cpp", "#include <tinyxml2.h>"},
      {"src/map/bad.cpp", "#include \"straightedge/host/map_file.hpp\""},
      {"src/io/bad.cpp", "#include <opencv2/core.hpp>"},
      {"src/io/bad.cpp", "#include <CLI/CLI.hpp>"},
      {"src/cli/bad.cpp", "#include <opencv2/core.hpp>"},
      {"src/novel/bad.cpp", ""},
      {"include/straightedge/bad.hpp", "#include <functional>"},
      {"include/straightedge/bad.hpp", "#include \"straightedge/canny.hpp\""},
      {"include/straightedge/host/bad.hpp", "#include <Eigen/Dense>"},
      {"include/straightedge/host/bad.hpp", "#include \"straightedge/absent.hpp\""},
  }));
  CAPTURE(file, line);
  tree.write(file, spdx + line + "\n");
  const auto breaches = project::include_breaches(tree.root());
  REQUIRE(breaches.size() == 1);
  CHECK(breaches[0].file == file);
}

TEST_CASE("each breach of shape is found") {
  const SampleTree tree;
  const auto lines = [](int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += "  work();\n";
    return text;
  };
  const auto [file, text] = GENERATE_COPY(table<std::string, std::string>({
      {"src/canny/bad.cpp", "int x;\n"},
      {"scripts/bad.sh", "#!/bin/sh\n\n" + spdx},
      {"src/canny/bad.cpp", spdx + lines(299)},
      {"include/straightedge/bad.hpp", spdx + lines(149)},
      {"src/canny/bad.cpp", spdx + "void f(int a,\n       int b) {\n" + lines(58) + "}\n"},
      {"src/canny/bad.cpp", spdx + std::string("// TO") + "DO\n"},
  }));
  CAPTURE(file, text);
  tree.write(file, text);
  const auto breaches = project::shape_breaches(tree.root());
  REQUIRE(breaches.size() == 1);
  CHECK(breaches[0].file == file);

  // One line less is within the limits.
  if (text.ends_with("work();\n")) {
    tree.write(file, text.substr(0, text.rfind("  work")));
    CHECK(listed(project::shape_breaches(tree.root())) == "");
  }
}
