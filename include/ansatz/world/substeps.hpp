// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Between a world's columns and the bodies of a response that owns substeps: velocities in, velocities out.
///
/// A solver wants the velocity that counts at its moment: before a substep the mean over it, behind a substep the mean over
/// the one that is done, at the end the velocity now. Each is v + f a h for the integrator's own v. Out go differences, so that a body
/// which no contact touched keeps its velocity to the bit.

#include <ansatz/world/contact_step.hpp>
#include <ansatz/world/data.hpp>

#include <vector>

namespace ansatz {

/// \tparam Acceleration a function of a slot and of a body's values
template <class C, class Acceleration> class SubstepBodies {
public:
    using S = typename C::S; ///< the space
    using Scalar = typename S::Scalar;
    using Slot = Bodies::Slot; ///< a body's place in the lanes
    using Time = typename S::Time; ///< s

    /// Of a world.
    SubstepBodies(WorldData<C>& data, const Acceleration& acceleration) : data_(data), acceleration_(acceleration) {}

    /// All bodies, with their weights: zero for what is not awake.
    template <class Body> void place(std::vector<Body>& bodies) const {
        bodies.resize(data_.bodies.size());
        for (std::size_t slot = 0; slot < bodies.size(); ++slot) {
            bodies[slot].position = data_.lanes.template get<Position>(slot).value();
            bodies[slot].u = S::template zero_vector<unit::Velocity>().value();
            bodies[slot].weight = slot < data_.bodies.end(Motion::awake) ? data_.lanes.template get<InverseMass>(slot).value() : Scalar(0);
        }
    }
    /// v + factor a h and the position, for all that move.
    /// \param last the length of the substep before, from which a history's velocity is derived
    template <class Body> void gather(std::vector<Body>& bodies, std::vector<typename Body::Raw>& before, double factor, const Time& h, const Time& last) const {
        before.resize(bodies.size());
        for (const auto motion : {Motion::awake, Motion::moving})
            for (std::size_t slot = data_.bodies.begin(motion); slot < data_.bodies.end(motion); ++slot) {
                bodies[slot].position = data_.lanes.template get<Position>(slot).value();
                bodies[slot].u = velocity(Slot(slot), motion == Motion::awake ? factor : 0, h, last).value();
                before[slot] = bodies[slot].u;
            }
    }
    /// What the contacts have changed, to the awake bodies.
    template <class Body> void scatter(const std::vector<Body>& bodies, const std::vector<typename Body::Raw>& before, const Time& last) {
        for (std::size_t slot = 0; slot < data_.bodies.end(Motion::awake); ++slot) {
            if (bodies[slot].u == before[slot]) continue;
            const auto change = S::Velocity::from_value(bodies[slot].u - before[slot]);
            data_.set_velocity(Slot(slot), velocity(Slot(slot), 0, last, last) + change);
        }
    }

private:
    typename S::Velocity velocity(Slot slot, double factor, const Time& h, const Time& last) const {
        if constexpr (C::history) {
            auto row = data_.load(slot, last);
            const bool awake = data_.bodies.motion(slot) == Motion::awake;
            if (awake && !data_.waiting(slot)) row.template get<Velocity>() = C::Integrator::velocity_now(row.template get<Velocity>(), acceleration_(slot, row), last);
            return factor == 0 ? row.template get<Velocity>() : row.template get<Velocity>() + (Scalar(factor) * h) * acceleration_(slot, row);
        } else {
            const auto v = data_.lanes.template get<Velocity>(slot);
            return factor == 0 ? v : v + (Scalar(factor) * h) * acceleration_(slot, data_.load(slot, last));
        }
    }

    WorldData<C>& data_;
    const Acceleration& acceleration_;
};

} // namespace ansatz
