// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

/// Two implementations of one job, timed in turns, so that both meet the same moods of the machine.
namespace compare {

struct Job {
  std::string name;     ///< "Canny L1"
  std::string size;     ///< "640x480"
  std::string kernels;  ///< of ours
  std::function<void()> ours;
  std::function<void()> theirs;
  std::function<bool()> agree;  ///< of what the two calls left behind
  std::string peer = "OpenCV";
  /// What the answers are alike in, for the table, asked after `agree`.
  std::function<std::string()> answers = [] { return "equal"; };
  bool one_call_a_turn = false;  ///< each finds the caches as the other left them
};

enum class Clock {
  thread,  ///< processor time of this thread: one thread each
  wall     ///< for jobs of several threads
};

/// Prints the head of the table.
void print_head();

/// Checks that the answers agree, then lets each have `rounds` turns, fewer (at least three) when that
/// takes more than some seconds; a turn is as many calls as fill 2 ms, at least one,
/// unless the job says otherwise. Prints a row: the medians, and the median of the rounds' ratios with its
/// quartiles. Ends the program when the answers differ.
void print_row(const Job& job, int rounds, Clock clock = Clock::thread);

}  // namespace compare
