// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The door of a world for elements: the members of `World` that add, change and remove them. Everything is
/// checked before anything is changed, as in door.hpp. Included by world.hpp.
// not in the umbrella: it is a part of world.hpp, which includes it

#include <ansatz/world/declaration.hpp>

namespace ansatz {

template <class... P>
void World<P...>::wake_ends([[maybe_unused]] const auto& state, [[maybe_unused]] std::uint32_t id) {
    state.for_each_body(id, [&](std::uint32_t body) { tell<hook::Wake>(data_.bodies.slot_of_id(body)); });
}

template <class... P>
template <Element E, class... Option>
ElementHandle<E> World<P...>::add(const E& element, const Option&... option) {
    need_element<E>();
    using Keeper = typename detail::KeeperOf<E, P...>::type;
    ElementHandle<E> handle;
    if constexpr (!std::is_void_v<Keeper>) {
        get_ready("World::add");
        auto& state = data_.template state<Keeper>();
        const auto position = [&](Slot slot) { return data_.lanes.template get<ansatz::Position>(slot); };
        auto admitted = state.admit("World::add", element, data_.bodies, position, option...);
        state.make_room();
        tell<hook::BeforeChange<>>();
        handle = state.insert(std::move(admitted)); // a copy may fail, and the modules have been told
        wake_ends(state, handle.id);
    }
    return handle;
}

template <class... P>
template <Element E, class... Option>
void World<P...>::set(ElementHandle<E> which, const E& to, const Option&... option) {
    need_element<E>();
    using Keeper = typename detail::KeeperOf<E, P...>::type;
    if constexpr (!std::is_void_v<Keeper>) {
        get_ready("World::set");
        auto& state = data_.template state<Keeper>();
        const auto id = state.id(which, "World::set");
        const auto position = [&](Slot slot) { return data_.lanes.template get<ansatz::Position>(slot); };
        auto admitted = state.admit("World::set", to, data_.bodies, position, option...);
        tell<hook::BeforeChange<>>();
        wake_ends(state, id);
        state.replace(id, std::move(admitted));
        wake_ends(state, id);
    }
}

template <class... P> template <class E> void World<P...>::remove(ElementHandle<E> which) {
    need_element<E>();
    using Keeper = typename detail::KeeperOf<E, P...>::type;
    if constexpr (!std::is_void_v<Keeper>) {
        get_ready("World::remove");
        auto& state = data_.template state<Keeper>();
        const auto id = state.id(which, "World::remove");
        tell<hook::BeforeChange<>>();
        wake_ends(state, id);
        state.erase(id);
    }
}

} // namespace ansatz
