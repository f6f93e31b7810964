// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <flann/flann.hpp>
#include <memory>

#include "peers.hpp"

namespace compare {
namespace {

std::vector<float> in_rows(const Points& points) {
  std::vector<float> rows;
  for (std::size_t i = 0; i < points.size(); ++i) rows.insert(rows.end(), {points.x[i], points.y[i], points.z[i]});
  return rows;
}

}  // namespace

/// The exact tree that PCL's k-d tree is, too, with its parameters; all positions in one call, which is the
/// fastest way to ask.
PointIndex flann_tree(const Points& cloud) {
  using Tree = flann::Index<flann::L2_Simple<float>>;
  auto rows = std::make_shared<std::vector<float>>(in_rows(cloud));
  auto tree = std::make_shared<std::unique_ptr<Tree>>();
  return {"FLANN k-d tree",
          [rows, tree] {
            constexpr int leaf_points = 15;
            const flann::Matrix<float> points(rows->data(), rows->size() / 3, 3);
            *tree = std::make_unique<Tree>(points, flann::KDTreeSingleIndexParams(leaf_points));
            (*tree)->buildIndex();
          },
          [tree](const Points& positions, std::vector<double>& squared) {
            std::vector<float> asked = in_rows(positions), distances(positions.size());
            std::vector<int> indices(positions.size());
            const flann::Matrix<float> queries(asked.data(), positions.size(), 3);
            flann::Matrix<int> found(indices.data(), positions.size(), 1);
            flann::Matrix<float> far(distances.data(), positions.size(), 1);
            flann::SearchParams exact(flann::FLANN_CHECKS_UNLIMITED, 0, false);
            exact.cores = 1;
            (*tree)->knnSearch(queries, found, far, 1, exact);
            squared.assign(distances.begin(), distances.end());
          }};
}

}  // namespace compare
