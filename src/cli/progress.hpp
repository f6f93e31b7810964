// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace straightedge::cli {

/// While it lives: a line on stderr that counts the seconds, from the first full one on, if stderr is a
/// terminal and `quiet` is false. The line is wiped at the end.
class Progress {
 public:
  Progress(std::string what, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Other words from the next second on.
  void tell(std::string what);
  /// A line for a person, on stderr, even if `quiet`; not in the midst of the line that counts.
  void say(const std::string& line);

 private:
  void count_seconds();

  std::string what_;
  bool done_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::thread thread_;
};

}  // namespace straightedge::cli
