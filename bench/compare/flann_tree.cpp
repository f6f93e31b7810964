// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <flann/flann.hpp>
#include <memory>

#include "peers.hpp"

namespace compare {
namespace {

std::vector<float> in_rows(const Points& points) {
  std::vector<float> rows;
  for (std::size_t i = 0; i < points.size(); ++i)
    rows.insert(rows.end(), {points.x[i], points.y[i], points.z[i]});
  return rows;
}

}  // namespace

/// The exact tree that PCL's k-d tree is, too, with its parameters.
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
            flann::SearchParams exact(flann::FLANN_CHECKS_UNLIMITED, 0, false);
            exact.cores = 1;
            int index = 0;
            float distance = 0;
            flann::Matrix<int> found(&index, 1, 1);
            flann::Matrix<float> far(&distance, 1, 1);
            for (std::size_t i = 0; i < positions.size(); ++i) {
              float at[] = {positions.x[i], positions.y[i], positions.z[i]};
              (*tree)->knnSearch(flann::Matrix<float>(at, 1, 3), found, far, 1, exact);
              squared[i] = static_cast<double>(distance);
            }
          },
          nullptr};
}

}  // namespace compare
