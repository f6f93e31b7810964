// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "cli/explain_depth.hpp"
#include "cli/explain_depth_pictures.hpp"
#include "cli/explain_depth_run.hpp"
#include "cli/explain_files.hpp"
#include "cli/explain_planes_hough.hpp"
#include "cli/explain_ransac.hpp"
#include "io/html_page.hpp"

namespace straightedge::cli {

/// Pictures are made where the text speaks of them: a section adds its files as it is written.
struct DepthStory {
  const ExplainDepthRun& run;
  const ExplainDepthOptions& options;
  PictureFiles& files;
  DepthRange range = {};
};

/// The whole page: what each stage does in a few sentences, its pictures and the numbers of the frame.
io::HtmlPage page_of(DepthStory& story);

// Parts of it, in order.
std::vector<io::HtmlSection> input_sections(DepthStory& story);
std::vector<io::HtmlSection> ransac_sections(DepthStory& story);
std::vector<io::HtmlSection> hough_sections(DepthStory& story);
std::vector<io::HtmlSection> labelling_sections(DepthStory& story);
std::vector<io::HtmlSection> result_sections(DepthStory& story);
std::vector<io::HtmlSection> octree_sections(DepthStory& story);

/// Encodes the picture, and says where it stands.
io::HtmlFigure add_figure(DepthStory& story, const std::string& file, const Image<Rgb>& picture,
                          const std::string& alt, const std::string& caption);

/// "12 planes", "1 plane".
std::string counted(std::int64_t count, const std::string& what);
/// "12.3 %".
std::string percent(double share);
/// Where a plane lies as the camera sees it: ahead, below, above, left or right.
std::string side_of(const Vector3& normal);
/// "0.01, -0.99, 0.1"
std::string in_words(const Vector3& v);

}  // namespace straightedge::cli
