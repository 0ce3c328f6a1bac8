// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// A table of a section's program whose columns are as wide as what stands in them, units included.

#include "width.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace ansatz::workbook {

/// What std::cout would print of these, one behind the other: printed(depth, " mm").
template <class... Values> std::string printed(const Values&... values) {
    std::ostringstream text;
    text.copyfmt(std::cout);
    (text << ... << values);
    return text.str();
}

/// Rows below their heads. Text stands at the left of its column, numbers at the right, with their unit if they have
/// one.
class Columns {
public:
    explicit Columns(std::vector<std::string> heads) : rows_{std::move(heads)} {}

    /// One more row, a value for each column.
    template <class... Values> Columns& row(const Values&... values) {
        rows_.push_back({printed(values)...});
        return *this;
    }

    friend std::ostream& operator<<(std::ostream& out, const Columns& table) {
        const auto& rows = table.rows_;
        const auto begins_a_number = [](const std::string& cell) {
            const std::size_t sign = cell.find_first_not_of("+-");
            return sign != std::string::npos && std::isdigit(static_cast<unsigned char>(cell[sign]));
        };
        for (const auto& row : rows) {
            std::string line;
            for (std::size_t column = 0; column < row.size(); ++column) {
                std::size_t width = 0;
                for (const auto& other : rows) width = std::max(width, visible_width(other[column]));
                const bool right = std::all_of(rows.begin() + 1, rows.end(),
                                               [&](const auto& r) { return begins_a_number(r[column]); });
                const std::string blanks(width - visible_width(row[column]), ' ');
                line += (column == 0 ? "  " : "   ") + (right ? blanks + row[column] : row[column] + blanks);
            }
            out << line.substr(0, line.find_last_not_of(' ') + 1) << '\n';
        }
        return out;
    }

private:
    std::vector<std::vector<std::string>> rows_; // the heads are the first
};

} // namespace ansatz::workbook
