// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Two paths in letters: that of an answer and the right one, and the step at which they part. What a student sees
/// where a test follows a body through many steps.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

namespace ansatz::workbook {

/// The first step at which two paths differ by more than a tolerance, or one of them is no number; their length, if
/// there is none.
inline std::size_t step_of_parting(const std::vector<double>& yours, const std::vector<double>& right,
                                   double tolerance) {
    std::size_t step = 0;
    while (step < right.size() && std::abs(yours[step] - right[step]) <= tolerance) ++step;
    return step;
}

/// Both paths over the steps, from the one before the first to the last. What of yours is far outside of the right
/// path stands at the edge.
/// \param yours, right of one length, at least two
/// \param parting      the step that is marked, within the length
/// \param seconds      how long a step is
inline std::string drawn_paths(const std::vector<double>& yours, const std::vector<double>& right, std::size_t parting,
                               double seconds) {
    constexpr std::size_t most_columns = 61;
    constexpr int rows = 11;
    const std::size_t steps = right.size() - 1, columns = std::min(most_columns, right.size());
    const auto step_of = [&](std::size_t column) { return (column * steps + (columns - 1) / 2) / (columns - 1); };

    auto [low, high] = std::minmax_element(right.begin(), right.end());
    double bottom = *low, top = *high;
    const double margin = top > bottom ? top - bottom : std::max(std::abs(top), 1e-300);
    const double lowest = bottom - margin, highest = top + margin;
    for (const double y : yours)
        if (std::isfinite(y)) bottom = std::min(bottom, std::max(y, lowest)), top = std::max(top, std::min(y, highest));
    if (!(top > bottom)) bottom -= margin, top += margin;
    const auto row_of = [&](double y) {
        return int(std::lround((std::clamp(y, bottom, top) - bottom) / (top - bottom) * (rows - 1)));
    };

    std::vector<std::string> lines(rows, std::string(columns, ' '));
    for (std::size_t c = 0; c < columns; ++c) {
        const std::size_t s = step_of(c);
        const int r = row_of(right[s]);
        lines[std::size_t(r)][c] = '+';
        if (!std::isfinite(yours[s])) continue;
        auto& mark = lines[std::size_t(row_of(yours[s]))][c];
        mark = mark == '+' ? '*' : 'o';
    }
    const auto number = [](double value) {
        std::ostringstream text;
        text << std::setprecision(4) << value;
        return text.str();
    };
    std::ostringstream picture;
    for (int r = rows; r-- > 0;) {
        picture << std::setw(10) << (r == rows - 1 ? number(top) : r == 0 ? number(bottom) : "") << " |";
        const auto& line = lines[std::size_t(r)];
        picture << line.substr(0, line.find_last_not_of(' ') + 1) << '\n';
    }
    std::string axis(columns, '-');
    std::size_t mark = 0;
    while (mark + 1 < columns && step_of(mark) < parting) ++mark;
    axis[mark] = '^';
    const std::string end = number(double(steps) * seconds) + " s";
    picture << std::string(11, ' ') << '+' << axis << '\n'
            << std::string(12, ' ') << "0" << std::string(columns > end.size() + 1 ? columns - end.size() - 1 : 1, ' ')
            << end << '\n'
            << std::string(12, ' ') << "o yours   + right   * both   ^ where they part\n";
    return picture.str();
}

} // namespace ansatz::workbook
