// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/netpbm.hpp"

#include <charconv>
#include <optional>
#include <vector>

#include "io/image_size.hpp"
#include "straightedge/gray.hpp"

namespace straightedge::io {
namespace {

struct Header {
  bool plain = false;  ///< numbers as text
  bool coloured = false;
  std::uint32_t maximum = 0;
  Size size;
  std::size_t length = 0;  ///< bytes before the first value
};

constexpr bool is_blank(char c) noexcept {
  return c == ' ' || (c >= '\t' && c <= '\r');
}
constexpr bool is_digit(char c) noexcept {
  return c >= '0' && c <= '9';
}

/// Past blanks, and past comments, which run from # to the end of their line.
std::size_t skip_blanks(std::string_view bytes, std::size_t at) {
  while (at < bytes.size() && (is_blank(bytes[at]) || bytes[at] == '#')) {
    if (bytes[at] == '#') {
      while (at < bytes.size() && bytes[at] != '\n' && bytes[at] != '\r') ++at;
    } else {
      ++at;
    }
  }
  return at;
}

/// The next number; none at the end, at anything else, or above 2^32 - 1.
std::optional<std::uint32_t> take_number(std::string_view bytes, std::size_t& at) {
  at = skip_blanks(bytes, at);
  std::uint32_t value = 0;
  if (at >= bytes.size() || !is_digit(bytes[at])) return {};
  const auto end = std::from_chars(bytes.data() + at, bytes.data() + bytes.size(), value);
  if (end.ec != std::errc{}) return {};
  at = static_cast<std::size_t>(end.ptr - bytes.data());
  return value;
}

Failure bad(const std::string& name, const char* what) {
  return {Problem::bad_content, name + ": " + what};
}

Result<Header> read_header(std::string_view bytes, const std::string& name) {
  Header header;
  header.plain = bytes[1] == '2' || bytes[1] == '3';
  header.coloured = bytes[1] == '3' || bytes[1] == '6';
  std::size_t at = 2;
  const auto width = take_number(bytes, at);
  const auto height = take_number(bytes, at);
  const auto maximum = take_number(bytes, at);
  if (!width || !height || !maximum) return bad(name, "has a broken PGM or PPM header");
  if (*maximum < 1 || *maximum > 65535) return bad(name, "has a maximum value outside of 1 to 65535");
  const auto size = checked_size(*width, *height, name);
  if (!size) return size.failure();
  if (at >= bytes.size()) return bad(name, "is truncated: it ends after its header");
  if (!is_blank(bytes[at])) return bad(name, "has a broken PGM or PPM header");
  header.size = *size;
  header.maximum = *maximum;
  header.length = at + 1;
  return header;
}

/// Values one after the other, whatever their notation; above the maximum or past the end is a failure.
class Values {
 public:
  Values(std::string_view bytes, const Header& header)
      : bytes_(bytes), at_(header.length), header_(header), wide_(header.maximum > 255) {}

  /// The shortest content that can hold the image, known before anything is allocated.
  static bool can_hold(std::size_t available, const Header& header) {
    const auto pixels =
        static_cast<std::uint64_t>(header.size.width) * static_cast<std::uint64_t>(header.size.height);
    const std::uint64_t values = pixels * (header.coloured ? 3 : 1);
    if (header.plain) return available + 1 >= 2 * values;
    return available >= values * (header.maximum > 255 ? 2 : 1);
  }

  /// The next value as the file has it; 0 after a failure.
  std::uint32_t next() {
    const std::uint32_t value = header_.plain ? next_text() : next_binary();
    if (value > header_.maximum) failed_ = "has a value above its stated maximum";
    return failed_ != nullptr ? 0 : value;
  }

  const char* failed() const { return failed_; }

 private:
  std::uint32_t next_text() {
    const auto value = take_number(bytes_, at_);
    if (!value)
      failed_ = at_ >= bytes_.size() ? "is truncated" : "has something between its values that is no number";
    return value.value_or(0);
  }
  std::uint32_t next_binary() {
    const auto first = static_cast<unsigned char>(bytes_[at_++]);
    if (!wide_) return first;
    return first * 256u + static_cast<unsigned char>(bytes_[at_++]);
  }

  std::string_view bytes_;
  std::size_t at_;
  const Header& header_;
  bool wide_;
  const char* failed_ = nullptr;
};

std::uint8_t scaled_to_8_bits(std::uint32_t value, std::uint32_t maximum) {
  if (maximum == 255) return static_cast<std::uint8_t>(value);
  if (maximum == 65535) return static_cast<std::uint8_t>(value >> 8);
  return static_cast<std::uint8_t>((value * 255 + maximum / 2) / maximum);
}

}  // namespace

bool is_netpbm(std::string_view bytes) noexcept {
  return bytes.size() >= 3 && bytes[0] == 'P' &&
         (bytes[1] == '2' || bytes[1] == '3' || bytes[1] == '5' || bytes[1] == '6') &&
         (is_blank(bytes[2]) || bytes[2] == '#');
}

Result<Image<std::uint8_t>> decode_netpbm(std::string_view bytes, const std::string& name) {
  const auto header = read_header(bytes, name);
  if (!header) return header.failure();
  if (!Values::can_hold(bytes.size() - header->length, *header)) return bad(name, "is truncated");

  Image<std::uint8_t> gray(header->size);
  const std::int32_t width = gray.width();
  const PixelFormat format = header->coloured ? PixelFormat::rgb : PixelFormat::gray;
  std::vector<std::uint8_t> row(static_cast<std::size_t>(width) * static_cast<std::size_t>(channels(format)));
  Values values(bytes, *header);
  for (std::int32_t y = 0; y < gray.height() && values.failed() == nullptr; ++y) {
    for (std::uint8_t& value : row) value = scaled_to_8_bits(values.next(), header->maximum);
    const ColorView colours{row.data(), width, 1, static_cast<std::ptrdiff_t>(row.size()), format};
    const Status status = gray_from_color(colours, {gray.view().row(y), {width, 1}});
    if (status != Status::ok) return Failure{Problem::internal, name + ": " + to_string(status)};
  }
  if (values.failed() != nullptr) return bad(name, values.failed());
  return gray;
}

Result<Image<std::uint16_t>> decode_netpbm16(std::string_view bytes, const std::string& name) {
  const auto header = read_header(bytes, name);
  if (!header) return header.failure();
  if (header->coloured) return bad(name, "is a colour picture; depth is one 16-bit gray value a pixel");
  if (header->maximum < 256)
    return bad(name, "is an 8-bit gray picture; depth is one 16-bit gray value a pixel");
  if (!Values::can_hold(bytes.size() - header->length, *header)) return bad(name, "is truncated");

  Image<std::uint16_t> raw(header->size);
  Values values(bytes, *header);
  for (std::int32_t y = 0; y < raw.height() && values.failed() == nullptr; ++y) {
    for (std::int32_t x = 0; x < raw.width(); ++x) raw.at(x, y) = static_cast<std::uint16_t>(values.next());
  }
  if (values.failed() != nullptr) return bad(name, values.failed());
  return raw;
}

}  // namespace straightedge::io
