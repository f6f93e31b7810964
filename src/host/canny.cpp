// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/canny.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>

#include "straightedge/canny_fused.hpp"
#include "straightedge/host/parallel.hpp"

namespace straightedge {
namespace {

struct Workspace {
  explicit Workspace(std::size_t bytes)
      : memory(std::make_unique_for_overwrite<std::byte[]>(bytes)), span(memory.get(), bytes) {}
  std::unique_ptr<std::byte[]> memory;
  std::span<std::byte> span;
};

// Once, on a picture that is made for it.
template <class Detector, class Run, class... More>
CannyEdges run_once(GrayView gray, const CannyOptions& options, std::string_view kernels, const Run& run,
                    const More&... more) {
  CannyEdges found;
  found.kernels = kernels;
  const Workspace workspace(Detector::workspace_bytes(gray.size(), options, more...));
  Detector detector;
  found.result.status = Detector::prepare(detector, gray.size(), options, workspace.span, more...);
  if (found.result.status != Status::ok) return found;
  found.edges = Image<std::uint8_t>::for_overwrite(gray.size());
  found.result = run(detector, found.edges.view());
  return found;
}

/// Thinner stripes would spend their time on the rows that they share with their neighbours.
constexpr std::int32_t least_rows = 32;

unsigned stripes(const GrayView& gray, unsigned threads) {
  return std::min(threads, static_cast<unsigned>(std::max<std::int32_t>(gray.height / least_rows, 1)));
}

}  // namespace

CannyEdges canny(GrayView gray, const CannyOptions& options, const KernelSet& kernels, ThreadPool& pool) {
  CannyEdges found;
  found.result.status = gray.valid() ? Canny::check(gray.size(), options) : Status::invalid_image;
  if (found.result.status != Status::ok) return found;
  const CannyRowOptions rows{.kernels = kernels.canny_rows,
                             .stripes = static_cast<std::int32_t>(stripes(gray, pool.threads()))};
  if (FusedCanny::workspace_bytes(gray.size(), options, rows) > 0) {
    const auto for_each = [&](std::int32_t count, auto work) {
      pool.for_each_index(static_cast<std::size_t>(count),
                          [&](std::size_t i, unsigned) { work(static_cast<std::int32_t>(i)); });
    };
    const auto run = [&](FusedCanny& detector, ImageView<std::uint8_t> edges) {
      return detector.run_with(gray, edges, for_each);
    };
    return run_once<FusedCanny>(gray, options, kernels.name, run, rows);
  }
  const auto run = [&](Canny& detector, ImageView<std::uint8_t> edges) { return detector.run(gray, edges); };
  return run_once<Canny>(gray, options, "plain", run);
}

CannyEdges canny(GrayView gray, const CannyOptions& options, const KernelSet& kernels, unsigned threads) {
  ThreadPool pool(gray.valid() ? stripes(gray, threads == 0 ? processors() : threads) : 1);
  return canny(gray, options, kernels, pool);
}

}  // namespace straightedge
