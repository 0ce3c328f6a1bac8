// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Between a world's columns and the bodies of a response that owns substeps: velocities in, velocities out.
///
/// A solver wants the velocity that counts at its moment: before a substep the mean over it, behind a substep the mean
/// over the one that is done, at the end the velocity now. Each is v + f a h for the integrator's own v. Out go
/// differences, so that a body which no contact touched keeps its velocity to the bit.

#include <ansatz/collision/contact_step.hpp>
#include <ansatz/motion/state.hpp>
#include <ansatz/world/execution.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ansatz {

/// \tparam C            the world's composition
/// \tparam Acceleration a function of a slot and of a body's values; asked by several threads where a policy runs loops
template <class C, class Policies, class Acceleration> class SubstepBodies {
public:
    using S = typename C::S; ///< the space
    using Scalar = typename S::Scalar;
    using Slot = Bodies::Slot;     ///< a body's place in the lanes
    using Time = typename S::Time; ///< s

    /// Of a world.
    SubstepBodies(WorldData<C>& data, const Policies& policies, const Acceleration& acceleration)
        : data_(data), policies_(policies), acceleration_(acceleration) {}

    /// All bodies, with their weights: zero for what is not awake. Nothing accelerates them yet. What sleeps or is
    /// fixed has no velocity from when it was placed before, and is not gone through again; where it is, a contact
    /// says.
    template <class Body>
    [[gnu::flatten]] void place(std::vector<Body>& bodies, std::vector<typename Body::Raw>& kicks) {
        const auto& all = data_.bodies;
        auto& before = data_.collisions.had_velocities;
        const auto zero = S::template zero_vector<unit::Velocity>().value();
        bodies.resize(all.size(), Body{zero, zero, Scalar(0)});
        kicks.resize(all.size(), zero);
        const auto stop = [&](std::size_t begin, std::size_t end) {
            for (std::size_t slot = begin; slot < std::min(end, all.size()); ++slot) {
                bodies[slot] = Body{zero, zero, Scalar(0)};
                kicks[slot] = zero;
            }
        };
        stop(0, before.awake);
        stop(before.moving, before.moving_end);
        for (std::size_t slot = 0; slot < all.end(Motion::awake); ++slot)
            bodies[slot].weight = data_.lanes.template get<InverseMass>(slot).value();
        before = {all.end(Motion::awake), all.begin(Motion::moving), all.end(Motion::moving)};
    }
    /// v + factor a h and the position, for all that move.
    /// \param last  the length of the substep before, from which a history's velocity is derived
    /// \param kicks a h of those that are awake, if asked for
    template <class Body>
    void gather(std::vector<Body>& bodies, std::vector<typename Body::Raw>& before, double factor, const Time& h,
                const Time& last, std::vector<typename Body::Raw>* kicks = nullptr) const {
        before.resize(bodies.size());
        in_ranges<C>(policies_, 0, data_.bodies.end(Motion::awake), [&](std::size_t begin, std::size_t end) {
            gather(bodies, before, factor, h, last, kicks, begin, end);
        });
        for (std::size_t slot = data_.bodies.begin(Motion::moving); slot < data_.bodies.end(Motion::moving); ++slot) {
            bodies[slot].position = data_.lanes.template get<Position>(slot).value();
            bodies[slot].u = velocity(Slot(slot), last).value();
        }
    }
    /// What impacts have changed. A body that was struck within the substep moves with its new velocity for the rest of
    /// the substep only.
    /// \param factor 1/s, of the time in the substep before the impact
    template <class Body>
    void scatter_late(std::vector<Body>& bodies, std::vector<typename Body::Raw>& before, const auto& impacts,
                      const Scalar& factor, const Time& last) {
        const std::size_t awake = data_.bodies.end(Motion::awake);
        for (std::size_t slot = 0; slot < awake; ++slot) bodies[slot].u += factor * impacts.late(slot);
        scatter(bodies, before, last);
        for (std::size_t slot = 0; slot < awake; ++slot) {
            if (factor < Scalar(0)) bodies[slot].u -= factor * impacts.late(slot);
            before[slot] = bodies[slot].u;
        }
    }
    /// What the contacts have changed, to the awake bodies.
    /// \param pushed by how much, if asked for
    template <class Body>
    void scatter(const std::vector<Body>& bodies, const std::vector<typename Body::Raw>& before, const Time& last,
                 std::vector<typename Body::Raw>* pushed = nullptr) {
        if (pushed) pushed->resize(bodies.size());
        const std::size_t awake = data_.bodies.end(Motion::awake);
        // Where dampers pull, all bodies are given their velocities if any is: see ContactStep::hold_velocities.
        bool all = false;
        if constexpr (C::history && C::template couplings_read<Velocity>)
            for (std::size_t slot = 0; slot < awake && !all; ++slot) all = !(bodies[slot].u == before[slot]);
        const auto part = [&](std::size_t begin, std::size_t end) {
            scatter(bodies, before, last, pushed, all, begin, end);
        };
        if constexpr (C::history) part(0, awake); // all of them note whose history begins anew
        else in_ranges<C>(policies_, 0, awake, part);
    }

private:
    /// \name Of bodies in a range of slots
    /// @{
    template <class Body>
    [[gnu::flatten, gnu::noinline]] void
    gather(std::vector<Body>& bodies, std::vector<typename Body::Raw>& before, double factor, const Time& h,
           const Time& last, std::vector<typename Body::Raw>* kicks, std::size_t begin, std::size_t end) const {
        for (std::size_t slot = begin; slot < end; ++slot) {
            auto& body = bodies[slot];
            body.position = data_.lanes.template get<Position>(slot).value();
            body.u = velocity(Slot(slot), last).value();
            if (kicks || factor != 0) {
                const auto kick = typename S::Velocity(h * acceleration_(Slot(slot), now(Slot(slot), last))).value();
                body.u += Scalar(factor) * kick;
                if (kicks) (*kicks)[slot] = kick;
            }
            before[slot] = body.u;
        }
    }
    template <class Body>
    [[gnu::flatten, gnu::noinline]] void
    scatter(const std::vector<Body>& bodies, const std::vector<typename Body::Raw>& before, const Time& last,
            std::vector<typename Body::Raw>* pushed, bool all, std::size_t begin, std::size_t end) {
        for (std::size_t slot = begin; slot < end; ++slot) {
            const typename Body::Raw by = bodies[slot].u - before[slot];
            if (pushed) (*pushed)[slot] = by;
            if (!all && bodies[slot].u == before[slot]) continue;
            data_.set_velocity(Slot(slot), velocity(Slot(slot), last) + S::Velocity::from_value(by));
        }
    }
    /// @}
    /// A body with the velocity that it has now.
    auto now(Slot slot, const Time& last) const {
        auto row = data_.load(slot, last);
        if constexpr (C::history)
            if (data_.bodies.motion(slot) == Motion::awake && !data_.waiting(slot))
                row.template get<Velocity>() =
                    C::Integrator::velocity_now(row.template get<Velocity>(), acceleration_(slot, row), last);
        return row;
    }
    typename S::Velocity velocity(Slot slot, const Time& last) const {
        if constexpr (C::history) return now(slot, last).template get<Velocity>();
        else return data_.lanes.template get<Velocity>(slot);
    }

    WorldData<C>& data_;
    const Policies& policies_;
    const Acceleration& acceleration_;
};

} // namespace ansatz
