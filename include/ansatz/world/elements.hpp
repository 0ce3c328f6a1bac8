// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Elements: what a policy keeps beside the bodies, such as the springs between them, added and removed at run time.
///
/// A policy says what its elements are (`using Element = Spring;`) and where they are kept (`template <class S> class
/// State`). The world holds that state as a part of its value: copied, hashed and saved with the bodies; what is tied
/// to a body goes with it. `world.add(Spring{...})` gives out a handle that survives the removal of others, works in
/// every copy, and is known as stale when its element is gone. A world whose policies keep nothing has none of this.
/// `ElementTable` is such a State for a policy of your own (element_table.hpp).

#include <ansatz/world/bodies.hpp>
#include <ansatz/world/columns.hpp>

#include <concepts>
#include <cstdint>
#include <tuple>
#include <vector>

namespace ansatz {

/// Names an element, in the world that made it and in every copy of that world.
template <class Element> struct ElementHandle {
    std::uint32_t id = 0xffffffffu; ///< counts up; given again only with another generation
    std::uint32_t generation = 0;   ///< how often the id was given before
    friend bool operator==(const ElementHandle&, const ElementHandle&) = default; ///< whether they name one element
};

/// Names a body in what a policy keeps, such as an end of a tie: by its id, which stays the same while it lives.
struct BodyId {
    std::uint32_t id = 0xffffffffu;                                 ///< of the body's handle
    friend bool operator==(const BodyId&, const BodyId&) = default; ///< whether they name one body
};

/// A description that `World::add` takes for an element: it says so with `using element = ...;`, its own name.
template <class E>
concept Element = std::same_as<typename E::element, E>;

/// Which ids of elements live: a part of a policy's State.
class ElementIds {
public:
    /// Ids ever given out.
    std::size_t ids() const { return generation_.size(); }
    /// How many live.
    std::size_t size() const { return generation_.size() - free_.size(); }
    /// Whether an element has this id.
    bool alive(std::size_t id) const { return alive_[id]; }
    /// The generation that its handle must have.
    std::uint32_t generation(std::size_t id) const { return generation_[id]; }

    /// Whether the handle names an element that is still there.
    template <class E> bool contains(const ElementHandle<E>& h) const {
        return h.id < generation_.size() && alive_[h.id] && generation_[h.id] == h.generation;
    }
    /// The id of a handle.
    /// \throws std::out_of_range for one whose element is gone, or that none ever had
    template <class E> std::uint32_t id(const ElementHandle<E>& h, const char* where) const {
        if (!contains(h)) detail::refuse_handle("number", h.id, h.generation, ids(), where);
        return h.id;
    }

    /// Room for so many.
    void reserve(std::size_t n) {
        generation_.reserve(n);
        alive_.reserve(n);
        free_.reserve(n);
    }
    /// Room for every id to be given back, so that `give_back` cannot fail; a copied vector has no more room than it
    /// needs.
    void reserve_notes() { free_.reserve(generation_.size()); }
    /// The id that `take` gives out next.
    std::uint32_t next() const { return free_.empty() ? std::uint32_t(generation_.size()) : free_.back(); }
    /// A new element.
    std::uint32_t take() {
        const auto id = next();
        if (free_.empty()) {
            generation_.push_back(0);
            alive_.push_back(1);
            if (free_.capacity() < generation_.size()) free_.reserve(generation_.capacity());
        } else {
            free_.pop_back();
            alive_[id] = 1;
        }
        return id;
    }
    /// It is gone; its handle is stale from now on.
    void give_back(std::uint32_t id) {
        alive_[id] = 0;
        ++generation_[id];
        free_.push_back(id);
    }
    /// Adds to a hash which elements there are, and which handles the next will get.
    template <class Hash> void add_to(Hash& hash) const {
        hash.add(generation_.size());
        for (std::size_t id = 0; id < generation_.size(); ++id)
            hash.add(std::uint64_t(generation_[id]) << 1 | alive_[id]);
        for (const auto id : free_) hash.add(id);
    }

private:
    friend struct ElementArchive;

    std::vector<std::uint32_t> generation_; // by id
    std::vector<std::uint8_t> alive_;       // by id
    std::vector<std::uint32_t> free_;       // ids to give out again, last freed first
};

/// What a number of an element may be, in a file.
enum class NumberIn : std::uint8_t {
    not_negative,        ///< finite, zero or more
    positive_or_infinite ///< a limit: greater than zero, and infinite where there is none
};

namespace detail {

/// Whether a policy keeps a state of its own in the world.
template <class P, class S> inline constexpr bool keeps_state = requires { typename P::template State<S>; };
template <class P, class S> using state_of = typename P::template State<S>;

/// Takes the place of what is not there.
struct Absent {
    friend bool operator==(const Absent&, const Absent&) = default;
};
inline constexpr Absent absent{};
template <class P, class S> struct StateOr {
    using type = Absent;
};
template <class P, class S>
    requires keeps_state<P, S>
struct StateOr<P, S> {
    using type = state_of<P, S>;
};

template <class P> struct HasElements : std::bool_constant < requires {
    typename P::Element;
} > {};

/// Whether elements of type E are what policy P keeps.
template <class P, class E> inline constexpr bool keeps_element = false;
template <class P, class E>
    requires requires { typename P::Element; }
inline constexpr bool keeps_element<P, E> = std::same_as<typename P::Element, E>;

/// The policy that keeps elements of type E.
template <class E, class... P> struct KeeperOf {
    using type = void;
};
template <class E, class First, class... Rest> struct KeeperOf<E, First, Rest...> : KeeperOf<E, Rest...> {};
template <class E, class First, class... Rest>
    requires keeps_element<First, E>
struct KeeperOf<E, First, Rest...> {
    using type = First;
};

} // namespace detail
} // namespace ansatz
