// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/laser_log.hpp"

#include <new>

#include "io/gzip.hpp"
#include "io/log_record.hpp"
#include "io/read_bytes.hpp"
#include "io/text_lines.hpp"

namespace straightedge {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

std::string_view without_mark(std::string_view text) {
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  return text;
}

std::optional<LaserLogFormat> format_of(std::string_view text) {
  for (io::TextLines lines(text); !lines.at_end();) {
    const std::string_view kind = io::LogRecord(lines.take()).kind();
    if (kind == "SCAN") return LaserLogFormat::text;
    if (kind == "FLASER") return LaserLogFormat::carmen;
  }
  return {};
}

Result<LaserLog> log_from_text(std::string_view text, const std::string& name) {
  const auto format = format_of(text);
  if (!format)
    return Failure{Problem::bad_content, name + ": holds no laser scan (no line begins with SCAN or FLASER)"};
  io::LogSoFar so_far;
  so_far.log.format = *format;
  io::TextLines lines(text);
  try {
    while (!lines.at_end()) {
      io::LogRecord record(lines.take());
      if (record.kind().empty()) continue;
      const std::size_t before = so_far.log.scans.size();
      *format == LaserLogFormat::text ? io::take_text_record(record, so_far)
                                      : io::take_carmen_record(record, so_far);
      if (so_far.log.scans.size() > before) so_far.log.scans.back().line = lines.number();
    }
  } catch (const io::BadRecord& bad) {
    return Failure{Problem::bad_content,
                   name + ": line " + io::to_text(lines.number()) + ": " + bad.sentence};
  }
  return std::move(so_far.log);
}

}  // namespace

Result<LaserLog> laser_log_from_bytes(std::string_view bytes, const std::string& name) try {
  if (!io::is_gzip(bytes)) return log_from_text(without_mark(bytes), name);
  const auto text = io::gunzip(bytes, max_laser_log_bytes, name);
  if (!text) return text.failure();
  return log_from_text(without_mark(*text), name);
} catch (const std::bad_alloc&) {
  return Failure{Problem::cannot_read, name + ": does not fit into memory"};
}

Result<LaserLog> read_laser_log(const std::filesystem::path& file) {
  const auto bytes = io::read_bytes(file, max_laser_log_bytes);
  if (!bytes) return bytes.failure();
  return laser_log_from_bytes(*bytes, file.string());
}

}  // namespace straightedge
