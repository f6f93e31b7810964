// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/progress.hpp"

#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <string_view>
#include <utility>

#include "cli/streams.hpp"

namespace straightedge::cli {
namespace {

void print(std::string_view text) {
  // A progress line that cannot be shown is not worth a word.
  [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, text.data(), text.size());
}

}  // namespace

Progress::Progress(std::string what, bool quiet) : what_(std::move(what)) {
  if (quiet || ::isatty(STDERR_FILENO) == 0) return;
  // Signals are the main thread's: there they wait while a file is being written.
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  thread_ = std::thread([this] { count_seconds(); });
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

Progress::~Progress() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void Progress::tell(std::string what) {
  const std::lock_guard lock(mutex_);
  what_ = std::move(what);
}

void Progress::say(const std::string& line) {
  const std::lock_guard lock(mutex_);
  if (thread_.joinable()) print("\r\x1B[K");
  print_words(line);
}

void Progress::count_seconds() {
  std::unique_lock lock(mutex_);
  for (int seconds = 1;; ++seconds) {
    if (changed_.wait_for(lock, std::chrono::seconds(1), [this] { return done_; })) {
      if (seconds > 1) print("\r\x1B[K");
      return;
    }
    print("\r\x1B[K" + what_ + " ... " + std::to_string(seconds) + " s");
  }
}

}  // namespace straightedge::cli
