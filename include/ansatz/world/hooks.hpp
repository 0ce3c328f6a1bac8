// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Hooks: what the frame tells the modules of a world, and how.
///
/// A module answers those that concern it with `static void on(hook::Removed, auto& data, Slot slot)`, and leaves out
/// the others. The upper modules are told first. `data` is a world's `WorldData`; `inside` (inside.hpp) is its data
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
struct ReserveNotes {};   ///< `(data, n)`: room for what a verb or a step notes about n bodies
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
struct Placed {};  ///< `(inside, id)`: a body was placed by a caller, or one that never sleeps was added
/// @}
/// \name A world is about to be changed from outside
/// @{

/// `(inside)`: columns of some body change; without a column, bodies or elements are added, changed or removed.
template <class... Column> struct BeforeChange {};
/// `(inside, slot)`: the forces on this body are about to change. Its velocity stays.
struct HoldVelocity {};
/// `(inside, id)`: wakes the neighbours of this body: those that it holds, and those that hold it.
struct Disturbed {};
/// `(inside, slot)`: this body has to be checked in the next step, whether it rests or not.
struct Wake {};
/// `(inside, slot)`: a column of one body is about to be written
template <class Column> struct BeforeWrite {};
template <class Policy> struct BeforeSet {}; ///< `(inside)`: a policy's parameters are about to change
template <class Policy> struct AfterSet {};  ///< `(inside)`: a policy's parameters have been changed
/// @}
/// \name A step
/// @{
struct CheckStep {};  ///< `(inside, dt, given)`: refuses a step of this length, or does nothing
struct BeforeStep {}; ///< `(step)`: before the step begins
struct BeginStep {};  ///< `(data)`: clears the events of the last step
/// `(data, policies)`: brings up to date what forces are derived from, for a query between two steps
struct RefreshBetweenSteps {};
/// @}
/// \name Rest
/// @{
struct WakeTouching {}; ///< `(step)`: wakes resting bodies that touch a moving one
struct MarkHeld {};     ///< `(data, scratch)`: `scratch.held[slot] = 1` for each body that something may hold
struct Join {};         ///< `(data, scratch)`: joins bodies that sleep together (motion/sleep.hpp)
struct EachPush {};     ///< `(step, add)`: `add(slot, acceleration)` for each push on a body that is no force
struct Slept {};        ///< `(data, id, pull)`: a body fell asleep while `pull()` was held
struct WasHeld {};      ///< `(data, id, pull, held)`: makes `held` true where it fell asleep under this pull
/// @}
/// \name Questions
/// @{
struct EachNeighbour {}; ///< `(data, id, f)`: calls `f(id)` for each body that it touches
struct NextSubsteps {};  ///< `(inside, parts)`: multiplies `parts` by the number of substeps of the next step
struct IsFinite {};      ///< `(data, slot, finite)`: makes `finite` false where a value of a body is not finite
/// @}
/// \name As a value
/// @{
struct HashCounts {}; ///< `(data, hash)`: the counts of steps
struct Hash {};       ///< `(data, hash)`
struct HashBody {};   ///< `(data, slot, hash)`
struct Save {};       ///< `(data, file, files)`: into a JSON object, by means of `files`
struct SaveBody {};   ///< `(data, slot, file)`
struct Load {};       ///< `(data, file)`: from a JSON object, after the bodies
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

/// Whether the state of all modules can be assigned within the room that they have.
template <class M, class C> constexpr bool assigns_in_place_of() {
    if constexpr (requires { M::template assigns_in_place<C>; }) return M::template assigns_in_place<C>;
    return true;
}
template <class C, class... M> constexpr bool modules_assign_in_place(Types<M...>) {
    return (assigns_in_place_of<M, C>() && ...);
}

/// What each module derives from its properties of a body; it may refuse them.
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
/// Each module makes room for the body: that may fail, and nothing has been changed yet.
template <class... M> void make_room_to_keep(Types<M...>, [[maybe_unused]] auto& data, const auto& admitted) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        (make_room_to_keep_one<M>(data, std::get<I>(admitted)), ...);
    }(std::index_sequence_for<M...>{});
}
template <class M>
void keep_one([[maybe_unused]] auto& data, [[maybe_unused]] std::uint32_t id, [[maybe_unused]] const auto& admitted) {
    if constexpr (requires { M::keep(data, id, admitted); }) M::keep(data, id, admitted);
}
/// Each module stores it for the body that gets this id.
template <class... M> void keep(Types<M...>, auto& data, std::uint32_t id, const auto& admitted) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        (keep_one<M>(data, id, std::get<I>(admitted)), ...);
    }(std::index_sequence_for<M...>{});
}
/// Whether a module of a world reads a column of a body to find out what the body does to its neighbours.
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
