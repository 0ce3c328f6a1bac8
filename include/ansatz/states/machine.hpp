// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Machine<Description, Representation, Options...>`: a finite state machine, described once (notes 5, 5.1).
///
/// | representation | the notes call it                | use it                                                   |
/// |----------------|----------------------------------|----------------------------------------------------------|
/// | `Switch`       | hard coded switch                | for small machines; fast, and the whole is visible to the compiler |
/// | `StatePattern` | hard coded state pattern         | where states are classes with data and behaviour of their own |
/// | `Table`        |                                  | for machines with many transitions and little to do in them |
/// | `Interpreted`  | interpreted state pattern        | for machines in files, changed while the game runs; parallel states |
///
/// All take the same events to the same trace: `start(context)` once, `handle(context, event)` for events,
/// `update(context, dt)` at every step. A machine is a value: copying it is the snapshot.

#include <ansatz/states/interpreted.hpp>
#include <ansatz/states/state_pattern.hpp>
#include <ansatz/states/switch.hpp>
#include <ansatz/states/table.hpp>

namespace ansatz {

namespace states {
/// The machine of a representation.
template <class D, class R, class... O> struct MachineOf {
    static_assert(
        !std::is_same_v<R, Interpreted> && requires { R::owns_behaviours; },
        "Ansatz: the representations of a Machine are Switch, StatePattern, Table and Interpreted, e.g. "
        "Machine<GuardNpc, Switch>");
    static_assert(!Model<D>::rows.childless || Options<O...>::childless,
                  "Ansatz: a state of this machine begins in none of the states in it, no_initial(); name one, "
                  "initial(\"...\"), or allow it: Machine<Description, Switch, AllowChildless>");
    using type = StaticMachine<D, R, O...>; ///< decided while it is compiled
};
/// The machine of Interpreted.
template <class D, class... O> struct MachineOf<D, Interpreted, O...> {
    /// Whether a state of it may be active without a child.
    static constexpr bool begins_in_none = [] {
        if constexpr (requires { D::machine; }) return Model<D>::rows.childless;
        else return false; // from a file: refused when it is made
    }();
    static_assert(!begins_in_none || Options<O...>::childless,
                  "Ansatz: a state of this machine begins in none of the states in it, no_initial(); name one, "
                  "initial(\"...\"), or allow it: Machine<Description, Interpreted, AllowChildless>");
    using type = InterpretedMachine<D, typename D::Context, O...>; ///< that walks a chart
};
} // namespace states

/// A finite state machine.
/// \tparam Description     a struct with `Context` and `machine`, see describe.hpp; `InFile<Context>` for one from a
/// file
/// \tparam Representation  Switch, StatePattern, Table or Interpreted
/// \tparam Options         what happens to unhandled events, and watchers, see options.hpp
template <class Description, class Representation = Switch, class... Options>
using Machine = typename states::MachineOf<Description, Representation, Options...>::type;

} // namespace ansatz
