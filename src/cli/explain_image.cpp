// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/explain_image.hpp"

#include <string>
#include <utility>
#include <vector>

#include "cli/explain_accumulator.hpp"
#include "cli/explain_files.hpp"
#include "cli/explain_pictures.hpp"
#include "cli/explain_progress.hpp"
#include "cli/explain_run.hpp"
#include "cli/explain_sections.hpp"

namespace straightedge::cli {
namespace {

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

}  // namespace

Result<Done> explain_image(GrayView gray, const ExplainOptions& options,
                           const std::filesystem::path& directory) {
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
