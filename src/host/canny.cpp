// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/canny.hpp"

#include <cstddef>
#include <memory>
#include <span>

#include "straightedge/canny_fused.hpp"

namespace straightedge {
namespace {

struct Workspace {
  explicit Workspace(std::size_t bytes)
      : memory(std::make_unique_for_overwrite<std::byte[]>(bytes)), span(memory.get(), bytes) {}
  std::unique_ptr<std::byte[]> memory;
  std::span<std::byte> span;
};

// Once, on a picture that is made for it.
template <class Detector, class... More>
CannyEdges run_once(GrayView gray, const CannyOptions& options, std::string_view kernels,
                    const More&... more) {
  CannyEdges found;
  found.kernels = kernels;
  const Workspace workspace(Detector::workspace_bytes(gray.size(), options, more...));
  Detector detector;
  found.result.status = Detector::prepare(detector, gray.size(), options, workspace.span, more...);
  if (found.result.status != Status::ok) return found;
  found.edges = Image<std::uint8_t>(gray.size());
  found.result = detector.run(gray, found.edges.view());
  return found;
}

}  // namespace

CannyEdges canny(GrayView gray, const CannyOptions& options, const KernelSet& kernels) {
  CannyEdges found;
  found.result.status = gray.valid() ? Canny::check(gray.size(), options) : Status::invalid_image;
  if (found.result.status != Status::ok) return found;
  const CannyRowOptions rows{.kernels = kernels.canny_rows};
  if (FusedCanny::workspace_bytes(gray.size(), options, rows) > 0) {
    return run_once<FusedCanny>(gray, options, kernels.name, rows);
  }
  return run_once<Canny>(gray, options, "plain");
}

}  // namespace straightedge
