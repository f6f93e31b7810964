// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/localizer.hpp"

namespace straightedge {

const char* to_string(LocalizeState state) noexcept {
  switch (state) {
    case LocalizeState::searching:
      return "searching";
    case LocalizeState::tracking:
      return "tracking";
    case LocalizeState::lost:
      return "lost";
  }
  return "unknown state";
}

const char* to_string(ScanVerdict verdict) noexcept {
  switch (verdict) {
    case ScanVerdict::used:
      return "used";
    case ScanVerdict::no_readings:
      return "no reading in it";
    case ScanVerdict::unusable:
      return "its angles or its laser's pose are not numbers";
    case ScanVerdict::time_backwards:
      return "older than the scan before";
  }
  return "unknown verdict";
}

const char* to_string(LineVerdict verdict) noexcept {
  switch (verdict) {
    case LineVerdict::matched:
      return "matched";
    case LineVerdict::no_wall:
      return "no wall near";
    case LineVerdict::wrong_side:
      return "the wall's floor is on the other side";
    case LineVerdict::no_overlap:
      return "the wall ends before it";
    case LineVerdict::gate:
      return "farther off than the uncertainties allow";
    case LineVerdict::not_joint:
      return "does not fit the other pairs";
    case LineVerdict::ambiguous:
      return "two walls explain it";
    case LineVerdict::no_pose:
      return "no pose to match from";
  }
  return "unknown verdict";
}

}  // namespace straightedge
