// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/streams.hpp"

#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace straightedge::cli {
namespace {

int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

}  // namespace

Result<Done> write_stdout(std::string_view bytes) {
  const int error = write_all(STDOUT_FILENO, bytes);
  if (error == 0) return Done{};
  return Failure{Problem::cannot_write,
                 "standard output: cannot be written (" + std::generic_category().message(error) + ")"};
}

void print_words(const std::string& line) {
  // Nobody is left to tell when stderr itself fails.
  (void)write_all(STDERR_FILENO, line + "\n");
}

std::string one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
  }
  return text;
}

}  // namespace straightedge::cli
