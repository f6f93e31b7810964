// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "canny/edge_words.hpp"

namespace straightedge {

/// Hysteresis in place, 64 pixels at a time, with a worklist of any size: `edges` of each word becomes what
/// hangs together with it through `kept`.
///
/// To grow a word is to add the kept pixels next to an edge, in the word itself or in the eight around it,
/// and the runs of kept pixels that those belong to.
///   1. Sweep down, left to right: grow every word.
///   2. Sweep up, right to left: grow every word. One that did grow goes onto the worklist.
///   3. Take a word from the worklist and grow the eight around it; those that did grow go onto the worklist.
///      Until it is empty.
///   4. If the worklist was full, sweep up again over the rows around the words that found no place.
/// What is reached does not depend on the order. Each sweep but the first two comes after the worklist was
/// full of words that had grown: at most 2 + edges / worklist sweeps.
void fill_words(const EdgeWords& words, std::span<std::uint32_t> worklist) noexcept;

}  // namespace straightedge
