// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Race`: subjects that do the same work, and how many times longer one may take than another. Ratios of one run:
/// every subject in turn, many times over, this thread's CPU time, the smallest of the repeats. A neighbour on the
/// machine can only make a repeat slower, and some repeats are always undisturbed when there are enough of them: so
/// while a bound does not hold, more are taken, up to `most_rounds`, before the test fails. What the table says is then
/// still the smallest of all, of both sides of a ratio.
///
/// Time needs an idle machine, so the timed race is a stage by name (`.ci/run times`). Every change runs the same race
/// under callgrind, where a repeat is one step and its instructions are counted: the same number each time.

#include "tests/catch.hpp"

#include <time.h>
#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#endif

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <fstream>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace ansatz::test {

constexpr int repeats_a_round = 15, fewest_rounds = 3, most_rounds = 20;
constexpr double shortest_repeat = 0.001; // s

inline double thread_seconds() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

/// What callgrind is to write its counts into, and does when a program asks it to; nothing where time is measured.
inline const char* counts_file() { return std::getenv("ANSATZ_COUNTS"); }

/// How often callgrind was asked to write its counts: the number that it adds to the file's name.
inline int dumps = 0;

/// The instructions of one call. Callgrind runs with `--instr-atstart=no --callgrind-out-file=$ANSATZ_COUNTS`.
template <class F> double instructions([[maybe_unused]] F&& call) {
#ifdef CALLGRIND_DUMP_STATS
    CALLGRIND_ZERO_STATS;
    CALLGRIND_START_INSTRUMENTATION;
    call();
    CALLGRIND_STOP_INSTRUMENTATION;
    CALLGRIND_DUMP_STATS;
    std::ifstream dump(std::string(counts_file()) + "." + std::to_string(++dumps));
    for (std::string word; dump >> word;)
        if (double counted = 0; (word == "totals:" || word == "summary:") && dump >> counted && counted > 0)
            return counted;
#endif
    FAIL("callgrind counted nothing: is ANSATZ_COUNTS its --callgrind-out-file?");
    return 0;
}

/// Something that advances `bodies` bodies by some steps.
struct Subject {
    std::string name;
    std::size_t bodies;
    std::function<void(int steps)> run;
    int steps = 1;                 // of one repeat
    std::vector<double> repeats{}; // ns a body and step, or instructions

    double best() const { return *std::min_element(repeats.begin(), repeats.end()); }
    double spread() const {
        std::vector<double> sorted = repeats;
        std::sort(sorted.begin(), sorted.end());
        return sorted[sorted.size() / 2] / sorted.front() - 1;
    }
};

/// The subjects of one table, and what must hold between them.
class Race {
public:
    using Competitor = const Subject&;

    Competitor add(std::string name, std::size_t bodies, std::function<void(int)> run) {
        return subjects_.emplace_back(Subject{std::move(name), bodies, std::move(run)});
    }
    /// `ours` takes at most `limit` times what the fastest of `others` takes.
    /// \param known_miss where the limit cannot be met: the table says MISSED, and what was measured must not become
    /// worse
    /// \param counted the limit of instructions, where it is another one than that of time
    void bound(std::string what, Competitor ours, std::vector<const Subject*> others, double limit,
               double known_miss = 0, double counted = 0) {
        const bool other = counts_file() && counted > 0;
        bounds_.push_back({std::move(what), &ours, std::move(others), other ? counted : limit, other ? 0 : known_miss});
    }

    void run() {
        int rounds = 0;
        if (counts_file()) {
            for (Subject& s : subjects_) {
                s.run(1); // what is allocated once
                s.repeats.push_back(instructions([&] { s.run(1); }) / double(s.bodies));
            }
            return tell("instructions of one step, counted by callgrind", "instructions");
        }
        for (Subject& s : subjects_) warm_up(s);
        do {
            for (int repeat = 0; repeat < repeats_a_round; ++repeat)
                for (Subject& s : subjects_) one(s);
            ++rounds;
        } while (rounds < fewest_rounds || (rounds < most_rounds && !all_hold()));

        tell("smallest of " + std::to_string(rounds * repeats_a_round) +
                 " repeats, taken in turn; spread: how far their median lies above it",
             "ns");
    }

private:
    /// The table, and what does not hold.
    void tell(const std::string& how, const std::string& unit) const {
        std::printf("\n%s\n%s\n\n", ANSATZ_FLAGS, how.c_str());
        std::printf("%-46s %8s %14s %8s\n", "", "bodies", (unit + " a body").c_str(), "spread");
        for (const Subject& s : subjects_)
            std::printf("%-46s %8zu %14.3f %6.0f %%\n", s.name.c_str(), s.bodies, s.best(), 100 * s.spread());
        std::printf("\n%-70s %8s %8s\n", "", "ratio", "at most");
        for (const Bound& b : bounds_)
            std::printf("%-70s %8.3f %8.3f  %s\n", b.what.c_str(), b.ratio(), b.limit,
                        b.ratio() <= b.limit ? "PASS"
                        : b.holds()          ? "MISSED"
                                             : "FAIL");
        std::fflush(stdout);
        for (const Bound& b : bounds_) {
            INFO(b.what << ": " << b.ratio() << " times, at most " << b.limit << "; " << how);
            CHECK(b.holds());
        }
    }

    struct Bound {
        std::string what;
        const Subject* ours;
        std::vector<const Subject*> others;
        double limit, known_miss;
        double ratio() const {
            double fastest = std::numeric_limits<double>::infinity();
            for (const Subject* other : others) fastest = std::min(fastest, other->best());
            return ours->best() / fastest;
        }
        bool holds() const { return ratio() <= std::max(limit, known_miss); }
    };

    bool all_hold() const {
        return std::all_of(bounds_.begin(), bounds_.end(), [](const Bound& b) { return b.holds(); });
    }
    static double seconds_of(const Subject& s) {
        const double start = thread_seconds();
        s.run(s.steps);
        return thread_seconds() - start;
    }
    static void warm_up(Subject& s) {
        while (seconds_of(s) < shortest_repeat) s.steps *= 2;
    }
    static void one(Subject& s) { s.repeats.push_back(1e9 * seconds_of(s) / s.steps / double(s.bodies)); }

    std::deque<Subject> subjects_; // so that references stay
    std::vector<Bound> bounds_;
};

} // namespace ansatz::test
