// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Outcome`: how a search stands or ended. A search never throws once it has begun; this is what it answers instead.

#include <ansatz/core/compiler_flags.hpp>

#include <string_view>

namespace ansatz::paths {

/// How a search stands.
enum class Outcome {
    not_begun,  ///< no search was begun yet
    running,    ///< there is more to expand: call advance() again
    found,      ///< the goal was reached; path() and cost() are of the way there
    no_path,    ///< all that can be reached was expanded, and the goal was not among it
    gave_up,    ///< the budget was spent; path() leads to the node that came nearest
    blocked,    ///< the start or the goal is marked impassable; why() says which
    too_far,    ///< no way was found, and ways were left out whose cost its number does not hold: take a wider CostIn
    bad_weight, ///< an edge's weight is negative or not a number; why() says which
};

/// Its name, as it is written here.
constexpr std::string_view name_of(Outcome outcome) {
    switch (outcome) {
    case Outcome::not_begun: return "not begun";
    case Outcome::running: return "running";
    case Outcome::found: return "found";
    case Outcome::no_path: return "no path";
    case Outcome::gave_up: return "gave up";
    case Outcome::blocked: return "blocked";
    case Outcome::too_far: return "too far";
    case Outcome::bad_weight: return "bad weight";
    }
    return "";
}

} // namespace ansatz::paths
