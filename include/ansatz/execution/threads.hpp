// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Threads`: runs the loops of a step on several cores, with oneTBB. The world comes to the same bits as without it,
/// on any number of threads (world/execution.hpp says why).
///
/// Use it for tens of thousands of bodies with laws of their own, with springs, or which collide: pairs are searched
/// and tested on all threads, and `SoftSubsteps<Coloured>` solves contacts on them. Springs are divided by the bodies
/// that they act on (motion/gathering.hpp): add bodies that hang together one behind the other, or many springs are
/// computed twice. What a step does in an order (other responses, islands of sleep, the door) stays serial. Many worlds
/// at once need no `Threads`: `ensemble` (ensemble.hpp) gives each a core of its own, and nothing has to wait in
/// between.
///
/// A program that includes this links oneTBB: `find_package(TBB)` and `TBB::tbb` (on Debian: libtbb-dev). No other
/// header of the library knows of it. What oneTBB keeps for its tasks is its own memory, outside of a step's promise
/// not to allocate.
///
/// Source: the scheduler is oneTBB's (Voss, Asenjo, Reinders, "Pro TBB", 2019).

#include <ansatz/core/error.hpp>
#include <ansatz/world/roles.hpp>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>

namespace ansatz {

/// An Execution: the loops of a step, run in ranges on a number of threads.
///
///     World world{Threads{}, RungeKutta4{}, Gravity{}, Drag{0.05 / second}};   // one thread for each core
///     World two{Threads{2}, VelocityVerlet{}, Gravity{}, Drag{0.05 / second}};
///
/// Copies of a world share the threads; they may step at the same time.
struct Threads {
    using role = roles::Execution;

    /// One thread for each core that the program may use.
    Threads() : Threads(oneapi::tbb::info::default_concurrency()) {}
    /// \param threads how many, the one that calls `step` among them; 1 or more, else std::invalid_argument. oneTBB
    ///                itself starts no more than there are cores.
    explicit Threads(int threads) : threads_(threads) {
        if (threads < 1)
            refuse_value("Threads", "threads", std::to_string(threads), "it is 1 or more; Threads{} takes every core");
        // oneTBB numbers the threads of an arena in sixteen bits.
        if (threads > 1) arena_ = std::make_shared<oneapi::tbb::task_arena>(std::min(threads, 1 << 14));
    }

    /// How many threads there may be.
    int threads() const { return threads_; }

    /// Calls `loop(begin, end)` for ranges that together are 0 to `count`.
    /// \param grain a range of fewer rows is not divided
    /// What a loop throws leaves this, when the others have returned.
    void execute(std::size_t count, std::size_t grain, const auto& loop) const {
        if (!arena_ || count <= grain) {
            if (count > 0) loop(std::size_t(0), count);
            return;
        }
        using Range = oneapi::tbb::blocked_range<std::size_t>;
        arena_->execute([&] {
            oneapi::tbb::parallel_for(Range(0, count, std::max<std::size_t>(grain, 1)),
                                      [&](const Range& range) { loop(range.begin(), range.end()); });
        });
    }

private:
    int threads_;
    std::shared_ptr<oneapi::tbb::task_arena> arena_; ///< none for one thread
};

} // namespace ansatz
