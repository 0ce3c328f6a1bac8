// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// How an answer is recognised as a known mistake: the numbers that it computes are compared with those of each wrong
/// one.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace ansatz::workbook {

/// What a subject computed, for each task; a task that threw or crashed has nothing.
using Probes = std::map<int, std::vector<double>>;

inline Probes read_probes(const std::string& file) {
    Probes probes;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        int task = 0;
        std::string word;
        std::vector<double> numbers;
        words >> task;
        bool whole = true;
        while (words >> word) {
            char* end = nullptr;
            numbers.push_back(std::strtod(word.c_str(), &end));
            whole = whole && *end == '\0';
        }
        if (whole && task > 0 && !numbers.empty()) probes[task] = numbers;
    }
    return probes;
}

/// Equal but for rounding, which differs with the way in which a formula is written down. Where terms cancel, what is
/// left is the rounding of what came before: so that is no number but zero which is as small as that beside the
/// largest.
inline bool same_numbers(const std::vector<double>& a, const std::vector<double>& b) {
    if (a.size() != b.size()) return false;
    double largest = 0;
    for (const auto* numbers : {&a, &b})
        for (const double x : *numbers)
            if (std::isfinite(x)) largest = std::max(largest, std::abs(x));
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (std::isnan(a[i]) && std::isnan(b[i])) continue;
        if (a[i] == b[i]) continue;
        if (!std::isfinite(a[i]) || !std::isfinite(b[i])) return false;
        const double larger = std::max(std::abs(a[i]), std::abs(b[i]));
        if (larger <= 4e-15 * largest) continue;
        if (!(std::abs(a[i] - b[i]) <= 1e-9 * larger)) return false;
    }
    return true;
}

/// Whether `mine` has the mistake of `wrong`: equal numbers in every task where `wrong` differs from the solution.
/// Other tasks may be right, wrong or not done yet.
inline bool same_mistake(const Probes& mine, const Probes& solution, const Probes& wrong) {
    bool somewhere = false;
    for (const auto& [task, right] : solution) {
        const auto w = wrong.find(task);
        if (w == wrong.end() || same_numbers(w->second, right)) continue;
        const auto m = mine.find(task);
        if (m == mine.end() || !same_numbers(m->second, w->second)) return false;
        somewhere = true;
    }
    return somewhere;
}

} // namespace ansatz::workbook
