// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Fields: what a state of your own consists of, said once. From it follow how it is hashed, saved and loaded.
///
///     template <class S> struct State {
///         std::vector<typename S::Scalar> height;
///         typename S::Length depth{};
///         static void fields(auto& self, auto&& field) {
///             field("height", self.height);
///             field("depth", self.depth);
///         }
///     };
///
/// A field is a number, a bool, a quantity, a vector quantity, or a std::vector or std::array of these; in the row of
/// an ElementTable a `BodyId`, too, which names no body until it is given one. In a file it stands under its name, a
/// quantity as a raw SI number. A state whose numbers have to fit together says so in `void check() const`, which
/// throws std::invalid_argument, and is called when a file was read.
///
/// A state without `fields` has functions of its own: `add_to(hash)`, and what world/save_elements.hpp reads.

#include <ansatz/units.hpp>
#include <ansatz/world/elements.hpp>
#include <ansatz/world/hash.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

namespace ansatz::detail {

struct AnyField {
    void operator()(std::string_view, const auto&) const {}
};
/// Whether a state says what it consists of.
template <class T>
concept NamesFields = requires(const T& state) { T::fields(state, AnyField{}); };

template <class T>
inline constexpr bool is_list = requires(const T& list) {
    list.begin();
    list.size();
    typename T::value_type;
};
/// Whether something has the lanes of a matrix: a vector quantity.
template <class T> inline constexpr bool is_quantity_of_lanes = requires(const T& q) { q.value().size(); };
template <class T>
inline constexpr bool is_quantity_of_one = !is_quantity_of_lanes<T> && requires(const T& q) {
    q.value();
    T::from_value(q.value());
};

/// Whether a field names bodies.
template <class T> inline constexpr bool names_bodies = std::same_as<T, BodyId>;
template <class T>
    requires is_list<T>
inline constexpr bool names_bodies<T> = names_bodies<typename T::value_type>;

/// Calls `f(id)` for each body that a field names; a BodyId that was not given one names no body.
template <class T, class F> void each_body_in(const T& x, F&& f) {
    if constexpr (std::same_as<T, BodyId>) {
        if (!(x == BodyId())) f(x.id);
    } else if constexpr (names_bodies<T>)
        for (const auto& one : x) each_body_in(one, f);
}
/// Adds a field to a hash.
template <class T> void hash_field(StateHash& hash, const T& x) {
    if constexpr (std::is_integral_v<T>) hash.add(std::uint64_t(x));
    else if constexpr (std::same_as<T, BodyId>) hash.add(x.id);
    else if constexpr (is_quantity_of_lanes<T>)
        for (int i = 0; i < int(x.value().size()); ++i) hash.add_number(x.value()[i]);
    else if constexpr (is_quantity_of_one<T>) hash.add_number(x.value());
    else if constexpr (is_list<T>) {
        hash.add(std::uint64_t(x.size()));
        for (const auto& one : x) hash_field(hash, static_cast<const typename T::value_type&>(one));
    } else hash.add_number(x);
}
/// Adds what something consists of.
/// \tparam FollowsBodies whether it is told when a body is removed
template <bool FollowsBodies, class T> void hash_fields(StateHash& hash, const T& state) {
    T::fields(state, [&]<class X>(std::string_view, const X& x) {
        static_assert(FollowsBodies || !names_bodies<X>,
                      "Ansatz: a State with a BodyId among its fields would name a body that is gone, since nobody "
                      "tells it; keep what names bodies in an ElementTable");
        hash_field(hash, x);
    });
}
/// Adds a state.
template <class T> void hash_state(StateHash& hash, const T& state) {
    if constexpr (requires { state.add_to(hash); }) state.add_to(hash);
    else {
        constexpr bool known = NamesFields<T>;
        static_assert(known,
                      "Ansatz: a policy keeps a State of which the world does not know what it consists of; give it "
                      "`static void fields(auto& self, auto&& field)`, which calls field(\"name\", self.name) for "
                      "each of its members");
        if constexpr (known) hash_fields<false>(hash, state);
    }
}

/// A field as a value in a file.
template <class Files, class T> typename Files::Json field_to_file(const T& x) {
    using Value = typename Files::Json;
    if constexpr (std::is_integral_v<T>) return x;
    else if constexpr (std::same_as<T, BodyId>) return x.id;
    else if constexpr (is_quantity_of_lanes<T>) {
        Value list = Value::array();
        for (int i = 0; i < int(x.value().size()); ++i) list.push_back(Files::number(x.value()[i]));
        return list;
    } else if constexpr (is_quantity_of_one<T>) return Files::number(x.value());
    else if constexpr (is_list<T>) {
        Value list = Value::array();
        for (const auto& one : x) list.push_back(field_to_file<Files>(static_cast<const typename T::value_type&>(one)));
        return list;
    } else return Files::number(x);
}
/// A field from a file.
/// \throws std::invalid_argument naming the place in the file
template <class T> void field_from_file(T& x, const auto& file) {
    if constexpr (std::same_as<T, bool>) x = file.yes();
    else if constexpr (std::same_as<T, BodyId>) x.id = std::uint32_t(file.whole(BodyId().id));
    else if constexpr (std::is_integral_v<T>) x = file.template integer<T>();
    else if constexpr (is_quantity_of_lanes<T>) {
        auto value = x.value();
        file.size_is(std::size_t(value.size()), "numbers");
        for (int i = 0; i < int(value.size()); ++i)
            value[i] = file.at(std::size_t(i)).template number<std::remove_cvref_t<decltype(value[0])>>();
        x = T::from_value(value);
    } else if constexpr (is_quantity_of_one<T>)
        x = T::from_value(file.template number<std::remove_cvref_t<decltype(x.value())>>());
    else if constexpr (is_list<T>) {
        const auto count = file.size("values");
        if constexpr (requires { x.resize(count); }) x.resize(count);
        else file.size_is(x.size(), "values");
        for (std::size_t i = 0; i < count; ++i) {
            typename T::value_type one{};
            field_from_file(one, file.at(i));
            x[i] = one;
        }
    } else x = file.template number<T>();
}

/// The fields of a state, by their names.
template <class Files, class T> void write_fields(typename Files::Json& file, const T& state) {
    T::fields(state, [&](std::string_view name, const auto& x) { file[std::string(name)] = field_to_file<Files>(x); });
}
/// \throws std::invalid_argument naming the place in the file
template <class T> void read_fields(T& state, const auto& file) {
    T::fields(state, [&](std::string_view name, auto& x) { field_from_file(x, file.at(std::string(name).c_str())); });
    if constexpr (requires { state.check(); }) {
        try {
            state.check();
        } catch (const std::invalid_argument& e) {
            refuse(Refusal::invalid_argument, file.place + ": " + e.what());
        }
    }
}

} // namespace ansatz::detail
