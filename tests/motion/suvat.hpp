// SPDX-License-Identifier: BSL-1.0
#pragma once

// SUVAT's five quantities as plain numbers, and `solve` by the letters of what is known.

#include <ansatz/motion/suvat.hpp>
#include <ansatz/units/print.hpp>

#include <string>

namespace ansatz::test {

template <class S> struct Five {
    S s, u, v, a, t;
};

template <class Unit, class S> Quantity<Unit, S> of(const S& x) { return Quantity<Unit, S>::from_value(x); }

/// `solve` by the letters of what is known.
template <class S> suvat::Solutions<S> solve(const std::string& knowns, const Five<S>& m) {
    const auto s = suvat::displacement(of<unit::Length>(m.s));
    const auto u = suvat::initial_velocity(of<unit::Velocity>(m.u));
    const auto v = suvat::final_velocity(of<unit::Velocity>(m.v));
    const auto a = suvat::acceleration(of<unit::Acceleration>(m.a));
    const auto t = suvat::time(of<unit::Time>(m.t));
    if (knowns == "suv") return suvat::solve(s, u, v);
    if (knowns == "sua") return suvat::solve(s, u, a);
    if (knowns == "sut") return suvat::solve(s, u, t);
    if (knowns == "sva") return suvat::solve(s, v, a);
    if (knowns == "svt") return suvat::solve(s, v, t);
    if (knowns == "sat") return suvat::solve(s, a, t);
    if (knowns == "uva") return suvat::solve(u, v, a);
    if (knowns == "uvt") return suvat::solve(u, v, t);
    if (knowns == "uat") return suvat::solve(u, a, t);
    return suvat::solve(v, a, t);
}

} // namespace ansatz::test
