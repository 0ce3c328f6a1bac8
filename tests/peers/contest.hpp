// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Contest`: scenes that several libraries play, timed in turn: what `./workbook peers` runs.
///
/// A program for each area has a main that makes a Contest, hands it scenes and writes its rows. A scene is a list of
/// subjects that do the same work for `n` bodies; each is run in turn, many times over, by this thread's CPU time, and
/// the smallest of its repeats counts. Ratios of one run are what a reader may compare.

#include "tests/peers/versions.hpp"
#include "tools/costs/json.hpp"

#include <time.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace peers {

/// Somebody who plays a scene.
struct Subject {
    std::string name;          ///< "ansatz <policy>", or the library's
    std::function<void()> run; ///< one repeat
    std::string remark{};      ///< what it does more, or less, than the others
};

/// One number of the table.
struct Row {
    std::string area, scene;
    int n;
    std::string subject;
    double value;
    std::string unit;
    double spread;      ///< of the median over the smallest
    std::string remark; ///< what the subject says of itself
};

class Contest {
public:
    /// \param clock by which the area measures
    explicit Contest(std::string area, int repeats, std::string clock = "thread CPU time, one thread")
        : area_(std::move(area)), clock_(std::move(clock)), repeats_(repeats) {}

    /// Times the subjects in turn and keeps a row for each.
    /// \param unit    e.g. "ns a body"
    /// \param divisor by what a repeat's nanoseconds are divided to be in that unit
    void play(const std::string& scene, int n, const std::string& unit, double divisor,
              const std::vector<Subject>& subjects) {
        std::vector<std::vector<double>> times(subjects.size());
        for (const Subject& s : subjects) s.run(); // warm
        for (int repeat = 0; repeat < repeats_; ++repeat)
            for (std::size_t k = 0; k < subjects.size(); ++k) {
                const double start = thread_seconds();
                subjects[k].run();
                times[k].push_back(1e9 * (thread_seconds() - start) / divisor);
            }
        std::printf("\n%s, n = %d, smallest of %d repeats in turn\n", scene.c_str(), n, repeats_);
        for (std::size_t k = 0; k < subjects.size(); ++k) {
            std::sort(times[k].begin(), times[k].end());
            const double best = times[k].front(), spread = times[k][times[k].size() / 2] / best - 1;
            std::printf("  %-34s %10.1f %s   (median %+.0f %%)  %s\n", subjects[k].name.c_str(), best, unit.c_str(),
                        100 * spread, subjects[k].remark.c_str());
            rows_.push_back({area_, scene, n, subjects[k].name, best, unit, spread, subjects[k].remark});
        }
        std::fflush(stdout);
    }
    /// A number that a scene measured by itself.
    void note(const std::string& scene, int n, const std::string& subject, double value, const std::string& unit,
              double spread = 0) {
        rows_.push_back({area_, scene, n, subject, value, unit, spread, ""});
    }
    int repeats() const { return repeats_; } ///< of every subject of a scene
    /// The processor's time that this thread has used, s.
    static double thread_seconds() {
        timespec t{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
        return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
    }
    /// A subject that cannot play, because it was not found.
    static void left_out(const std::string& library, const std::string& package) {
        std::cout << "left out: " << library << " (on Debian: apt install " << package << ")\n";
    }
    /// `{"machine": {...}, "versions": {...}, "rows": [...]}` into `<folder>/<area>.json`.
    void write(const std::string& folder) const {
        const auto machine = ansatz::workbook::this_machine();
        ansatz::workbook::Json json;
        json["machine"] = {{"cpu", machine.cpu},       {"cores", machine.cores},
                           {"system", machine.system}, {"compiler", machine.compiler},
                           {"flags", machine.flags},   {"date", machine.date},
                           {"clock", clock_},          {"repeats", repeats_}};
        json["versions"] = versions();
        json["rows"] = ansatz::workbook::Json::array();
        for (const Row& r : rows_)
            json["rows"].push_back({{"area", r.area},
                                    {"scene", r.scene},
                                    {"n", r.n},
                                    {"subject", r.subject},
                                    {"value", r.value},
                                    {"unit", r.unit},
                                    {"spread", r.spread},
                                    {"remark", r.remark}});
        const std::string file = folder + "/" + area_ + ".json";
        ansatz::workbook::write_whole(file, json.dump(2) + "\n");
        std::cout << "\nwritten: " << file << '\n';
    }

private:
    std::string area_, clock_;
    int repeats_;
    std::vector<Row> rows_;
};

} // namespace peers
