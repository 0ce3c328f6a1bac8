// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Keep<Columns...>` and `Datum<T>`: things that a world stores although none of its policies needs them.
///
/// Use `Keep<InverseMass>` to ask a world of gravity alone for momentum and energy, and `Datum<T>` for whatever belongs
/// to a body in your program (a name, a sprite). Not for what a policy needs: the policy declares that itself.

#include <ansatz/world/columns.hpp>
#include <ansatz/world/roles.hpp>

#include <type_traits>

namespace ansatz {

/// Stores the columns `C...`. Costs their bytes for each body and not one instruction of the step.
template <class... C> struct Keep {
    static_assert((Column<C> && ...), "Ansatz: Keep stores columns, e.g. Keep<InverseMass>; see columns.hpp");
    using role = roles::Observer;
    using reads = Columns<C...>;
};

/// Stores one `T` for each body, reached by `world.datum(handle)`. It is copied with the world, and saved where it is a
/// number, a text, trivially copyable, or has two functions of yours (world/datum_text.hpp). It is not hashed, because
/// only your program knows what it means.
template <class T> struct Datum {
    static_assert(std::is_default_constructible_v<T>,
                  "Ansatz: Datum<T> needs a T with a default constructor, for bodies that are added "
                  "without datum(...); write Datum<std::optional<T>>");
    using role = roles::Observer;
    using reads = Columns<>;
    using datum_type = T; ///< the user's type
};

} // namespace ansatz
