// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `OnThreads`: the runs of an ensemble on the cores of this machine, with oneTBB.
///
/// A program that includes this links oneTBB: `find_package(TBB)` and `TBB::tbb` (on Debian: libtbb-dev).

#include <ansatz/core/error.hpp>
#include <ansatz/execution/ensemble.hpp>

#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace ansatz {

/// Runs of an ensemble on several threads, a run on one. Its results are those of `OneByOne`, to the bit.
///
/// When a run throws, those that are under way end, and are kept; no other begins.
struct OnThreads {
    /// One thread for each core that the program may use.
    OnThreads() : OnThreads(oneapi::tbb::info::default_concurrency()) {}
    /// \param threads 1 or more, else std::invalid_argument. oneTBB itself starts no more than there are cores.
    explicit OnThreads(int threads) : threads_(threads) {
        if (threads < 1)
            refuse_value("OnThreads", "threads", std::to_string(threads),
                         "it is 1 or more; OnThreads{} takes every core");
    }

    /// Calls `take(i, run(i))` for each i of `todo`: `run` on any thread, `take` one at a time.
    /// \throws what the first run of the list that failed threw
    template <class Result> void each(const std::vector<std::size_t>& todo, const auto& run, const auto& take) const {
        std::mutex taking;
        std::atomic<std::size_t> next = 0, failed_at = todo.size();
        std::exception_ptr failure;
        const auto work = [&] {
            // Handed out one by one: runs differ in length, and the first to fail is the first of the list.
            for (std::size_t k = next++; k < todo.size() && failed_at == todo.size(); k = next++) try {
                    Result result = run(todo[k]);
                    const std::lock_guard lock(taking);
                    take(todo[k], std::move(result));
                } catch (...) {
                    const std::lock_guard lock(taking);
                    if (k < failed_at) {
                        failed_at = k;
                        failure = std::current_exception();
                    }
                }
        };
        // No more than there are runs, nor than the sixteen bits in which oneTBB numbers the threads of an arena.
        const int workers = int(std::min({std::size_t(threads_), todo.size(), std::size_t(1) << 14}));
        oneapi::tbb::task_arena arena(std::max(workers, 1));
        // A worker is a task; one that begins late finds nothing left to do.
        arena.execute([&] {
            oneapi::tbb::parallel_for(
                0, workers, [&](int) { work(); }, oneapi::tbb::simple_partitioner{});
        });
        if (failure) std::rethrow_exception(failure);
    }

private:
    int threads_;
};

} // namespace ansatz
