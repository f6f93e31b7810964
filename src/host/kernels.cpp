// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/kernels.hpp"

#include <cstddef>
#include <cstdlib>
#include <string>

#include "straightedge/detail/x86_instructions.hpp"

namespace straightedge {
namespace {

// Plain to fastest: a machine that has one of them has all before it.
constexpr KernelSet all_sets[] = {
    {"plain", &plain_canny_row_kernels, &plain_plane_row_kernels},
#if defined(__x86_64__)
    {"sse2", &sse2_canny_row_kernels, &plain_plane_row_kernels},
    {"avx2", &avx2_canny_row_kernels, &avx2_plane_row_kernels},
    {"avx512", &avx512_canny_row_kernels, &avx512_plane_row_kernels},
#endif
};

std::size_t count_sets() {
#if defined(__x86_64__)
  return detail::has_avx512() ? 4 : detail::has_avx2() ? 3 : 2;
#else
  return 1;
#endif
}

}  // namespace

std::span<const KernelSet> kernel_sets() {
  static const std::size_t count = count_sets();
  return std::span(all_sets).first(count);
}

const KernelSet& best_kernels() {
  return kernel_sets().back();
}

Result<KernelSet> kernels_by_name(std::string_view name) {
  std::string names;
  for (const KernelSet& set : kernel_sets()) {
    if (set.name == name) return set;
    names += (names.empty() ? "" : ", ") + std::string(set.name);
  }
  return Failure{Problem::bad_option,
                 "this machine has no kernels named \"" + std::string(name) + "\"; it has " + names};
}

Result<KernelSet> kernels_from_environment() {
  const char* const name = std::getenv("STRAIGHTEDGE_KERNELS");
  if (name == nullptr) return best_kernels();
  auto set = kernels_by_name(name);
  if (!set) return Failure{set.failure().problem, "STRAIGHTEDGE_KERNELS: " + set.failure().sentence};
  return set;
}

}  // namespace straightedge
