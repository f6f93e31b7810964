// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

#include "run_program.hpp"
#include "straightedge/host/image_file.hpp"
#include "straightedge/host/map_file.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

struct Room {
  TemporaryFolder folder;
  std::string picture = folder.put("room.pgm", room_pgm()).string();

  std::string at(const std::string& name) const { return (folder / name).string(); }
};

}  // namespace

TEST_CASE("outputs that cannot be written") {
  const Room room;
  const std::string far = room.at("no/such/folder/m.xml");
  refusal(run_program({"lines", room.picture, "-o", far}), 4, far);
  refusal(run_program({"lines", room.picture, "-o", room.at("m.xml"), "--svg", room.at("no/m.svg")}), 4,
          "no/m.svg");
  refusal(run_program({"edges", room.picture, "-o", room.at("no/e.png")}), 4, "no/e.png");
  refusal(run_program({"hough", room.picture, "--csv", room.at("no/h.csv")}), 4, "no/h.csv");
  CHECK(names_in(room.folder) == std::vector<std::string>{"room.pgm"});

  std::filesystem::create_directory(room.at("folder.xml"));
  refusal(run_program({"lines", room.picture, "-o", room.at("folder.xml")}), 4, "folder.xml");
  refusal(run_program({"lines", room.picture, "-o", "/dev/full"}), 4, "/dev/full");
  CHECK(names_in(room.folder) == std::vector<std::string>{"folder.xml", "room.pgm"});
}

TEST_CASE("a folder without permission stays as it is") {
  if (::geteuid() == 0) return;  // the superuser may write anywhere
  const Room room;
  std::filesystem::create_directory(room.at("closed"));
  REQUIRE(::chmod(room.at("closed").c_str(), 0500) == 0);
  refusal(run_program({"lines", room.picture, "-o", room.at("closed/m.xml")}), 4, "closed/m.xml");
  CHECK(std::filesystem::is_empty(room.at("closed")));
}

TEST_CASE("a full standard output is an output that cannot be written") {
  const Room room;
  const RunSettings full{.standard_output = "/dev/full"};
  refusal(run_program({"hough", room.picture}, full), 4, "standard output");
  refusal(run_program({"lines", room.picture, "-o", "-"}, full), 4, "standard output");
  refusal(run_program({"lines", room.picture, "-o", room.at("m.xml"), "--json", "--quiet"}, full), 4,
          "standard output");
  refusal(run_program({"--help"}, full), 4, "standard output");
}

TEST_CASE("names of outputs that cannot be meant") {
  const Room room;
  const auto lines = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"lines", room.picture});
    return run_program(more);
  };
  refusal(lines({"-o", room.at("m.json")}), 2, "m.json: the name of the file for --output must end in .xml");
  refusal(lines({"-o", room.at("m")}), 2, "must end in .xml");
  refusal(lines({"-o", room.at("m.xml"), "--svg", room.at("m.pdf")}), 2, "m.pdf");
  refusal(lines({"-o", room.at("m.xml"), "--png", room.at("m.jpg")}), 2, "m.jpg");
  refusal(lines({"-o", ""}), 2, "--output");
  refusal(lines({"-o", "-", "--csv", "-"}), 2, "--csv");
  refusal(lines({"-o", "-", "--json"}), 2, "standard output");
  refusal(run_program({"show", room.at("m.xml"), "-o", room.at("m.pdf")}), 2, "m.pdf");
  refusal(run_program({"show", room.at("m.xml"), "-o", room.at("m")}), 2, "must end in .svg");
  CHECK(names_in(room.folder) == std::vector<std::string>{"room.pgm"});
}

TEST_CASE("an output does not replace an input or another output") {
  const Room room;
  const std::string edges = room.at("e.png");
  REQUIRE(run_program({"edges", room.picture, "-o", edges}).code == 0);
  const std::string before = bytes_of(edges);
  refusal(run_program({"edges", edges, "-o", edges}), 2, "would replace the input");
  refusal(run_program({"lines", edges, "-o", room.at("m.xml"), "--png", room.at("./e.png")}), 2,
          "would replace");
  std::filesystem::create_symlink(edges, room.at("link.png"));
  refusal(run_program({"edges", edges, "-o", room.at("link.png")}), 2, "would replace the input");
  CHECK(bytes_of(edges) == before);
  refusal(run_program({"lines", edges, "-o", room.at("m.xml"), "--csv", room.at("x.csv"), "--svg",
                       room.at("m.svg"), "--png", room.at("m.svg")}),
          2, "m.svg");
  const std::string yaml =
      "image: e.png\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
      "free_thresh: 0.2\n";
  refusal(run_program(
              {"lines", room.folder.put("m.yaml", yaml).string(), "-o", room.at("m.xml"), "--png", edges}),
          2, "would replace the input");
  CHECK(bytes_of(edges) == before);
}

TEST_CASE("a failure leaves an older output as it was") {
  const Room room;
  const std::string old = "the map of last week";
  room.folder.put("m.xml", old);
  const std::string cut = room.folder.put("cut.pgm", room_pgm().substr(0, 9000)).string();
  refusal(run_program({"lines", cut, "-o", room.at("m.xml")}), 5, cut);
  refusal(run_program({"lines", room.picture, "-o", room.at("m.xml"), "--png", room.at("no/m.png")}), 4,
          "no/m.png");
  CHECK(bytes_of(room.at("m.xml")) == old);
}

TEST_CASE("data goes to standard output, words to standard error") {
  const Room room;
  const Run words = run_program({"lines", room.picture, "-o", room.at("m.xml")});
  CHECK(words.code == 0);
  CHECK(words.out.empty());
  CHECK(words.err.find("written   " + room.at("m.xml")) != std::string::npos);
  const Run data = run_program({"lines", room.picture, "-o", "-", "--quiet"});
  CHECK(data.code == 0);
  CHECK(data.err.empty());
  CHECK(data.out == bytes_of(room.at("m.xml")));
  const Run both = run_program({"lines", room.picture, "-o", "-"});
  CHECK(both.out == data.out);
  CHECK_FALSE(both.err.empty());
  const Run png = run_program({"edges", room.picture, "-o", "-", "--quiet"});
  CHECK(png.err.empty());
  CHECK(decode_gray_image(png.out, "edges"));
}

TEST_CASE("a picture may come by standard input") {
  const Room room;
  const Run named = run_program({"lines", room.picture, "-o", "-", "--quiet", "--name", "n"});
  const Run piped =
      run_program({"lines", "-", "-o", "-", "--quiet", "--name", "n"}, {.standard_input = room.picture});
  CHECK(piped.code == 0);
  CHECK(piped.out.substr(piped.out.find("<line ")) == named.out.substr(named.out.find("<line ")));
}

TEST_CASE("strange names of files are names of files") {
  const Room room;
  for (const std::string name : {"a b.xml", "\xC3\xA4.xml", "'\"$(x).xml", "line\nbreak.xml", "100%.xml"}) {
    const Run run = run_program({"lines", room.picture, "-o", room.at(name), "--quiet"});
    INFO(name << ": " << run.err);
    CHECK(run.code == 0);
    CHECK(read_line_map(room.at(name)));
  }
  refusal(run_program({"lines", room.at("no\nsuch.png"), "-o", room.at("m.xml")}), 3, "no?such.png");
}

TEST_CASE("an interrupted run leaves whole files or none") {
  const TemporaryFolder folder;
  const std::string picture = fixture("images/board.jpg");
  const auto at = [&](const std::string& name) { return (folder / name).string(); };
  int interrupted = 0;
  for (int ms = 1; ms <= 120; ms += 3) {
    const Run run =
        run_program({"lines", picture, "-o", at("m.xml"), "--svg", at("m.svg"), "--png", at("m.png")},
                    {.interrupt_after_ms = ms});
    interrupted += run.code == -SIGINT ? 1 : 0;
    CHECK((run.code == 0 || run.code == -SIGINT));
    for (const std::string& name : names_in(folder)) {
      INFO(name << " after " << ms << " ms");
      CHECK((name == "m.xml" || name == "m.svg" || name == "m.png"));
      if (name == "m.xml") CHECK(read_line_map(folder / name));
      if (name == "m.png") CHECK(read_gray_image(folder / name));
      if (name == "m.svg") CHECK(bytes_of(folder / name).find("</svg>") != std::string::npos);
      std::filesystem::remove(folder / name);
    }
  }
  CHECK(interrupted > 0);
}

TEST_CASE("explain makes a folder of its own, or none") {
  const Room room;
  const std::string folder = room.at("pages");
  const Run run = run_program({"explain", room.picture, "-o", folder, "--quiet", "--json"});
  INFO(run.err);
  CHECK(run.code == 0);
  CHECK(run.err.empty());
  CHECK(run.out.find(folder + "/index.html") != std::string::npos);
  const std::string page = bytes_of(folder + "/index.html");
  CHECK(page.find("room.pgm") != std::string::npos);
  CHECK(page.find("straightedge straightedge") == std::string::npos);
  CHECK(page.find(room.folder.path().string()) == std::string::npos);
  refusal(run_program({"explain", room.picture, "-o", room.picture}), 4, room.picture);
  CHECK(run_program({"explain", room.picture, "-o", room.at("deep/pages")}).code == 0);
  refusal(run_program({"explain", room.picture, "-o", ""}), 2, "--output");
  CHECK(names_in(room.folder) == std::vector<std::string>{"deep", "pages", "room.pgm"});
}
