// SPDX-License-Identifier: BSL-1.0
// Fifty machines made while this file is compiled, in every representation: the same events lead to the same trace.
// Compiled without optimisation: two hundred machines, and none of them is measured.

#include <ansatz/states/interpreted.hpp>
#include <ansatz/states/state_pattern.hpp>
#include <ansatz/states/switch.hpp>
#include <ansatz/states/table.hpp>

#include "tests/states/oracle.hpp"

#include <random>

using namespace states_tests;

namespace {

constexpr std::uint32_t mixed(std::uint32_t seed, std::uint32_t k) {
    std::uint32_t x = seed * 2654435761u + k * 40503u + 97u;
    x ^= x >> 15, x *= 2246822519u, x ^= x >> 13, x *= 3266489917u;
    return x ^ (x >> 16);
}
struct Bit {
    unsigned k;
    constexpr bool operator()(const Bits& b) const { return (b.bits >> k & 1) != 0; }
};
constexpr std::string_view event_names[] = {"a", "b", "c", "a b", "b.*", "*", "c.d", "done.state.g"};

constexpr std::string_view state_names[] = {"p", "q", "g", "u", "v", "w", "x", "y", "h", "r"};

template <std::uint32_t Seed> struct Made {
    using Context = Bits;
    static constexpr auto e(std::uint32_t k) { return on(event_names[mixed(Seed, k) % 8]); }
    static constexpr auto t(std::uint32_t k) { return to(state_names[mixed(Seed, 100 + k) % (Seed % 2 ? 9 : 3)]); }
    static constexpr auto b(std::uint32_t k) {
        return when(std::string_view("ABCDEF").substr(mixed(Seed, 200 + k) % 6, 1), Bit{mixed(Seed, 200 + k) % 6});
    }
    static constexpr auto history() {
        if constexpr (Seed % 4 == 1) return deep_history("h", to(mixed(Seed, 300) % 2 ? "v" : "x"));
        else return shallow_history("h", to(mixed(Seed, 300) % 2 ? "v" : "w"));
    }
    static constexpr auto deep() {
        return states::machine(
            initial(mixed(Seed, 301) % 2 ? "p" : "u"), state("p", transition(e(1), t(1)), transition(b(3), t(3))),
            state("g", transition(e(7), b(7), t(7)), transition(b(8), t(8)), transition(e(9), t(9), internal()),
                  state("u", transition(e(10), t(10)), transition(e(11), b(11))),
                  state("v", transition(t(12), b(12)), state("x", transition(e(14), t(14))),
                        state("y", transition(b(15), t(15)))),
                  final_state("w"), history()),
            state("q", transition(on("c"), to("h")), transition(e(17), t(17))));
    }
    static constexpr auto flat() {
        return states::machine(
            state("p", transition(e(1), t(1)), transition(e(2), b(2), t(2)), transition(b(3), t(3))),
            state("q", transition(b(4), t(4)), transition(e(5), t(5)), transition(e(6), b(6), t(6))),
            state("g", transition(e(11), t(11)), transition(b(12), t(12)), transition(b(13), t(13))));
    }
    static constexpr auto machine = [] {
        if constexpr (Seed % 2) return deep();
        else return flat();
    }();
};

// Machines that nobody watches take other ways through the code.
template <class D> bool same_unwatched(std::mt19937& random) {
    Bits bits{unsigned(random())};
    Machine<D, Switch> a;
    Machine<D, StatePattern> b;
    Machine<D, Table> c;
    Machine<D, Interpreted> d;
    a.start(bits), b.start(bits), c.start(bits), d.start(bits);
    for (int i = 0; i < 400; ++i) {
        bits.bits = unsigned(random());
        const char* event = inputs[random() % 8];
        if (random() % 3 == 0) a.update(bits), b.update(bits), c.update(bits), d.update(bits);
        else a.handle(bits, event), b.handle(bits, event), c.handle(bits, event), d.handle(bits, event);
        if (a.active() != b.active() || a.active() != c.active() || a.active() != d.active()) return false;
    }
    return true;
}
template <class D> bool same_in_all(std::mt19937& random) {
    const auto outline = outline_of<D>();
    Bits bits{unsigned(random())};
    Oracle oracle{outline, bits};
    Machine<D, Switch, Everything> a;
    Machine<D, StatePattern, Everything> b;
    Machine<D, Table, Everything> c;
    Machine<D, Interpreted, Everything> d;
    auto all = [&](auto&& f) { f(a), f(b), f(c), f(d); };
    oracle.start();
    all([&](auto& m) { m.start(bits); });
    for (int i = 0; i < 400; ++i) {
        bits.bits = unsigned(random());
        if (random() % 3 == 0) {
            oracle.update();
            all([&](auto& m) { m.update(bits); });
        } else {
            const char* event = inputs[random() % 8];
            oracle.handle(event);
            all([&](auto& m) { m.handle(bits, event); });
        }
        bool together = true;
        all([&](auto& m) { together = together && m.active_name() == outline.states[oracle.path.back()].name; });
        if (!together) return false;
    }
    const auto trace = text(a);
    CHECK(std::count(trace.begin(), trace.end(), '*') > 5);
    return without_numbers(trace) == oracle.trace && trace == text(b) && trace == text(c) && trace == text(d);
}

#ifdef ANSATZ_FEWER_TYPES // the sanitizers of .ci/run, for the time of compiling: four of each kind, with both
                          // histories
constexpr std::uint32_t how_many = 8;
#else
constexpr std::uint32_t how_many = 50;
#endif

} // namespace

TEST_CASE("fifty machines made at compile time: one trace in every representation", "[states]") {
    std::mt19937 random(7);
    [&]<std::uint32_t... S>(std::integer_sequence<std::uint32_t, S...>) {
        (
            [&] {
                INFO("machine " << S);
                CHECK(same_in_all<Made<S>>(random));
                if constexpr (S < 4) CHECK(same_unwatched<Made<S>>(random));
            }(),
            ...);
    }(std::make_integer_sequence<std::uint32_t, how_many>{});
}
