// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Hooks: what the frame tells the modules of a world, and how.
///
/// A module answers those that concern it with `static void on(hook::Removed, auto& data, Slot slot)`; of the others it
/// says nothing. The upper modules are told first. `data` is a world's `WorldData`; `inside` (inside.hpp) is its data
/// with its policies, where a hook is about a world that is being changed.

#include <ansatz/world/modules.hpp>

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

namespace ansatz {

/// One type for each thing that a module may be told.
namespace hook {
/// \name Room: these may fail, and change nothing that can be seen
/// @{
struct Reserve {};        ///< `(data, n)`: room for n bodies
struct ReserveNotes {};   ///< `(data, n)`: room for what a verb or a step notes of n bodies
struct MakeRoom {};       ///< `(data, id, moving)`: room for a body that gets this id
struct MakeRoomFor {};    ///< `(data, other)`: room for what another world holds
struct MakeRoomToCome {}; ///< `(data, n)`: room for n bodies that the next step may make by dividing others
/// @}
/// \name Bodies come and go
/// @{
struct Added {}; ///< `(data, slot, row)`: a body has been added with these values; must not fail
/// `(data, id, part, share)`: a body has been divided within a step; `part` is like it, and will have this share of its
/// mass; must not fail
struct Divided {};
struct Removed {}; ///< `(data, slot)`: the body of this slot is about to go; must not fail
struct Placed {};  ///< `(inside, id)`: a body was put somewhere from outside, or was added and does not fall asleep
/// @}
/// \name A world is about to be changed from outside
/// @{

/// `(inside)`: columns of some body change; with none, bodies or what is between them come, change or go.
template <class... Column> struct BeforeChange {};
/// `(inside, slot)`: what forces do to this body changes. Its velocity is what it is.
struct HoldVelocity {};
/// `(inside, id)`: whoever is held by this body, or holds it, has to look again whether it stays.
struct Disturbed {};
/// `(inside, slot)`: this body has to be looked at in the next step, whether it rests or not.
struct Wake {};
/// `(inside, slot)`: a column of one body is about to be written
template <class Column> struct BeforeWrite {};
template <class Policy> struct BeforeSet {}; ///< `(inside)`: a policy's parameters are about to change
template <class Policy> struct AfterSet {};  ///< `(inside)`: and have been changed
/// @}
/// \name A step
/// @{
struct CheckStep {};  ///< `(inside, dt, given)`: refuse it, or say nothing
struct LookAround {}; ///< `(step)`: before it begins
struct BeginStep {};  ///< `(data)`: what the last step brought is forgotten
/// `(data, policies)`: forces are asked between two steps; what they are derived from is looked at
struct RefreshBetweenSteps {};
/// @}
/// \name Rest
/// @{
struct WakeTouching {}; ///< `(step)`: wakes who rests and touches somebody that moves
struct MarkHeld {};     ///< `(data, scratch)`: `scratch.held[slot] = 1` for each body that something may hold
struct Join {};         ///< `(data, scratch)`: who sleeps with whom (motion/sleep.hpp)
struct EachPush {};     ///< `(step, add)`: `add(slot, acceleration)` for what holds a body and is no force
struct Slept {};        ///< `(data, id, pull)`: a body fell asleep while `pull()` was held
struct WasHeld {};      ///< `(data, id, pull, held)`: makes `held` true where it fell asleep under this pull
/// @}
/// \name Questions
/// @{
struct EachNeighbour {}; ///< `(data, id, f)`: calls `f(id)` for each body that it touches
struct NextParts {};     ///< `(inside, parts)`: multiplies `parts` by those into which it will divide the next step
struct IsFinite {};      ///< `(data, slot, finite)`: makes it false where something of a body is no number
/// @}
/// \name As a value
/// @{
struct HashCounts {}; ///< `(data, hash)`: what was counted in steps
struct Hash {};       ///< `(data, hash)`
struct HashBody {};   ///< `(data, slot, hash)`
struct Save {};       ///< `(data, file, files)`: into a JSON object, with what `files` writes
struct SaveBody {};   ///< `(data, slot, file)`
struct Load {};       ///< `(data, file)`: from one, when the bodies are there
struct LoadBody {};   ///< `(data, slot, file)`
struct Report {};     ///< `(data, status)`
/// @}
} // namespace hook

namespace detail {

template <class M, class Hook, class... A> [[gnu::always_inline]] inline void tell_one(A&... argument) {
    if constexpr (requires { M::on(Hook{}, argument...); }) M::on(Hook{}, argument...);
}
/// Tells the modules of a list.
template <class Hook, class... M, class... A> [[gnu::always_inline]] inline void tell(Types<M...>, A&&... argument) {
    (tell_one<M, Hook>(argument...), ...);
}

/// Whether everything that modules keep can be assigned in the room that is there: a module that cannot says so.
template <class M, class C> constexpr bool assigns_in_place_of() {
    if constexpr (requires { M::template assigns_in_place<C>; }) return M::template assigns_in_place<C>;
    return true;
}
template <class C, class... M> constexpr bool modules_assign_in_place(Types<M...>) {
    return (assigns_in_place_of<M, C>() && ...);
}

/// What each module makes of the properties of a body that are its own; they may be refused here.
template <class M, class C, class... Property> auto admit_one(const Property&... property) {
    if constexpr (requires { M::template admit<C>(property...); }) return M::template admit<C>(property...);
    else return std::false_type{};
}
template <class C, class... M, class... Property>
auto admit([[maybe_unused]] Types<M...> modules, const Property&... property) {
    return std::tuple(admit_one<M, C>(property...)...);
}
template <class M> void make_room_to_keep_one([[maybe_unused]] auto& data, [[maybe_unused]] const auto& admitted) {
    if constexpr (requires { M::make_room_to_keep(data, admitted); }) M::make_room_to_keep(data, admitted);
}
/// Each makes room for what it will keep: that may fail, and nothing has been changed yet.
template <class... M> void make_room_to_keep(Types<M...>, [[maybe_unused]] auto& data, const auto& admitted) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        (make_room_to_keep_one<M>(data, std::get<I>(admitted)), ...);
    }(std::index_sequence_for<M...>{});
}
template <class M>
void keep_one([[maybe_unused]] auto& data, [[maybe_unused]] std::uint32_t id, [[maybe_unused]] const auto& admitted) {
    if constexpr (requires { M::keep(data, id, admitted); }) M::keep(data, id, admitted);
}
/// Each keeps it for the body that gets this id.
template <class... M> void keep(Types<M...>, auto& data, std::uint32_t id, const auto& admitted) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        (keep_one<M>(data, id, std::get<I>(admitted)), ...);
    }(std::index_sequence_for<M...>{});
}
/// Whether a module of a world looks at a column of a body to find out what the body does to its neighbours.
template <class M, class Column, class C> constexpr bool looks_at() {
    if constexpr (requires { M::template looks_at<Column, C>; }) return M::template looks_at<Column, C>;
    return false;
}
template <class Column, class C, class... M> constexpr bool any_looks_at(Types<M...>) {
    return (looks_at<M, Column, C>() || ...);
}
template <class Column, class C>
inline constexpr bool matters_to_neighbours = any_looks_at<Column, C>(typename C::modules{});

} // namespace detail
} // namespace ansatz
