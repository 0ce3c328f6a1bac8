// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Row`: the values of one body's columns, as quantities, while the laws read it.
///
/// The loop over bodies loads a row from the lanes, hands its values to laws, stages and effects, and stores what was
/// written. A row lives in registers; nothing of it remains in an optimised program.

#include <ansatz/world/columns.hpp>

#include <cstddef>
#include <utility>

namespace ansatz {

namespace detail {

template <class C, class S> struct Cell {
    value_of<C, S> value;
};

template <class C, class S, class Scalar> [[gnu::always_inline]] inline value_of<C, S> load(const Scalar* raw) {
    using V = value_of<C, S>;
    if constexpr (has_own_lanes<C, S>) return V::from_lanes(raw);
    else if constexpr (!requires { V::value_type::RowsAtCompileTime; }) return V::from_value(raw[0]);
    else if constexpr (V::value_type::RowsAtCompileTime == 2)
        return V::from_value(typename V::value_type(raw[0], raw[1]));
    else return V::from_value(typename V::value_type(raw[0], raw[1], raw[2]));
}

template <class C, class S, class Scalar>
[[gnu::always_inline]] inline void store(const value_of<C, S>& q, Scalar* raw) {
    using V = value_of<C, S>;
    if constexpr (has_own_lanes<C, S>) q.to_lanes(raw);
    else if constexpr (!requires { V::value_type::RowsAtCompileTime; }) raw[0] = q.value();
    else
        for (int i = 0; i < V::value_type::RowsAtCompileTime; ++i) raw[i] = q.value()[i];
}

/// Whether every number of a value is finite.
template <class C, class S> bool has_finite_numbers(const value_of<C, S>& q) {
    if constexpr (has_own_lanes<C, S>) {
        typename S::Scalar raw[room_for<C, S>] = {};
        q.to_lanes(raw);
        bool finite = true;
        for (std::size_t k = 0; k < lanes_of<C>(S::dimension); ++k) finite = finite && is_finite(raw[k]);
        return finite;
    } else return is_finite(q);
}

/// Position of column C's first lane among the lanes of a list.
template <class C, class... In> constexpr std::size_t offset_in(Columns<In...>, [[maybe_unused]] int dimension) {
    std::size_t offset = 0;
    bool found = false;
    ((found = found || std::same_as<C, In>, offset += found ? 0 : lanes_of<In>(dimension)), ...);
    return offset;
}

template <class... In> constexpr std::size_t lane_count(Columns<In...>, [[maybe_unused]] int dimension) {
    return (std::size_t(0) + ... + lanes_of<In>(dimension));
}

} // namespace detail

/// The values of columns `C...` of one body in space `S`.
template <class S, class List> struct Row;
/// One body's values of a list of columns.
template <class S, class... C> struct Row<S, Columns<C...>> : detail::Cell<C, S>... {
    /// The columns.
    using columns = Columns<C...>;

    /// The value of a column.
    template <class Which> [[gnu::always_inline]] value_of<Which, S>& get() { return detail::Cell<Which, S>::value; }
    /// The value of a column.
    template <class Which> [[gnu::always_inline]] const value_of<Which, S>& get() const {
        return detail::Cell<Which, S>::value;
    }
};

namespace detail {

/// Calls `f` with the values of the listed columns, in the order of the list (Clock is not a value).
template <class R, class F, class... C>
[[gnu::always_inline]] inline decltype(auto) with_values(R& row, Columns<C...>, F&& f) {
    return std::forward<F>(f)(row.template get<C>()...);
}

} // namespace detail
} // namespace ansatz
