// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/explain_files.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "straightedge/host/atomic_file.hpp"
#include "straightedge/host/image_file.hpp"

namespace straightedge::cli {
namespace {

namespace fs = std::filesystem;

// An old page must not speak of new pictures when one of them cannot be written, and a new page not lie
// beside pictures of an older run.
constexpr const char* all_names[] = {
    // Of pictures and depth frames.
    page_name, "accumulator.png",
    // Of pictures.
    "gray.png", "ground.png", "blurred.png", "gradient-x.png", "gradient-y.png", "magnitude.png",
    "direction.png", "direction-wheel.png", "suppressed.png", "strong-weak.png", "edges.png", "peaks.png",
    "segments.png", "progress-1.png", "progress-2.png", "progress-3.png", "progress-4.png", "lines.png",
    // Of depth frames.
    "depth.png", "inverse-depth.png", "cells-32.png", "cells-16.png", "cells-8.png", "cells-4.png",
    "window.png", "hypotheses.png", "first-triple.png", "best-triple.png", "refitted.png", "boxes.png",
    "patches.png", "distances.png", "candidates.png", "cell-labels-32.png", "cell-labels-16.png",
    "cell-labels-8.png", "cell-labels-4.png", "labels.png", "residuals.png", "map.svg",
    // Of laser scans.
    "readings.svg", "scan-lines.svg", "matches.svg", "pose.svg", "search-1.svg", "search-2.svg",
    "search-3.svg", "search-4.svg"};

/// Half of the pictures have no colour, and one channel is encoded three times as fast.
Result<std::string> encode(const Image<Rgb>& picture) {
  Image<std::uint8_t> gray(picture.size());
  for (std::int32_t y = 0; y < picture.height(); ++y) {
    const Rgb* row = picture.view().row(y);
    std::uint8_t* to = gray.view().row(y);
    for (std::int32_t x = 0; x < picture.width(); ++x) {
      if (row[x].red != row[x].green || row[x].red != row[x].blue) return encode_png(picture.view());
      to[x] = row[x].red;
    }
  }
  return encode_png(gray.view());
}

Result<bool> make_folder(const fs::path& directory) {
  std::error_code error;
  const bool made = fs::create_directories(directory, error);
  if (error || !fs::is_directory(directory, error)) {
    const std::string reason = error ? error.message() : "it is not a folder";
    return Failure{Problem::cannot_write, directory.string() + ": cannot be made (" + reason + ")"};
  }
  return made;
}

/// The page at once, so that none speaks of pictures that are being replaced; pictures unless they are.
void remove_older(const std::vector<NamedFile>& files, const fs::path& directory) {
  std::error_code ignored;
  for (const std::string name : all_names) {
    const bool replaced = name != page_name && std::any_of(files.begin(), files.end(), [&](const auto& file) {
                            return file.name == name;
                          });
    if (!replaced && fs::is_regular_file(directory / name, ignored)) fs::remove(directory / name, ignored);
  }
}

}  // namespace

void PictureFiles::add(const std::string& name, const Image<Rgb>& picture) {
  if (!trouble_.sentence.empty()) return;
  auto png = encode(picture);
  if (!png) {
    trouble_ = png.failure();
    return;
  }
  files_.push_back({name, std::move(*png)});
}

Result<std::vector<NamedFile>> PictureFiles::take() {
  if (!trouble_.sentence.empty()) return trouble_;
  return std::move(files_);
}

Result<Done> write_folder(const std::vector<NamedFile>& files, const fs::path& directory) {
  const auto made = make_folder(directory);
  if (!made) return made.failure();
  remove_older(files, directory);
  for (const NamedFile& file : files) {
    const auto done = write_file_atomically(directory / file.name, file.bytes);
    if (done) continue;
    std::error_code ignored;
    if (*made) fs::remove_all(directory, ignored);
    return done.failure();
  }
  return Done{};
}

}  // namespace straightedge::cli
