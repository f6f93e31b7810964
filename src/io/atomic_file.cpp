// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "io/deferred_signals.hpp"

namespace straightedge {
namespace {

namespace fs = std::filesystem;

Failure cannot_write(const fs::path& file, int error) {
  return {Problem::cannot_write,
          file.string() + ": cannot be written (" + std::generic_category().message(error) + ")"};
}

/// 0, or the error number. Closes the descriptor in any case: some file systems report a full disk there.
int write_all_and_close(int descriptor, std::string_view bytes) {
  int error = 0;
  while (error == 0 && !bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      error = errno;
    }
  }
  if (::close(descriptor) != 0 && error == 0) error = errno;
  return error;
}

/// Devices and pipes have no content that could be half replaced. Appending keeps what a redirected
/// standard output holds already.
Result<Done> write_directly(const fs::path& file, std::string_view bytes) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (descriptor < 0) return cannot_write(file, errno);
  const int error = write_all_and_close(descriptor, bytes);
  if (error != 0) return cannot_write(file, error);
  return Done{};
}

/// Opens a file that did not exist before, beside the target; its name is put into `aside`.
int open_aside(const fs::path& target, fs::path& aside) {
  for (int attempt = 0;; ++attempt) {
    std::string name(".");
    name.append(target.filename().string()).append(".").append(std::to_string(::getpid()));
    name.append(".").append(std::to_string(attempt)).append(".part");
    aside = target.parent_path() / name;
    const int descriptor = ::open(aside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0 || errno != EEXIST || attempt == 10000) return descriptor;
  }
}

Result<Done> write_aside_and_rename(const fs::path& file, const fs::path& target, std::string_view bytes,
                                    const struct stat* old) {
  fs::path aside;
  const int descriptor = open_aside(target, aside);
  if (descriptor < 0) return cannot_write(file, errno);
  if (old != nullptr) (void)::fchmod(descriptor, old->st_mode & 07777);
  int error = write_all_and_close(descriptor, bytes);
  if (error == 0 && ::rename(aside.c_str(), target.c_str()) != 0) error = errno;
  if (error == 0) return Done{};
  ::unlink(aside.c_str());
  return cannot_write(file, error);
}

bool is_process_stream(const fs::path& file) {
  const std::string name = file.lexically_normal().string();
  return name.starts_with("/dev/") || name.starts_with("/proc/");
}

}  // namespace

Result<Done> write_file_atomically(const fs::path& file, std::string_view bytes) {
  if (file.empty() || !file.has_filename()) return cannot_write(file, file.empty() ? ENOENT : EISDIR);
  if (is_process_stream(file)) return write_directly(file, bytes);

  struct stat old {};
  const bool exists = ::stat(file.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode)) return cannot_write(file, EISDIR);
  if (exists && !S_ISREG(old.st_mode)) return write_directly(file, bytes);
  // Replacing a file needs write permission on its folder alone; a protected file stays protected.
  if (exists && ::access(file.c_str(), W_OK) != 0) return cannot_write(file, errno);

  fs::path target = file;
  std::error_code error;
  if (fs::is_symlink(fs::symlink_status(file, error))) {
    target = fs::weakly_canonical(file, error);
    if (error) return cannot_write(file, error.value());
  }
  const io::DeferredSignals deferred;
  return write_aside_and_rename(file, target, bytes, exists ? &old : nullptr);
}

}  // namespace straightedge
