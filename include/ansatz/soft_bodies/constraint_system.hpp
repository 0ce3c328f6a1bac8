// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ConstraintSystem`: the bodies and the constraints of a world, as a Solver sees them behind the integrator.
///
/// Positions are those that the integrator has predicted from all forces; a solver moves them until the constraints
/// hold. The velocity takes each correction as it is made, \f$ \mathbf v \mathrel{+}= \Delta\mathbf x / h \f$, and is never read off
/// positions: far from the origin the way of a substep is lost in a position's last digit, and a body whose velocity is
/// (x - x_0)/h hangs in the air.

#include <ansatz/motion/step.hpp>
#include <ansatz/soft_bodies/constraint.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>

namespace ansatz {

/// \tparam StepT the step
template <class StepT> class ConstraintSystem {
public:
    using C = typename StepT::Composition_; ///< of the world
    using S = typename C::S;                ///< the space
    using Scalar = typename S::Scalar;
    using Vec = Vector<Scalar, S::dimension>; ///< m, m/s, or a direction

    /// Behind the integrator.
    explicit ConstraintSystem(StepT& step)
        : step_(step),
          awake_(step.data.bodies.end(Motion::awake)),
          h_(step.context.dt().value()),
          inverse_mass_(step.data.lanes.template lane<InverseMass>()) {
        for (int k = 0; k < S::dimension; ++k) {
            x_[std::size_t(k)] = step.data.lanes.template lane<Position>(k);
            v_[std::size_t(k)] = step.data.lanes.template lane<Velocity>(k);
        }
        arrange_all(typename C::held{});
    }

    /// Calls `solve(system)`, and remembers what it did to velocities for whoever expects it again.
    template <class F> void hold(F&& solve) {
        if constexpr (C::template stores<HeldAcceleration>) {
            each_held([&](std::size_t slot, const Vec&) { return Vec(-velocity(slot)); });
            solve(*this);
            each_held([&](std::size_t slot, const Vec& before) { return Vec((velocity(slot) + before) / h_); });
        } else solve(*this);
    }
    /// Of this part of the step, s.
    Scalar h() const { return h_; }
    /// Bodies that may be moved stand in the slots below.
    std::size_t awake() const { return awake_; }
    /// 1/m, 1/kg; zero for who is not moved: fixed bodies, platforms, and those that rest.
    [[gnu::always_inline]] Scalar weight(std::size_t slot) const {
        return slot < awake_ ? inverse_mass_[slot] : Scalar(0);
    }
    /// m
    [[gnu::always_inline]] Vec position(std::size_t slot) const { return get(x_, slot); }
    /// m/s
    [[gnu::always_inline]] Vec velocity(std::size_t slot) const { return get(v_, slot); }
    /// Moves a body, and its velocity with it.
    [[gnu::always_inline]] void move(std::size_t slot, const Vec& by) {
        const Scalar rate = 1 / h_;
        for (int k = 0; k < S::dimension; ++k) {
            x_[std::size_t(k)][slot] += by[k];
            v_[std::size_t(k)][slot] += by[k] * rate;
        }
    }

    /// Calls `f(slot)` for every body by id, an order that sleeping and waking do not change.
    template <class F> void each_by_id(F&& f) const {
        const auto& bodies = step_.data.bodies;
        for (std::uint32_t id = 0; id < bodies.ids(); ++id)
            if (bodies.alive(id)) f(std::size_t(bodies.slot_of_id(id)));
    }
    /// Calls `f(constraint)` for every constraint of the world, always in the same order.
    template <class F> [[gnu::always_inline]] void each(F&& f) const {
        [&]<class... Q>(Types<Q...>) {
            (detail::Bound<Q, S>(std::get<Q>(step_.policies)).constraints(step_.template view_of<Q>(), f), ...);
        }(typename C::held{});
    }

private:
    template <class F> void each_held(F&& f) {
        for (std::size_t slot = 0; slot < awake_; ++slot)
            step_.data.lanes.template set<HeldAcceleration>(
                slot, S::Acceleration::from_value(
                          f(slot, step_.data.lanes.template get<HeldAcceleration>(slot).value())));
    }
    using Lanes_ = std::array<Scalar*, std::size_t(S::dimension)>;
    [[gnu::always_inline]] static Vec get(const Lanes_& lanes, std::size_t slot) {
        Vec all;
        for (int k = 0; k < S::dimension; ++k) all[k] = lanes[std::size_t(k)][slot];
        return all;
    }
    template <class... Q> void arrange_all(Types<Q...>) { (arrange<Q>(), ...); }
    template <class Q> void arrange() {
        if constexpr (detail::keeps_state<Q, S>)
            if constexpr (requires { step_.data.template state<Q>().arrange(step_.data.bodies, std::size_t()); })
                step_.data.template state<Q>().arrange(step_.data.bodies, step_.data.states.layout);
    }

    StepT& step_;
    std::size_t awake_;
    Scalar h_;
    const Scalar* inverse_mass_;
    Lanes_ x_{}, v_{};
};
template <class StepT> ConstraintSystem(StepT&) -> ConstraintSystem<StepT>; ///< of a step

} // namespace ansatz
