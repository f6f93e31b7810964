// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "caller_memory.hpp"

#include <algorithm>
#include <cstring>

namespace workspace {
namespace {

constexpr std::size_t alignment = 64;
constexpr std::size_t margin = 64;
constexpr unsigned char pattern = 0xA5;

}  // namespace

Block::Block(const Shape& shape, std::size_t off_alignment)
    : shape_(shape), bytes_(alignment + 2 * margin + off_alignment + shape.stride * shape.rows, pattern) {
  const auto address = reinterpret_cast<std::uintptr_t>(bytes_.data()) + margin;
  start_ = margin + (alignment - address % alignment) % alignment + off_alignment;
  remember();
}

bool Block::guards_intact() const {
  for (std::size_t i = 0; i < bytes_.size(); ++i) {
    const bool before_or_behind = i < start_ || i >= start_ + shape_.stride * shape_.rows;
    const bool outside = before_or_behind || (i - start_) % shape_.stride >= shape_.row;
    if (outside && bytes_[i] != pattern) return false;
  }
  return true;
}

void Block::append_rows_to(std::vector<unsigned char>& out) const {
  for (std::size_t y = 0; y < shape_.rows; ++y) {
    const auto first = bytes_.begin() + static_cast<std::ptrdiff_t>(start_ + y * shape_.stride);
    out.insert(out.end(), first, first + static_cast<std::ptrdiff_t>(shape_.row));
  }
}

std::span<std::byte> CallerMemory::workspace(std::size_t bytes) {
  const std::size_t given = bytes - std::min(bytes, layout_.missing);
  // A stride of nothing would be no stride.
  workspaces_.emplace_back(Block::Shape{given, 1, given + 1}, layout_.offset);
  unsigned char* first = workspaces_.back().row(0);
  std::memset(first, layout_.dirt, given);
  return {reinterpret_cast<std::byte*>(first), given};
}

PointsView CallerMemory::input(const std::vector<float>& xyz) {
  const std::size_t count = xyz.size() / 3;
  const auto floats = static_cast<std::size_t>(layout_.point_floats);
  const bool arrays = floats == 1;
  const auto ahead = static_cast<std::size_t>(layout_.ahead) * sizeof(float);
  // Three rows of numbers, or a row a point.
  const Block::Shape shape = arrays ? Block::Shape{count * sizeof(float), 3, (count + 2) * sizeof(float)}
                                    : Block::Shape{3 * sizeof(float), count, floats * sizeof(float)};
  Block& block = inputs_.emplace_back(shape, ahead);
  for (std::size_t i = 0; i < xyz.size(); ++i) {
    const std::size_t point = i / 3, axis = i % 3;
    unsigned char* to =
        arrays ? block.row(axis) + point * sizeof(float) : block.row(point) + axis * sizeof(float);
    std::memcpy(to, &xyz[i], sizeof(float));
  }
  block.remember();
  const auto number = [&](std::size_t axis) {
    return reinterpret_cast<const float*>(arrays ? block.row(axis) : block.row(0) + axis * sizeof(float));
  };
  return {number(0), number(1), number(2), count, static_cast<std::ptrdiff_t>(floats * sizeof(float))};
}

Block& CallerMemory::picture(Blocks& blocks, Size size, std::size_t element) {
  const auto width = static_cast<std::size_t>(size.width);
  const Block::Shape shape{width * element, static_cast<std::size_t>(size.height),
                           (width + static_cast<std::size_t>(layout_.gap)) * element};
  return blocks.emplace_back(shape, static_cast<std::size_t>(layout_.ahead) * element);
}

std::vector<unsigned char> CallerMemory::pictures() const {
  std::vector<unsigned char> bytes;
  for (const Block& block : outputs_) block.append_rows_to(bytes);
  return bytes;
}

bool CallerMemory::inputs_untouched() const {
  return std::all_of(inputs_.begin(), inputs_.end(), [](const Block& b) { return b.untouched(); });
}

bool CallerMemory::outputs_untouched() const {
  const auto untouched = [](const Block& b) { return b.untouched(); };
  return std::all_of(outputs_.begin(), outputs_.end(), untouched) &&
         std::all_of(lists_.begin(), lists_.end(), untouched);
}

bool CallerMemory::guards_intact() const {
  const auto intact = [](const Blocks& blocks) {
    return std::all_of(blocks.begin(), blocks.end(), [](const Block& b) { return b.guards_intact(); });
  };
  return intact(workspaces_) && intact(inputs_) && intact(outputs_) && intact(lists_);
}

}  // namespace workspace
