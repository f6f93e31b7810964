# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT

# What `explain` does, as a library: the program and the tests link it.
add_library(straightedge_explain STATIC
  ${CMAKE_CURRENT_LIST_DIR}/explain_accumulator.cpp
  ${CMAKE_CURRENT_LIST_DIR}/explain_chart.cpp
  ${CMAKE_CURRENT_LIST_DIR}/explain_depth.cpp
  ${CMAKE_CURRENT_LIST_DIR}/explain_depth_cells.cpp
  ${CMAKE_CURRENT_LIST_DIR}/explain_depth_pictures.cpp
  ${CMAKE_CURRENT_LIST_DIR}/explain_depth_result_sections.cpp
  ${CMAKE_CURRENT_LIST_DIR}/explain_depth_run.cpp
  ${CMAKE_CURRENT_LIST_DIR}/explain_depth_search.cpp
  ${CMAKE_CURRENT_LIST_DIR}/explain_depth_search_sections.cpp
  ${CMAKE_CURRENT_LIST_DIR}/explain_depth_sections.cpp
  ${CMAKE_CURRENT_LIST_DIR}/explain_edge_sections.cpp
  ${CMAKE_CURRENT_LIST_DIR}/explain_files.cpp
  ${CMAKE_CURRENT_LIST_DIR}/explain_geometry.cpp
  ${CMAKE_CURRENT_LIST_DIR}/explain_image.cpp
  ${CMAKE_CURRENT_LIST_DIR}/explain_legend.cpp
  ${CMAKE_CURRENT_LIST_DIR}/explain_line_sections.cpp
  ${CMAKE_CURRENT_LIST_DIR}/explain_octree.cpp
  ${CMAKE_CURRENT_LIST_DIR}/explain_octree_section.cpp
  ${CMAKE_CURRENT_LIST_DIR}/explain_overlays.cpp
  ${CMAKE_CURRENT_LIST_DIR}/explain_pictures.cpp
  ${CMAKE_CURRENT_LIST_DIR}/explain_planes_hough.cpp
  ${CMAKE_CURRENT_LIST_DIR}/explain_progress.cpp
  ${CMAKE_CURRENT_LIST_DIR}/explain_ransac.cpp
  ${CMAKE_CURRENT_LIST_DIR}/explain_run.cpp
  ${CMAKE_CURRENT_LIST_DIR}/explain_sections.cpp
  ${CMAKE_CURRENT_LIST_DIR}/explain_text.cpp)
target_link_libraries(straightedge_explain PUBLIC straightedge)
target_include_directories(straightedge_explain PRIVATE ${PROJECT_SOURCE_DIR}/src)
straightedge_flags(straightedge_explain)
