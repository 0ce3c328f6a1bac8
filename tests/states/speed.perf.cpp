// SPDX-License-Identifier: BSL-1.0
// What an event costs in each representation, beside the same machine written by hand: a race, whose ratios are of this
// thread's CPU time.

#include <ansatz/states/machine.hpp>

#include "tests/catch.hpp"
#include "tests/performance/race.hpp"

#include <random>

using namespace ansatz;
using namespace ansatz::states;

namespace {

struct Counter {
    unsigned long n = 0;
};
constexpr std::string_view names[] = {"0", "1", "2", "3", "4", "5", "6", "7", "8", "9"};
// Ten states, 45 transitions: state i takes the events i, i + 2, ... and goes somewhere.
constexpr int count(int i) { return i % 2 ? 5 : 4; }
constexpr int takes(int i, int k) { return (i + 2 * k) % 10; }
constexpr int goes(int i, int k) { return (3 * i + 7 * k + 1) % 10; }
constexpr bool guarded(int i, int k) { return (i + k) % 3 == 0; }

struct Odd {
    bool operator()(const Counter& c) const { return c.n & 1; }
};
struct Add {
    void operator()(Counter& c) const { ++c.n; }
};
template <bool Acts, int I, int K> constexpr auto made() {
    if constexpr (Acts && guarded(I, K))
        return transition(on(names[takes(I, K)]), when(Odd{}), then(Add{}), to(names[goes(I, K)]));
    else if constexpr (Acts) return transition(on(names[takes(I, K)]), then(Add{}), to(names[goes(I, K)]));
    else return transition(on(names[takes(I, K)]), to(names[goes(I, K)]));
}
template <bool Acts, int I, int... K> constexpr auto made_state(std::integer_sequence<int, K...>) {
    return state(names[I], made<Acts, I, K>()...);
}
template <bool Acts> struct Ten {
    using Context = Counter;
    static constexpr auto machine = []<int... I>(std::integer_sequence<int, I...>) {
        return states::machine(made_state<Acts, I>(std::make_integer_sequence<int, count(I)>{})...);
    }(std::make_integer_sequence<int, 10>{});
};

// ---------------------------------------------------------------- by hand
template <bool Acts, int I, int K> [[gnu::always_inline]] inline bool row(Counter& c) {
    if constexpr (Acts && guarded(I, K))
        if (!(c.n & 1)) return false;
    if constexpr (Acts) ++c.n;
    return true;
}
#define ROW(I, K)                                                                                                      \
    case takes(I, K):                                                                                                  \
        if (!row<Acts, I, K>(c)) return false;                                                                         \
        GO(I, K);                                                                                                      \
        return true;
#define ROWS4(I)                                                                                                       \
    switch (e) { ROW(I, 0) ROW(I, 1) ROW(I, 2) ROW(I, 3) default : return false; }
#define ROWS5(I)                                                                                                       \
    switch (e) { ROW(I, 0) ROW(I, 1) ROW(I, 2) ROW(I, 3) ROW(I, 4) default : return false; }
#define GO(I, K) now = goes(I, K)
template <bool Acts> struct BySwitch {
    unsigned now = 0;
    bool handle(Counter& c, unsigned e) {
        switch (now) {
        case 0: ROWS4(0)
        case 1: ROWS5(1)
        case 2: ROWS4(2)
        case 3: ROWS5(3)
        case 4: ROWS4(4)
        case 5: ROWS5(5)
        case 6: ROWS4(6)
        case 7: ROWS5(7)
        case 8: ROWS4(8)
        case 9: ROWS5(9)
        default: return false;
        }
    }
};
#undef GO
#define GO(I, K) m.now = &std::get<goes(I, K)>(m.all)
template <bool Acts> struct ByClasses {
    struct Base {
        virtual bool handle(ByClasses&, Counter&, unsigned) = 0;
    };
    template <int I> struct One final : Base {
        bool handle(ByClasses& m, Counter& c, unsigned e) override {
            if constexpr (count(I) == 4) ROWS4(I) else ROWS5(I)
        }
    };
    std::tuple<One<0>, One<1>, One<2>, One<3>, One<4>, One<5>, One<6>, One<7>, One<8>, One<9>> all;
    Base* now = &std::get<0>(all);
    bool handle(Counter& c, unsigned e) { return now->handle(*this, c, e); }
};

// Begins at a cache line, each of them. Where the code lies is not what is measured, and matters more than what is:
// with the same instructions the switch with guards and actions took 1.0 to 1.1 times the one by hand where its loop
// began at a multiple of 32 bytes, and 1.5 to 1.7 times where it began 16 behind one (g++ 12, AMD EPYC).
template <class M, class E>
[[gnu::noinline, gnu::aligned(64)]] std::size_t run(M& m, Counter& c, const std::vector<E>& events) {
    std::size_t taken = 0;
    for (const auto e : events) taken += m.handle(c, e);
    return taken;
}

template <bool Acts> void measure(const char* what) {
    using D = Ten<Acts>;
    constexpr std::size_t n = 100000;
    std::mt19937 random(3);
    std::vector<unsigned> raw(n);
    std::vector<EventId> events(n);
    for (std::size_t i = 0; i < n; ++i)
        raw[i] = unsigned(random() % 10), events[i] = Machine<D, Switch>::event(names[raw[i]]);
    BySwitch<Acts> hand;
    ByClasses<Acts> classes;
    Machine<D, Switch> a;
    Machine<D, Table> b;
    Machine<D, StatePattern> c;
    Machine<D, Interpreted> d;
    Counter of[6];
    a.start(of[2]), b.start(of[3]), c.start(of[4]), d.start(of[5]);

    // The same work: each takes as many of the events as the others.
    const std::size_t taken = run(hand, of[0], raw);
    CHECK(taken > n / 3);
    CHECK(run(classes, of[1], raw) == taken);
    CHECK(run(a, of[2], events) == taken);
    CHECK(run(b, of[3], events) == taken);
    CHECK(run(c, of[4], events) == taken);
    CHECK(run(d, of[5], events) == taken);

    // What the race calls a body is an event here, and a step the whole list of them.
    test::Race race;
    std::size_t sink = 0;
    auto subject = [&](const char* name, auto& m, Counter& context, const auto& in) -> test::Race::Competitor {
        return race.add(std::string(name) + ", " + what, n, [&](int steps) {
            for (int i = 0; i < steps; ++i) sink += run(m, context, in);
        });
    };
    const auto& by_switch = subject("hand switch", hand, of[0], raw);
    const auto& switched = subject("Switch", a, of[2], events);
    const auto& tabled = subject("Table", b, of[3], events);
    const auto& by_classes = subject("hand virtual", classes, of[1], raw);
    const auto& patterned = subject("StatePattern", c, of[4], events);
    const auto& interpreted = subject("Interpreted", d, of[5], events);
    // Where there are actions, a machine refuses to be called from within one: nine instructions for each event, which
    // the switch by hand does not have. They took 1.1 times its time on one processor (Zen 3) and 1.6 on another (Zen
    // 4).
    race.bound("Switch, of the switch by hand", switched, {&by_switch}, 1.3, Acts ? 1.7 : 0, Acts ? 1.75 : 1.3);
    if (Acts) race.bound("Table, of virtual functions by hand", tabled, {&by_classes}, 1.3); // see below
    else race.bound("Table, of the switch by hand", tabled, {&by_switch}, 1.3, 0, 1.35);
    race.bound("StatePattern, of virtual functions by hand", patterned, {&by_classes}, 1.3);
    // Its instructions wait for nobody, and a switch by hand waits for its jumps: in time the two are nearer.
    race.bound("Interpreted, of the switch by hand", interpreted, {&by_switch}, 4, 0, Acts ? 10 : 4);
    race.run();
    CHECK(sink > taken);
}

} // namespace

TEST_CASE("an event costs what it costs by hand: ten states, 45 transitions", "[states]") {
    measure<false>("transitions alone");
}

// Where every transition acts, a table calls through a pointer for each event, as virtual functions do and a switch
// does not: 1.37 times the switch was measured, 0.97 times virtual functions. The bound is theirs there.
TEST_CASE("an event costs what it costs by hand: with guards and actions", "[states]") {
    measure<true>("with guards and actions");
}
