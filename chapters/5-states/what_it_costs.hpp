// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What `what_it_costs` of chapter 5 is made of: the axis that has a file of its own.

#include "costs.hpp"

namespace state_costs {

void add_hysteresis(ansatz::workbook::Costs& costs); ///< what a band of hysteresis lets through

} // namespace state_costs
