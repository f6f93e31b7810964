// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/explain_image.hpp"

#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/explain_accumulator.hpp"
#include "cli/explain_pictures.hpp"
#include "cli/explain_progress.hpp"
#include "cli/explain_run.hpp"
#include "cli/explain_sections.hpp"
#include "straightedge/host/atomic_file.hpp"
#include "straightedge/host/image_file.hpp"

namespace straightedge::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* page_name = "index.html";
// An old page must not speak of new pictures when one of them cannot be written, and a new page not lie
// beside pictures of an older run.
constexpr const char* sometimes_written[] = {page_name,        "ground.png",     "progress-1.png",
                                             "progress-2.png", "progress-3.png", "progress-4.png"};

struct NamedFile {
  std::string name;
  std::string bytes;
};

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

/// Encodes one picture after another; the first failure stays.
class PictureFiles {
 public:
  void add(const std::string& name, const Image<Rgb>& picture) {
    if (!trouble_.sentence.empty()) return;
    auto png = encode(picture);
    if (!png) {
      trouble_ = png.failure();
      return;
    }
    files_.push_back({name, std::move(*png)});
  }
  Result<std::vector<NamedFile>> take() {
    if (!trouble_.sentence.empty()) return trouble_;
    return std::move(files_);
  }

 private:
  std::vector<NamedFile> files_;
  Failure trouble_;
};

Result<std::vector<NamedFile>> picture_files(const ExplainRun& run, GrayView gray, GradientNorm norm,
                                             const PictureScale& scale, const Image<Rgb>& accumulator,
                                             const std::vector<ProgressPicture>& progress) {
  PictureFiles files;
  files.add("gray.png", show_gray(gray, scale));
  if (run.picture.kind == PictureKind::map) files.add("ground.png", show_gray(run.picture.stretched, scale));
  files.add("blurred.png", show_gray(run.canny.blurred(), scale));
  files.add("gradient-x.png", show_signed(run.canny.gradient_x(), scale));
  files.add("gradient-y.png", show_signed(run.canny.gradient_y(), scale));
  files.add("magnitude.png", show_magnitude(run, norm, scale));
  files.add("direction.png", show_direction(run, norm, scale));
  files.add("direction-wheel.png", direction_wheel());
  files.add("suppressed.png", show_crests(run, norm, scale));
  files.add("strong-weak.png", show_classes(run, scale));
  files.add("edges.png", show_gray(run.edges, scale));
  files.add("accumulator.png", accumulator);
  files.add("peaks.png", show_peaks(run, scale));
  files.add("segments.png", show_segments(run, scale));
  for (std::size_t i = 0; i < progress.size(); ++i) files.add(progress_file(i), progress[i].picture);
  files.add("lines.png", show_lines(run, scale));
  return files.take();
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

Result<Done> write_folder(const std::vector<NamedFile>& files, const fs::path& directory) {
  const auto made = make_folder(directory);
  if (!made) return made.failure();
  std::error_code ignored;
  for (const char* name : sometimes_written) {
    if (fs::is_regular_file(directory / name, ignored)) fs::remove(directory / name, ignored);
  }
  for (const NamedFile& file : files) {
    const auto done = write_file_atomically(directory / file.name, file.bytes);
    if (done) continue;
    if (*made) fs::remove_all(directory, ignored);
    return done.failure();
  }
  return Done{};
}

}  // namespace

Result<Done> explain_image(GrayView gray, const ExplainOptions& options, const fs::path& directory) {
  // Step 1.
  const auto run = run_stages(gray, options.lines);
  if (!run) return run.failure();
  // Step 2.
  const GradientNorm norm = options.lines.canny.norm;
  const PictureScale scale = scale_of(*run, norm);
  const AccumulatorPicture accumulator = show_accumulator(*run);
  const auto progress = show_progress(*run, first_round(options.lines), scale);
  auto files = picture_files(*run, gray, norm, scale, accumulator.picture, progress);
  if (!files) return files.failure();
  // Step 3.
  const ExplainStory story{*run,    options, scale, accumulator.picture.size(), accumulator.most_votes,
                           progress};
  files->push_back({page_name, io::html_from_page(page_of(story))});
  // Step 4.
  return write_folder(*files, directory);
}

}  // namespace straightedge::cli
