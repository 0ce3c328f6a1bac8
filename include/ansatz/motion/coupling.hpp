// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `sum_coupled`: the forces between bodies, summed for all of them into the column CoupledForce.
///
/// The sums are a cache: they follow from the bodies, the policies and the time alone. A step leaves those of the state
/// that it has made, so that a query reads them and the next step need not ask again; whatever changes what the forces
/// see makes them stale (`CoupledSums`). Only worlds in which something couples bodies have any of this.

#include <ansatz/motion/state.hpp>
#include <ansatz/motion/still_forces.hpp>
#include <ansatz/world/execution.hpp>
#include <ansatz/world/view.hpp>

#include <algorithm>
#include <tuple>
#include <utility>

namespace ansatz {

namespace detail {
/// With everything inlined: left to itself the compiler calls `load` for each body, which doubles the instructions.
template <class C>
[[gnu::flatten]] void derive_velocities_of(WorldData<C>& data, const typename C::S::Time& last, std::size_t begin,
                                           std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot)
        data.lanes.template set<Velocity>(slot, data.load(Bodies::Slot(slot), last).template get<Velocity>());
}
} // namespace detail

/// Where velocity is derived and a force between bodies reads it, it must stand in its lane.
/// \param last the length of the last step, from which the velocity is derived
template <class C, class Policies>
void derive_velocities([[maybe_unused]] WorldData<C>& data, [[maybe_unused]] const Policies& policies,
                       [[maybe_unused]] const typename C::S::Time& last) {
    if constexpr (C::history && C::template stores<Velocity>) {
        std::size_t size = data.bodies.size();
        if constexpr (detail::keeps_still_forces<C>())
            if (data.still_forces.value.holds(data)) { // all others stand still, and have said so since
                detail::derive_velocities_of<C>(data, last, data.bodies.begin(Motion::moving),
                                                data.bodies.end(Motion::moving));
                size = data.bodies.end(Motion::awake);
            }
        in_ranges<C>(policies, 0, size, [&](std::size_t begin, std::size_t end) {
            detail::derive_velocities_of<C>(data, last, begin, end);
        });
    }
}

/// \name Platforms within a step
/// A platform moves on while the stages of a step ask the forces at later times; it arrives when the stages are done.
/// @{

/// Where they are when the step begins.
template <class C> void remember_platforms([[maybe_unused]] WorldData<C>& data) {
    if constexpr (C::coupled) {
        const auto begin = data.bodies.begin(Motion::moving), n = data.bodies.count(Motion::moving);
        data.coupled.platforms.resize(n * std::size_t(C::S::dimension));
        for (int k = 0; k < C::S::dimension; ++k)
            std::copy_n(data.lanes.template lane<Position>(k) + begin, n,
                        data.coupled.platforms.begin() + std::ptrdiff_t(n) * k);
    }
}
/// Where they are a fraction of the step later.
template <class C>
void place_platforms([[maybe_unused]] WorldData<C>& data, [[maybe_unused]] double fraction,
                     [[maybe_unused]] const typename C::S::Time& dt) {
    if constexpr (C::coupled && C::template stores<Velocity>) {
        const auto begin = data.bodies.begin(Motion::moving), n = data.bodies.count(Motion::moving);
        const typename C::S::Scalar later = typename C::S::Scalar(fraction) * dt.value();
        for (int k = 0; k < C::S::dimension; ++k)
            for (std::size_t i = 0; i < n; ++i) {
                const auto& start = data.coupled.platforms[std::size_t(k) * n + i];
                data.lanes.template lane<Position>(k)[begin + i] =
                    fraction == 0 ? start : start + later * data.lanes.template lane<Velocity>(k)[begin + i];
            }
    }
}
/// @}

namespace detail {
/// Adds one force between bodies to the sums.
/// \return whether it did; if not, all sums are of no use and are to be begun anew (gathering.hpp)
template <class Q, class C, class Policies>
bool couple_one(WorldData<C>& data, const Policies& policies, const Context<typename C::S>& context) {
    using S = typename C::S;
    if constexpr (keeps_state<Q, S>)
        if constexpr (requires { data.template state<Q>().arrange(data.bodies, data.states.layout); })
            data.template state<Q>().arrange(data.bodies, data.states.layout);
    AskedForce<Q, C> in(data, policies, context);
    static_assert(!C::executed || GatheredCouplingIn<Q, S> || !names_elements<Bound<Q, S>>,
                  "Ansatz: a force between bodies that has element_count, and whose elements the world cannot ask; "
                  "write `std::array<std::size_t, 2> ends(const auto& view, std::size_t k) const` and "
                  "`std::array<typename S::Force, 2> forces(const auto& view, std::size_t k, const auto& context) "
                  "const` beside it");
    if constexpr (C::executed && GatheredCouplingIn<Q, S>) {
        std::array<typename S::Scalar*, std::size_t(S::dimension)> sums{};
        for (std::size_t k = 0; k < sums.size(); ++k) sums[k] = data.lanes.template lane<CoupledForce>(int(k));
        auto& gathered = data.gathered.value[place_of<Q, typename C::couplings>];
        return gathered.template add<C>(policies, in.force, std::as_const(in.view), in.context, sums);
    } else {
        in.force.couple(in.view, in.context);
        return true;
    }
}
/// Every sum is nothing.
template <class C, class Policies> void clear_sums(WorldData<C>& data, const Policies& policies) {
    in_ranges<C>(policies, 0, data.bodies.size(), [&](std::size_t begin, std::size_t end) {
        for (int k = 0; k < C::S::dimension; ++k) {
            auto* lane = data.lanes.template lane<CoupledForce>(k);
            std::fill(lane + begin, lane + end, typename C::S::Scalar(0));
        }
    });
}
} // namespace detail

/// Asks every force between bodies, at `context`; derived velocities stand in their lane already.
template <class C, class Policies>
void sum_coupled([[maybe_unused]] WorldData<C>& data, [[maybe_unused]] const Policies& policies,
                 [[maybe_unused]] const Context<typename C::S>& context) {
    if constexpr (C::coupled) {
        if constexpr (detail::keeps_still_forces<C>())
            if (!data.coupled.changed && data.still_forces.value.holds(data))
                return data.still_forces.value.sum(data, policies, context);
        bool summed = false; // at once, but where threads find that elements act on other slots (gathering.hpp)
        for (int tries = 0; !summed && tries < 2; ++tries) {
            detail::clear_sums(data, policies);
            summed = true;
            [&]<class... Q>(Types<Q...>) {
                ((summed = detail::couple_one<Q>(data, policies, context) && summed), ...);
            }(typename C::couplings{});
        }
        if constexpr (detail::keeps_still_forces<C>()) data.still_forces.value.note_sum(data, policies, context);
    }
}

namespace detail {
/// Whether a body's velocity depends on the present forces: it is awake, and its history has begun.
template <class C> bool has_history(const WorldData<C>& data, std::size_t slot) {
    return slot < data.bodies.end(Motion::awake) && !data.waiting(Bodies::Slot(slot));
}
/// Calls `f(slot)` for each such body.
template <class C, class F> void for_each_with_history(const WorldData<C>& data, F&& f) {
    for (std::size_t slot = 0; slot < data.bodies.end(Motion::awake); ++slot)
        if (has_history(data, slot)) f(slot);
}
/// Where velocity is derived from history with half a step of the present acceleration, a change of the forces (a body
/// that was removed, a mass that is another) would be a push. The history takes it up: by exactly nothing where the
/// acceleration is what it was.
/// \return whether a history is another now
template <class C>
bool make_good([[maybe_unused]] WorldData<C>& data, [[maybe_unused]] const typename C::S::Time& last) {
    bool changed = false;
    if constexpr (C::history && C::coupled) {
        using S = typename C::S;
        for_each_with_history(data, [&](std::size_t slot) {
            auto change = data.lanes.template get<CoupledForce>(slot);
            auto value = change.value();
            for (int k = 0; k < S::dimension; ++k)
                value[k] -= data.coupled.before[slot * std::size_t(S::dimension) + std::size_t(k)];
            change = decltype(change)::from_value(value);
            if (change == S::template zero_vector<unit::Force>()) return;
            const auto x = S::template zero_vector<unit::Length>();
            const auto v = S::template zero_vector<unit::Velocity>();
            const auto a = data.lanes.template get<InverseMass>(slot) * change;
            data.lanes.template set<PreviousPosition>(slot, data.lanes.template get<PreviousPosition>(slot) +
                                                                C::Integrator::history(x, v, a, last));
            changed = true;
        });
    }
    return changed;
}
template <class C> void remember_sums(WorldData<C>& data) {
    auto& before = data.coupled.before;
    before.resize(data.bodies.size() * std::size_t(C::S::dimension));
    for (std::size_t slot = 0; slot < data.bodies.size(); ++slot)
        for (int k = 0; k < C::S::dimension; ++k)
            before[slot * std::size_t(C::S::dimension) + std::size_t(k)] =
                data.lanes.template lane<CoupledForce>(k)[slot];
}
/// Where the sums cannot be finished (a force throws, there is no memory), the column holds again what was before the
/// change that waits to be made good; without one, it is summed anew whenever it is asked for.
template <class C> struct KeepSums {
    WorldData<C>* data;
    ~KeepSums() {
        if (!data) return;
        const auto& before = data->coupled.before;
        for (std::size_t slot = 0; slot < data->bodies.size(); ++slot)
            for (int k = 0; k < C::S::dimension; ++k)
                data->lanes.template lane<CoupledForce>(k)[slot] =
                    before[slot * std::size_t(C::S::dimension) + std::size_t(k)];
    }
};
} // namespace detail

/// Sums the forces between bodies for the state as it stands, unless they are known already.
template <class C, class Policies>
void refresh_coupled([[maybe_unused]] WorldData<C>& data, [[maybe_unused]] const Policies& policies,
                     [[maybe_unused]] const Context<typename C::S>& context) {
    if constexpr (C::coupled) {
        if (data.coupled.known_for(context.dt())) return;
        auto sum = [&] {
            if (data.coupled.changed) detail::remember_sums(data);
            detail::KeepSums<C> keep{C::history && data.coupled.changed ? &data : nullptr};
            data.template tell<hook::RefreshBetweenSteps>(policies);
            derive_velocities(data, policies, context.dt().previous);
            sum_coupled(data, policies, context);
            keep.data = nullptr;
        };
        sum();
        // Where a force reads the velocity that a history holds, a history made good changes the force, though less
        // each time. The sums that are left follow from the histories that are left: a loaded world finds the same.
        constexpr int most = C::template couplings_read<Velocity> ? 8 : 1;
        for (int i = 0; data.coupled.changed && i < most && detail::make_good(data, context.dt().previous); ++i)
            if constexpr (most > 1) sum();
        data.coupled.changed = false;
        data.coupled.know(context.dt());
    }
}

} // namespace ansatz
