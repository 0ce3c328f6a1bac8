// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What `./workbook play` shows: your code and the library's, as policies of the same real World, side by side.

#include <time.h>

#include <algorithm>
#include <functional>
#include <iomanip>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace ansatz::workbook {

/// A table with a row for each answer: the numbers of its scene, and the time that it takes.
class Play {
public:
    /// \param scene   what happens, e.g. "a mass on a spring, omega = 10/s, 60 steps a second, 3 s"
    /// \param columns what each number of a row is, with its unit
    Play(const std::string& scene, std::vector<std::string> columns) : columns_(std::move(columns)) {
        std::cout << scene << "\n\n";
    }

    /// Says what the time is for, where there are neither bodies nor steps: "ns a call".
    void timed(std::string what) { timed_ = std::move(what); }

    /// \param numbers as many as there are columns
    /// \param step    does what is timed, for `bodies` bodies at once
    void row(const std::string& who, std::vector<double> numbers, int bodies, std::function<void()> step) {
        rows_.push_back({who, std::move(numbers), bodies, std::move(step)});
    }

    /// Times all rows in turns, prints them, and says whether the first two rows' numbers are the same. 0, for main.
    int print() {
        for (int repeat = 0; repeat < 25; ++repeat)
            for (Row& row : rows_) row.nanoseconds = std::min(row.nanoseconds, time_of(row));
        constexpr int first = 10;
        std::cout << std::setw(first) << "";
        for (const auto& column : columns_) std::cout << "  " << std::setw(width_of(column)) << column;
        std::cout << "  " << std::setw(18) << timed_ << '\n';
        for (const Row& row : rows_) {
            std::cout << std::left << std::setw(first) << row.who << std::right;
            for (std::size_t i = 0; i < columns_.size(); ++i)
                std::cout << "  " << std::setw(width_of(columns_[i])) << shown(row.numbers[i]);
            std::cout << "  " << std::setw(18) << std::fixed << std::setprecision(2) << row.nanoseconds
                      << std::defaultfloat << '\n';
        }
        if (rows_.size() > 1)
            std::cout << (rows_[0].numbers == rows_[1].numbers
                              ? "\nYour numbers are the library's, to the last bit.\n"
                              : "\nYour numbers are not the library's to the last bit; the table says by how much they "
                                "differ.\nThat is no mistake by itself: the same formula in another order rounds "
                                "otherwise, and where many\nbodies collide a last bit grows. Our own solution may "
                                "differ likewise.\n");
        std::clog << "the scene is over\n"; // how the workbook knows that nothing has ended the program before
        return 0;
    }

private:
    struct Row {
        std::string who;
        std::vector<double> numbers;
        int bodies;
        std::function<void()> step;
        double nanoseconds = std::numeric_limits<double>::infinity();
    };

    static int width_of(const std::string& column) { return std::max(14, static_cast<int>(column.size())); }
    static std::string shown(double number) {
        std::ostringstream text;
        text << std::setprecision(9) << number;
        return text.str();
    }
    /// This thread's CPU time for a body and step, the mean of 50 steps.
    static double time_of(const Row& row) {
        auto now = [] {
            timespec t{};
            clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
            return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
        };
        const double start = now();
        for (int i = 0; i < 50; ++i) row.step();
        return (now() - start) / 50 / row.bodies;
    }

    std::vector<std::string> columns_;
    std::string timed_ = "ns a body and step";
    std::vector<Row> rows_;
};

} // namespace ansatz::workbook
