// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/atomic_file.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "catch.hpp"
#include "temporary_folder.hpp"

using straightedge::Problem;
using straightedge::write_file_atomically;

TEST_CASE("a new file holds exactly the bytes, and nothing is left beside it") {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\n\xFF", 5);
  REQUIRE(write_file_atomically(folder / "x.bin", bytes));
  CHECK(bytes_of(folder / "x.bin") == bytes);
  CHECK(folder.count() == 1);
}

TEST_CASE("an older file is replaced and keeps its mode") {
  const TemporaryFolder folder;
  const auto file = folder.put("x.txt", "a longer text than the new one");
  ::chmod(file.c_str(), 0640);
  REQUIRE(write_file_atomically(file, "new"));
  CHECK(bytes_of(file) == "new");
  struct stat about {};
  REQUIRE(::stat(file.c_str(), &about) == 0);
  CHECK((about.st_mode & 0777) == 0640);
  CHECK(folder.count() == 1);
}

TEST_CASE("a symbolic link stays one, and the file that it names is written") {
  const TemporaryFolder folder;
  const auto file = folder.put("real.txt", "old");
  std::filesystem::create_symlink("real.txt", folder / "link.txt");
  REQUIRE(write_file_atomically(folder / "link.txt", "new"));
  CHECK(std::filesystem::is_symlink(folder / "link.txt"));
  CHECK(bytes_of(file) == "new");
}

TEST_CASE("what cannot be written is one sentence with the file's name, and leaves nothing") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "folder");
  const auto refuses = [&](const std::filesystem::path& file, const std::string& reason) {
    const auto result = write_file_atomically(file, "bytes");
    REQUIRE_FALSE(result);
    CHECK(result.failure().problem == Problem::cannot_write);
    CHECK(result.failure().sentence == file.string() + ": cannot be written (" + reason + ")");
  };
  refuses(folder / "missing/x.txt", "No such file or directory");
  refuses(folder / "folder", "Is a directory");
  refuses((folder / "folder").string() + "/", "Is a directory");
  refuses("", "No such file or directory");
  refuses("/dev/full", "No space left on device");
  refuses(folder / std::string(300, 'x'), "File name too long");
  CHECK(folder.count() == 1);
}

TEST_CASE("a protected file stays as it is") {
  if (::geteuid() == 0) return;  // nothing is protected from root
  const TemporaryFolder folder;
  const auto file = folder.put("x.txt", "old");
  ::chmod(file.c_str(), 0444);
  const auto result = write_file_atomically(file, "new");
  REQUIRE_FALSE(result);
  CHECK(result.failure().problem == Problem::cannot_write);
  CHECK(bytes_of(file) == "old");
}

TEST_CASE("a pipe is written directly and stays a pipe") {
  const TemporaryFolder folder;
  const auto pipe = folder / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  REQUIRE(reader >= 0);
  REQUIRE(write_file_atomically(pipe, "through the pipe"));
  char text[32] = {};
  CHECK(::read(reader, text, sizeof text) == 16);
  CHECK(std::string(text) == "through the pipe");
  ::close(reader);
  CHECK(std::filesystem::is_fifo(pipe));
}

TEST_CASE("a signal that ends the program leaves the old file or the new one, whole and alone") {
  const TemporaryFolder folder;
  const std::string old_bytes(1 << 20, 'o');
  const std::string new_bytes(1 << 20, 'n');
  const auto file = folder.put("x.bin", old_bytes);
  for (int round = 0; round < 20; ++round) {
    // The test program's own handlers must not meet the signal: it waits until they are gone.
    sigset_t ending;
    sigset_t before;
    sigemptyset(&ending);
    for (const int signal : {SIGINT, SIGTERM}) sigaddset(&ending, signal);
    ::sigprocmask(SIG_BLOCK, &ending, &before);
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      for (const int signal : {SIGINT, SIGTERM}) ::signal(signal, SIG_DFL);
      ::sigprocmask(SIG_SETMASK, &before, nullptr);
      while (true) (void)write_file_atomically(file, round % 2 == 0 ? new_bytes : old_bytes);
    }
    ::sigprocmask(SIG_SETMASK, &before, nullptr);
    ::usleep(static_cast<useconds_t>(1000 + 700 * round));
    ::kill(child, round % 2 == 0 ? SIGINT : SIGTERM);
    int status = 0;
    ::waitpid(child, &status, 0);
    CHECK(WIFSIGNALED(status));
    CHECK(folder.count() == 1);
    const std::string found = bytes_of(file);
    CHECK((found == old_bytes || found == new_bytes));
  }
}
