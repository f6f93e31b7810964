// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <string>

#include "cli/explain_depth_sections.hpp"
#include "cli/explain_octree.hpp"
#include "cli/explain_sections.hpp"

namespace straightedge::cli {
namespace {

using io::HtmlSection;

constexpr int levels[] = {4, 2, 0};

void add_level(DepthStory& story, const OctreeStage& stage, int level, HtmlSection& section) {
  const OctreeLevelPicture shown = show_octree_level(stage, level);
  const std::string side = in_words(100 * shown.side_m, 0) + " cm";
  section.figures.push_back(add_figure(story, "octree-" + std::to_string(level) + ".png", shown.picture,
                                       "Cubes of " + side + " with readings, from above",
                                       "Level " + std::to_string(level) + ": cubes of " + side + ", " +
                                           in_words(std::int64_t{shown.nodes}) +
                                           " of which hold readings. The brighter, the more readings stand "
                                           "over one another."));
}

void add_question(DepthStory& story, const OctreeStage& stage, HtmlSection& section) {
  const OctreeQuestionPicture shown = show_octree_question(stage);
  section.figures.push_back(add_figure(
      story, "octree-question.png", shown.picture, "Cubes that a question looks at, and those it passes over",
      "Which readings lie in the red ball of " + in_words(shown.radius_m, 2) +
          " m? A slice at the height of its middle. Blue: cubes that are too far away, whatever is in them, "
          "with "
          "one comparison each. Orange: leaves that the ball touches; their readings are asked one by one."));
  section.facts = {{"octree-nodes", "Nodes", in_words(std::int64_t{stage.octree.nodes().size()})},
                   {"octree-leaves", "Leaves", in_words(std::int64_t{stage.octree.nodes().leaves()})},
                   {"octree-passed", "Readings passed over",
                    in_words(std::int64_t{shown.passed_points}) + " with " +
                        in_words(std::int64_t{shown.passed_nodes}) + " comparisons"},
                   {"octree-asked", "Readings in touched leaves", in_words(std::int64_t{shown.leaf_points})},
                   {"octree-found", "Readings in the ball", in_words(std::int64_t{shown.found})}};
}

}  // namespace

std::vector<HtmlSection> octree_sections(DepthStory& story) {
  HtmlSection section{
      .id = "octree",
      .title = "The readings in an octree",
      .paragraphs =
          {"A map of many frames must find what lies near a place without going through all it has. An "
           "octree cuts a cube into eight, each of these into eight, and so on; cubes without readings are "
           "not "
           "kept. Here are the readings of this frame, seen from above; the camera stands at the "
           "small ring.",
           "Walls are narrow and bright, for many readings stand over one another; floors and tables are wide and "
           "dark. The last picture shows why a question is cheap: cubes that are too far away as a whole are "
           "passed over as a whole."},
      .sources = {"include/straightedge/octree.hpp", "include/straightedge/octree_nodes.hpp"}};
  const OctreeStage stage = build_octree(story.run.depth);
  if (stage.points == 0) {
    section.paragraphs = {"There is no reading, so there is no tree."};
    return {section};
  }
  for (const int level : levels) add_level(story, stage, level, section);
  add_question(story, stage, section);
  return {section};
}

}  // namespace straightedge::cli
