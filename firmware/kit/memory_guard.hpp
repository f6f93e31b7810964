// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

namespace firmware {

/// From here on a write to flash (through null, too) faults, and so does a stack that grows beyond its
/// size. Fills the stack with a pattern, so that what is used of it can be counted.
void guard_memory() noexcept;

}  // namespace firmware
