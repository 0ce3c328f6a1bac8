// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Tables that a policy sees beside the columns of bodies: what another policy keeps (springs, water), or what a module
/// names (contacts). It says which: `using sees = Types<Springs<>, Contacts>;`, and asks for them by
/// `view.template table<Contacts>()`. Debug drawing is such a policy.
///
/// \snippet tests/world/seen_tables.cpp drawing

#include <ansatz/world/elements.hpp>
#include <ansatz/world/types.hpp>

#include <tuple>

namespace ansatz {

namespace detail {

/// The type of a table: that of a policy's state, or what a module's tag says in `template <class S> using Table`.
template <class Q, class S> struct TableType {
    using type = Absent;
};
template <class Q, class S>
    requires keeps_state<Q, S>
struct TableType<Q, S> {
    using type = state_of<Q, S>;
};
template <class Q, class S>
    requires requires { typename Q::template Table<S>; }
struct TableType<Q, S> {
    using type = typename Q::template Table<S>;
};

template <class P> struct Sees {
    using type = Types<>;
};
template <class P>
    requires requires { typename P::sees; }
struct Sees<P> {
    using type = typename P::sees;
};
template <class P> using sees_of = typename Sees<P>::type;

/// A table of a world.
template <class Q, class Data> const auto& table_in(const Data& data) {
    using C = typename Data::Composition_;
    if constexpr (requires { Q::table_in(data); }) return Q::table_in(data);
    else {
        constexpr bool there = stands_in<Q, typename C::keepers>;
        static_assert(there, "Ansatz: a policy sees a table that this world does not have; add the policy that keeps "
                             "it to the list, or take it out of `sees`");
        if constexpr (there) return data.template state<Q>();
        else return absent;
    }
}

} // namespace detail

/// The tables that a policy sees.
template <class S, class List> class SeenTables;
/// \tparam Q policies that keep something, and the names of modules' tables
template <class S, class... Q> class SeenTables<S, Types<Q...>> {
public:
    /// Those of a world.
    template <class Data> static SeenTables in([[maybe_unused]] const Data& data) {
        SeenTables all;
        ((std::get<detail::place_of<Q, std::tuple<Q...>>>(all.tables_) = &detail::table_in<Q>(data)), ...);
        return all;
    }
    /// One of them.
    template <class Which> const auto& get() const {
        constexpr bool seen = (std::same_as<Which, Q> || ...);
        static_assert(seen, "Ansatz: a policy reads a table without saying so; add it to its "
                            "`using sees = Types<...>;`");
        if constexpr (seen) return *std::get<detail::place_of<Which, std::tuple<Q...>>>(tables_);
        else return detail::absent;
    }

private:
    [[no_unique_address]] std::tuple<const typename detail::TableType<Q, S>::type*...> tables_{};
};

} // namespace ansatz
