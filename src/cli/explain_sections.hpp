// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/explain_image.hpp"
#include "cli/explain_pictures.hpp"
#include "cli/explain_progress.hpp"
#include "io/html_page.hpp"

namespace straightedge::cli {

/// What the page's texts are about.
struct ExplainStory {
  const ExplainRun& run;
  const ExplainOptions& options;
  PictureScale scale;
  Size accumulator;             ///< of its picture
  std::int32_t most_votes = 0;  ///< of one cell
  const std::vector<ProgressPicture>& progress;
};

/// The whole page: what each stage does in a few sentences, its pictures and its numbers.
io::HtmlPage page_of(const ExplainStory& story);

// The two halves of the way, stage by stage.
std::vector<io::HtmlSection> edge_sections(const ExplainStory& story);
std::vector<io::HtmlSection> line_sections(const ExplainStory& story);

/// A picture of a stage, of the size that all of them have.
io::HtmlFigure stage_figure(const ExplainStory& story, const char* file, const char* alt,
                            const char* caption);

/// The file of the n-th picture of the progress.
std::string progress_file(std::size_t n);

/// Numbers as people read them.
std::string in_words(double value, int decimals);
std::string in_words(std::int64_t value);

}  // namespace straightedge::cli
