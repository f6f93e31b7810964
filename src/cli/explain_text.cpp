// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/explain_text.hpp"

#include <algorithm>
#include <array>

#include "cli/explain_colours.hpp"

namespace straightedge::cli {
namespace {

constexpr int columns = 5;
constexpr int rows = 9;

/// Nine rows of five dots; the last two are below the base line.
struct Letter {
  char name;
  std::array<std::string_view, rows> dots;
};

constexpr Letter letters[] = {
    {'0', {" ### ", "#   #", "#  ##", "# # #", "##  #", "#   #", " ### ", "", ""}},
    {'1', {"  #  ", " ##  ", "  #  ", "  #  ", "  #  ", "  #  ", " ### ", "", ""}},
    {'2', {" ### ", "#   #", "    #", "   # ", "  #  ", " #   ", "#####", "", ""}},
    {'3', {" ### ", "#   #", "    #", "  ## ", "    #", "#   #", " ### ", "", ""}},
    {'4', {"   # ", "  ## ", " # # ", "#  # ", "#####", "   # ", "   # ", "", ""}},
    {'5', {"#####", "#    ", "#### ", "    #", "    #", "#   #", " ### ", "", ""}},
    {'6', {" ### ", "#    ", "#    ", "#### ", "#   #", "#   #", " ### ", "", ""}},
    {'7', {"#####", "    #", "   # ", "  #  ", "  #  ", " #   ", " #   ", "", ""}},
    {'8', {" ### ", "#   #", "#   #", " ### ", "#   #", "#   #", " ### ", "", ""}},
    {'9', {" ### ", "#   #", "#   #", " ####", "    #", "    #", " ### ", "", ""}},
    {'-', {"", "", "", "#####", "", "", "", "", ""}},
    {'(', {"   # ", "  #  ", " #   ", " #   ", " #   ", "  #  ", "   # ", "", ""}},
    {')', {" #   ", "  #  ", "   # ", "   # ", "   # ", "  #  ", " #   ", "", ""}},
    {'.', {"", "", "", "", "", "  ## ", "  ## ", "", ""}},
    {'+', {"", "  #  ", "  #  ", "#####", "  #  ", "  #  ", "", "", ""}},
    {'a', {"", "", " ### ", "    #", " ####", "#   #", " ####", "", ""}},
    {'b', {"#    ", "#    ", "#### ", "#   #", "#   #", "#   #", "#### ", "", ""}},
    {'c', {"", "", " ####", "#    ", "#    ", "#    ", " ####", "", ""}},
    {'d', {"    #", "    #", " ####", "#   #", "#   #", "#   #", " ####", "", ""}},
    {'e', {"", "", " ### ", "#   #", "#####", "#    ", " ### ", "", ""}},
    {'f', {"   ##", "  #  ", "#####", "  #  ", "  #  ", "  #  ", "  #  ", "", ""}},
    {'g', {"", "", " ####", "#   #", "#   #", "#   #", " ####", "    #", " ### "}},
    {'h', {"#    ", "#    ", "#### ", "#   #", "#   #", "#   #", "#   #", "", ""}},
    {'i', {"  #  ", "", " ##  ", "  #  ", "  #  ", "  #  ", " ### ", "", ""}},
    {'k', {"#    ", "#    ", "#  # ", "# #  ", "##   ", "# #  ", "#  # ", "", ""}},
    {'l', {" ##  ", "  #  ", "  #  ", "  #  ", "  #  ", "  #  ", " ### ", "", ""}},
    {'m', {"", "", "## # ", "# # #", "# # #", "# # #", "# # #", "", ""}},
    {'n', {"", "", "#### ", "#   #", "#   #", "#   #", "#   #", "", ""}},
    {'o', {"", "", " ### ", "#   #", "#   #", "#   #", " ### ", "", ""}},
    {'p', {"", "", "#### ", "#   #", "#   #", "#   #", "#### ", "#    ", "#    "}},
    {'r', {"", "", "# ## ", "##   ", "#    ", "#    ", "#    ", "", ""}},
    {'s', {"", "", " ####", "#    ", " ### ", "    #", "#### ", "", ""}},
    {'t', {"  #  ", "  #  ", "#####", "  #  ", "  #  ", "  #  ", "   ##", "", ""}},
    {'u', {"", "", "#   #", "#   #", "#   #", "#   #", " ####", "", ""}},
    {'v', {"", "", "#   #", "#   #", "#   #", " # # ", "  #  ", "", ""}},
    {'w', {"", "", "#   #", "# # #", "# # #", "# # #", " # # ", "", ""}},
    {'x', {"", "", "#   #", " # # ", "  #  ", " # # ", "#   #", "", ""}},
    {'y', {"", "", "#   #", "#   #", "#   #", "#   #", " ####", "    #", " ### "}},
};

void draw_dot(ImageView<Rgb> image, std::int32_t x, std::int32_t y, const TextPlace& place) {
  for (int k = 0; k < place.scale * place.scale; ++k) {
    const std::int32_t u = x + k % place.scale, v = y + k / place.scale;
    if (image.contains(u, v)) image.at(u, v) = place.colour;
  }
}

void draw_letter(ImageView<Rgb> image, const Letter& letter, const TextPlace& place) {
  for (int r = 0; r < rows; ++r) {
    const std::string_view dots = letter.dots[static_cast<std::size_t>(r)];
    for (int c = 0; c < static_cast<int>(dots.size()); ++c) {
      if (dots[static_cast<std::size_t>(c)] == ' ') continue;
      draw_dot(image, place.x + c * place.scale, place.y + r * place.scale, place);
    }
  }
}

}  // namespace

Size text_size(std::string_view text, int scale) {
  const auto count = static_cast<std::int32_t>(text.size());
  return {count > 0 ? (count * (columns + 1) - 1) * scale : 0, 7 * scale};
}

void draw_tag(Image<Rgb>& picture, std::string_view text, Point2 middle, const TextPlace& look) {
  const Size box = text_size(text, look.scale);
  const int margin = 2 * look.scale;
  const auto place = [margin](double at, std::int32_t extent, std::int32_t room) {
    const auto first = static_cast<std::int32_t>(at) - extent / 2;
    return std::clamp(first, margin, std::max(margin, room - extent - margin));
  };
  TextPlace corner = look;
  corner.x = place(middle.x, box.width, picture.width());
  corner.y = place(middle.y, box.height, picture.height());
  for (std::int32_t v = corner.y - look.scale; v < corner.y + box.height + look.scale; ++v) {
    for (std::int32_t u = corner.x - look.scale; u < corner.x + box.width + look.scale; ++u) {
      if (picture.view().contains(u, v)) picture.at(u, v) = paper;
    }
  }
  draw_text(picture.view(), text, corner);
}

void draw_text(ImageView<Rgb> image, std::string_view text, const TextPlace& place) {
  TextPlace next = place;
  for (const char name : text) {
    for (const Letter& letter : letters) {
      if (letter.name == name) draw_letter(image, letter, next);
    }
    next.x += (columns + 1) * place.scale;
  }
}

}  // namespace straightedge::cli
