// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What guards read, and machines of two states with a guard each way.

#include <ansatz/states/guards.hpp>
#include <ansatz/states/values.hpp>

#include "tests/states/support.hpp"

namespace states_tests {

struct Walker {
    Quantity<unit::Length> x{};
    double noise = 0;
    float share = 0;
    int coins = 0;
};
constexpr auto place = value("x", &Walker::x);

/// A machine of two states with a guard each way.
template <auto There, auto Back> struct Turns {
    using Context = Walker;
    static constexpr auto machine = states::machine(state("low", transition(when(There()), to("high"))),
                                                    state("high", transition(when(Back()), to("low"))));
};
template <auto There, auto Back> int turns(auto&& next, int updates) {
    Walker w;
    Machine<Turns<There, Back>, Switch> m;
    m.start(w);
    int count = 0;
    for (int i = 0; i < updates; ++i) {
        next(w, i, m);
        count += m.update(w, frame);
    }
    return count;
}

} // namespace states_tests
