// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What `what_it_costs` of chapter 2 is made of: one function for each axis, in a file of its own.

#include "costs.hpp"
#include "plot.hpp"

#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace collision_costs {

using ansatz::workbook::Costs;
using ansatz::workbook::Rows;

void add_broadphase(Costs& costs);
void add_narrowphase(Costs& costs);
void add_response(Costs& costs);
void add_solver(Costs& costs);
void add_rest(Costs& costs);

/// The rows of an axis, or of one of its problems, or of a choice in that.
inline Rows rows_of(const Rows& rows, const std::string& axis, const std::string& problem = {},
                    const std::string& choice = {}) {
    Rows chosen;
    for (const ansatz::workbook::Row& row : rows)
        if (row.axis == axis && (problem.empty() || row.problem == problem) && (choice.empty() || row.choice == choice))
            chosen.push_back(row);
    return chosen;
}

/// Writes a picture of a summary into the folder of the others.
inline void write(const ansatz::workbook::Plot& plot, const std::filesystem::path& folder, const std::string& name) {
    ansatz::workbook::draw(folder / (name + ".svg"), plot.script());
}

} // namespace collision_costs
