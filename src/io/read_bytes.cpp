// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/read_bytes.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <system_error>

namespace straightedge::io {
namespace {

Failure cannot_read(const std::filesystem::path& file, const char* what, int error) {
  return {Problem::cannot_read,
          file.string() + ": cannot be " + what + " (" + std::generic_category().message(error) + ")"};
}

Failure too_long(const std::filesystem::path& file, std::size_t max_bytes) {
  return {Problem::bad_content, file.string() + ": is longer than the " + std::to_string(max_bytes) +
                                    " bytes that are read of such a file"};
}

/// Appends until the end; pipes and devices do not tell their length, so the limit is kept while reading.
int read_until_end(int descriptor, std::string& bytes, std::size_t max_bytes) {
  constexpr std::size_t chunk = std::size_t{1} << 16;
  while (bytes.size() <= max_bytes) {
    const std::size_t used = bytes.size();
    bytes.resize(std::min(std::max(used + chunk, bytes.capacity()), max_bytes + 1));
    const ssize_t count = ::read(descriptor, bytes.data() + used, bytes.size() - used);
    bytes.resize(used + (count > 0 ? static_cast<std::size_t>(count) : 0));
    if (count == 0) return 0;
    if (count < 0 && errno != EINTR) return errno;
  }
  return 0;
}

}  // namespace

Result<std::string> read_bytes(const std::filesystem::path& file, std::size_t max_bytes) try {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return cannot_read(file, "opened", errno);
  struct Closer {
    int descriptor;
    ~Closer() { ::close(descriptor); }
  } const closer{descriptor};

  std::string bytes;
  struct stat about {};
  if (::fstat(descriptor, &about) == 0 && S_ISREG(about.st_mode)) {
    const auto length = static_cast<std::size_t>(about.st_size);
    if (length > max_bytes) return too_long(file, max_bytes);
    bytes.reserve(length + 1);
  }
  const int error = read_until_end(descriptor, bytes, max_bytes);
  if (error != 0) return cannot_read(file, "read", error);
  if (bytes.size() > max_bytes) return too_long(file, max_bytes);
  return bytes;
} catch (const std::bad_alloc&) {
  return cannot_read(file, "read", ENOMEM);
}

}  // namespace straightedge::io
