// SPDX-License-Identifier: BSL-1.0
// The scene of section 1.6.4 with your integrator in it: the order of the method, and the way back.

#include "play.hpp"
#include "oscillation.hpp"
#include "plot.hpp"
#include "subject.hpp"

using namespace ansatz;

const auto omega = 1.0 / second;
const problems::OnALine start{1.0 * metre, 0.5 * metre_per_second};
const auto duration = 10.0 * second;

template <class Integrator> void show(const char* who, workbook::Play& table, workbook::Plot& plot) {
    std::vector<Quantity<unit::Time>> steps;
    std::vector<Quantity<unit::Length>> errors;
    for (int n = 100; n <= 1600; n *= 2) {
        steps.push_back(duration / double(n));
        const auto place = problems::oscillate<Integrator>(omega, steps.back(), n, start.v).places.back();
        errors.push_back(abs(place - problems::oscillator(omega, start, duration).x));
    }
    plot.linked_points(who, steps, errors);

    World world{Integrator{}, problems::Oscillator{omega}};
    const auto body = world.add(position(metres(1, 0, 0)), velocity(metres_per_second(0.5, 0, 0)));
    for (int i = 0; i < 1000; ++i) world.step(0.01 * second);
    world.set_velocity(body, -world.velocity(body));
    for (int i = 0; i < 1000; ++i) world.step(0.01 * second);

    World many{Integrator{}, problems::Oscillator{omega}};
    for (int i = 0; i < 1000; ++i) many.add(position(metres(i, 0, 0)));
    table.row(who,
              {errors.front().value(), errors.back().value(), norm(world.position(body) - metres(1, 0, 0)).value()},
              1000, [many]() mutable { many.step(1e-3 * second); });
}

int main() {
    workbook::Play table(
        "A mass on a spring, omega = 1/s, from 1 m with 0.5 m/s. Second order: a sixteenth of the step, 1/256 "
        "of the error.",
        {"error at 0.1 s, m", "error at 0.00625 s, m", "off after 10 s there and back, m"});
    workbook::Plot plot("play-motion.verlet", "Verlet: yours and the library's");
    plot.x("time step").y("error after 10 s").log_x().log_y();
    show<exercise::Verlet>("yours", table, plot);
    show<ansatz::Verlet>("library", table, plot);
    plot.write();
    return table.print();
}
