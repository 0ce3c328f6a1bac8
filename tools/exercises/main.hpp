// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What the main of an exercise needs: the tests of this executable in Catch2 2.13 and 3, and the comparison of probes.

#include "tests/catch.hpp"

#if __has_include(<catch2/catch_all.hpp>)
#define ANSATZ_CATCH_3
#endif

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace ansatz::workbook {

#ifdef ANSATZ_CATCH_3
using ListenerBase = Catch::EventListenerBase;
inline std::string text_of(Catch::StringRef text) { return std::string(text); }
#else
using ListenerBase = Catch::TestEventListenerBase;
inline std::string text_of(const std::string& text) { return text; }
#endif

/// A test case of an exercise, e.g. "the position moves with the old velocity", {"task-1", "old-velocity"}.
struct Test {
    std::string sentence;
    std::vector<std::string> tags;
};

/// Every test of this executable, in the order in which they are written down.
inline std::vector<Test> all_tests() {
    std::vector<Test> tests;
    Catch::ConfigData data;
    const Catch::Config config(data);
#ifdef ANSATZ_CATCH_3
    for (const auto& handle : Catch::getAllTestCasesSorted(config)) {
        const auto& info = handle.getTestCaseInfo();
        Test test{std::string(info.name), {}};
        for (const auto& tag : info.tags) test.tags.emplace_back(tag.original);
        tests.push_back(test);
    }
#else
    for (const auto& info : Catch::getAllTestCasesSorted(config)) tests.push_back({info.name, info.tags});
#endif
    return tests;
}

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

/// Equal but for rounding, which differs with the way in which a formula is written down.
inline bool same_numbers(const std::vector<double>& a, const std::vector<double>& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (std::isnan(a[i]) && std::isnan(b[i])) continue;
        if (a[i] == b[i]) continue;
        if (!std::isfinite(a[i]) || !std::isfinite(b[i])) return false;
        if (!(std::abs(a[i] - b[i]) <= 1e-9 * std::max(std::abs(a[i]), std::abs(b[i])))) return false;
    }
    return true;
}

/// Whether `mine` has the mistake of `wrong`: equal numbers in every task where `wrong` differs from the solution. Other
/// tasks may be right, wrong or not done yet.
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
