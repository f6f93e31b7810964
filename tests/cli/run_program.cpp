// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "run_program.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>

#include "support/catch.hpp"

namespace {

void redirect(int stream, const std::string& file, int flags) {
  const int descriptor = ::open(file.c_str(), flags, 0600);
  if (descriptor < 0 || ::dup2(descriptor, stream) < 0) ::_exit(126);
}

[[noreturn]] void become_program(std::vector<char*>& words, const RunSettings& settings,
                                 const std::string& out, const std::string& err) {
  redirect(STDIN_FILENO, settings.standard_input.empty() ? "/dev/null" : settings.standard_input, O_RDONLY);
  redirect(STDOUT_FILENO, out, O_WRONLY | O_CREAT | O_TRUNC);
  redirect(STDERR_FILENO, err, O_WRONLY | O_CREAT | O_TRUNC);
  if (settings.address_space != 0) {
    const rlimit limit{settings.address_space, settings.address_space};
    if (::setrlimit(RLIMIT_AS, &limit) != 0) ::_exit(126);
  }
  if (!settings.locale.empty()) ::setenv("LC_ALL", settings.locale.c_str(), 1);
  if (!settings.kernels.empty()) ::setenv("STRAIGHTEDGE_KERNELS", settings.kernels.c_str(), 1);
  ::execv(STRAIGHTEDGE_PROGRAM, words.data());
  ::_exit(127);
}

}  // namespace

Run run_program(const std::vector<std::string>& arguments, const RunSettings& settings) {
  const TemporaryFolder folder;
  const std::string err = (folder / "err").string();
  const std::string out =
      settings.standard_output.empty() ? (folder / "out").string() : settings.standard_output;
  std::vector<std::string> owned = {"straightedge"};
  owned.insert(owned.end(), arguments.begin(), arguments.end());
  std::vector<char*> words;
  for (std::string& word : owned) words.push_back(word.data());
  words.push_back(nullptr);
  // Until it is the program, the child has the handlers of this test, which would report a failure.
  sigset_t interrupt, before;
  sigemptyset(&interrupt);
  sigaddset(&interrupt, SIGINT);
  ::sigprocmask(SIG_BLOCK, &interrupt, &before);
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGINT, SIG_DFL);
    ::sigprocmask(SIG_SETMASK, &before, nullptr);
    become_program(words, settings, out, err);
  }
  ::sigprocmask(SIG_SETMASK, &before, nullptr);
  REQUIRE(child >= 0);
  if (settings.interrupt_after_ms > 0) {
    ::usleep(static_cast<useconds_t>(settings.interrupt_after_ms) * 1000);
    ::kill(child, SIGINT);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  Run run;
  run.code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  run.err = bytes_of(err);
  if (settings.standard_output.empty()) run.out = bytes_of(out);
  return run;
}

std::string refusal(const Run& run, int code, const std::string& name) {
  INFO("code " << run.code << ", stderr: " << run.err);
  CHECK(run.code == code);
  CHECK(run.out.empty());
  CHECK(run.err.starts_with("straightedge: "));
  CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
  CHECK(run.err.ends_with("\n"));
  CHECK(run.err.find(name) != std::string::npos);
  return run.err;
}

std::vector<std::string> names_in(const TemporaryFolder& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string pgm_header(int width, int height) {
  return "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n";
}

std::string pgm(int width, int height, int value) {
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return pgm_header(width, height) + std::string(pixels, static_cast<char>(value));
}

std::string room_pgm() {
  constexpr int width = 200, height = 160;
  std::string bytes = pgm_header(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool outer = x >= 30 && x < 170 && y >= 30 && y < 130;
      const bool inner = x >= 36 && x < 164 && y >= 36 && y < 124;
      bytes += static_cast<char>(outer && !inner ? 0 : 254);
    }
  }
  return bytes;
}
