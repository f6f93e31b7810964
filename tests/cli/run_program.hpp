// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/temporary_folder.hpp"

/// The real program, run as a user runs it.
struct Run {
  int code = -1;  ///< exit code; minus the signal's number when one ended it
  std::string out;
  std::string err;
};

struct RunSettings {
  std::string standard_input = {};   ///< file to read it from; empty: nothing is there
  std::size_t address_space = 0;     ///< bytes the program may take; 0: as many as it wants
  std::string standard_output = {};  ///< file or device in place of what `Run::out` is read from
  std::string locale = {};           ///< LC_ALL
  std::string kernels = {};          ///< STRAIGHTEDGE_KERNELS; empty: as it is
  int interrupt_after_ms = 0;        ///< SIGINT, as Ctrl-C sends it; 0: never
};

Run run_program(const std::vector<std::string>& arguments, const RunSettings& settings = {});

/// The failure's one sentence: checks that stdout is empty, that stderr is one line of the program's, that
/// `name` is in it, and the exit code.
std::string refusal(const Run& run, int code, const std::string& name);

/// Names of what is in a folder, sorted.
std::vector<std::string> names_in(const TemporaryFolder& folder);

inline std::string fixture(const std::string& name) {
  return std::string(STRAIGHTEDGE_FIXTURES "/") + name;
}

/// A PGM of one gray value, or with the header's size and no pixels.
std::string pgm(int width, int height, int value);
std::string pgm_header(int width, int height);

/// A PGM of 200 x 160: light ground, four dark walls, 6 thick, of a room.
std::string room_pgm();
