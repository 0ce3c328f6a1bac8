// SPDX-License-Identifier: BSL-1.0
// The scene of section 1.4 with your collision in it: two bodies of a world that meet.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;

using Body = mechanics::PointMass<double, Vector<double, 2>>;
using Collide = std::pair<Body, Body> (*)(const Body&, const Body&, double);

/// A cart and a wagon on a line, one metre apart: where the cart is, step by step, and what is left in the end.
void show(const char* who, Collide collide, workbook::Play& table, workbook::Plot& plot) {
    World world{Space<double, 2>{}, SemiImplicitEuler{}, Keep<InverseMass>{}};
    const auto cart = world.add(position(metres(0, 0)), velocity(metres_per_second(2, 0)), mass(1.0 * kilogram));
    const auto wagon = world.add(position(metres(1, 0)), velocity(metres_per_second(-1, 0)), mass(3.0 * kilogram));
    const auto momentum = total_momentum(world);
    const auto energy = kinetic_energy(world);
    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Length>> places;
    bool met = false;
    for (int i = 0; i < 60; ++i) {
        times.push_back(world.time());
        places.push_back(x(world.position(cart)));
        world.step(1.0 / 60 * second);
        if (met || x(world.position(cart)) < x(world.position(wagon))) continue;
        const auto [one, other] =
            collide({1.0 * kilogram, world.velocity(cart)}, {3.0 * kilogram, world.velocity(wagon)}, 0.5);
        world.set_velocity(cart, one.velocity);
        world.set_velocity(wagon, other.velocity);
        met = true;
    }
    plot.line(who, times, places);
    table.row(who,
              {x(world.velocity(cart)).value(), x(world.velocity(wagon)).value(),
               norm(total_momentum(world) - momentum).value(), double(kinetic_energy(world) / energy)},
              1000, [collide]() {
                  static volatile double left = 0;
                  for (int i = 0; i < 1000; ++i)
                      left = left + x(collide({1.0 * kilogram, metres_per_second(i, 0)},
                                              {3.0 * kilogram, metres_per_second(0, 1)}, 0.5)
                                          .first.velocity)
                                        .value();
              });
}

int main() {
    workbook::Play table("1 kg with 2 m/s meets 3 kg with -1 m/s, e = 0.5. The momentum is -1 kg m/s before and after.",
                         {"cart, m/s", "wagon, m/s", "momentum off by, kg m/s", "energy left"});
    table.timed("ns a collision");
    workbook::Plot plot("play-motion.momentum", "A collision: yours and the library's");
    plot.x("time").y("place of the cart");
    show("yours", exercise::collide, table, plot);
    show(
        "library", [](const Body& a, const Body& b, double e) { return mechanics::collide(a, b, e); }, table, plot);
    plot.write();
    return table.print();
}
