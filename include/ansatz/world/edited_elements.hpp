// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Elements that a system changes although another policy keeps them: a tear takes hinges and sails with it. The system
/// says which, by what `World::add` takes for them, `using edits = Types<Spring, Hinge>;`, and asks for the table by
/// `view.template edit<Hinge>()`. It need not know which policy keeps them; where none does, it gets `detail::absent`.
///
/// Tables are edited at one place of the step: at a phase from `phases::breaking` on and before `phases::sums`, where
/// springs break. There no loop runs over them, and the sums of forces are made anew behind it. What a table has, it
/// has for this, too: `for_each`, `row`, `replace`, `erase`; `insert` only where there is room, or the step allocates.
/// To read only, `view.template elements<Hinge>()`.
///
/// \snippet tests/world/edited_elements.cpp moth

#include <ansatz/world/elements.hpp>
#include <ansatz/world/types.hpp>

namespace ansatz::detail {

template <class P> struct Edits {
    using type = Types<>;
};
template <class P>
    requires requires { typename P::edits; }
struct Edits<P> {
    using type = typename P::edits;
};
/// The elements that a system says it changes.
template <class P> using edits_of = typename Edits<P>::type;

template <class E, class List> struct KeeperIn;
template <class E, class... P> struct KeeperIn<E, Types<P...>> {
    using type = typename KeeperOf<E, P...>::type;
};

/// The table of elements of a type, whichever policy keeps them; `absent` where none of the world's policies does.
template <class E, class Data> auto& elements_in([[maybe_unused]] Data& data) {
    using Keeper = typename KeeperIn<E, typename Data::Composition_::policies>::type;
    if constexpr (std::is_void_v<Keeper>) return absent;
    else return data.template state<Keeper>();
}

} // namespace ansatz::detail
