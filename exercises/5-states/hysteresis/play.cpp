// SPDX-License-Identifier: BSL-1.0
// The sentry of section 5.2.3 with your band in it, beside the library's.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/states.hpp>

#include <cmath>
#include <random>
#include <vector>

using namespace ansatz;
using namespace ansatz::states;

namespace {

struct Ear {
    Quantity<unit::Length> distance = 1.0 * metre;
};
struct Sentry {
    using Context = Ear;
    static constexpr auto edge = band(value("distance", &Ear::distance), 1.0 * metre, 0.1 * metre);
    static constexpr auto machine = states::machine(state("near", transition(when(edge.above()), to("far"))),
                                                    state("far", transition(when(edge.below()), to("near"))));
};

} // namespace

int main() {
    workbook::Play table(
        "Somebody stands at 1 m and is measured 100000 times with a noise of 0.05 m; the band is 0.1 m to both sides.",
        {"turns"});
    table.timed("ns an update");
    std::mt19937_64 random(5);
    const auto uniform = [&] { return (double(random() >> 11) + 0.5) * 0x1p-53; };
    std::vector<Quantity<unit::Length>> measured;
    for (int i = 0; i < 100000; ++i)
        measured.push_back((1 + 0.05 * std::sqrt(-2 * std::log(uniform())) * std::cos(2 * M_PI * uniform())) * metre);

    const auto yours = [](bool far, Quantity<unit::Length> d) {
        return exercise::above_after(far, d, 1.0 * metre, 0.1 * metre);
    };
    const auto bare = [](bool, Quantity<unit::Length> d) { return d > 1.0 * metre; };
    const auto turns = [&](auto&& after) {
        bool far = false;
        int n = 0;
        for (const auto d : measured) {
            const bool now = after(far, d);
            n += now != far;
            far = now;
        }
        return n;
    };
    volatile bool sink = false;
    table.row("yours", {double(turns(yours))}, 1,
              [&, i = std::size_t(0)]() mutable { sink = yours(sink, measured[i++ % measured.size()]); });

    Ear ear;
    Machine<Sentry> sentry;
    sentry.start(ear);
    int theirs = 0;
    for (const auto d : measured) {
        ear.distance = d;
        theirs += sentry.update(ear);
    }
    table.row("library", {double(theirs)}, 1, [&, i = std::size_t(0)]() mutable {
        ear.distance = measured[i++ % measured.size()];
        sink = sentry.update(ear);
    });
    table.row("no band", {double(turns(bare))}, 1,
              [&, i = std::size_t(0)]() mutable { sink = bare(sink, measured[i++ % measured.size()]); });
    return table.print();
}
