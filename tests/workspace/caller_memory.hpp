// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <list>
#include <span>
#include <vector>

#include "straightedge/host/image.hpp"
#include "straightedge/points_view.hpp"
#include "straightedge/status.hpp"

namespace workspace {

using namespace straightedge;

/// How a caller's memory may lie.
struct Layout {
  int gap = 0;              ///< elements behind each row of a picture
  int ahead = 0;            ///< elements by which each first pixel is off the alignment of 64 bytes
  int point_floats = 1;     ///< from one point to the next; 1: three arrays
  std::size_t offset = 0;   ///< bytes by which the workspace is off that alignment
  std::size_t missing = 0;  ///< bytes that the workspace has too few
  unsigned char dirt = 0;   ///< what the workspace is full of
};

/// Bytes in rows, with guards before, between and behind them.
class Block {
 public:
  struct Shape {
    std::size_t row = 0;  ///< bytes in use
    std::size_t rows = 1;
    std::size_t stride = 0;
  };
  Block(const Shape& shape, std::size_t off_alignment);

  unsigned char* row(std::size_t y) { return bytes_.data() + start_ + y * shape_.stride; }
  /// What is in the rows now is what "untouched" means.
  void remember() { before_ = bytes_; }
  bool untouched() const { return bytes_ == before_; }
  bool guards_intact() const;
  void append_rows_to(std::vector<unsigned char>& out) const;

 private:
  Shape shape_;
  std::size_t start_ = 0;
  std::vector<unsigned char> bytes_, before_;
};

/// Everything that one call of an algorithm reads and writes.
class CallerMemory {
 public:
  explicit CallerMemory(const Layout& layout) : layout_(layout) {}

  std::span<std::byte> workspace(std::size_t bytes);
  bool has_workspace() const { return !workspaces_.empty(); }

  template <class T>
  ImageView<const T> input(const Image<T>& image) {
    return copy(inputs_, image);
  }
  PointsView input(const std::vector<float>& xyz);

  template <class T>
  ImageView<T> output(Size size) {
    return view<T>(picture(outputs_, size, sizeof(T)), size);
  }
  /// A picture that is changed.
  template <class T>
  ImageView<T> changed(const Image<T>& image) {
    return copy(outputs_, image);
  }
  /// A list; what is in it is told by `say`, because structs have gaps.
  template <class T>
  std::span<T> list(std::size_t count) {
    lists_.emplace_back(Block::Shape{count * sizeof(T), 1, count * sizeof(T)}, 0);
    lists_.back().remember();
    return {reinterpret_cast<T*>(lists_.back().row(0)), count};
  }
  void say(std::initializer_list<double> numbers) { said_.insert(said_.end(), numbers); }

  /// What was said, and the pixels of all pictures written.
  const std::vector<double>& said() const { return said_; }
  std::vector<unsigned char> pictures() const;

  bool inputs_untouched() const;
  bool outputs_untouched() const;
  bool guards_intact() const;

 private:
  using Blocks = std::list<Block>;  // views stay where they are

  Block& picture(Blocks& blocks, Size size, std::size_t element);
  template <class T>
  ImageView<T> view(Block& block, Size size) {
    const auto stride = static_cast<std::ptrdiff_t>(sizeof(T)) * (size.width + layout_.gap);
    return {reinterpret_cast<T*>(block.row(0)), size, stride};
  }
  template <class T>
  ImageView<T> copy(Blocks& blocks, const Image<T>& image) {
    Block& block = picture(blocks, image.size(), sizeof(T));
    const ImageView<T> to = view<T>(block, image.size());
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) to.at(x, y) = image.at(x, y);
    }
    block.remember();
    return to;
  }

  Layout layout_;
  Blocks workspaces_, inputs_, outputs_, lists_;
  std::vector<double> said_;
};

}  // namespace workspace
