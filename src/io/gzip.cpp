// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/gzip.hpp"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <new>

#include "io/number_text.hpp"

namespace straightedge::io {
namespace {

constexpr std::string_view magic = "\x1F\x8B";
constexpr std::size_t chunk = std::size_t{1} << 16;
constexpr int gzip_window = MAX_WBITS + 16;  // 16: the container is gzip's and no other

/// zlib's state, and its end whatever happens.
class Inflater {
 public:
  Inflater() { good_ = inflateInit2(&stream_, gzip_window) == Z_OK; }
  ~Inflater() {
    if (good_) inflateEnd(&stream_);
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  bool good() const noexcept { return good_; }

  /// Appends at most `room` bytes to `text` and takes what was read off `packed`. Returns zlib's word.
  int step(std::string_view& packed, std::string& text, std::size_t room) {
    const std::size_t used = text.size();
    text.resize(used + std::min(room, chunk));
    constexpr std::size_t most = std::numeric_limits<uInt>::max();
    const std::size_t given = std::min(packed.size(), most);
    stream_.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(packed.data()));
    stream_.avail_in = static_cast<uInt>(given);
    stream_.next_out = reinterpret_cast<Bytef*>(text.data() + used);
    stream_.avail_out = static_cast<uInt>(text.size() - used);
    const int said = inflate(&stream_, Z_NO_FLUSH);
    packed.remove_prefix(given - stream_.avail_in);
    text.resize(text.size() - stream_.avail_out);
    return said;
  }

  bool next_member() { return inflateReset(&stream_) == Z_OK; }

 private:
  z_stream stream_{};
  bool good_ = false;
};

}  // namespace

bool is_gzip(std::string_view bytes) noexcept {
  return bytes.starts_with(magic);
}

Result<std::string> gunzip(std::string_view bytes, std::size_t max_bytes, const std::string& name) try {
  const auto bad = [&](const std::string& what) { return Failure{Problem::bad_content, name + ": " + what}; };
  Inflater inflater;
  if (!inflater.good()) throw std::bad_alloc();
  std::string text;
  for (;;) {
    const int said = inflater.step(bytes, text, max_bytes + 1 - text.size());
    if (text.size() > max_bytes)
      return bad("unpacks to more than the " + to_text(max_bytes) + " bytes that are read of such a file");
    if (said == Z_STREAM_END) {
      if (bytes.find_first_not_of('\0') == std::string_view::npos) return text;
      if (!is_gzip(bytes) || !inflater.next_member()) return bad("has other bytes behind its gzip data");
    } else if (said == Z_BUF_ERROR) {
      return bad("is cut short: its gzip data ends too early");
    } else if (said == Z_MEM_ERROR) {
      throw std::bad_alloc();
    } else if (said != Z_OK) {
      return bad("its gzip data is damaged");
    }
  }
} catch (const std::bad_alloc&) {
  return Failure{Problem::cannot_read, name + ": does not fit into memory"};
}

}  // namespace straightedge::io
