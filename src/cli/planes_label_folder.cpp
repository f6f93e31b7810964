// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/planes_label_folder.hpp"

#include <unistd.h>

#include <cerrno>
#include <map>
#include <system_error>

#include "io/deferred_signals.hpp"
#include "io/number_text.hpp"
#include "straightedge/host/atomic_file.hpp"

namespace straightedge::cli {
namespace {

namespace fs = std::filesystem;

Failure cannot_write(const fs::path& folder, const std::error_code& error) {
  return {Problem::cannot_write, folder.string() + ": cannot be written (" + error.message() + ")"};
}

/// Without a slash at the end, which would give the folder an empty name.
fs::path plain(const fs::path& folder) {
  const fs::path whole = fs::absolute(folder).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

Result<Done> write_files(const fs::path& folder, const std::vector<FolderFile>& files) {
  for (const FolderFile& file : files) {
    std::error_code error;
    fs::create_directories((folder / file.name).parent_path(), error);
    if (error) return cannot_write(folder, error);
    if (auto written = write_file_atomically(folder / file.name, file.bytes); !written) return written;
  }
  return Done{};
}

/// A folder beside the wanted one that was not there before.
Result<fs::path> make_aside(const fs::path& folder) {
  std::error_code error;
  for (int attempt = 0; attempt < 10000; ++attempt) {
    std::string name(".");
    name.append(folder.filename().string()).append(".").append(io::to_text(::getpid()));
    name.append(".").append(io::to_text(attempt)).append(".part");
    const fs::path aside = folder.parent_path() / name;
    if (fs::create_directory(aside, error)) return aside;
    if (error) break;
  }
  return cannot_write(folder, error ? error : std::make_error_code(std::errc::file_exists));
}

}  // namespace

std::string label_name(const SequenceFrame& frame) {
  return fs::path(frame.name).stem().string() + ".png";
}

Result<Done> check_label_folder(const fs::path& folder, const std::vector<SequenceFrame>& frames) {
  if (folder.empty()) return Failure{Problem::bad_option, "--labels: the name of the folder is empty"};
  std::map<std::string, std::string> names;
  std::error_code error;
  for (const SequenceFrame& frame : frames) {
    if (fs::equivalent(folder, fs::absolute(frame.file).parent_path(), error))
      return Failure{Problem::bad_option, folder.string() + ": --labels would replace the frames in it"};
    if (!frame.problem.empty()) continue;
    const auto [other, fresh] = names.insert({label_name(frame), frame.name});
    if (!fresh)
      return Failure{Problem::bad_option, frame.file.string() + ": --labels has one name for " +
                                              other->second + " and " + frame.name};
  }
  const bool there = fs::exists(folder, error);
  if (there && !fs::is_directory(folder, error))
    return cannot_write(folder, std::make_error_code(std::errc::not_a_directory));
  const fs::path place = there ? folder : plain(folder).parent_path();
  if (::access(place.c_str(), W_OK | X_OK) == 0) return Done{};
  return cannot_write(folder, {errno, std::generic_category()});
}

Result<Done> write_folder(const fs::path& folder, const std::vector<FolderFile>& files) {
  const io::DeferredSignals deferred;
  std::error_code error;
  if (fs::exists(folder, error)) return write_files(folder, files);
  const auto aside = make_aside(plain(folder));
  if (!aside) return aside.failure();
  auto written = write_files(*aside, files);
  if (written) {
    fs::rename(*aside, plain(folder), error);
    if (!error) return Done{};
    written = cannot_write(folder, error);
  }
  fs::remove_all(*aside, error);
  return written;
}

}  // namespace straightedge::cli
