// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// A cost table for the terminal: one group a problem, columns only where there is something to say.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "../width.hpp"
#include "order.hpp"
#include "row.hpp"

namespace ansatz::workbook {

/// A time whose repeats typically lie this far above their minimum is not to be trusted; it is flagged.
inline constexpr double spread_limit = 0.05;

/// 12800 as "12 800": counts are compared by their length.
inline std::string grouped(double count) {
    char text[40];
    std::snprintf(text, sizeof text, "%.0f", count);
    const std::string digits{text};
    std::string spaced;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        const std::size_t left = digits.size() - i;
        if (i > 0 && left % 3 == 0 && digits[i - 1] != '-') spaced += ' ';
        spaced += digits[i];
    }
    return spaced;
}

/// A time with three significant digits, never in powers of ten below a million: 0.0123, 12.3, 12 300.
inline std::string time_text(double exact) {
    if (exact == 0 || !std::isfinite(exact)) return "0";
    const double time = std::stod(significant(exact, 3)); // rounded first: 999.96 has four places before the point
    const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(time))));
    if (magnitude < -3 || magnitude > 8) return significant(time, 3);
    if (magnitude >= 3) {
        const double unit = std::pow(10.0, magnitude - 2);
        return grouped(std::round(time / unit) * unit);
    }
    char text[40];
    std::snprintf(text, sizeof text, "%.*f", std::max(0, 2 - magnitude), time);
    return text;
}

namespace detail {

struct Column {
    std::string head;
    bool left; // text stands left, numbers right
    std::function<std::string(const Row&)> cell;
};

inline std::vector<Column> columns(const Row& like) {
    const auto scientific = [](const Number& number) {
        char text[40] = "";
        if (number) std::snprintf(text, sizeof text, "%.2e", *number);
        return std::string{text};
    };
    return {
        {"choice", true, [](const Row& r) { return r.choice; }},
        {"parameter", true, [](const Row& r) { return r.parameter.text(); }},
        {"n", false, [](const Row& r) { return r.n ? grouped(*r.n) : std::string{}; }},
        {"error", false, [=](const Row& r) { return r.diverged ? std::string{"diverged"} : scientific(r.error); }},
        {like.work_unit, false, [](const Row& r) { return r.work ? grouped(*r.work) : std::string{}; }},
        {"time", false, [](const Row& r) { return r.time ? time_text(*r.time) : std::string{}; }},
        {"spread", false,
         [](const Row& r) {
             if (!r.spread) return std::string{};
             char text[40];
             std::snprintf(text, sizeof text, "%.1f %%%s", 100 * *r.spread, *r.spread > spread_limit ? " !" : "  ");
             return std::string{text};
         }},
        {"order", false,
         [](const Row& r) {
             if (!r.order) return std::string{};
             char text[40];
             std::snprintf(text, sizeof text, "%.2f%s", *r.order, order_is_off(r) ? " !" : "  ");
             return std::string{text};
         }},
        {"known", false, [](const Row& r) { return r.known_order ? significant(*r.known_order, 3) : std::string{}; }},
    };
}

inline void print_group(std::ostream& out, const Rows& rows) {
    std::vector<Column> shown;
    std::vector<std::size_t> widths;
    for (const Column& column : columns(rows.front())) {
        std::size_t widest = 0;
        for (const Row& row : rows) widest = std::max(widest, visible_width(column.cell(row)));
        if (widest == 0) continue; // a column that nothing stands in is not printed
        shown.push_back(column);
        widths.push_back(std::max(widest, visible_width(column.head)));
    }
    const auto line = [&](const std::function<std::string(std::size_t)>& cell) {
        std::string text;
        for (std::size_t i = 0; i < shown.size(); ++i) {
            const std::string content = cell(i);
            const std::string space(widths[i] - visible_width(content), ' ');
            text += "  " + (shown[i].left ? content + space : space + content);
        }
        text.erase(text.find_last_not_of(' ') + 1);
        out << text << '\n';
    };

    line([&](std::size_t i) {
        // Flags take two places beside their number; the head stands over the number.
        const bool flagged = shown[i].head == "spread" || shown[i].head == "order";
        return flagged && widths[i] >= visible_width(shown[i].head) + 2 ? shown[i].head + "  " : shown[i].head;
    });
    std::string choice;
    for (const Row& row : rows) {
        const bool again = row.choice == choice;
        line([&](std::size_t i) { return i == 0 && again ? std::string{} : shown[i].cell(row); });
        choice = row.choice;
    }
}

} // namespace detail

/// Prints every row, grouped by axis and problem, with what the marks mean where one stands.
inline void print_table(std::ostream& out, const Rows& rows) {
    bool noisy = false, off = false;
    for (const std::string& axis : different(rows, &Row::axis)) {
        const Rows of_axis = where(rows, &Row::axis, axis);
        for (const std::string& problem : different(of_axis, &Row::problem)) {
            const Rows group = where(of_axis, &Row::problem, problem);
            const Row& first = group.front();
            out << axis << (problem.empty() ? "" : ": " + problem) << '\n';
            if (!first.error_norm.empty()) out << "  error: " << first.error_norm << '\n';
            if (std::any_of(group.begin(), group.end(), [](const Row& row) { return row.time.has_value(); }))
                out << "  time: " << first.time_unit << '\n';
            detail::print_group(out, group);
            out << '\n';
            for (const Row& row : group) {
                noisy = noisy || (row.spread && *row.spread > spread_limit);
                off = off || order_is_off(row);
            }
        }
    }
    if (noisy)
        out << "! beside a spread: the median repeat is more than 5 % above the minimum kept; close other programs and "
               "repeat.\n";
    if (off) out << "! beside an order: more than 0.1 off the known one.\n";
}

} // namespace ansatz::workbook
