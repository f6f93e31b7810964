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
std::uint32_t gather_row(const SearchReadings& row, std::int32_t columns, float u0, float v0,
                         const GatheredReadings& out) noexcept;
void take_cells(const SearchCells& cells, std::int32_t count, const SearchGate& gate, float none,
                const SearchOutput& out) noexcept;
void mask_cells(const std::uint16_t* labels, std::ptrdiff_t stride, std::int32_t rows, std::int32_t side,
                std::int32_t count, float none, float* q) noexcept;
std::uint32_t count_readings(const float* q, const SearchBox& box) noexcept;
void mark_hits(const SearchReadings& readings, const SearchBox& box, const SearchPlane& plane, float most,
               std::uint8_t* hit) noexcept;
SearchMarks keep_dense(const std::uint8_t* hit, const SearchBox& box, std::uint8_t* core,
                       std::uint8_t* counts, std::uint8_t* columns) noexcept;
void empty_marked(const std::uint8_t* core, const SearchBox& box, float none, float* q) noexcept;
void sum_marked(const SearchReadings& readings, const std::uint8_t* core, const SearchBox& box,
                const SearchPlane& plane, float u0, float v0, float* marks, SearchSums& sums) noexcept;

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
