// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Rehearsal`: an Execution that runs all on one thread and works out how long it would have taken on many cores.
///
/// Each loop that is divided is cut as for so many cores, the ranges are timed one after the other, and each is given
/// to the core that is free first. What is not divided takes the time that it takes. Waking the others costs what was
/// measured on this machine for one, once for each time that the number of cores doubles. What one machine cannot tell
/// is not in it: cores that share caches and memory, or a clock that slows down when all of them work.

#include <ansatz/world/roles.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace peers {

/// s, by the clock on the wall.
inline double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// As many cores as one likes, one after the other.
struct Rehearsal {
    using role = ansatz::roles::Execution;

    /// \param cores how many
    /// \param wake  s, what waking another thread takes
    Rehearsal(int cores, double wake) : cores_(cores), wake_(wake * std::log2(double(cores))) {}
    /// How many cores there are.
    int threads() const { return cores_; }
    /// Runs ranges one after the other.
    void execute(std::size_t count, std::size_t grain, const auto& loop) const {
        const std::size_t ranges =
            std::min(count / std::max<std::size_t>(grain, 1), ranges_for_each_core * std::size_t(cores_));
        if (ranges <= 1) { // left alone
            if (count > 0) loop(std::size_t(0), count);
            return;
        }
        std::vector<double> busy(std::size_t(cores_), 0.0); // s, of each core
        double before = wall_seconds();
        for (std::size_t n = 0; n < ranges; ++n) {
            loop(count * n / ranges, count * (n + 1) / ranges);
            const double now = wall_seconds();
            *std::min_element(busy.begin(), busy.end()) += now - before;
            before = now;
        }
        *gained_ += std::accumulate(busy.begin(), busy.end(), -wake_) - *std::max_element(busy.begin(), busy.end());
    }
    /// s, by how much all that was run since the last time would have been shorter.
    double take_gained() const { return std::exchange(*gained_, 0.0); }

private:
    static constexpr std::size_t ranges_for_each_core = 4;
    int cores_;
    double wake_;                                                  // s, the others of them
    std::shared_ptr<double> gained_ = std::make_shared<double>(0); // of all copies
};

} // namespace peers
