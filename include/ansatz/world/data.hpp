// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `WorldData`: what a world holds of its bodies, and how one body is read from it and written to it.
///
/// This is the value that is copied, hashed and saved. It has no policy in it and no algorithm: the step is in
/// step.hpp, the door with its checks in world.hpp.

#include <ansatz/world/bodies.hpp>
#include <ansatz/world/cache.hpp>
#include <ansatz/world/clock.hpp>
#include <ansatz/world/composition.hpp>
#include <ansatz/world/context.hpp>
#include <ansatz/world/hooks.hpp>
#include <ansatz/world/lanes.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace ansatz {

/// What could go wrong inside a step and does not stop it; poll it with World::status.
struct Status {
    /// A step was broken off by an exception: the world is in the midst of it, and takes nothing but another world.
    bool lost = false;
    std::uint64_t unsolved = 0;   ///< body steps whose equation an implicit integrator could not solve, so far
    std::uint64_t not_finite = 0; ///< bodies whose state is infinite or not a number, now
    Handle first_not_finite{};    ///< the one with the smallest id among them
    std::string said{};           ///< what policies have to say, now; one of your own, or e.g. WorldRadius
    /// Nothing went wrong.
    bool ok() const { return !lost && unsolved == 0 && not_finite == 0 && said.empty(); }
    /// "ok", or what went wrong.
    friend std::string describe(const Status& status) {
        if (status.lost) return "a step was broken off by an exception";
        if (status.ok()) return "ok";
        std::string text;
        if (status.unsolved > 0)
            text = detail::joined({describe(std::size_t(status.unsolved)), " body steps unsolved"});
        if (status.not_finite > 0)
            text += detail::joined({text.empty() ? "" : ", ", describe(std::size_t(status.not_finite)),
                                    " bodies not finite, the first is body ",
                                    describe(std::size_t(status.first_not_finite.id))});
        if (!status.said.empty()) text += (text.empty() ? "" : "; ") + status.said;
        return text;
    }
    /// The same on a stream.
    template <class Out> friend auto operator<<(Out& out, const Status& status) -> decltype(out << std::string()) {
        return out << describe(status);
    }
};

template <class C> struct WorldData;

namespace detail {
/// What the policies of a world keep beside the bodies.
template <class S, class List> struct States;
template <class S, class... P> struct States<S, Types<P...>> {
    std::tuple<state_of<P, S>...> each;
    std::uint64_t layout = 0; ///< counts the exchanges of slots, so that a state may remember where bodies are

    template <class F> void for_each(F&& f) {
        std::apply([&](auto&... state) { (f(state), ...); }, each);
    }
    template <class F> void for_each(F&& f) const {
        std::apply([&](const auto&... state) { (f(state), ...); }, each);
    }
};
template <class S> struct States<S, Types<>> {
    static void for_each(auto&&) {}
};

/// Whether assigning what a policy keeps cannot fail once there is room: it says so, or owns nothing, for what owns
/// memory has a destructor.
template <class T> inline constexpr bool makes_room = requires(T& to, const T& from) { to.make_room_for(from); };
template <class List> inline constexpr bool all_make_room = true;
template <class... T>
inline constexpr bool all_make_room<std::tuple<T...>> = ((makes_room<T> || std::is_trivially_destructible_v<T>)&&...);
template <class S, class List> inline constexpr bool states_make_room = true;
template <class S, class... P>
inline constexpr bool states_make_room<S, Types<P...>> = all_make_room<std::tuple<state_of<P, S>...>>;
template <class T> void make_room_for(T& to, const T& from) {
    if constexpr (makes_room<T>) to.make_room_for(from);
}

/// Whether a policy adds bodies within a step.
template <class P, class S>
inline constexpr bool brings_bodies =
    requires(state_of<P, S>& state, const P& policy) { state.bodies_to_come(policy); };
template <class List, class S> inline constexpr bool any_brings_bodies = false;
template <class... P, class S> inline constexpr bool any_brings_bodies<Types<P...>, S> = (brings_bodies<P, S> || ...);
/// Whether a module can follow where a body is divided: it keeps nothing of a body that `add` was given, or answers.
template <class M, class C> constexpr bool divides() {
    if constexpr (requires { typename M::template AddFacts<C>; })
        return requires(WorldData<C>& data, const typename C::S::Scalar& share) {
            M::on(hook::Divided{}, data, 0U, 0U, share);
        };
    return true;
}
template <class C, class... M> constexpr bool all_divide(Types<M...>) { return (divides<M, C>() && ...); }
/// Whether a list of policies has a datum of the user's.
template <class List> inline constexpr bool holds_datum = false;
template <class... P> inline constexpr bool holds_datum<Types<P...>> = (is_datum<P> || ...);
/// Which bodies were divided in the present step, and into which: a world's data of the user follow behind it.
using Divisions = Cache<std::vector<std::pair<std::uint32_t, std::uint32_t>>>;
struct NoDivisions {};

template <class List> struct ControlOf { // nothing decides, or something that is refused with a sentence
    using type = Cache<Absent>;
};
template <class First, class... Rest>
    requires requires { typename First::Kept; }
struct ControlOf<Types<First, Rest...>> {
    using type = Cache<typename First::Kept>;
};

template <class List, class C, class Data> struct AllStates;
template <class... M, class C, class Data> struct AllStates<Types<M...>, C, Data> : StateIn<M, C, Data>::type... {};
} // namespace detail

/// All that a world of this composition holds: what the frame keeps, and what each of its modules does.
template <class C> struct WorldData : detail::AllStates<typename C::modules, C, WorldData<C>> {
    /// The space.
    using S = typename C::S;
    using Composition_ = C; ///< of the world
    using Scalar = typename S::Scalar;
    using Slot = Bodies::Slot; ///< a body's place in the lanes

    Lanes<S, typename C::stored> lanes; ///< the columns
    Bodies bodies;                      ///< handles, ids and slots
    StepClock<S> clock;                 ///< tick and time
    /// What policies keep beside the bodies, such as elements between them.
    [[no_unique_address]] detail::States<S, typename C::keepers> states;
    /// What decides how a step is taken keeps its numbers here.
    [[no_unique_address]] typename detail::ControlOf<typename C::controls>::type control;
    /// Where a user's datum follows when bodies are divided.
    static constexpr bool notes_divisions =
        detail::any_brings_bodies<typename C::keepers, S> && detail::holds_datum<typename C::policies>;
    /// Empty between two steps.
    [[no_unique_address]] std::conditional_t<notes_divisions, detail::Divisions, detail::NoDivisions> divisions;

    /// What policy `P` keeps; nothing, where it keeps nothing.
    template <class P> const auto& state() const {
        if constexpr (detail::keeps_state<P, S>) return std::get<detail::place_of<P, typename C::keepers>>(states.each);
        else return detail::absent;
    }
    /// The same, to change it.
    template <class P>
    auto& state()
        requires detail::keeps_state<P, S>
    {
        return std::get<detail::place_of<P, typename C::keepers>>(states.each);
    }

    /// Room for so many bodies in everything.
    [[gnu::cold]] void reserve(std::size_t n) {
        lanes.reserve(n);
        bodies.reserve(n);
        tell<hook::Reserve>(n);
        reserve_notes(n);
    }
    /// Whether a copy can be assigned in the room that is there: nothing in it owns memory that is not asked for here.
    static constexpr bool assigns_in_place = std::is_trivially_destructible_v<Scalar> &&
                                             detail::states_make_room<S, typename C::keepers> &&
                                             detail::modules_assign_in_place<C>(typename C::modules{});
    /// Room for what another holds, so that assigning it cannot fail.
    void make_room_for(const WorldData& other) {
        lanes.reserve(other.lanes.size());
        bodies.make_room_for(other.bodies);
        tell<hook::MakeRoomFor>(other);
        [&]<class... P>(Types<P...>) {
            (detail::make_room_for(state<P>(), other.template state<P>()), ...);
        }(typename C::keepers{});
    }
    /// Room for what a step, or anything that is done to the world between steps, may note about each body. A copied
    /// vector has no more room than it needs, so the first of them makes it, and no later one.
    void reserve_notes(std::size_t n) {
        bodies.reserve_notes();
        tell<hook::ReserveNotes>(n);
        states.for_each([](auto& state) {
            if constexpr (requires { state.reserve_notes(); }) state.reserve_notes();
        });
    }
    /// Before a body is removed: the elements that name it are found, which may fail.
    void find_named() {
        states.for_each([&](auto& state) {
            if constexpr (requires { state.find_named(bodies.ids()); }) state.find_named(bodies.ids());
        });
    }
    /// Room for what only a step notes, such as what breaks in it: who reads those of the last step may do what he
    /// likes meanwhile.
    void reserve_notes_of_step() {
        states.for_each([](auto& state) {
            if constexpr (requires { state.reserve_notes_of_step(); }) state.reserve_notes_of_step();
        });
    }

    /// From one range of bodies to another.
    Slot move(Slot slot, Motion to) {
        return bodies.move(slot, to, [&](std::size_t i, std::size_t j) { swap(i, j); });
    }
    /// Room for a body that is about to be added, in the notes too; `id` is the one that it gets.
    void make_room(std::uint32_t id, bool moves) {
        reserve_notes(std::size_t(id) + 1 > bodies.ids() ? std::size_t(id) + 1 : bodies.ids());
        tell<hook::MakeRoom>(id, moves);
    }
    /// Room for bodies that a step may make by dividing others.
    void make_room_to_come(std::size_t n) {
        tell<hook::MakeRoomToCome>(n);
        states.for_each([&](auto& state) {
            if constexpr (requires { state.make_room_to_come(); }) state.make_room_to_come();
            if constexpr (requires { state.make_room_for_bodies(n); }) state.make_room_for_bodies(bodies.ids() + n);
        });
        if constexpr (notes_divisions) divisions.value.reserve(n);
    }
    /// Adds a body that is like another in every column, within a step; with room for it, it cannot fail. Its state of
    /// motion, and what modules keep of it, are the other's.
    /// \param share of the mass, which is not yet divided
    /// \return its id
    std::uint32_t divide(std::uint32_t id, const Scalar& share) {
        static_assert(detail::all_divide<Composition_>(typename C::modules{}),
                      "Ansatz: a policy of this world divides bodies, and a module of it keeps something of each body "
                      "and does not say what becomes of it; it needs `static void on(hook::Divided, auto& data, "
                      "std::uint32_t id, std::uint32_t part, const auto& share)`");
        const auto kind = bodies.motion(bodies.slot_of_id(id));
        const auto last = Slot(bodies.size());
        lanes.push_back();
        const auto part = bodies.push_back();
        for (std::size_t k = 0; k < lanes.width; ++k) lanes.lane_at(k)[last] = lanes.lane_at(k)[bodies.slot_of_id(id)];
        move(last, kind);
        tell<hook::Divided>(id, part.id, share);
        states.for_each([&](auto& state) {
            if constexpr (requires { state.body_divided(id, part.id, share); }) state.body_divided(id, part.id, share);
        });
        if constexpr (notes_divisions) divisions.value.emplace_back(id, part.id);
        return part.id;
    }
    /// How many bodies policies may add within a step: `state.bodies_to_come(policy)` of each that keeps something,
    /// which makes room for what it notes of them.
    template <class Policies> std::size_t bodies_to_come(const Policies& policies) {
        return bodies_to_come(policies, typename C::keepers{});
    }
    /// Removes a body; the others keep their order, but for one or a few.
    void erase(Slot slot) {
        tell<hook::Removed>(slot);
        states.for_each([&](auto& state) {
            if constexpr (requires { state.body_removed(bodies.id(slot)); }) state.body_removed(bodies.id(slot));
        });
        bodies.erase(slot, [&](std::size_t i, std::size_t j) { swap(i, j); });
        lanes.pop_back();
    }

    /// Tells the modules.
    template <class Hook, class... A> void tell(A&&... argument) {
        detail::tell<Hook>(typename C::modules{}, *this, argument...);
    }
    /// Asks them.
    template <class Hook, class... A> void ask(A&&... argument) const {
        detail::tell<Hook>(typename C::modules{}, *this, argument...);
    }

private:
    template <class Policies, class... P>
    std::size_t bodies_to_come([[maybe_unused]] const Policies& policies, Types<P...>) {
        std::size_t all = 0;
        [[maybe_unused]] const auto add = [&]<class One>(std::type_identity<One>) {
            if constexpr (detail::brings_bodies<One, S>) all += state<One>().bodies_to_come(std::get<One>(policies));
        };
        (add(std::type_identity<P>()), ...);
        return all;
    }
    void swap(std::size_t i, std::size_t j) {
        lanes.swap(i, j);
        if constexpr (C::keepers::size > 0) ++states.layout;
    }
};

} // namespace ansatz
