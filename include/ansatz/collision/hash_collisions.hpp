// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What the hash of a world holds of its shapes and contacts: a part of `World::hash`.
///
/// The same numbers as are written to a file (save_collisions.hpp), because a world goes on from them: a contact that
/// had begun does not begin again, the impulses along and across it act in the next step, and bodies are tested by
/// their shapes.

#include <ansatz/world/hash.hpp>
#include <ansatz/world/held_parameters.hpp>

#include <cstdint>
#include <string_view>
#include <type_traits>

namespace ansatz::detail {

/// The parameters of a description, a shape.
template <class P> void add_parameters_to(StateHash& hash, const P& description) {
    for (const char letter : std::string_view(P::name)) hash.add(std::uint64_t(letter));
    if constexpr (!NamesParameters<P>) return; // nor does a file know them
    else
        P::parameters(description, [&](std::string_view, const auto& value) {
            using Value = std::remove_cvref_t<decltype(value)>;
            if constexpr (std::is_integral_v<Value>) hash.add(std::uint64_t(value));
            else if constexpr (std::is_floating_point_v<Value>) hash.add_number(value);
            else if constexpr (requires { value.value().size(); })
                for (int i = 0; i < value.value().size(); ++i) hash.add_number(value.value()[i]);
            else hash.add_number(value.value());
        });
}

/// Shapes by body, contacts by their two bodies, and what responses keep of them.
template <class C, class Data> void add_collisions_to(StateHash& hash, const Data& data) {
    const auto& collisions = data.collisions;
    for (std::uint32_t id = 0; id < data.bodies.ids(); ++id) {
        if (!data.bodies.alive(id)) continue;
        hash.add(std::uint64_t(id) << 1 | std::uint64_t(collisions.is_sensor(id)));
        collisions.shapes.visit_description(id, [&](const auto& description) { add_parameters_to(hash, description); });
        if constexpr (C::rests)
            for (int k = 0; k < C::S::dimension; ++k) hash.add_number(collisions.pull_when_it_slept(id).value()[k]);
    }
    for (const auto& c : collisions.contacts.all()) {
        if (!collisions.lasts(data.bodies, c)) continue; // it says nothing of how the world goes on
        hash.add(std::uint64_t(c.first.id) << 32 | c.second.id);
        hash.add(c.steps);
        hash.add_number(c.depth.value());
        for (int k = 0; k < C::S::dimension; ++k) {
            hash.add_number(c.point.value()[k]);
            hash.add_number(c.normal[k]);
        }
    }
    collisions.add_siblings_to(hash);
    hash.add(std::uint64_t(collisions.parts));
    hash.add_number(collisions.expected.value());
    data.states.for_each([&](const auto& state) {
        if constexpr (requires { state.saved([](auto&&...) {}); })
            state.saved([&](std::uint32_t a, std::uint32_t b, const auto& numbers) {
                hash.add(std::uint64_t(a) << 32 | b);
                for (const auto& number : numbers) hash.add_number(number);
            });
    });
}

} // namespace ansatz::detail
