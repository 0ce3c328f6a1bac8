// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What the tests of worlds share: the integrators and spaces that everything must hold for, small policies, and
/// comparisons to the last bit.

#include <ansatz/world.hpp>

#include "tests/dice.hpp"
#include "tests/refusal.hpp"

#include <cstring>
#include <string>
#include <string_view>

namespace ansatz::test {

#define ANSATZ_INTEGRATORS ExplicitEuler, SemiImplicitEuler, VelocityVerlet, Verlet, RungeKutta4, ImplicitEuler
#define ANSATZ_STAGED_INTEGRATORS ExplicitEuler, SemiImplicitEuler, VelocityVerlet, Verlet, RungeKutta4

/// A column that no policy of the library knows.
struct Heat {
    using Unit = unit::Energy;
    static constexpr Shape shape = Shape::scalar;
    static constexpr std::string_view name = "heat";
};
/// A vector column that no policy of the library knows.
struct Home {
    using Unit = unit::Length;
    static constexpr Shape shape = Shape::vector;
    static constexpr std::string_view name = "home";
};

/// A force between bodies that is always nothing: with it a world runs its stages over all bodies, without it body by
/// body, and nothing else may differ.
struct Nothing {
    using role = roles::Force;
    using reads = Columns<>;
    static constexpr bool couples_bodies = true;
    template <class S> struct In {
        explicit In(const Nothing&) {}
        void couple(auto&, const auto&) const {}
    };
};

/// A spring to the origin for each body, a = -w^2 x, with its derivative.
struct ToOrigin {
    using role = roles::Force;
    using reads = Columns<Position>;
    Parameter<unit::FrequencySquared> squared_frequency = 1.0 / (second * second);
    template <class S> struct In {
        typename S::template ScalarOf<unit::FrequencySquared> w2;
        explicit In(const ToOrigin& spring) : w2(S::convert(spring.squared_frequency)) {}
        typename S::Acceleration acceleration(const typename S::Position& x, const auto&) const { return -(w2 * x); }
        Jacobian<S> jacobian(const typename S::Position&, const auto&) const {
            Jacobian<S> j{};
            auto m = j.position.value();
            for (int i = 0; i < S::dimension; ++i) m(i, i) = -w2.value();
            j.position = decltype(j.position)::from_value(m);
            return j;
        }
    };
};

/// An acceleration along x that is nothing until `from` and one metre per second squared afterwards.
struct Later {
    using role = roles::Force;
    using reads = Columns<Clock>;
    Parameter<unit::Time> from = 1.0 * second;
    template <class S> struct In {
        typename S::ClockTime from;
        explicit In(const Later& later) : from(S::ClockTime::from_value(typename S::ClockScalar(later.from.value()))) {}
        typename S::Acceleration acceleration(const auto& context) const {
            auto a = S::template zero_vector<unit::Acceleration>().value();
            if (context.time() >= from) a[0] = 1;
            return S::Acceleration::from_value(a);
        }
    };
};

/// A vector of as many components as the world has, from up to three.
template <class World_, class Unit> auto vec(const Unit& unit, double x, double y, double z = 0) {
    if constexpr (World_::S::dimension == 2) return vector_of(unit, x, y);
    else return vector_of(unit, x, y, z);
}

/// Two quantities, equal to the last bit; +0 and -0 differ.
template <class Q> bool same_bits(const Q& a, const Q& b) {
    const auto x = a.value();
    const auto y = b.value();
    if constexpr (detail::is_matrix<std::remove_const_t<decltype(x)>>)
        return std::memcmp(x.data(), y.data(), sizeof(*x.data()) * std::size_t(x.size())) == 0;
    else return std::memcmp(&x, &y, sizeof x) == 0;
}

/// Two worlds, in every column of every body equal by value (so +0 is -0), and in their clocks.
template <class A, class B> bool same_state(const A& a, const B& b) {
    if (a.size() != b.size() || a.tick() != b.tick() || a.time() != b.time()) return false;
    for (const Handle h : a.handles()) {
        if (!b.contains(h) || a.motion(h) != b.motion(h)) return false;
        bool same = true;
        [&]<class... C>(Columns<C...>) {
            ((same = same && a.template read<C>(h) == b.template read<C>(h)), ...);
        }(intersection_of<typename A::composition::state, typename B::composition::state>{});
        if (!same) return false;
    }
    return true;
}

} // namespace ansatz::test
