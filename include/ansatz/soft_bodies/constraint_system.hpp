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
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

namespace ansatz {

/// One body: what a solver touches lies together, in double in one line of the cache, and in fours, which vector units
/// take at once.
template <class S>
struct alignas(std::is_floating_point_v<typename S::Scalar> ? 8 * sizeof(typename S::Scalar)
                                                            : alignof(typename S::Scalar)) HeldBody {
    using Four = std::array<typename S::Scalar, 4>; ///< a vector, and something behind it
    Four x;                                         ///< m; what is no component is zero
    Four v; ///< m/s; the last one is 1/m, 1/kg, zero of a body that is not moved
};

/// \tparam StepT the step
template <class StepT> class ConstraintSystem {
public:
    using C = typename StepT::Composition_; ///< of the world
    using S = typename C::S;                ///< the space
    using Scalar = typename S::Scalar;
    using Vec = Vector<Scalar, S::dimension>; ///< m, m/s, or a direction

    using Body = HeldBody<S>; ///< what it moves

    /// Behind the integrator.
    /// \param bodies room for them, by slot
    ConstraintSystem(StepT& step, std::vector<Body>& bodies)
        : step_(step),
          bodies_(bodies),
          awake_(step.data.bodies.end(Motion::awake)),
          h_(step.context.dt().value()),
          rate_(1 / h_) {
        arrange_all(typename C::held{});
    }

    /// Calls `solve(system)` for the bodies as they stand, and moves them.
    template <class F> void hold(F&& solve) {
        load();
        solve(*this);
        store();
    }
    /// Of this substep, s.
    Scalar h() const { return h_; }
    /// Bodies that may be moved stand in the slots below.
    std::size_t awake() const { return awake_; }
    /// 1/m, 1/kg; zero for bodies that are not moved: fixed bodies, platforms, and those that rest.
    [[gnu::always_inline]] Scalar weight(std::size_t slot) const { return bodies_[slot].v[3]; }
    /// m
    [[gnu::always_inline]] auto position(std::size_t slot) const {
        return Eigen::Map<const Vec>(bodies_[slot].x.data());
    }
    /// m/s
    [[gnu::always_inline]] auto velocity(std::size_t slot) const {
        return Eigen::Map<const Vec>(bodies_[slot].v.data());
    }
    /// Moves a body, and its velocity with it.
    [[gnu::always_inline]] void move(std::size_t slot, const Vec& by) {
        Body& body = bodies_[slot];
        // `rate_` is read before anything is stored: read again for each number, it keeps g++ from storing two at once,
        // and the next constraint, which loads two at once, waits for both (a sixth of an XPBD step).
        const Vec faster = by * rate_;
        Eigen::Map<Vec>(body.x.data()) += by;
        Eigen::Map<Vec>(body.v.data()) += faster;
    }
    /// All of them, for a solver that moves many at once.
    std::span<Body> bodies() { return bodies_; }
    /// How many bodies there will be room for, however many a step makes by dividing others; 0 where none does.
    std::size_t room() const {
        if constexpr (detail::any_brings_bodies<typename C::keepers, S>) return step_.data.lanes.room();
        else return 0;
    }
    /// Calls `f(policy, view)` for each policy that gives constraints, bound, with what it keeps.
    template <class F> void each_policy(F&& f) const {
        [&]<class... Q>(Types<Q...>) {
            (f(detail::Bound<Q, S>(std::get<Q>(step_.policies)), step_.template view_of<Q>()), ...);
        }(typename C::held{});
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
    [[gnu::flatten]] void load() {
        const auto& lanes = step_.data.lanes;
        // A step may have added bodies, in room that was made for them.
        if (bodies_.capacity() < step_.data.bodies.size()) bodies_.reserve(step_.data.lanes.room());
        bodies_.resize(step_.data.bodies.size());
        std::array<const Scalar*, 3> x{}, v{};
        for (int k = 0; k < S::dimension; ++k) {
            x[std::size_t(k)] = lanes.template lane<Position>(k);
            v[std::size_t(k)] = lanes.template lane<Velocity>(k);
        }
        const auto* weight = lanes.template lane<InverseMass>();
        Body* to = bodies_.data();
        for (std::size_t slot = 0; slot < bodies_.size(); ++slot) {
            const auto at = [&](const auto& lane, int k) {
                return k < S::dimension ? lane[std::size_t(k)][slot] : Scalar(0);
            };
            to[slot] = {{at(x, 0), at(x, 1), at(x, 2), Scalar(0)}, {at(v, 0), at(v, 1), at(v, 2), weight[slot]}};
        }
        for (std::size_t slot = awake_; slot < bodies_.size(); ++slot) to[slot].v[3] = Scalar(0);
    }
    /// What was done to velocities is kept in a column, for a response that expects it again.
    [[gnu::flatten]] void store() {
        auto& lanes = step_.data.lanes;
        const Body* from = bodies_.data();
        for (int k = 0; k < S::dimension; ++k) {
            auto* x = lanes.template lane<Position>(k);
            auto* v = lanes.template lane<Velocity>(k);
            if constexpr (C::template stores<HeldAcceleration>) {
                auto* a = lanes.template lane<HeldAcceleration>(k);
                for (std::size_t slot = 0; slot < awake_; ++slot)
                    a[slot] = (from[slot].v[std::size_t(k)] - v[slot]) / h_;
            }
            for (std::size_t slot = 0; slot < awake_; ++slot) {
                x[slot] = from[slot].x[std::size_t(k)];
                v[slot] = from[slot].v[std::size_t(k)];
            }
        }
    }
    template <class... Q> void arrange_all(Types<Q...>) { (arrange<Q>(), ...); }
    template <class Q> void arrange() {
        if constexpr (detail::keeps_state<Q, S>)
            if constexpr (requires { step_.data.template state<Q>().arrange(step_.data.bodies, std::size_t()); })
                step_.data.template state<Q>().arrange(step_.data.bodies, step_.data.states.layout);
    }

    StepT& step_;
    std::vector<Body>& bodies_;
    std::size_t awake_;
    Scalar h_, rate_; // s, 1/s
};

} // namespace ansatz
