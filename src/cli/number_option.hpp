// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// Options that are numbers: the whole text must be one number of the range that the help states, whatever
/// the locale; NaN and infinity never are. A breach is a usage error that names the option and the range.
/// The help shows the value that `target` holds as the default.
namespace straightedge::cli {

inline constexpr std::uint64_t max_seed = UINT64_MAX;

struct RealRange {
  double low = 0;
  double high = 0;
  bool ends = true;  ///< whether low and high themselves belong to it
};

/// `unit`: what stands behind the option in the help, such as PX.
CLI::Option* add_real(CLI::App& command, const std::string& name, double& target, RealRange range,
                      const std::string& unit, const std::string& help);

/// The same for an option in degrees whose target is in radians. The range is in degrees.
CLI::Option* add_degrees(CLI::App& command, const std::string& name, double& target, RealRange degrees,
                         const std::string& help);

struct WholeRange {
  std::uint64_t low = 0;
  std::uint64_t high = 0;
};

template <class Whole>
CLI::Option* add_whole(CLI::App& command, const std::string& name, Whole& target, WholeRange range,
                       const std::string& unit, const std::string& help);

extern template CLI::Option* add_whole(CLI::App&, const std::string&, std::int32_t&, WholeRange,
                                       const std::string&, const std::string&);
extern template CLI::Option* add_whole(CLI::App&, const std::string&, std::uint64_t&, WholeRange,
                                       const std::string&, const std::string&);

/// Numbers separated by commas, as many as `targets`; false when the text is anything else.
bool read_numbers(const std::string& text, const std::vector<double*>& targets);

/// One of a few words. `target`'s value must be among them.
template <class Value>
CLI::Option* add_choice(CLI::App& command, const std::string& name, Value& target,
                        std::vector<std::pair<std::string, Value>> words, const std::string& help) {
  std::string all, standard;
  for (const auto& [word, value] : words) {
    all += (all.empty() ? "" : "|") + word;
    if (value == target) standard = word;
  }
  const auto read = [name, &target, words = std::move(words), all](const std::string& text) {
    for (const auto& [word, value] : words) {
      if (word != text) continue;
      target = value;
      return;
    }
    throw CLI::ValidationError(name, "\"" + text + "\" is none of " + all);
  };
  return command.add_option_function<std::string>(name, read, help)->type_name(all)->default_str(standard);
}

}  // namespace straightedge::cli
