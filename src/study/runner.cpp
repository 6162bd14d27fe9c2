// SPDX-License-Identifier: BSD-3-Clause
#include "study/runner.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace hidwa_local_planner {
namespace study {

void make_runs(const std::vector<Run>& runs, std::size_t threads, const std::function<void(const Run&)>& make,
               const std::function<void()>& made) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::size_t i = next++; i < runs.size() && !failed; i = next++) {
      try {
        make(runs[i]);
        const std::lock_guard<std::mutex> lock(mutex);
        made();
      } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex);
        if (!failure) failure = std::current_exception();
        failed = true;
      }
    }
  };
  std::vector<std::thread> workers;
  for (std::size_t i = 1; i < std::min(threads, runs.size()); ++i) workers.emplace_back(work);
  work();
  for (std::thread& worker : workers) worker.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace study
}  // namespace hidwa_local_planner
