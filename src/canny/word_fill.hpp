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
///   2. When a word has grown, those around it that can now grow, and that the sweep has passed already, go
///      onto the worklist.
///   3. Take a word from the worklist and grow it. Until it is empty.
///   4. If the worklist was full, sweep again over the rows of the words that found no place.
/// What is reached does not depend on the order. A word that grows sends eight others onto the worklist at most,
/// so before every sweep but the first `worklist` / 8 words had grown, or more: at most 1 + 8 edges / worklist
/// sweeps.
void fill_words(const EdgeWords& words, std::span<std::uint32_t> worklist) noexcept;

}  // namespace straightedge
