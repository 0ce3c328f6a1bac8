// SPDX-License-Identifier: BSL-1.0
// Guards: values with units, crossings, bands, times; oscillation and how it is seen.

#include <ansatz/states/guards.hpp>
#include <ansatz/states/values.hpp>

#include <ansatz/states/crossing.hpp>
#include <ansatz/states/dwell.hpp>
#include <ansatz/states/hysteresis.hpp>
#include <ansatz/states/oscillation.hpp>

#include <ansatz/motion.hpp>
#include <ansatz/world.hpp>
#include <ansatz/world/fixed_step.hpp>

#include "tests/measured.hpp"
#include "tests/states/guarded.hpp"

#include <random>

using namespace states_tests;

namespace {

// A guard asked alone, as a machine would.
template <class G> struct Probe {
    G guard;
    typename G::Memory memory{};
    Walker w{};
    bool operator()(double x) {
        w.x = x * metre;
        Question<Walker, NoBehaviour> q{w, own, {}, {}};
        if (!begun) guard.begin(memory, q);
        else guard.sample(memory, q);
        begun = true;
        return guard.ask(q, memory);
    }
    bool begun = false;
    NoBehaviour own{};
};

} // namespace

TEST_CASE("a body that steps over a boundary: equality misses it, a crossing does not", "[states]") {
    // 0.3 m a step from 0: 0.3, 0.6, ... never 5.
    auto walk = [](Walker& w, int i, auto&) { w.x = 0.3 * (i + 1) * metre; };
    CHECK(turns<[] { return place == 5.0 * metre; }, [] { return place < -1.0 * metre; }>(walk, 100) == 0);
    CHECK(turns<[] { return rises_through(place, 5.0 * metre); }, [] { return place < -1.0 * metre; }>(walk, 100) == 1);

    // For any step that is not a divisor, and for any start: exactly one crossing of a monotonous walk.
    std::mt19937 random(1);
    std::uniform_real_distribution<double> step(0.01, 3.0), start(-4.0, 4.9);
    for (int i = 0; i < 1000; ++i) {
        Probe<decltype(rises_through(place, 5.0 * metre))> up{rises_through(place, 5.0 * metre)};
        Probe<decltype(falls_through(place, 5.0 * metre))> down{falls_through(place, 5.0 * metre)};
        Probe<decltype(crosses(place, 5.0 * metre))> both{crosses(place, 5.0 * metre)};
        int ups = 0, downs = 0, crossings = 0;
        const double h = step(random);
        double x = start(random);
        for (int k = 0; k < 1200; ++k, x += h) ups += up(x), downs += down(x), crossings += both(x);
        REQUIRE(ups == 1);
        REQUIRE(downs == 0);
        REQUIRE(crossings == 1);
    }
}

TEST_CASE("what a crossing is: touching, starting on the limit, gaps that are no numbers", "[states]") {
    Probe<decltype(crosses(place, 1.0 * metre))> c{crosses(place, 1.0 * metre)};
    CHECK_FALSE(c(1.0)); // starts on it
    CHECK_FALSE(c(2.0)); // and leaves it: it was not on the other side
    CHECK(c(1.0));       // touches it
    CHECK_FALSE(c(1.0)); // stays
    CHECK_FALSE(c(3.0));
    CHECK_FALSE(c(NAN)); // nothing is known
    CHECK(c(0.5));       // since 3, through 1
    CHECK(c(INFINITY));
    CHECK_FALSE(c(INFINITY));
    CHECK(c(-INFINITY));
    Probe<decltype(rises_through(place, 0.0 * metre))> r{rises_through(place, 0.0 * metre)};
    CHECK_FALSE(r(NAN)); // the first value is none: no crossing before there are two
    CHECK_FALSE(r(1.0));
    CHECK_FALSE(r(-0.0));
    CHECK_FALSE(r(1.0)); // from -0, which is the limit
    CHECK_FALSE(r(-1.0));
    CHECK(r(0.0));
    // A limit without a fraction is one as well, and a value on either side of it is not on it.
    const auto metres = value("metres", [](const Walker& w) { return w.x.value(); });
    Probe<decltype(crosses(metres, 0))> whole{crosses(metres, 0)};
    CHECK_FALSE(whole(-0.5));
    CHECK(whole(0.5));
    CHECK_FALSE(whole(NAN));
    CHECK(whole(-0.25));
    CHECK(whole(1e30)); // more than an int holds
    CHECK_FALSE(whole(0.75));
    CHECK(whole(0.0));
    Probe<decltype(rises_through(metres, 1u))> natural{rises_through(metres, 1u)};
    CHECK_FALSE(natural(-3.5));
    CHECK(natural(1.5));
    // Integers and floats too.
    CHECK(rises_through(value("coins", &Walker::coins), 5).name() == "coins rises through 5");
    CHECK((value("share", &Walker::share) < 0.5f).name() == "share < 0.5");
    CHECK((place < 5.0 * metre && !(place > 7.0 * metre || after(2.0 * second))).name() ==
          "(x < 5 m and not (x > 7 m or after 2 s))");
}

namespace {
struct D1 {
    using Context = Walker;
    static constexpr auto machine =
        states::machine(state("a", transition(on("go"), to("b"))),
                        state("b", transition(when(rises_through(place, 1.0 * metre)), to("c"))), state("c"));
};
} // namespace

TEST_CASE("a crossing is between two updates of the machine, whichever state was active", "[states]") {
    each_representation([]<class R>() {
        Walker w;
        Machine<D1, R> m;
        m.start(w);
        m.update(w, frame);
        m.handle(w, "go"); // the previous value was seen while a was active
        w.x = 1.5 * metre;
        CHECK(m.update(w, frame));
        CHECK(m.is_in("c"));
        auto late = Machine<D1, R>{};
        w.x = 0.0 * metre;
        late.start(w);
        w.x = 2.0 * metre;
        late.update(w, frame); // crossed here, in a
        late.handle(w, "go");
        CHECK_FALSE(late.update(w, frame)); // and does not again in b
        CHECK(late.is_in("b"));
    });
}

TEST_CASE("hysteresis in noise: transitions against band width (hard case P6)", "[states]") {
    // Threshold 1, noise sigma = 0.1, N samples: N / 2 erfc(w / sqrt 2) transitions for a band of w sigma each way, the
    // larger the band the nearer; the closed form counts the samples beyond either edge, of which every second half
    // turns.
    constexpr int n = 100000;
    std::mt19937 random(42);
    std::normal_distribution<double> noise(1.0, 0.1);
    auto draw = [&](Walker& w, int, auto&) { w.noise = noise(random); };
    constexpr auto v = value("noise", &Walker::noise);
    const double found[] = {
        double(turns<[] { return band(value("noise", &Walker::noise), 1.0, 0.0).above(); },
                     [] { return band(value("noise", &Walker::noise), 1.0, 0.0).below(); }>(draw, n)),
        double(turns<[] { return band(value("noise", &Walker::noise), 1.0, 0.1).above(); },
                     [] { return band(value("noise", &Walker::noise), 1.0, 0.1).below(); }>(draw, n)),
        double(turns<[] { return band(value("noise", &Walker::noise), 1.0, 0.2).above(); },
                     [] { return band(value("noise", &Walker::noise), 1.0, 0.2).below(); }>(draw, n)),
        double(turns<[] { return band(value("noise", &Walker::noise), 1.0, 0.3).above(); },
                     [] { return band(value("noise", &Walker::noise), 1.0, 0.3).below(); }>(draw, n)),
        double(turns<[] { return band(value("noise", &Walker::noise), 1.0, 0.4).above(); },
                     [] { return band(value("noise", &Walker::noise), 1.0, 0.4).below(); }>(draw, n)),
        double(turns<[] { return band(value("noise", &Walker::noise), 1.0, 0.5).above(); },
                     [] { return band(value("noise", &Walker::noise), 1.0, 0.5).below(); }>(draw, n))};
    for (int w = 0; w < 5; ++w) {
        const double expected = n * 0.5 * std::erfc(w / std::sqrt(2.0));
        INFO("half-width " << w << " sigma: " << found[w] << " transitions, the law says " << expected);
        CHECK(test::measured("P6", "transitions with a band of " + std::to_string(w) + " sigma", found[w],
                             test::about(expected, 5 * std::sqrt(expected))));
    }
    CHECK(test::measured("P6", "transitions with a band of 5 sigma", found[5], test::at_most(1)));
    CHECK_THAT(refusal([&] { band(v, 1.0, -0.1); }), ContainsSubstring("half_width is -0.1"));
    CHECK_THAT(refusal([&] { band(v, 1.0, double(NAN)); }), ContainsSubstring("half_width is nan"));
}

TEST_CASE("a feedback loop: the behaviour of the states throws the value back", "[states]") {
    // A heater with a delay: it goes on warming after it was switched off. One threshold turns it at every swing, a
    // band less often; a dwell time bounds it, whatever the loop does.
    auto loop = [](Walker& w, int, auto& m) {
        const double drive = m.is_in("low") ? 1.0 : -1.0;
        w.share += float(0.2 * (drive - double(w.share))); // the actuator follows late
        w.noise += 0.05 * double(w.share);
    };
    const int bare =
        turns<[] { return (value("t", &Walker::noise) > 1.0); }, [] { return value("t", &Walker::noise) < 1.0; }>(loop,
                                                                                                                  6000);
    const int banded = turns<[] { return band(value("t", &Walker::noise), 1.0, 0.5).above(); },
                             [] { return band(value("t", &Walker::noise), 1.0, 0.5).below(); }>(loop, 6000);
    const int dwelling = turns<[] { return (value("t", &Walker::noise) > 1.0 && after(2.0 * second)); },
                               [] { return value("t", &Walker::noise) < 1.0 && after(2.0 * second); }>(loop, 6000);
    CHECK(bare > 2 * banded);
    CHECK(banded > 0);
    CHECK(dwelling <= 6000 / 120); // at most once in 2 s of 60 updates each
    CHECK(dwelling > 10);
}

namespace {
struct D2 {
    using Context = Walker;
    static constexpr auto machine = states::machine(
        state("walk", transition(when(after(0.5 * second) && value("x", &Walker::noise) > 0.0), to("rest"))),
        state("rest", transition(when(held_for(value("x", &Walker::noise) < 0.2, 0.3 * second)), to("walk"))));
};
} // namespace

TEST_CASE("times are seconds: the same scenario at 30, 60 and 240 updates a second (hard case P7)", "[states]") {
    auto scenario = [](double rate) {
        Walker w;
        Machine<D2, Table> m;
        m.start(w);
        int count = 0;
        for (int i = 0; i < int(60 * rate); ++i) {
            w.noise = std::sin(2 * std::numbers::pi * 0.31 * i / rate);
            count += m.update(w, 1.0 / rate * second);
        }
        return count;
    };
    const int at60 = scenario(60);
    CHECK(at60 > 20);
    CHECK(test::measured("P7", "transitions at 30 Hz", scenario(30), test::about(at60, 1)));
    CHECK(test::measured("P7", "transitions at 240 Hz", scenario(240), test::about(at60, 1)));
}

namespace {
struct D3 {
    using Context = Walker;
    static constexpr auto machine =
        states::machine(state("a", transition(when(after(2.0 * second)), to("b"))), state("b"));
};
} // namespace

TEST_CASE("a dwell time ends with the step that completes it, whichever way a sum of steps is rounded", "[states]") {
    each_representation([]<class R>() {
        for (const int rate : {7, 24, 30, 50, 60, 90, 144, 240, 1000}) {
            Walker w;
            Machine<D3, R> m;
            m.start(w);
            int steps = 0;
            while (!m.is_in("b") && steps < 10000) m.update(w, 1.0 / rate * second), ++steps;
            CHECK(steps == 2 * rate);
        }
    });
    CHECK_THAT(refusal([] { after(-1.0 * second); }), ContainsSubstring("after: the time is -1 s"));
    CHECK_THAT(refusal([] { held_for(place > 1.0 * metre, double(INFINITY) * second); }),
               ContainsSubstring("held_for: the time is inf s"));
}

TEST_CASE("values that are not numbers decide nothing (hard case P9)", "[states]") {
    // A guard that reads a direction when the target is reached: 0 / 0.
    Walker w;
    w.x = double(NAN) * metre;
    Question<Walker, NoBehaviour> q{w, {}, {}, {}};
    for (const auto answer :
         {(place < 1.0 * metre).ask(q, {}), (place <= 1.0 * metre).ask(q, {}), (place > 1.0 * metre).ask(q, {}),
          (place >= 1.0 * metre).ask(q, {}), (place == 1.0 * metre).ask(q, {}), (place != 1.0 * metre).ask(q, {})})
        CHECK_FALSE(answer);
    int n = 0;
    CHECK(turns<[] { return band(place, 1.0 * metre, 0.1 * metre).above(); },
                [] { return band(place, 1.0 * metre, 0.1 * metre).below(); }>(
              [&](Walker& v, int i, auto&) {
                  v.x = (i % 2 ? double(NAN) : 2.0) * metre;
                  ++n;
              },
              100) == 1);
}

namespace {
struct Scene {
    World<SemiImplicitEuler, Gravity> world{SemiImplicitEuler{}, Gravity{}};
    decltype(world.add(position(metres(0, 0, 0)))) ball = world.add(position(metres(0, 10, 0)));
};
struct D4 {
    using Context = Scene;
    static constexpr auto height =
        value("height", [](const Scene& s) { return component(s.world.position(s.ball), 1); });
    static constexpr auto machine =
        states::machine(state("falling", transition(when(falls_through(height, 5.0 * metre)), to("low"))),
                        state("low", transition(when(height < 0.0 * metre), to("gone"))), state("gone"));
};
struct Game {
    Scene scene;
    Machine<D4, Switch, Recorded<>> machine;
    void step(Quantity<unit::Time> dt) {
        scene.world.step(dt);
        machine.update(scene, dt);
    }
};
} // namespace

TEST_CASE("a machine reads a world, and both are steps of one clock", "[states]") {
    Game game;
    game.machine.start(game.scene);
    FixedStep clock{frame};
    for (int i = 0; i < 200; ++i) clock.advance(game, 0.0167 * second);
    CHECK(game.machine.is_in("gone"));
    const auto& seen = game.machine.get<Recorded<>>();
    std::vector<double> times;
    for (std::size_t i = 0; i < seen.size(); ++i)
        if (seen[i].what == Happening::What::took) times.push_back(seen[i].time.value());
    REQUIRE(times.size() == 2);
    // x = x0 - g t^2 / 2, at the first step at or after the crossing; semi-implicit Euler falls g t dt / 2 further.
    for (int i = 0; i < 2; ++i) {
        const double exact = std::sqrt(2 * (i == 0 ? 5.0 : 10.0) / 9.80665);
        CHECK(times[std::size_t(i)] >= exact - frame.value() * 0.51);
        CHECK(times[std::size_t(i)] <= exact + frame.value() * 1.01);
    }
}

TEST_CASE("an oscillation is more than n transitions between two states within a time", "[states]") {
    using D = Turns<[] { return (value("noise", &Walker::noise) > 0.0); },
                    [] { return value("noise", &Walker::noise) < 0.0; }>;
    each_representation([]<class R>() {
        auto run = [](int period, std::uint32_t n, double within) {
            Walker w;
            Machine<D, R, OscillationReport> m{OscillationReport{n, within * second}};
            m.start(w);
            for (int i = 0; i < 600; ++i) {
                w.noise = i / period % 2 ? 1 : -1;
                m.update(w, frame);
            }
            return m.template get<OscillationReport>();
        };
        // A turn every 6 updates: in 1 s there are 10; eleven turns last 10 gaps of 0.1 s.
        CHECK(run(6, 10, 1.0).oscillates());
        CHECK_FALSE(run(6, 11, 1.0).oscillates());
        CHECK_FALSE(run(60, 2, 1.5).oscillates());
        const auto report = run(6, 4, 1.0);
        REQUIRE(report.size() == 1);
        report.for_each([](const OscillationReport::Oscillation& o) {
            CHECK(o.a == StateId(1));
            CHECK(o.b == StateId(2));
            CHECK(o.turns == 99);
            CHECK(o.since.value() == Approx(7.0 / 60));
        });
    });
    CHECK_THAT(refusal([] { OscillationReport{0}; }), ContainsSubstring("turns is 0"));
    CHECK_THAT(refusal([] { OscillationReport{4, 0.0 * second}; }), ContainsSubstring("within is 0 s"));
}
