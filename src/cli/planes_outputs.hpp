// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/outputs.hpp"
#include "cli/planes_label_folder.hpp"
#include "cli/planes_points.hpp"
#include "straightedge/host/ply.hpp"

namespace straightedge::cli {

/// The files of all methods, in the order in which they are written. With both methods their names carry
/// the method before the ending, and the label folder holds a folder for each.
class PlanesOutputs {
 public:
  explicit PlanesOutputs(const PlanesArguments& arguments);

  /// Before any work is done, see check_outputs.
  Result<Done> check(const std::vector<std::filesystem::path>& inputs,
                     const std::vector<SequenceFrame>& frames) const;
  /// Makes the content of all files. `run`'s maps have their descriptions already; it must outlive `write`.
  Result<Done> fill(const PlanesRun& run);
  /// Each file whole or not at all.
  Result<Done> write() const;
  /// For people; empty when nothing was asked for.
  std::string names() const;

 private:
  /// Readings of one method for its pictures.
  struct Points {
    std::shared_ptr<PointsPly> ply;
    std::vector<PlaneViewPoint> view;
  };

  Result<std::vector<Points>> collect_points(const PlanesRun& run) const;
  Result<Done> fill_output(Output& output, const PlanesRun& run, const MethodRun& method,
                           const Points& points) const;
  Result<Done> fill_labels(const PlanesRun& run);

  const PlanesArguments& arguments_;
  std::vector<PlaneMethod> methods_;
  std::vector<Output> outputs_;  ///< all of the first method, then all of the second
  std::vector<FolderFile> labels_;
};

}  // namespace straightedge::cli
