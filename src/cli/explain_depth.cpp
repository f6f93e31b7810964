// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/explain_depth.hpp"

#include "cli/explain_depth_run.hpp"
#include "cli/explain_depth_sections.hpp"
#include "io/svg_size.hpp"
#include "straightedge/host/plane_view.hpp"

namespace straightedge::cli {
namespace {

/// The last section's drawing is no PNG, so it goes its own way.
NamedFile draw_map(const ExplainDepthRun& run, const ExplainDepthOptions& options, io::HtmlPage& page) {
  const Pose camera[] = {Pose{}};
  NamedFile file{"map.svg",
                 plane_map_svg(run.map, {.title = "Planes of " + options.input, .camera_path = camera})};
  for (io::HtmlSection& section : page.sections) {
    for (io::HtmlFigure& figure : section.figures) {
      if (figure.file == file.name) figure.size = io::svg_size(file.bytes);
    }
  }
  return file;
}

}  // namespace

Result<Done> explain_depth(const DepthView& depth, const ExplainDepthOptions& options,
                           const std::filesystem::path& directory) {
  // Step 1.
  const auto run = run_depth_stages(depth, options.detector);
  if (!run) return run.failure();
  // Steps 2 and 3.
  PictureFiles pictures;
  DepthStory story{*run, options, pictures, depth_range(*run)};
  io::HtmlPage page = page_of(story);
  auto files = pictures.take();
  if (!files) return files.failure();
  files->push_back(draw_map(*run, options, page));
  files->push_back({page_name, io::html_from_page(page)});
  // Step 4.
  return write_folder(*files, directory);
}

}  // namespace straightedge::cli
