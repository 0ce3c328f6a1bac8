// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The machines that `what_it_costs` of chapter 5 compares: n states, five events, a transition for nine of ten pairs
/// of them. Ten states have 45 transitions. Written by hand (switch_by_hand.hpp, classes_by_hand.hpp),
/// described for the library, and for Boost.Statechart.

#include "classes_by_hand.hpp"
#include "switch_by_hand.hpp"

#include <ansatz/states.hpp>

#include <boost/mpl/list.hpp>
#include <boost/statechart/simple_state.hpp>
#include <boost/statechart/state_machine.hpp>
#include <boost/statechart/transition.hpp>

#include <array>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

namespace compared {

/// "s7", "e2".
template <char Letter, int I> struct Name {
    static constexpr std::array<char, 3> text{Letter, char(I < 10 ? '0' + I : '0' + I / 10), char('0' + I % 10)};
    static constexpr std::string_view view{text.data(), I < 10 ? 2u : 3u};
};
template <int N, bool Acts> struct Described {
    using Context = Tally;
    template <int S, int E> static constexpr auto move() {
        using namespace ansatz::states;
        if constexpr (!answers(S, E)) return std::tuple<>();
        else if constexpr (Acts)
            return std::tuple(transition(on(Name<'e', E>::view), then(act<S, E>), to(Name<'s', next(S, E, N)>::view)));
        else return std::tuple(transition(on(Name<'e', E>::view), to(Name<'s', next(S, E, N)>::view)));
    }
    template <int S> static constexpr auto one() {
        return std::apply([](auto... moves) { return ansatz::states::state(Name<'s', S>::view, moves...); },
                          std::tuple_cat(move<S, 0>(), move<S, 1>(), move<S, 2>(), move<S, 3>(), move<S, 4>()));
    }
    static constexpr auto machine = []<int... S>(std::integer_sequence<int, S...>) {
        return ansatz::states::machine(one<S>()...);
    }(std::make_integer_sequence<int, N>{});
};

/// A machine of the library, with the events' numbers looked up.
template <int N, bool Acts, class Representation> class Library {
public:
    Library() {
        machine_.start(tally_);
        for (int e = 0; e < events; ++e) ids_[std::size_t(e)] = machine_.event(std::string_view(names[std::size_t(e)]));
    }
    bool handle(Tally& tally, int event) { return machine_.handle(tally, ids_[std::size_t(event)]); }
    int state() const { return int(ansatz::index(machine_.active())) - 1; } // 0 is the root

private:
    static constexpr std::array<std::string_view, events> names{"e0", "e1", "e2", "e3", "e4"};
    Tally tally_;
    ansatz::Machine<Described<N, Acts>, Representation> machine_;
    std::array<ansatz::EventId, events> ids_{};
};

// ---------------------------------------------------------------- Boost.Statechart
namespace statechart {
namespace sc = boost::statechart;
template <int E> struct Event : sc::event<Event<E>> {};
template <int N, bool Acts, int S> struct State;
template <int N, bool Acts> struct Machine : sc::state_machine<Machine<N, Acts>, State<N, Acts, 0>> {
    Tally* tally = nullptr;
    bool moved = false;
    template <int S, int E> void took(const Event<E>&) {
        moved = true;
        if constexpr (Acts) act<S, E>(*tally);
    }
};
template <int N, bool Acts, int S, int E> struct Move {
    using M = Machine<N, Acts>;
    using type = boost::mpl::list<sc::transition<Event<E>, State<N, Acts, next(S, E, N)>, M, &M::template took<S, E>>>;
};
// The pair that has no transition is left out of the list of a state.
template <int N, bool Acts, int S, int E, class Rest> struct Joined {
    using type =
        typename boost::mpl::push_front<Rest,
                                        typename boost::mpl::front<typename Move<N, Acts, S, E>::type>::type>::type;
};
template <int N, bool Acts, int S, int E = 0> struct Reactions {
    using rest = typename Reactions<N, Acts, S, E + 1>::type;
    using type =
        typename std::conditional_t<answers(S, E), Joined<N, Acts, S, E, rest>, std::type_identity<rest>>::type;
};
template <int N, bool Acts, int S> struct Reactions<N, Acts, S, events> {
    using type = boost::mpl::list<>;
};
template <int N, bool Acts, int S> struct State : sc::simple_state<State<N, Acts, S>, Machine<N, Acts>> {
    using reactions = typename Reactions<N, Acts, S>::type;
    static constexpr int number = S;
};
} // namespace statechart

/// Boost.Statechart with the same interface.
template <int N, bool Acts> class Statechart {
public:
    Statechart() { machine_.initiate(); }
    bool handle(Tally& tally, int event) {
        using namespace statechart;
        machine_.tally = &tally;
        machine_.moved = false;
        switch (event) {
        case 0: machine_.process_event(Event<0>()); break;
        case 1: machine_.process_event(Event<1>()); break;
        case 2: machine_.process_event(Event<2>()); break;
        case 3: machine_.process_event(Event<3>()); break;
        default: machine_.process_event(Event<4>());
        }
        return machine_.moved;
    }
    /// The state, by asking each whether it is it.
    int state() const {
        int found = -1;
        [&]<int... S>(std::integer_sequence<int, S...>) {
            ((machine_.template state_cast<const statechart::State<N, Acts, S>*>() != nullptr ? void(found = S)
                                                                                              : void()),
             ...);
        }(std::make_integer_sequence<int, N>{});
        return found;
    }

private:
    statechart::Machine<N, Acts> machine_;
};

} // namespace compared
