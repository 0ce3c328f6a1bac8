// SPDX-License-Identifier: BSL-1.0
// 5.2.3 State oscillations: one threshold turns with every tremor, a band of two turns when something happened

// A condition and its contrary, with one threshold: the machine is in one state above it and in the other below. Two
// things make it tremble. Noise: with a value that stands on the threshold, every second update turns it. A band of
// half-width w sigma lets one update in 2 / erfc(w / sqrt 2) through, so that each sigma of width is worth more than
// the one before. And feedback, the "over compensation" of the notes: the state itself pushes the value back over the
// threshold that called it. There a band sets the period, and a dwell time bounds it. What comes out of a watcher is a
// report, not a feeling.

#include "claims.hpp"
#include "columns.hpp"
#include "graphviz.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/states.hpp>
#include <ansatz/world.hpp>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <random>
#include <string>
#include <vector>

using namespace ansatz;
using namespace ansatz::states;

namespace {

constexpr auto sigma = 0.05 * metre;

struct Ear {
    Quantity<unit::Length> distance = 1.0 * metre;
};
//! [sentry]
/// Near or far, with a band of half-width w sigma around 1 m.
template <int W> struct Sentry {
    using Context = Ear;
    static constexpr auto edge = band(value("distance", &Ear::distance), 1.0 * metre, double(W) * sigma);
    static constexpr auto machine = states::machine(state("near", transition(when(edge.above()), to("far"))),
                                                    state("far", transition(when(edge.below()), to("near"))));
};
//! [sentry]

/// Transitions in n updates of a value that stands on the threshold and is measured with noise.
template <int W> int transitions_in_noise(int n) {
    Ear ear;
    Machine<Sentry<W>> sentry;
    sentry.start(ear);
    std::mt19937_64 random(2026);
    auto uniform = [&] { return (double(random() >> 11) + 0.5) * 0x1p-53; };
    int transitions = 0;
    for (int i = 0; i < n; ++i) {
        const double normal = std::sqrt(-2 * std::log(uniform())) * std::cos(2 * M_PI * uniform()); // Box and Muller
        ear.distance = 1.0 * metre + normal * sigma;
        transitions += sentry.update(ear);
    }
    return transitions;
}

/// A leader walks away at 1 m/s; his follower runs at 3 m/s or waits, and shall stay 5 m behind.
struct Pair {
    World<SemiImplicitEuler> world{SemiImplicitEuler{}};
    Handle leader = world.add(position(metres(5, 0, 0)), velocity(metres_per_second(1, 0, 0)));
    Handle follower = world.add(position(metres(0, 0, 0)));
    auto gap() const { return x(world.position(leader)) - x(world.position(follower)); }
    void go(double speed) { world.set_velocity(follower, metres_per_second(speed, 0, 0)); }
};
inline void run(Pair& pair) { pair.go(3); }
inline void stop(Pair& pair) { pair.go(0); }

//! [followers]
constexpr auto gap = value("gap", &Pair::gap);
struct OneThreshold {
    using Context = Pair;
    static constexpr auto machine =
        states::machine(state("waits", on_entry(stop), transition(when(gap > 5.0 * metre), to("runs"))),
                        state("runs", on_entry(run), transition(when(gap < 5.0 * metre), to("waits"))));
};
struct WithBand {
    using Context = Pair;
    static constexpr auto near = band(gap, 5.0 * metre, 0.5 * metre);
    static constexpr auto machine =
        states::machine(state("waits", on_entry(stop), transition(when(near.above()), to("runs"))),
                        state("runs", on_entry(run), transition(when(near.below()), to("waits"))));
};
struct WithDwell {
    using Context = Pair;
    static constexpr auto machine = states::machine(
        state("waits", on_entry(stop), transition(when(gap > 5.0 * metre && after(1.0 * second)), to("runs"))),
        state("runs", on_entry(run), transition(when(gap < 5.0 * metre && after(1.0 * second)), to("waits"))));
};
//! [followers]

struct Walk {
    int transitions = 0;
    bool reported = false;
    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Length>> gaps;
};
/// A minute of following, at `rate` updates a second.
template <class Description> Walk follow(int rate) {
    Walk walk;
    Pair pair;
    //! [report]
    Machine<Description, Switch, OscillationReport> follower{
        OscillationReport{4, 1.0 * second}}; // more than 4 turns within 1 s
    //! [report]
    follower.start(pair);
    for (int i = 0; i < 60 * rate; ++i) {
        if constexpr (requires { follower.time(); }) walk.transitions += follower.update(pair, 1.0 / rate * second);
        else walk.transitions += follower.update(pair);
        pair.world.step(1.0 / rate * second);
        if (i < 10 * rate) walk.times.push_back(pair.world.time()), walk.gaps.push_back(pair.gap());
    }
    walk.reported = follower.template get<OscillationReport>().oscillates();
    return walk;
}

} // namespace

int main() {
    workbook::Claims claim;

    // Noise.
    const int n = 100000;
    const std::vector<int> widths{0, 1, 2, 3, 4, 5};
    const std::vector<int> counted{transitions_in_noise<0>(n), transitions_in_noise<1>(n), transitions_in_noise<2>(n),
                                   transitions_in_noise<3>(n), transitions_in_noise<4>(n), transitions_in_noise<5>(n)};
    auto law = [&](double w) { return n * 0.5 * std::erfc(w / std::sqrt(2.0)); };
    bool follows = true;
    workbook::Columns table({"half-width", "transitions in 100000 updates", "the law"});
    for (std::size_t w = 0; w < widths.size(); ++w) {
        table.row(workbook::printed(w, " sigma"), counted[w],
                  workbook::printed(std::fixed, std::setprecision(1), law(double(w))));
        follows = follows && std::abs(counted[w] - law(double(w))) <= 5 * std::sqrt(law(double(w))) + (w == 5 ? 1 : 0);
    }
    std::cout << table;
    claim("transitions follow n erfc(w / sqrt 2) / 2", follows);
    claim("a band of five sigma keeps still", counted[5] <= 1);

    // Feedback.
    const Walk bare = follow<OneThreshold>(60), banded = follow<WithBand>(60), dwelling = follow<WithDwell>(60);
    workbook::say() << "In a minute the follower changes his mind " << bare.transitions << " times, with a band "
                    << banded.transitions << " times, with a dwell time " << dwelling.transitions << " times\n";
    claim("with one threshold he turns at more than half of all updates", bare.transitions > 60 * 60 / 2);
    claim("and faster updates make it worse", follow<OneThreshold>(240).transitions > 3 * bare.transitions);
    // 1 m at 2 m/s, 1 m at 1 m/s: a period of 1.5 s; each turn comes up to a step late.
    claim("the band turns twice in (1/2 + 1/1) s and hardly depends on the rate",
          std::abs(banded.transitions - 80) <= 3 && std::abs(follow<WithBand>(240).transitions - 80) <= 3);
    claim("the dwell time turns at most once a second", dwelling.transitions <= 60);
    claim("the report names the first, and neither of the others",
          bare.reported && !banded.reported && !dwelling.reported);

    workbook::draw_graph("5.2.3-machine", to_dot(outline_of<WithBand>(), {"waits"}));
    workbook::Plot noise("5.2.3", "In noise each sigma of the band is worth more than the one before");
    std::vector<double> fine;
    for (double w = 0; w <= 5; w += 0.1) fine.push_back(w);
    std::vector<int> some(widths.begin(), widths.end() - 1),
        seen(counted.begin(), counted.end() - 1); // 0 has no place on a logarithm
    noise.x("half-width of the band, sigma").y("transitions in 100000 updates").log_y();
    noise.reference("n erfc(w / sqrt 2) / 2", fine, law).points("measured", some, seen).write();
    workbook::Plot feedback("5.2.3-feedback", "A follower: a band sets the period, a dwell time bounds it");
    feedback.x("time")
        .y("gap")
        .line("one threshold", bare.times, bare.gaps)
        .line("band of 0.5 m", banded.times, banded.gaps)
        .line("dwell time of 1 s", dwelling.times, dwelling.gaps)
        .write();
    return claim.result();
}
