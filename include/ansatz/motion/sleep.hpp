// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Which bodies fall asleep and which wake where they touch each other or hang together: islands whose bodies have all
/// been slow for long enough and are all held.
///
/// A body is held where the acceleration that remains to it is next to nothing: what pulls at it at rest, and what its
/// contacts push, friction included, where their response knows that (SoftSubsteps keeps it, Penalty's is one of the
/// forces). A pile trembles while it settles: a hundredth of what its contacts carry may remain. The impulses of other
/// responses are not kept; there a body is held where one of its contacts pushes against what pulls.
///
/// At the top of its flight a ball is slow, but nothing holds it; nor does a body beside it that falls as well. What is
/// held by a body that is not held itself is in one island with it, and stays awake with it; so does what touches a
/// platform that moves, or hangs on it.

#include <ansatz/motion/islands.hpp>
#include <ansatz/motion/state.hpp>

#include <cstdint>

namespace ansatz {

namespace detail {
/// Whether a body is a platform on its way.
template <class C> bool goes(const WorldData<C>& data, Bodies::Slot slot) {
    return data.bodies.motion(slot) == Motion::moving &&
           !(data.load(slot).template get<Velocity>() == C::S::template zero_vector<unit::Velocity>());
}
/// Calls `f(state, id)` for each element of a world that acts on its bodies where they are; a rope that hangs slack
/// holds no body.
template <class C, class F> void for_each_element(const WorldData<C>& data, F&& f) {
    const auto at = [&](std::uint32_t body) { return data.lanes.template get<Position>(data.bodies.slot_of_id(body)); };
    data.states.for_each([&](const auto& state) {
        if constexpr (requires { state.for_each_body(0u, at); }) // others keep nothing that bodies hang on
            state.for_each([&](std::uint32_t id, const auto&) {
                if constexpr (requires { state.is_slack(id, at); })
                    if (state.is_slack(id, at)) return;
                f(state, id);
            });
    });
}
/// The same for those that name one body.
template <class C, class F> void for_each_element_of(const WorldData<C>& data, std::uint32_t body, F&& f) {
    const auto at = [&](std::uint32_t id) { return data.lanes.template get<Position>(data.bodies.slot_of_id(id)); };
    data.states.for_each([&](const auto& state) {
        if constexpr (requires { state.for_each_body(0u, at); }) {
            const auto one = [&](std::uint32_t id) {
                bool names = false;
                state.for_each_body(id, [&](std::uint32_t named) { names = names || named == body; });
                if constexpr (requires { state.is_slack(id, at); }) names = names && !state.is_slack(id, at);
                if (names) f(state, id);
            };
            if constexpr (requires { state.knows_named(); })
                if (state.knows_named()) {
                    state.for_each_naming(body, one);
                    return;
                }
            state.for_each([&](std::uint32_t id, const auto&) { one(id); });
        }
    });
}
/// Wakes the bodies that hang on one that disturbs.
/// \param disturbs whether the body of a slot wakes those that hang together with it
/// \param wake     what wakes the body of a slot
/// \return whether any body was woken
template <class C, class Disturbs, class Wake>
bool wake_through_elements(const WorldData<C>& data, const Disturbs& disturbs, const Wake& wake) {
    bool any = false;
    for_each_element(data, [&](const auto& state, std::uint32_t id) {
        bool sleeps = false, moves = false;
        state.for_each_body(id, [&](std::uint32_t body) {
            const auto slot = data.bodies.slot_of_id(body);
            const bool rests = data.bodies.motion(slot) == Motion::resting;
            sleeps = sleeps || rests;
            moves = moves || (!rests && disturbs(slot));
        });
        if (!sleeps || !moves) return;
        any = true;
        state.for_each_body(id, [&](std::uint32_t body) {
            const auto slot = data.bodies.slot_of_id(body);
            if (data.bodies.motion(slot) == Motion::resting) wake(slot);
        });
    });
    return any;
}
} // namespace detail

/// Whether a body wakes one that rests in contact with it, or hangs together with it.
/// \param begins whether the two have just met
template <class C>
bool disturbs(const WorldData<C>& data, Bodies::Slot slot, bool begins, const typename C::S::Time& dt) {
    using S = typename C::S;
    const auto motion = data.bodies.motion(slot);
    if (motion == Motion::moving)
        return !(data.load(slot, dt).template get<Velocity>() == S::template zero_vector<unit::Velocity>());
    return motion == Motion::awake && (begins || data.lanes.template get<RestTime>(slot) == typename S::Time());
}

namespace detail {
/// Bodies that hang together are of one island.
template <class C> void join_by_elements(const WorldData<C>& data, SleepScratch<typename C::S>& scratch) {
    const auto awake = data.bodies.end(Motion::awake);
    for_each_element(data, [&](const auto& state, std::uint32_t id) {
        std::size_t first = awake;
        bool moves = false;
        state.for_each_body(id, [&](std::uint32_t body) {
            const auto slot = data.bodies.slot_of_id(body);
            if (slot >= awake) {
                moves = moves || goes(data, slot);
                return;
            }
            if (first < awake) scratch.islands.unite(std::uint32_t(first), slot);
            first = slot;
        });
        if (moves && first < awake) scratch.goes_along[first] = 1;
    });
}
} // namespace detail

/// Finds the ids of the bodies that fall asleep now.
/// \param slow_long whether the body of a slot has been slow for long enough
/// \param pull      the acceleration that the body of a slot would have at rest
/// \param push      `push(add)` calls `add(slot, acceleration)` with what each contact does to each of its bodies,
/// where contacts know it
/// \param balanced  whether an acceleration is next to nothing
template <class C, class SlowLong, class Pull, class Push, class Balanced>
void find_sleepers(const WorldData<C>& data, SleepScratch<typename C::S>& scratch, const SlowLong& slow_long,
                   const Pull& pull, const Push& push, const Balanced& balanced) {
    const auto awake = data.bodies.end(Motion::awake);
    scratch.sleepers.clear();
    bool any = false;
    for (std::size_t slot = 0; slot < awake && !any; ++slot) any = slow_long(slot);
    if (!any) return;

    scratch.islands.reset(awake);
    scratch.pulls.resize(awake);
    scratch.forget_held(awake, awake);
    scratch.goes_along.assign(awake, 0);
    scratch.restless.assign(awake, 0);
    scratch.trembles.resize(awake);
    for (std::size_t slot = 0; slot < awake; ++slot) {
        scratch.pulls[slot] = pull(Bodies::Slot(slot));
        scratch.trembles[slot] = typename C::S::Scalar(0.01) * norm(scratch.pulls[slot]);
    }
    push([&](std::size_t slot, const auto& acceleration) {
        if (slot < awake) scratch.pulls[slot] += acceleration;
    });
    for (std::size_t slot = 0; slot < awake; ++slot)
        scratch.held[slot] = balanced(scratch.pulls[slot]) || norm(scratch.pulls[slot]) < scratch.trembles[slot];
    data.template ask<hook::Join>(scratch); // by what touches
    detail::join_by_elements(data, scratch);
    for (std::size_t slot = 0; slot < awake; ++slot)
        if (!scratch.held[slot] || scratch.goes_along[slot] || !slow_long(slot))
            scratch.restless[scratch.islands.of(std::uint32_t(slot))] = 1;
    for (std::size_t slot = 0; slot < awake; ++slot)
        if (!scratch.restless[scratch.islands.of(std::uint32_t(slot))])
            scratch.sleepers.push_back(data.bodies.id(slot));
}

} // namespace ansatz
