// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Touch` and `Contact`: what a narrowphase finds out about two bodies that intersect (notes 2.1.2).
///
/// | symbol | meaning                                                                                     | unit |
/// |--------|---------------------------------------------------------------------------------------------|------|
/// | P      | contact point: halfway between the two surfaces, so that it is the same for (a, b) and (b, a) | m  |
/// | N      | contact normal: a unit vector *from b to a*, the way a must be moved; it turns round for (b, a) | 1 |
/// | p      | penetration depth: how far they must be moved apart along N until they only touch          | m    |
///
/// The notes put P on the surface of the second sphere, S1 - N (r1 - p); another body would be the second when the two
/// are swapped. Their N = |S1 - S2| is a length; meant is (S1 - S2) / |S1 - S2|. Bodies that only touch (p = 0) do not
/// intersect.

#include <ansatz/units.hpp>
#include <ansatz/world/bodies.hpp>
#include <ansatz/world/elements.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ansatz {

/// Where and how two shapes intersect.
template <class S> struct Touch {
    typename S::Position point{};                    ///< P, m
    Vector<typename S::Scalar, S::dimension> normal; ///< N, from the second to the first
    typename S::Length depth{};                      ///< p, m, greater than zero
};

/// The same with the roles of the two exchanged.
template <class S> Touch<S> swapped(const Touch<S>& t) { return {t.point, -t.normal, t.depth}; }

/// Two bodies of a world that intersect; the first is the one with the smaller id. A response that stops bodies before
/// they intersect (`SoftSubsteps`) leaves them in contact while they press each other; the depth is zero then, or a
/// little less.
template <class S> struct Contact : Touch<S> {
    Handle first;            ///< a
    Handle second;           ///< b
    std::uint32_t steps = 0; ///< how many steps it has lasted; 0 where it begins
    /// Whether it was no contact before the last step.
    bool begins() const { return steps == 0; }
};

/// Two bodies that do not intersect any more.
struct ContactEnd {
    Handle first;                                                           ///< the one with the smaller id
    Handle second;                                                          ///< the other; either may have been removed
    friend bool operator==(const ContactEnd&, const ContactEnd&) = default; ///< the same bodies
};

namespace detail {
/// The ids of the two bodies of a pair, by which pairs are in order.
template <class T> [[gnu::always_inline]] inline std::pair<std::uint32_t, std::uint32_t> ids_of(const T& pair) {
    if constexpr (requires { pair.first.id; }) return {pair.first.id, pair.second.id};
    else return {pair.a, pair.b};
}
/// Room for so many in a list that grows from step to step: with an eighth more than it needs, it is seldom copied,
/// and most of what it holds is used.
template <class T> [[gnu::noinline]] void grow(std::vector<T>& list, std::size_t n) {
    if (list.capacity() < n) list.reserve(n + n / 8 + 8);
}
/// One more in such a list.
template <class T> [[gnu::always_inline]] inline void append(std::vector<T>& list, const T& one) {
    if (list.size() == list.capacity()) grow(list, list.size() + 1);
    list.push_back(one);
}
/// Gives two lists that are about to change places the same room: otherwise a step that has long had all the room that
/// it needs finds some day that the list with little room has come round.
template <class T> void equal_room(std::vector<T>& a, std::vector<T>& b) {
    a.reserve(b.capacity());
    b.reserve(a.capacity());
}
} // namespace detail

/// The contacts of a world, as observers and systems see them: `using sees = Types<Contacts>;`. As `world.contacts()`,
/// they may be of bodies that were removed since: `view.contains(contact.first)` tells.
struct Contacts {
    template <class S> using Table = std::vector<Contact<S>>; ///< what `view.template table<Contacts>()` is
    /// Those of a world.
    template <class Data> static const auto& table_in(const Data& data) {
        constexpr bool collides = requires { data.collisions.contacts; };
        static_assert(collides, "Ansatz: a policy sees the contacts of a world whose bodies do not collide; add a "
                                "Narrowphase and what belongs to it, or take Contacts out of `sees`");
        if constexpr (collides) return data.collisions.contacts.all();
        else return detail::absent;
    }
};

} // namespace ansatz
