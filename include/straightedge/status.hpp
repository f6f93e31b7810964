// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace straightedge {

/// What a function of the core has to say about its work. Nothing in the core prints, throws or
/// exits: bad options and bad input end here, in release builds too.
enum class [[nodiscard]] Status : std::uint8_t {
  ok,                   ///< done; an empty result is a result
  output_full,          ///< the caller's output is full; what is in it is valid
  cancelled,            ///< a trace asked to stop; what was found until then is valid
  invalid_option,       ///< an option is not a number or outside its range
  invalid_image,        ///< a view (pixels, depth, points) is null or its sizes or values make no sense
  size_mismatch,        ///< two views that belong together, or a view and `prepare`, differ in size
  too_large,            ///< the image is larger than the algorithm's numbers can hold
  workspace_too_small,  ///< fewer bytes than `workspace_bytes` says
  not_prepared,         ///< `run` was called before a successful `prepare`
};

/// One sentence for each value, for people.
constexpr const char* to_string(Status status) noexcept {
  switch (status) {
    case Status::ok: return "done";
    case Status::output_full: return "the output is full; more was found than it holds";
    case Status::cancelled: return "stopped by the caller";
    case Status::invalid_option: return "an option is not a number or out of its range";
    case Status::invalid_image: return "the input has no pixels or points, or its stride or camera makes no sense";
    case Status::size_mismatch: return "the sizes of two images that belong together differ";
    case Status::too_large: return "the image is too large for this algorithm";
    case Status::workspace_too_small: return "the workspace is smaller than workspace_bytes says";
    case Status::not_prepared: return "prepare has not been called or has failed";
  }
  return "unknown status";
}

}  // namespace straightedge
