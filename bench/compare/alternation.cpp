// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "alternation.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "thread_time.hpp"

namespace compare {
namespace {

/// A row is not worth more.
constexpr double most_ms_a_row = 2000;

/// A tenth of a millisecond after somebody else's three hundred would tell of the caches that those left.
constexpr double least_ms_a_turn = 2;

double now_ms(Clock clock) {
  if (clock == Clock::thread) return bench::thread_ms();
  const auto since = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>(since).count();
}

double time_ms(const std::function<void()>& call, int times, Clock clock) {
  const double before = now_ms(clock);
  for (int i = 0; i < times; ++i) call();
  return (now_ms(clock) - before) / times;
}

/// As many as fill a turn. The first call, which fetches memory, tells only that one may be too few.
int calls_a_turn(const Job& job, const std::function<void()>& call, Clock clock) {
  if (time_ms(call, 1, clock) >= least_ms_a_turn || job.one_call_a_turn) return 1;
  return static_cast<int>(std::clamp(least_ms_a_turn / time_ms(call, 1, clock), 1.0, 1000.0));
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace

void print_head() {
  std::printf(
      "| job | size | kernels | peer | Straightedge, ms | peer, ms | times faster | quartiles | answers |\n");
  std::printf("| --- | --- | --- | --- | ---: | ---: | ---: | --- | --- |\n");
}

void print_row(const Job& job, int rounds, Clock clock) {
  const int our_calls = calls_a_turn(job, job.ours, clock);
  const int their_calls = calls_a_turn(job, job.theirs, clock);
  if (!job.agree()) {
    std::fprintf(stderr, "%s\n", job.answers().c_str());
    std::fprintf(stderr, "%s, %s, %s, %s: the answers differ\n", job.name.c_str(), job.size.c_str(),
                 job.kernels.c_str(), job.peer.c_str());
    std::exit(70);
  }
  std::vector<double> ours, theirs, ratios;
  double spent = 0;
  for (int round = 0; round < rounds && (round < 3 || spent < most_ms_a_row); ++round) {
    ours.push_back(time_ms(job.ours, our_calls, clock));
    theirs.push_back(time_ms(job.theirs, their_calls, clock));
    ratios.push_back(theirs.back() / ours.back());
    spent += ours.back() * our_calls + theirs.back() * their_calls;
  }
  std::printf("| %s | %s | %s | %s | %.3f | %.3f | %.2f | %.2f–%.2f | %s |\n", job.name.c_str(),
              job.size.c_str(), job.kernels.c_str(), job.peer.c_str(), bench::median(ours),
              bench::median(theirs), bench::median(ratios), quantile(ratios, 0.25), quantile(ratios, 0.75),
              job.answers().c_str());
  std::fflush(stdout);
}

}  // namespace compare
