// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The user's own datum for each body, as a world with the policy `Datum<T>` keeps it.
// not in the umbrella: it is a part of world.hpp, which includes it

#include <ansatz/world/data.hpp>

#include <cstdint>
#include <type_traits>
#include <vector>

namespace ansatz::detail {

/// The user's own datum for each body, by id; in a struct, because a vector of bool has no elements.
template <class T> struct DataOfUser {
    struct Kept {
        T datum{};
    };
    std::vector<Kept> by_id;

    void make_room(std::uint32_t id) {
        if (by_id.size() <= id) by_id.resize(id + 1);
    }
    /// Whether assigning cannot fail where there is room: what owns memory has a destructor.
    static constexpr bool assigns_in_place = std::is_trivially_destructible_v<T>;
    void make_room_for(const DataOfUser& other) { by_id.reserve(other.by_id.size()); }
    T& at(std::uint32_t id) { return by_id[id].datum; }
    const T& at(std::uint32_t id) const { return by_id[id].datum; }
};
template <> struct DataOfUser<void> {
    static constexpr bool assigns_in_place = true;
    static void make_room_for(const DataOfUser&) {}
    Absent& at(std::uint32_t) const; // never defined: such a call was refused with a sentence
};
/// Never defined either.
template <class T> const T& nowhere();

template <class... P> struct DatumOf {
    using type = void;
};
template <class First, class... Rest> struct DatumOf<First, Rest...> {
    using type = typename DatumOf<Rest...>::type;
};
template <class First, class... Rest>
    requires is_datum<First>
struct DatumOf<First, Rest...> {
    using type = typename First::datum_type;
};

} // namespace ansatz::detail
