// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "base/kernel_set.hpp"
#include "straightedge/plane_search_kernels.hpp"

/// What plane_search_kernels.hpp tells of each, for one instruction set.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

void try_triples(const SearchReadings& readings, std::uint32_t count, const SearchTriples& triples,
                 SearchPlanes& planes) noexcept;
SearchInliers find_inliers(const SearchReadings& readings, std::uint32_t padded, const SearchPlane& plane,
                           float most) noexcept;
void sum_inliers(const SearchReadings& readings, std::uint32_t padded, const SearchPlane& plane, float most,
                 SearchSums& sums) noexcept;
void take_readings(const float* first, std::int32_t step, std::int32_t count, float none, float* q) noexcept;
void weigh(float* q, float* w, std::int32_t padded, float least, float per_square, float none) noexcept;
std::uint32_t count_readings(const float* q, const SearchBox& box) noexcept;
void mark_hits(const SearchReadings& readings, const SearchBox& box, const SearchPlane& plane,
               std::uint8_t* hit) noexcept;
SearchMarks keep_dense(const std::uint8_t* hit, const SearchBox& box, std::uint8_t* core,
                       std::uint8_t* counts, std::uint8_t* columns) noexcept;
void sum_marked(const SearchReadings& readings, const std::uint8_t* core, const SearchBox& box,
                const SearchPlane& plane, float u0, float v0, float* marks, SearchSums& sums) noexcept;
void take_cheaper(const SearchReadings& readings, const std::uint8_t* core, const SearchBox& box,
                  const SearchPlane& plane, float label, float* rows, float* cost, float* owner) noexcept;

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
