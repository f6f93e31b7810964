// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/number_option.hpp"

#include <cmath>
#include <optional>

#include "io/number_text.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge::cli {
namespace {

constexpr double radians_per_degree = pi / 180;

std::string range_text(const RealRange& range) {
  const std::string between = io::to_text(range.low) + " to " + io::to_text(range.high);
  return range.ends ? between : "between " + io::to_text(range.low) + " and " + io::to_text(range.high);
}

std::string whole_range_text(const WholeRange& range) {
  if (range.high == UINT64_MAX) return io::to_text(range.low) + " to 2^64 - 1";
  return io::to_text(range.low) + " to " + io::to_text(range.high);
}

[[noreturn]] void refuse(const std::string& name, const std::string& text, const std::string& wanted) {
  throw CLI::ValidationError(name, "\"" + text + "\" is not " + wanted);
}

double read_real(const std::string& name, const std::string& text, const RealRange& range) {
  const std::optional<double> value = io::number_from_text<double>(text);
  const bool inside = value && (range.ends ? *value >= range.low && *value <= range.high
                                           : *value > range.low && *value < range.high);
  if (!inside) refuse(name, text, "a number " + range_text(range));
  return *value;
}

}  // namespace

CLI::Option* add_real(CLI::App& command, const std::string& name, double& target, RealRange range,
                      const std::string& unit, const std::string& help) {
  const auto read = [name, &target, range](const std::string& text) {
    target = read_real(name, text, range);
  };
  return command.add_option_function<std::string>(name, read, help + "; " + range_text(range))
      ->type_name(unit)
      ->default_str(io::to_text(target));
}

CLI::Option* add_degrees(CLI::App& command, const std::string& name, double& target, RealRange degrees,
                         const std::string& help) {
  const auto read = [name, &target, degrees](const std::string& text) {
    target = read_real(name, text, degrees) * radians_per_degree;
  };
  return command.add_option_function<std::string>(name, read, help + "; " + range_text(degrees))
      ->type_name("DEGREES")
      ->default_str(io::to_short_text(target / radians_per_degree));
}

template <class Whole>
CLI::Option* add_whole(CLI::App& command, const std::string& name, Whole& target, WholeRange range,
                       const std::string& unit, const std::string& help) {
  const auto read = [name, &target, range](const std::string& text) {
    const std::optional<std::uint64_t> value = io::number_from_text<std::uint64_t>(text);
    if (!value || *value < range.low || *value > range.high) {
      refuse(name, text, "a whole number " + whole_range_text(range));
    }
    target = static_cast<Whole>(*value);
  };
  return command.add_option_function<std::string>(name, read, help + "; " + whole_range_text(range))
      ->type_name(unit)
      ->default_str(io::to_text(target));
}

template CLI::Option* add_whole(CLI::App&, const std::string&, std::int32_t&, WholeRange, const std::string&,
                                const std::string&);
template CLI::Option* add_whole(CLI::App&, const std::string&, std::uint64_t&, WholeRange, const std::string&,
                                const std::string&);

bool read_numbers(const std::string& text, const std::vector<double*>& targets) {
  std::size_t at = 0;
  for (double* const target : targets) {
    const std::size_t end = text.find(',', at);
    const bool last = target == targets.back();
    if ((end == std::string::npos) != last) return false;
    const auto value = io::number_from_text<double>(std::string_view(text).substr(at, end - at));
    if (!value || !std::isfinite(*value)) return false;
    *target = *value;
    at = end + 1;
  }
  return true;
}

}  // namespace straightedge::cli
