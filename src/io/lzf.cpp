// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/lzf.hpp"

#include <algorithm>

namespace straightedge::io {
namespace {

/// Input and output with the places that are next. A step is false when it would leave either.
class Decoder {
 public:
  Decoder(std::string_view input, std::span<char> output) : input_(input), output_(output) {}

  bool run() {
    while (!input_.empty()) {
      const std::size_t control = take();
      if (!(control < 32 ? copy_literals(control + 1) : repeat(control))) return false;
    }
    return written_ == output_.size();
  }

 private:
  std::size_t take() {
    const auto byte = static_cast<unsigned char>(input_.front());
    input_.remove_prefix(1);
    return byte;
  }

  bool copy_literals(std::size_t count) {
    if (count > input_.size() || count > output_.size() - written_) return false;
    std::copy_n(input_.begin(), count, output_.begin() + static_cast<std::ptrdiff_t>(written_));
    input_.remove_prefix(count);
    written_ += count;
    return true;
  }

  bool repeat(std::size_t control) {
    std::size_t count = control >> 5;
    if (input_.size() < (count == 7 ? 2 : 1)) return false;
    if (count == 7) count += take();
    count += 2;
    const std::size_t back = (control & 31) * 256 + take() + 1;
    if (back > written_ || count > output_.size() - written_) return false;
    // One by one, since the bytes that are repeated may be among those just written.
    for (; count > 0; --count, ++written_) output_[written_] = output_[written_ - back];
    return true;
  }

  std::string_view input_;
  std::span<char> output_;
  std::size_t written_ = 0;
};

}  // namespace

bool lzf_decompress(std::string_view input, std::span<char> output) {
  return Decoder(input, output).run();
}

}  // namespace straightedge::io
