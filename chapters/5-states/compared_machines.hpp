// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The machines that `what_it_costs` of chapter 5 compares: n states, five events, a transition for nine of ten pairs
/// of them. Ten states have 45 transitions. Written by hand, described for the library, and for Boost.Statechart.

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

constexpr int events = 5;
/// Whether state s answers event e, and with which state.
constexpr bool answers(int s, int e) { return (s + e) % 10 != 9; }
constexpr int next(int s, int e, int n) { return (s * 7 + e * 3 + 1) % n; }

/// What the machines decide about: something that depends on every transition that was taken, and on their order.
struct Tally {
    std::uint32_t sum = 0;
};
/// What is done with the transition of state s on event e, where anything is done.
template <int S, int E> inline void act(Tally& t) {
    if constexpr ((S + E) % 3 == 0) t.sum += S + 1;
    else if constexpr ((S + E) % 3 == 1) t.sum ^= 8 * E + 5;
    else t.sum = 3 * t.sum + S;
}

// ---------------------------------------------------------------- by hand, ten states
/// A switch, as one writes it.
template <bool Acts> class HandSwitch {
public:
    bool handle(Tally& tally, int event) {
        switch (state_) {
        case 0:
            switch (event) {
            case 0:
                done<0, 0>(tally);
                state_ = 1;
                return true;
            case 1:
                done<0, 1>(tally);
                state_ = 4;
                return true;
            case 2:
                done<0, 2>(tally);
                state_ = 7;
                return true;
            case 3:
                done<0, 3>(tally);
                state_ = 0;
                return true;
            case 4:
                done<0, 4>(tally);
                state_ = 3;
                return true;
            }
            break;
        case 1:
            switch (event) {
            case 0:
                done<1, 0>(tally);
                state_ = 8;
                return true;
            case 1:
                done<1, 1>(tally);
                state_ = 1;
                return true;
            case 2:
                done<1, 2>(tally);
                state_ = 4;
                return true;
            case 3:
                done<1, 3>(tally);
                state_ = 7;
                return true;
            case 4:
                done<1, 4>(tally);
                state_ = 0;
                return true;
            }
            break;
        case 2:
            switch (event) {
            case 0:
                done<2, 0>(tally);
                state_ = 5;
                return true;
            case 1:
                done<2, 1>(tally);
                state_ = 8;
                return true;
            case 2:
                done<2, 2>(tally);
                state_ = 1;
                return true;
            case 3:
                done<2, 3>(tally);
                state_ = 4;
                return true;
            case 4:
                done<2, 4>(tally);
                state_ = 7;
                return true;
            }
            break;
        case 3:
            switch (event) {
            case 0:
                done<3, 0>(tally);
                state_ = 2;
                return true;
            case 1:
                done<3, 1>(tally);
                state_ = 5;
                return true;
            case 2:
                done<3, 2>(tally);
                state_ = 8;
                return true;
            case 3:
                done<3, 3>(tally);
                state_ = 1;
                return true;
            case 4:
                done<3, 4>(tally);
                state_ = 4;
                return true;
            }
            break;
        case 4:
            switch (event) {
            case 0:
                done<4, 0>(tally);
                state_ = 9;
                return true;
            case 1:
                done<4, 1>(tally);
                state_ = 2;
                return true;
            case 2:
                done<4, 2>(tally);
                state_ = 5;
                return true;
            case 3:
                done<4, 3>(tally);
                state_ = 8;
                return true;
            case 4:
                done<4, 4>(tally);
                state_ = 1;
                return true;
            }
            break;
        case 5:
            switch (event) {
            case 0:
                done<5, 0>(tally);
                state_ = 6;
                return true;
            case 1:
                done<5, 1>(tally);
                state_ = 9;
                return true;
            case 2:
                done<5, 2>(tally);
                state_ = 2;
                return true;
            case 3:
                done<5, 3>(tally);
                state_ = 5;
                return true;
            }
            break;
        case 6:
            switch (event) {
            case 0:
                done<6, 0>(tally);
                state_ = 3;
                return true;
            case 1:
                done<6, 1>(tally);
                state_ = 6;
                return true;
            case 2:
                done<6, 2>(tally);
                state_ = 9;
                return true;
            case 4:
                done<6, 4>(tally);
                state_ = 5;
                return true;
            }
            break;
        case 7:
            switch (event) {
            case 0:
                done<7, 0>(tally);
                state_ = 0;
                return true;
            case 1:
                done<7, 1>(tally);
                state_ = 3;
                return true;
            case 3:
                done<7, 3>(tally);
                state_ = 9;
                return true;
            case 4:
                done<7, 4>(tally);
                state_ = 2;
                return true;
            }
            break;
        case 8:
            switch (event) {
            case 0:
                done<8, 0>(tally);
                state_ = 7;
                return true;
            case 2:
                done<8, 2>(tally);
                state_ = 3;
                return true;
            case 3:
                done<8, 3>(tally);
                state_ = 6;
                return true;
            case 4:
                done<8, 4>(tally);
                state_ = 9;
                return true;
            }
            break;
        case 9:
            switch (event) {
            case 1:
                done<9, 1>(tally);
                state_ = 7;
                return true;
            case 2:
                done<9, 2>(tally);
                state_ = 0;
                return true;
            case 3:
                done<9, 3>(tally);
                state_ = 3;
                return true;
            case 4:
                done<9, 4>(tally);
                state_ = 6;
                return true;
            }
            break;
        }
        return false;
    }
    int state() const { return state_; }

private:
    template <int S, int E> static void done(Tally& tally) {
        if constexpr (Acts) act<S, E>(tally);
    }
    int state_ = 0;
};

/// The state pattern, as one writes it: a class for each state, and a virtual call for each event.
template <bool Acts> class HandClasses {
public:
    HandClasses() = default;
    HandClasses(const HandClasses&) = delete;
    bool handle(Tally& tally, int event) {
        const State* to = now_->handle(*this, tally, event);
        if (to == nullptr) return false;
        now_ = to;
        return true;
    }
    int state() const { return now_->number(); }

private:
    struct State {
        virtual const State* handle(const HandClasses&, Tally&, int event) const = 0; ///< the next state, or none
        virtual int number() const = 0;

    protected:
        ~State() = default;
    };
    template <int S, int E> static void done(Tally& tally) {
        if constexpr (Acts) act<S, E>(tally);
    }
    struct S0 final : State {
        int number() const override { return 0; }
        const State* handle(const HandClasses& all, Tally& tally, int event) const override {
            switch (event) {
            case 0: done<0, 0>(tally); return &all.s1_;
            case 1: done<0, 1>(tally); return &all.s4_;
            case 2: done<0, 2>(tally); return &all.s7_;
            case 3: done<0, 3>(tally); return &all.s0_;
            case 4: done<0, 4>(tally); return &all.s3_;
            }
            return nullptr;
        }
    };
    struct S1 final : State {
        int number() const override { return 1; }
        const State* handle(const HandClasses& all, Tally& tally, int event) const override {
            switch (event) {
            case 0: done<1, 0>(tally); return &all.s8_;
            case 1: done<1, 1>(tally); return &all.s1_;
            case 2: done<1, 2>(tally); return &all.s4_;
            case 3: done<1, 3>(tally); return &all.s7_;
            case 4: done<1, 4>(tally); return &all.s0_;
            }
            return nullptr;
        }
    };
    struct S2 final : State {
        int number() const override { return 2; }
        const State* handle(const HandClasses& all, Tally& tally, int event) const override {
            switch (event) {
            case 0: done<2, 0>(tally); return &all.s5_;
            case 1: done<2, 1>(tally); return &all.s8_;
            case 2: done<2, 2>(tally); return &all.s1_;
            case 3: done<2, 3>(tally); return &all.s4_;
            case 4: done<2, 4>(tally); return &all.s7_;
            }
            return nullptr;
        }
    };
    struct S3 final : State {
        int number() const override { return 3; }
        const State* handle(const HandClasses& all, Tally& tally, int event) const override {
            switch (event) {
            case 0: done<3, 0>(tally); return &all.s2_;
            case 1: done<3, 1>(tally); return &all.s5_;
            case 2: done<3, 2>(tally); return &all.s8_;
            case 3: done<3, 3>(tally); return &all.s1_;
            case 4: done<3, 4>(tally); return &all.s4_;
            }
            return nullptr;
        }
    };
    struct S4 final : State {
        int number() const override { return 4; }
        const State* handle(const HandClasses& all, Tally& tally, int event) const override {
            switch (event) {
            case 0: done<4, 0>(tally); return &all.s9_;
            case 1: done<4, 1>(tally); return &all.s2_;
            case 2: done<4, 2>(tally); return &all.s5_;
            case 3: done<4, 3>(tally); return &all.s8_;
            case 4: done<4, 4>(tally); return &all.s1_;
            }
            return nullptr;
        }
    };
    struct S5 final : State {
        int number() const override { return 5; }
        const State* handle(const HandClasses& all, Tally& tally, int event) const override {
            switch (event) {
            case 0: done<5, 0>(tally); return &all.s6_;
            case 1: done<5, 1>(tally); return &all.s9_;
            case 2: done<5, 2>(tally); return &all.s2_;
            case 3: done<5, 3>(tally); return &all.s5_;
            }
            return nullptr;
        }
    };
    struct S6 final : State {
        int number() const override { return 6; }
        const State* handle(const HandClasses& all, Tally& tally, int event) const override {
            switch (event) {
            case 0: done<6, 0>(tally); return &all.s3_;
            case 1: done<6, 1>(tally); return &all.s6_;
            case 2: done<6, 2>(tally); return &all.s9_;
            case 4: done<6, 4>(tally); return &all.s5_;
            }
            return nullptr;
        }
    };
    struct S7 final : State {
        int number() const override { return 7; }
        const State* handle(const HandClasses& all, Tally& tally, int event) const override {
            switch (event) {
            case 0: done<7, 0>(tally); return &all.s0_;
            case 1: done<7, 1>(tally); return &all.s3_;
            case 3: done<7, 3>(tally); return &all.s9_;
            case 4: done<7, 4>(tally); return &all.s2_;
            }
            return nullptr;
        }
    };
    struct S8 final : State {
        int number() const override { return 8; }
        const State* handle(const HandClasses& all, Tally& tally, int event) const override {
            switch (event) {
            case 0: done<8, 0>(tally); return &all.s7_;
            case 2: done<8, 2>(tally); return &all.s3_;
            case 3: done<8, 3>(tally); return &all.s6_;
            case 4: done<8, 4>(tally); return &all.s9_;
            }
            return nullptr;
        }
    };
    struct S9 final : State {
        int number() const override { return 9; }
        const State* handle(const HandClasses& all, Tally& tally, int event) const override {
            switch (event) {
            case 1: done<9, 1>(tally); return &all.s7_;
            case 2: done<9, 2>(tally); return &all.s0_;
            case 3: done<9, 3>(tally); return &all.s3_;
            case 4: done<9, 4>(tally); return &all.s6_;
            }
            return nullptr;
        }
    };
    S0 s0_;
    S1 s1_;
    S2 s2_;
    S3 s3_;
    S4 s4_;
    S5 s5_;
    S6 s6_;
    S7 s7_;
    S8 s8_;
    S9 s9_;
    const State* now_ = &s0_;
};

// ---------------------------------------------------------------- the library
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
