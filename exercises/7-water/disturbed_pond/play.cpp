// SPDX-License-Identifier: BSL-1.0
// The scene of section 7.3.1 with your machine in it: somebody wades through a pond from second 2 to second 8.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/water/ripples.hpp>

#include <algorithm>
#include <cmath>

using namespace ansatz;

namespace {

struct Evening {
    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Length>> heights;
    int changes = 0, rings = 0;
    double calm_at = 0;
};
/// 20 s of a pond at so many updates a second, moved by three functions.
template <class Next, class Begun, class Faded> Evening wade(int rate, Next&& next, Begun&& begun, Faded&& faded) {
    Evening all;
    Ripples pond(16);
    const auto damping = 1.5 / second;
    auto state = exercise::State::calm;
    std::vector<Quantity<unit::Time>> rings; // when each began
    const auto came = 2.0 * second;
    for (int n = 1; n <= 20 * rate; ++n) {
        const auto before = double(n - 1) / rate * second, now = double(n) / rate * second;
        const bool wades = now > came && now <= 8.0 * second;
        std::erase_if(rings, [&](Quantity<unit::Time> since) { return faded(now - since, damping); });
        const auto then = next(state, wades, rings.size());
        if (then != state) ++all.changes;
        if (then == exercise::State::calm && state != then) all.calm_at = now.value();
        state = then;
        if (state == exercise::State::stirred)
            for (int k = begun(std::max(0.0 * second, before - came), now - came, 0.6 * second); k > 0; --k) {
                pond.begin(
                    {.x = (now - came) * (1.0 * metre_per_second), .z = 0.0 * metre, .begun = now, .damping = damping});
                rings.push_back(now);
                ++all.rings;
            }
        all.times.push_back(now);
        all.heights.push_back(pond.height(3.0 * metre, 1.0 * metre, now));
    }
    return all;
}

} // namespace

int main() {
    workbook::Play table("Somebody wades from second 2 to second 8, a stride in 0.6 s. At 20 updates a second:",
                         {"changes of state", "rings", "calm again, s"});
    table.timed("ns an update");
    workbook::Plot plot("play-water.disturbed_pond", "A metre beside the way: yours and the formula's");
    plot.x("time").y("height");
    const auto mine = wade(20, exercise::next, exercise::begun, exercise::faded);
    table.row("yours", {double(mine.changes), double(mine.rings), mine.calm_at}, 400,
              [] { wade(20, exercise::next, exercise::begun, exercise::faded); });
    const auto often = wade(240, exercise::next, exercise::begun, exercise::faded);
    table.row("yours, 240 updates a second", {double(often.changes), double(often.rings), often.calm_at}, 4800,
              [] { wade(240, exercise::next, exercise::begun, exercise::faded); });
    plot.line("20 updates a second", mine.times, mine.heights).line("240", often.times, often.heights);
    plot.write();
    return table.print();
}
