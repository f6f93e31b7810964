// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/outputs.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "cli/streams.hpp"
#include "straightedge/host/atomic_file.hpp"

namespace straightedge::cli {
namespace {

namespace fs = std::filesystem;

bool is_stream(const Output& output) {
  return output.path == "-";
}

/// Devices take any kind of bytes.
bool is_device(const std::string& path) {
  return path.starts_with("/dev/");
}

Result<Done> check_name(const Output& output) {
  if (output.path.empty())
    return Failure{Problem::bad_option, output.option + ": the name of the file is empty"};
  if (is_stream(output) || is_device(output.path) || output.extension.empty()) return Done{};
  if (lower_case(fs::path(output.path).extension().string()) == output.extension) return Done{};
  return Failure{Problem::bad_option, output.path + ": the name of the file for " + output.option +
                                          " must end in " + output.extension};
}

bool same_place(const fs::path& a, const fs::path& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  return fs::weakly_canonical(a, error) == fs::weakly_canonical(b, error);
}

bool collide(const Output& a, const Output& b) {
  if (is_stream(a) || is_stream(b)) return is_stream(a) && is_stream(b);
  return !is_device(a.path) && same_place(a.path, b.path);
}

Result<Done> check_folder(const Output& output) {
  if (is_stream(output) || is_device(output.path)) return Done{};
  const fs::path folder = fs::path(output.path).parent_path();
  const int closed = ::access(folder.empty() ? "." : folder.c_str(), W_OK | X_OK) == 0 ? 0 : errno;
  std::error_code error;
  const int reason = fs::is_directory(output.path, error) ? EISDIR : closed;
  if (reason == 0) return Done{};
  return Failure{Problem::cannot_write,
                 output.path + ": cannot be written (" + std::generic_category().message(reason) + ")"};
}

Result<Done> write_output(const Output& output) {
  if (output.write) return output.write(is_stream(output) ? "/dev/stdout" : output.path);
  return is_stream(output) ? write_stdout(output.bytes) : write_file_atomically(output.path, output.bytes);
}

}  // namespace

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c); });
  return text;
}

Result<Done> check_outputs(std::span<const Output> outputs, const std::vector<fs::path>& inputs, bool json) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const Output& output = outputs[i];
    if (auto named = check_name(output); !named) return named;
    if (json && is_stream(output)) {
      return Failure{Problem::bad_option, output.option + " - and --json both want standard output"};
    }
    for (const Output& other : outputs.first(i)) {
      if (!collide(output, other)) continue;
      return Failure{Problem::bad_option,
                     output.path + ": " + other.option + " and " + output.option + " name the same file"};
    }
    for (const fs::path& input : inputs) {
      if (is_stream(output) || is_device(output.path) || !same_place(output.path, input)) continue;
      return Failure{Problem::bad_option, output.path + ": " + output.option + " would replace the input"};
    }
  }
  for (const Output& output : outputs) {
    if (auto open = check_folder(output); !open) return open;
  }
  return Done{};
}

Result<Done> write_outputs(std::span<const Output> outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const Output& output = outputs[i];
    const auto written = write_output(output);
    if (written) continue;
    const std::string before = i == 0 ? "" : "; written before: " + names_of(outputs.first(i));
    return Failure{written.failure().problem, written.failure().sentence + before};
  }
  return Done{};
}

std::string names_of(std::span<const Output> outputs) {
  std::string names;
  for (const Output& output : outputs) {
    names += (names.empty() ? "" : ", ") + (is_stream(output) ? "standard output" : output.path);
  }
  return names;
}

fs::path input_path(const std::string& argument) {
  return argument == "-" ? "/dev/stdin" : argument;
}

std::string base_name(const fs::path& input) {
  return input.filename().string();
}

}  // namespace straightedge::cli
