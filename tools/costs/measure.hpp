// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Times runs with Google Benchmark: thread CPU time, the repeats of all rows shuffled among each
/// other, the minimum kept. On a shared machine the same loop takes five times as long when a
/// neighbour wakes up; that hits some repeats of every row instead of every repeat of some row.

#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "row.hpp"

namespace ansatz::workbook {

/// The nanoseconds that one run took, and how far the median of the repeats lies above them.
struct Timing {
    Number nanoseconds{};
    Number spread{};
};

struct TimingPlan {
    int repeats = 15;
    double sample_seconds = 0.010;   ///< runs are repeated within one sample until it lasts this long
    double once_above_seconds = 2.0; ///< a run that takes longer is not repeated: its noise averages out
    bool show_progress = true;
};

namespace detail {

/// This thread's CPU time in seconds.
inline double thread_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// The mean time of `times` runs, one after the other.
inline double seconds_of(const Timed& run, std::int64_t times) {
    const double start = thread_seconds();
    for (std::int64_t i = 0; i < times; ++i) run();
    return std::max(thread_seconds() - start, 1e-9) / static_cast<double>(times);
}

/// Gathers every single repeat, and prints nothing.
class Gather : public benchmark::BenchmarkReporter {
public:
    explicit Gather(std::size_t rows) : samples(rows) {}
    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
            // benchmarks are named by the number of their row
            samples[std::stoul(run.run_name.function_name)].push_back(run.GetAdjustedCPUTime());
        }
    }
    std::vector<std::vector<double>> samples; // nanoseconds of one run, for every row and repeat
};

/// One line on the terminal that overwrites itself; nothing where nobody watches.
inline void progress(const std::string& text) {
    if (isatty(STDERR_FILENO) != 0) std::fprintf(stderr, "\r\033[K%s", text.c_str());
}

} // namespace detail

/// The smallest of some samples, and (median - smallest) / smallest.
inline Timing summarise(std::vector<double> samples) {
    if (samples.empty()) return {};
    std::sort(samples.begin(), samples.end());
    const double smallest = samples.front();
    if (samples.size() < 3 || !(smallest > 0)) return {smallest, {}};
    const std::size_t middle = samples.size() / 2;
    const double median = samples.size() % 2 == 1 ? samples[middle] : (samples[middle - 1] + samples[middle]) / 2;
    return {smallest, (median - smallest) / smallest};
}

/// Times all runs of a table together, so that their repeats can be interleaved.
inline std::vector<Timing> time_runs(const std::vector<Timed>& runs, const TimingPlan& plan) {
    std::vector<Timing> timings(runs.size());
    std::vector<std::size_t> repeated;
    double estimate = 0;
    benchmark::ClearRegisteredBenchmarks();
    int done = 0, all = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (!runs[i]) continue;
        // The first run warms up caches and kept memory; then runs are bundled until a bundle lasts long
        // enough to tell how many of them make a sample.
        detail::progress(plan.show_progress ? "warming up " + std::to_string(i + 1) + "/" + std::to_string(runs.size())
                                            : "");
        double seconds = detail::seconds_of(runs[i], 1);
        if (seconds > plan.once_above_seconds) {
            timings[i].nanoseconds = 1e9 * seconds;
            continue;
        }
        for (std::int64_t bundle = 1;
             seconds * static_cast<double>(bundle) < plan.sample_seconds / 8 && bundle < (1 << 20);) {
            bundle *= 4;
            seconds = detail::seconds_of(runs[i], bundle);
        }
        const auto iterations =
            static_cast<std::int64_t>(std::clamp(std::ceil(plan.sample_seconds / seconds), 1.0, 1e7));
        estimate += plan.repeats * seconds * static_cast<double>(iterations);
        repeated.push_back(i);
        benchmark::RegisterBenchmark(std::to_string(i).c_str(),
                                     [&, i](benchmark::State& state) {
                                         ++done;
                                         if (plan.show_progress) {
                                             char text[96];
                                             std::snprintf(text, sizeof text, "timing %d/%d (about %.0f s in all)",
                                                           done, all, std::ceil(estimate));
                                             detail::progress(text);
                                         }
                                         for (auto _ : state) runs[i]();
                                     })
            ->Iterations(iterations)
            ->Repetitions(plan.repeats)
            ->Unit(benchmark::kNanosecond);
    }
    if (!repeated.empty()) {
        all = plan.repeats * static_cast<int>(repeated.size());
        std::string program = "what_it_costs", interleave = "--benchmark_enable_random_interleaving=true";
        char* arguments[] = {program.data(), interleave.data(), nullptr};
        int count = 2;
        benchmark::Initialize(&count, arguments);
        detail::Gather gather{runs.size()};
        benchmark::RunSpecifiedBenchmarks(&gather);
        for (std::size_t i : repeated) timings[i] = summarise(gather.samples[i]);
        benchmark::ClearRegisteredBenchmarks();
    }
    detail::progress("");
    return timings;
}

} // namespace ansatz::workbook
