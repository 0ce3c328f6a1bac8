// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `stable_step`: the largest time step that an integrator takes without growing, for one oscillator and for the
/// springs of a world (notes 3).
///
/// Use it before a simulation is started and whenever springs were added: a step beyond it does not make a spring a bit
/// wrong, it makes it explode. Damping that is computed explicitly makes the limit smaller, not larger. To have every
/// step held to it, add StepLimit to the world (step_limit.hpp).
///
/// The limit is not looked up in a table: the integrator makes one step of
/// \f$ \ddot x = -\omega^2 x - \gamma \dot x \f$, and its own two rows of numbers say whether repeating it grows. So
/// it is right for an integrator of yours, too.
///
/// | symbol | meaning                                        | unit  |
/// |--------|------------------------------------------------|-------|
/// | omega^2 | stiffness for each mass, k / m                | 1/s^2 |
/// | gamma  | damping for each mass, c / m                   | 1/s   |
///
/// E. I. Jury, Theory and Application of the z-Transform Method (1964), for the conditions.

#include <ansatz/motion/concepts.hpp>
#include <ansatz/motion/present.hpp>
#include <ansatz/springs/measured_stiffness.hpp>
#include <ansatz/units/requirements.hpp>
#include <ansatz/world/world.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace ansatz {

namespace detail {

/// x'' = -stiffness x - damping v, for one body.
struct PlainOscillator {
    using role = roles::Force;
    using reads = Columns<Position, Velocity>;
    double stiffness, damping; // 1/s^2, 1/s
    template <class S> struct In {
        double stiffness, damping;
        explicit In(const PlainOscillator& o) : stiffness(o.stiffness), damping(o.damping) {}
        typename S::Acceleration acceleration(const typename S::Position& x, const typename S::Velocity& v,
                                              const auto&) const {
            return S::Acceleration::from_value(-stiffness * x.value() - damping * v.value());
        }
        Jacobian<S> jacobian(const auto&, const auto&, const auto&) const {
            Jacobian<S> j;
            using Matrix = Eigen::Matrix<double, S::dimension, S::dimension>;
            j.position = decltype(j.position)::from_value(-stiffness * Matrix::Identity());
            j.velocity = decltype(j.velocity)::from_value(-damping * Matrix::Identity());
            return j;
        }
    };
};

/// The matrix of one step of length 1: how the two columns that integrator `I` keeps follow from themselves.
template <class I, class... Kept>
std::array<double, 4> one_step(const I& integrator, double stiffness, double damping, Columns<Kept...>) {
    static_assert(sizeof...(Kept) == 2,
                  "Ansatz: stable_step knows integrators that keep two columns, Position and another");
    using S = Space<double, 2>;
    using Sum = Laws<S, PlainOscillator>;
    using R = Row<S, union_of<Columns<Kept...>, scratch_of<I>, Columns<Position, Velocity>>>;
    const auto one = S::Time::from_value(1.0);
    std::uint64_t unsolved = 0;
    const WholeStep<S, I, Sum, Effects<S>, Effects<S>, Columns<>> step{
        Sum(PlainOscillator{stiffness, damping}),          Effects<S>(), Effects<S>(),
        Context<S>(S::ClockTime(), TimeStep<S>(one, one)), &unsolved,    BoundIntegrator<I, S>(integrator)};
    R row{};
    // Both trajectories at once, one in each component.
    auto start = [&]<class First, class Second>(Columns<First, Second>) {
        row.template get<First>() = value_of<First, S>::from_value({1.0, 0.0});
        row.template get<Second>() = value_of<Second, S>::from_value({0.0, 1.0});
    };
    start(Columns<Kept...>{});
    step(row, 0);
    auto end = [&]<class First, class Second>(Columns<First, Second>) {
        const auto a = row.template get<First>().value(), b = row.template get<Second>().value();
        return std::array{a[0], a[1], b[0], b[1]};
    };
    return end(Columns<Kept...>{});
}

/// Jury's conditions for a matrix of two rows: both eigenvalues at most 1. Those of a symplectic method are 1 exactly,
/// so that rounding must not decide.
template <class I> bool is_stable(const I& integrator, double stiffness, double damping) {
    const auto m = one_step(plain_integrator(integrator), stiffness, damping, writes_of<plain_integrator_of<I>>{});
    const double trace = m[0] + m[3], determinant = m[0] * m[3] - m[1] * m[2];
    constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
    return determinant <= 1 + rounding && std::abs(trace) <= 1 + determinant + rounding * (1 + std::abs(trace));
}

} // namespace detail

/// The largest time step that integrator `I` takes without growing, for one oscillator: s, zero if it grows with every
/// step, infinite if it never does.
/// \param stiffness omega^2 = k/m, 1/s^2, finite, not negative
/// \param damping   gamma = c/m, 1/s, finite, not negative
/// \param integrator the one that is meant, where it has parameters
/// \throws std::invalid_argument for other values
template <class I>
Quantity<unit::Time> stable_step(const Quantity<unit::FrequencySquared>& stiffness,
                                 const Quantity<unit::Frequency>& damping = 0.0 * hertz, const I& integrator = I()) {
    require_not_negative("stable_step", "stiffness", stiffness);
    require_not_negative("stable_step", "damping", damping);
    const double k = stiffness.value(), c = damping.value(), rate = std::max(std::sqrt(k), c);
    if (rate == 0) return std::numeric_limits<double>::infinity() * second;
    // In units of 1 / rate, so that nothing depends on how fast the oscillator is.
    auto stable = [&](double h) { return detail::is_stable(integrator, k / rate / rate * h * h, c / rate * h); };
    constexpr double least = 1e-6, usual = 1e-2, most = 1e6, apart = 1.05;
    double below = stable(usual) ? usual : least;
    if (!stable(below)) return 0.0 * second;
    while (below < most && stable(below * apart)) below *= apart;
    if (below >= most) return std::numeric_limits<double>::infinity() * second;
    double above = below * apart;
    for (int i = 0; i < 60; ++i) (stable(0.5 * (below + above)) ? below : above) = 0.5 * (below + above);
    return below / rate * second;
}

/// What is known of the springs of a world: how stiff and how damped they are for the masses that they hold.
struct Stiffness {
    Quantity<unit::FrequencySquared>
        largest{};                       ///< no eigenvalue of M^-1 K is larger, 1/s^2, whatever the springs' lengths
    Quantity<unit::Frequency> damping{}; ///< no eigenvalue of M^-1 C is larger, 1/s
    Quantity<unit::Time> least_ratio{};  ///< the least c/k of a spring, s
    Quantity<unit::Time> most_ratio{};   ///< the largest, infinite where a damper has no stiffness
    friend bool operator==(const Stiffness&, const Stiffness&) = default; ///< the same numbers
};
/// What the bound is computed in; kept by those who ask in every step.
struct StiffnessScratch {
    std::vector<double> stiff;  ///< the sum of the stiffnesses at each body, N/m
    std::vector<double> damped; ///< that of the dampings, N s/m
};

namespace detail {
template <class W, class Data> Stiffness stiffness_in(const W& world, const Data& data, StiffnessScratch& scratch) {
    using C = typename W::composition;
    Stiffness all;
    if constexpr (C::coupled) {
        const std::size_t size = data.bodies.size();
        const auto inside = Key::inside(world);
        auto& stiff = scratch.stiff;
        auto& damped = scratch.damped;
        stiff.assign(size + 1, 0);
        damped.assign(size + 1, 0);
        double least_ratio = std::numeric_limits<double>::infinity(), most_ratio = 0, largest = 0, damping = 0;
        auto each = [&](auto&& f) {
            for_each_stiff<W>([&]<class Q>() {
                Bound<Q, typename W::S>(world.template get<Q>()).stiffnesses(ObserverView<typename W::S, Q>(data), f);
            });
        };
        const auto weight = inside.data.lanes.template lane<InverseMass>(0);
        auto moves = [&](std::size_t slot) { // the masses are those of now, and the data may be older
            if (slot >= size) return 0.0;
            const auto now = slot_in(std::as_const(inside.data), data, std::uint32_t(slot));
            return weight[now] > 0 ? static_cast<double>(weight[now]) : 0.0;
        };
        each([&](std::size_t a, std::size_t b, const auto& k, const auto& c) {
            stiff[a] += static_cast<double>(k);
            stiff[b] += static_cast<double>(k);
            damped[a] += static_cast<double>(c);
            damped[b] += static_cast<double>(c);
            if (!(moves(a) + moves(b) > 0) || !(k > 0 || c > 0)) return;
            const double ratio =
                k > 0 ? static_cast<double>(c) / static_cast<double>(k) : std::numeric_limits<double>::infinity();
            least_ratio = std::min(least_ratio, ratio);
            most_ratio = std::max(most_ratio, ratio);
        });
        each([&](std::size_t a, std::size_t b, const auto& k, const auto& c) {
            if (k > 0) largest = std::max(largest, stiff[a] * moves(a) + stiff[b] * moves(b));
            if (c > 0) damping = std::max(damping, damped[a] * moves(a) + damped[b] * moves(b));
        });
        all = {largest / (second * second), damping / second, (largest > 0 ? least_ratio : 0) * second,
               most_ratio * second};
    }
    return all;
}
} // namespace detail

/// A bound of the stiffness of a world's springs, from one pass over them.
///
/// A spring of stiffness k between masses takes of each mass the share that its k has among all springs of that body;
/// alone with these shares it would swing with
///
/// \f[ \omega^2 = \frac{K_a}{m_a} + \frac{K_b}{m_b}, \f]
///
/// where K is the sum of the stiffnesses at a body, and the whole swings no faster than its fastest spring. For
/// two bodies and a spring it is exact.
///
/// It is of what the forces saw last; where something was changed since, ask without scratch.
template <class... P> Stiffness stiffness_of(const World<P...>& world, StiffnessScratch& scratch) {
    return detail::stiffness_in(world, detail::Key::inside(world).data, scratch);
}
/// The same, once, for the world as it is now.
template <class... P> Stiffness stiffness_of(const World<P...>& world) {
    StiffnessScratch scratch;
    return detail::stiffness_in(world, detail::at_present(detail::Key::inside(world)), scratch);
}

/// The largest time step that integrator `I` takes without growing, whatever such springs do, s.
/// \param integrator the one that is meant, where it has parameters
template <class I> Quantity<unit::Time> stable_step(const Stiffness& springs, const I& integrator = I()) {
    if (springs.largest.value() == 0 && springs.damping.value() == 0)
        return std::numeric_limits<double>::infinity() * second;
    // A network swings in many ways, each with some stiffness up to the largest and some damping between the least and
    // the most that goes with it, and not every method is held most by the same of them: semi-implicit Euler by what is
    // stiffest and most damped, explicit Euler by what is damped least, Runge-Kutta by what is damped much and hardly
    // stiff.
    auto limit = stable_step<I>(springs.largest, springs.damping, integrator);
    constexpr int parts = 8;
    for (int i = 0; i <= parts; ++i) {
        const auto stiffness = springs.largest * (double(i) / parts);
        const auto at_most = [&](const auto& ratio) {
            return is_finite(ratio) ? std::min(springs.damping, ratio * stiffness) : springs.damping;
        };
        const auto least = at_most(springs.least_ratio), most = at_most(springs.most_ratio);
        for (int j = 0; j <= parts; ++j)
            limit =
                std::min(limit, stable_step<I>(stiffness, least + (most - least) * (double(j) / parts), integrator));
    }
    return limit;
}

/// The largest time step that the integrator of a world takes without growing, whatever its springs do, s: zero where
/// it grows with every step (explicit Euler without damping), infinite where nothing is stiff or the method never
/// grows.
///
/// It is of the world as it stands: springs stay as stiff as they are however they stretch, a filling (`Pressure`)
/// becomes stiffer as its surface is pressed or inflated. Ask again before each step there, or take `StepLimit`, which
/// does.
///
/// It is on the safe side: a chain of twenty bodies takes 0.3 % more, and `measured_stiffness` says how much a world
/// does. Forces of one body (`Gravity`, a drag of yours) are not counted, nor those between bodies that do not say
/// how stiff they are: give yours `stiffnesses` and `jacobian` (DifferentiableCouplingIn), and it counts; `Attraction`
/// has neither.
template <class... P> Quantity<unit::Time> stable_step(const World<P...>& world) {
    using I = typename World<P...>::Integrator;
    return stable_step<I>(stiffness_of(world), world.template get<I>());
}

} // namespace ansatz
