// SPDX-License-Identifier: BSL-1.0
// 1.9 Gravity: one constant added to the acceleration, the same for a feather and an anvil

// Gravity is an acceleration, not a force: a world of gravity alone stores no masses at all, because it has no use for
// them. The constant can be varied while the world runs, "as a cheap way of simulating different environments".

#include "claims.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/world.hpp>

#include <iostream>
#include <string>
#include <vector>

using namespace ansatz;

int main() {
    workbook::Claims claim;
    //! [tower]
    World tower{VelocityVerlet{}, Gravity{}, Keep<InverseMass>{}};
    const auto feather = tower.add(position(metres(0, 50, 0)), mass(0.001 * kilogram));
    const auto anvil = tower.add(position(metres(1, 50, 0)), mass(100.0 * kilogram));
    for (int i = 0; i < 180; ++i) tower.step(1.0 / 60 * second);
    //! [tower]
    std::cout << "After three seconds without air: feather at " << y(tower.position(feather)) << ", anvil at "
              << y(tower.position(anvil)) << '\n';
    claim("every mass falls alike, bit for bit", y(tower.position(feather)) == y(tower.position(anvil)));
    claim("and as far as s = g t^2 / 2 says",
          abs(y(tower.position(anvil)) - (50 - 0.5 * 9.81 * 9) * metre) < 1e-10 * metre);

    std::cout << "Bytes of a body: " << World<VelocityVerlet, Gravity>::bytes_per_body << " without masses, "
              << tower.bytes_per_body << " with\n";
    claim("a world of gravity alone stores no masses",
          World<VelocityVerlet, Gravity>::bytes_per_body == World<VelocityVerlet>::bytes_per_body);

    struct Place {
        std::string name;
        Quantity<unit::Acceleration> g;
    };
    workbook::Plot plot("1.9", "The same throw in four environments");
    plot.x("time").y("height");
    for (const auto& place :
         {Place{"earth", 9.81 * metre_per_second_squared}, Place{"mars", 3.71 * metre_per_second_squared},
          Place{"moon", 1.62 * metre_per_second_squared}, Place{"space", 0.0 * metre_per_second_squared}}) {
        //! [places]
        World world{VelocityVerlet{}, Gravity{}};
        world.set(Gravity{-place.g * Vector<double, 3>(0, 1, 0)});
        const auto ball = world.add(velocity(metres_per_second(0, 10, 0)));
        //! [places]
        std::vector<Quantity<unit::Time>> times;
        std::vector<Quantity<unit::Length>> heights;
        Quantity<unit::Length> apex{};
        for (int i = 0; i <= 4 * 60; ++i) {
            times.push_back(world.time());
            heights.push_back(y(world.position(ball)));
            apex = max(apex, heights.back());
            world.step(1.0 / 60 * second);
        }
        std::cout << "  " << place.name << ": highest " << apex << " within four seconds\n";
        if (place.name == "earth")
            claim("on earth the throw rises u^2 / 2g = 5.097 m", abs(apex - 5.097 * metre) < 0.01 * metre);
        plot.line(place.name, times, heights);
    }
    plot.y_range(-10.0 * metre, 40.0 * metre).write();

    // Gravity may change while a ball is in the air: below, it is switched off at the apex.
    //! [off]
    World lift{SemiImplicitEuler{}, Gravity{}};
    const auto ball = lift.add(velocity(metres_per_second(0, 9.81, 0)));
    for (int i = 0; i < 60; ++i) lift.step(1.0 / 60 * second);
    lift.set(Gravity{metres_per_second_squared(0, 0, 0)});
    //! [off]
    const auto here = lift.position(ball);
    for (int i = 0; i < 60; ++i) lift.step(1.0 / 60 * second);
    workbook::say() << "Gravity switched off at the top of a throw: the ball moves " << norm(lift.position(ball) - here)
                    << " in the next second\n";
    claim("switched off at the apex, the ball stays where it is", norm(lift.position(ball) - here) < 1e-10 * metre);
    return claim.result();
}
