// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace straightedge {

/// One for each processor that the system offers, at least 1.
unsigned processors() noexcept;

/// Threads that wait for work, so that starting a piece of it costs microseconds. They choose among
/// themselves who does what: results are the same for any number of them when every index writes to places
/// of its own, and what is added up over indices is whole numbers.
class ThreadPool {
 public:
  /// `thread` is below threads(), 0 is the caller's own: index into what each thread keeps for itself.
  using Work = std::function<void(std::size_t index, unsigned thread)>;

  /// The caller's thread counts. 0: as many as there are processors. Where the system gives no more threads
  /// the pool has fewer.
  explicit ThreadPool(unsigned threads = 0);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  unsigned threads() const noexcept;

  /// Calls work(i, thread) once for every i below count, and returns when all calls have. Indices begin in
  /// ascending order. When a call throws, no further index begins and the exception of the lowest index that
  /// threw leaves here. For one caller at a time, and not from inside the work.
  void for_each_index(std::size_t count, const Work& work);

 private:
  struct Team;
  std::unique_ptr<Team> team_;
};

/// The same with threads of its own, not more than indices: 0 for as many as there are processors, 1 for
/// none.
void for_each_index(std::size_t count, unsigned threads, const ThreadPool::Work& work);

}  // namespace straightedge
