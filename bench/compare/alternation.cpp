// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "alternation.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "thread_time.hpp"

namespace compare {
namespace {

double time_ms(const std::function<void()>& call) {
  const double before = bench::thread_ms();
  call();
  return bench::thread_ms() - before;
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace

void print_head() {
  std::printf("| job | size | kernels | Straightedge, ms | peer, ms | times faster | quartiles |\n");
  std::printf("| --- | --- | --- | ---: | ---: | ---: | --- |\n");
}

void print_row(const Job& job, int rounds) {
  job.ours();
  job.theirs();
  if (!job.agree()) {
    std::fprintf(stderr, "%s, %s, %s: the answers differ\n", job.name.c_str(), job.size.c_str(),
                 job.kernels.c_str());
    std::exit(70);
  }
  std::vector<double> ours, theirs, ratios;
  for (int round = 0; round < rounds; ++round) {
    ours.push_back(time_ms(job.ours));
    theirs.push_back(time_ms(job.theirs));
    ratios.push_back(theirs.back() / ours.back());
  }
  std::printf("| %s | %s | %s | %.3f | %.3f | %.2f | %.2f–%.2f |\n", job.name.c_str(), job.size.c_str(),
              job.kernels.c_str(), bench::median(ours), bench::median(theirs), bench::median(ratios),
              quantile(ratios, 0.25), quantile(ratios, 0.75));
  std::fflush(stdout);
}

}  // namespace compare
