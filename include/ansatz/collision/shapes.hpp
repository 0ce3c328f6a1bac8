// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ShapeIn`, what a shape is, and `ShapesOf`: the shapes of a world's bodies, stored by kind.
///
/// A shape is a description (`Sphere{0.5 * metre}`) with `using shape = ` itself, a name, `bounded`, and a nested
/// `template <class S> struct In` made from it: its numbers in the scalar of a space, and, where it is bounded, the
/// corners of its box. A shape of yours needs that and functions `collide(In, position, In, position, touch)`, one for
/// each kind that it meets, in either order, in the namespace of your shape; the library need not know of it.

#include <ansatz/collision/contact.hpp>
#include <ansatz/collision/properties.hpp>

#include <concepts>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace ansatz {

namespace detail {
template <class T>
concept ShapeNamed = requires {
    { T::bounded } -> std::convertible_to<bool>;
    { T::name } -> std::convertible_to<std::string_view>;
};
template <class T, class S>
concept ShapeMade =
    requires { typename T::template In<S>; } && std::constructible_from<typename T::template In<S>, const T&> &&
    std::same_as<typename T::template In<S>::description, T>;
template <class T, class S>
concept ShapeKept = std::copyable<T> && std::copyable<typename T::template In<S>>;
template <class T, class S>
concept ShapeBoxed = !T::bounded || requires(const typename T::template In<S>& in, const typename S::Position& x,
                                             typename S::Position& corner) { in.bounds(x, corner, corner); };
} // namespace detail

/// A shape in a space: named, made from its description, stored in vectors, and with a box if it says that it has one.
///
/// `Sphere`, `Plane` and `Box` are shapes (notes 2.1.2).
template <class T, class S>
concept ShapeIn = ShapeDescription<T> && detail::ShapeNamed<T> && detail::ShapeMade<T, S> && detail::ShapeKept<T, S> &&
                  detail::ShapeBoxed<T, S>;

/// The shapes of bodies, by the ids of the bodies, each kind in a vector of its own.
template <class S, class... T> class ShapesOf {
public:
    static constexpr std::uint8_t none = 255; ///< the kind of a body without a shape
    static_assert(sizeof...(T) < none, "Ansatz: a Narrowphase has at most 254 kinds of shapes");

    /// The place of a kind in the list.
    template <class Kind>
    static constexpr std::uint8_t kind_of = [] {
        std::uint8_t place = none, next = 0;
        ((place = std::same_as<Kind, T> ? next : place, ++next), ...);
        return place;
    }();

    /// The kind of a body's shape; `none` if it has none.
    [[gnu::always_inline]] std::uint8_t kind(std::uint32_t id) const { return id < kind_.size() ? kind_[id] : none; }
    /// Whether a body has a shape.
    bool has(std::uint32_t id) const { return kind(id) != none; }
    /// Whether it has one that a box holds.
    bool bounded(std::uint32_t id) const {
        bool answer = false;
        visit(id, [&](const auto& shape) { answer = std::remove_cvref_t<decltype(shape)>::description::bounded; });
        return answer;
    }
    /// The shape of a body of this kind.
    template <class Kind> [[gnu::always_inline]] const typename Kind::template In<S>& get(std::uint32_t id) const {
        return std::get<kind_of<Kind>>(kinds_).shapes[place_[id]];
    }
    /// Calls `f(shape)` with a body's shape, if it has one.
    template <class F> [[gnu::always_inline]] void visit(std::uint32_t id, F&& f) const {
        [[maybe_unused]] const auto k = kind(id);
        ((k == kind_of<T> ? f(get<T>(id)) : void()), ...);
    }
    /// Calls `f(description)` with the shape of a body as it was given, if it has one.
    template <class F> void visit_description(std::uint32_t id, F&& f) const {
        [[maybe_unused]] const auto k = kind(id);
        ((k == kind_of<T> ? f(std::get<kind_of<T>>(kinds_).descriptions[place_[id]]) : void()), ...);
    }
    /// How many bodies have a shape of this kind.
    template <class Kind> std::size_t count() const { return std::get<kind_of<Kind>>(kinds_).shapes.size(); }
    /// The bodies that have one.
    template <class Kind> const std::vector<std::uint32_t>& owners() const {
        return std::get<kind_of<Kind>>(kinds_).owners;
    }

    /// Room for a body with this id.
    void make_room(std::uint32_t id) {
        if (kind_.size() > id) return;
        kind_.resize(std::size_t(id) + 1, none);
        place_.resize(std::size_t(id) + 1);
    }
    /// Room for so many bodies.
    void reserve(std::size_t n) {
        kind_.reserve(n);
        place_.reserve(n);
    }
    /// Room for so many bodies more, whatever the kind of their shapes.
    void make_room_for_more(std::size_t n) {
        (std::get<kind_of<T>>(kinds_).reserve(std::get<kind_of<T>>(kinds_).owners.size() + n), ...);
    }
    /// Room for one body more with a shape of this kind.
    template <class Kind> void make_room_for_one() {
        auto& all = std::get<kind_of<Kind>>(kinds_);
        if (all.owners.size() == all.owners.capacity()) all.reserve(all.owners.size() < 4 ? 8 : 2 * all.owners.size());
    }
    /// Gives a body the shape that another has.
    void copy(std::uint32_t id, std::uint32_t to) {
        [[maybe_unused]] const auto k = kind(id);
        ((k == kind_of<T> ? copy_of<T>(id, to) : void()), ...);
    }
    /// Whether assigning cannot fail where there is room: what owns memory has a destructor.
    static constexpr bool assigns_in_place =
        ((std::is_trivially_destructible_v<T> && std::is_trivially_destructible_v<typename T::template In<S>>)&&...);
    /// Room for what another holds, so that assigning it cannot fail.
    void make_room_for(const ShapesOf& other) {
        reserve(other.kind_.size());
        (std::get<kind_of<T>>(kinds_).reserve(std::get<kind_of<T>>(other.kinds_).owners.size()), ...);
    }
    /// Gives a body a shape. Where it fails, the body has the one that it had.
    template <class Kind>
    void set(std::uint32_t id, const Kind& description, const typename Kind::template In<S>& shape) {
        make_room(id);
        make_room_for_one<Kind>();
        auto& all = std::get<kind_of<Kind>>(kinds_);
        auto shape_of_its_own = shape; // what may fail, before anything is changed
        auto description_of_its_own = description;
        erase(id);
        all.shapes.push_back(std::move(shape_of_its_own));
        all.descriptions.push_back(std::move(description_of_its_own));
        all.owners.push_back(id);
        kind_[id] = kind_of<Kind>;
        place_[id] = std::uint32_t(all.shapes.size() - 1);
    }
    /// Takes a body's shape from it.
    void erase(std::uint32_t id) {
        [[maybe_unused]] const auto k = kind(id);
        ((k == kind_of<T> ? erase_from<T>(id) : void()), ...);
        if (k != none) kind_[id] = none;
    }

private:
    template <class Kind> struct OfKind {
        std::vector<typename Kind::template In<S>> shapes;
        std::vector<Kind> descriptions;    // as they were given
        std::vector<std::uint32_t> owners; // the ids of the bodies

        void reserve(std::size_t n) {
            shapes.reserve(n);
            descriptions.reserve(n);
            owners.reserve(n); // last: room here means room everywhere
        }
    };
    template <class Kind> void copy_of(std::uint32_t id, std::uint32_t to) {
        const auto& all = std::get<kind_of<Kind>>(kinds_);
        const auto shape = all.shapes[place_[id]]; // theirs may go elsewhere while one is added
        const auto description = all.descriptions[place_[id]];
        set(to, description, shape);
    }
    template <class Kind> void erase_from(std::uint32_t id) {
        auto& all = std::get<kind_of<Kind>>(kinds_);
        const auto place = place_[id];
        all.owners[place] = all.owners.back();
        if (place + 1 < all.owners.size()) {
            all.shapes[place] = std::move(all.shapes.back());
            all.descriptions[place] = std::move(all.descriptions.back());
        }
        place_[all.owners[place]] = place;
        all.shapes.pop_back();
        all.descriptions.pop_back();
        all.owners.pop_back();
    }

    std::vector<std::uint8_t> kind_;   // by id
    std::vector<std::uint32_t> place_; // by id
    std::tuple<OfKind<T>...> kinds_;
};

} // namespace ansatz
