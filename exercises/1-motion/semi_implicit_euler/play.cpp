// SPDX-License-Identifier: BSL-1.0
// The scene of section 1.6.3 with your integrator in it: a mass on a spring whose energy swings and does not grow.

#include "play.hpp"
#include "oscillation.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <algorithm>

using namespace ansatz;

const auto omega = 10.0 / second;
const auto dt = 1.0 / 60 * second;

template <class Integrator> void show(const char* who, workbook::Play& table, workbook::Plot& plot) {
    const auto run = problems::oscillate<Integrator>(omega, dt, 6000, 3.0 * metre_per_second);
    const auto [least, most] = std::minmax_element(run.energies.begin(), run.energies.end());
    const auto shown = [](const auto& all) { return std::vector(all.begin(), all.begin() + 240); };
    plot.line(who, shown(run.times), shown(run.energies));

    World many{Integrator{}, problems::Oscillator{omega}};
    for (int i = 0; i < 1000; ++i) many.add(position(metres(i, 0, 0)));
    table.row(who,
              {run.places.back().value(), double(*least / run.energies.front()), double(*most / run.energies.front())},
              1000, [many]() mutable { many.step(1e-3 * second); });
}

int main() {
    workbook::Play table(
        "A mass on a spring, omega = 10/s, 60 steps a second, for 100 s. An energy of 1 would be nature's.",
        {"place, m", "least energy, times that at the start", "most energy, times that at the start"});
    workbook::Plot plot("play-motion.semi_implicit_euler", "Semi-implicit Euler: yours and the library's");
    plot.x("time").y("energy per mass");
    show<exercise::SemiImplicitEuler>("yours", table, plot);
    show<ansatz::SemiImplicitEuler>("library", table, plot);
    plot.write();
    return table.print();
}
