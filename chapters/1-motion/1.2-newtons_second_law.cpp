// SPDX-License-Identifier: BSL-1.0
// 1.2 Newton's second law: forces add up as vectors, and the sum is mass times acceleration

// F = m a. Two things follow that games rely on. Forces on one body are summed as vectors, in any order. And a force is
// shared by the mass that it must move, while gravity, whose force grows with the mass, accelerates everything alike:
// this is why the policy Gravity answers with an acceleration and needs no mass, and AppliedForces answers with a force
// and does. The units keep the two apart.

#include "claims.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/world.hpp>

#include <vector>

using namespace ansatz;

int main() {
    workbook::Claims claim;
    const auto dt = 1.0 / 60 * second;

    // As a formula: a sledge of 20 kg, two dogs, friction.
    //! [formula]
    const auto sledge = 20.0 * kilogram;
    const auto left_dog = newtons(60, 0, 15), right_dog = newtons(60, 0, -15), friction = newtons(-80, 0, 0);
    const auto sum = mechanics::resultant(left_dog, right_dog, friction);
    const auto acceleration = mechanics::acceleration(sum, sledge);
    //! [formula]
    workbook::say() << "The dogs pull with " << sum << " in all; the sledge accelerates with " << acceleration << '\n';
    claim("60 + 60 - 80 = 40 N along x, nothing across", sum == newtons(40, 0, 0));
    claim("40 N on 20 kg are 2 m/s^2", acceleration == metres_per_second_squared(2, 0, 0));
    claim("and back: F = m a", mechanics::force(sledge, acceleration) == sum);

    // In a world: the same three forces, applied one by one, for a second.
    //! [sledges]
    World snow{SemiImplicitEuler{}, AppliedForces{}};
    const auto light = snow.add(mass(sledge));
    const auto heavy = snow.add(mass(2.0 * sledge));
    //! [sledges]
    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Velocity>> speed_light, speed_heavy;
    for (int i = 0; i < 60; ++i) {
        times.push_back(snow.time());
        speed_light.push_back(x(snow.velocity(light)));
        speed_heavy.push_back(x(snow.velocity(heavy)));
        //! [pull]
        for (const auto body : {light, heavy})
            for (const auto& force : {left_dog, right_dog, friction}) snow.apply_force(body, force);
        snow.step(dt);
        //! [pull]
    }
    workbook::say() << "After a second the sledge does " << snow.velocity(light) << ", one of twice the mass "
                    << snow.velocity(heavy) << '\n';
    claim("v = a t", norm(snow.velocity(light) - metres_per_second(2, 0, 0)) < 1e-12 * metre_per_second);
    claim("twice the mass, half the velocity",
          norm(snow.velocity(heavy) - metres_per_second(1, 0, 0)) < 1e-12 * metre_per_second);

    // A force is there for one step only: there is nothing to clear.
    const auto before = snow.velocity(light);
    snow.step(dt);
    claim("the dogs stop pulling, and the velocity stays", snow.velocity(light) == before);

    // Gravity: a feather and an anvil.
    //! [feather]
    World tower{SemiImplicitEuler{}, Gravity{}, Keep<InverseMass>{}};
    const auto feather = tower.add(mass(0.001 * kilogram)), anvil = tower.add(mass(100.0 * kilogram));
    for (int i = 0; i < 60; ++i) tower.step(dt);
    //! [feather]
    claim("without air a feather falls like an anvil, to the last bit",
          tower.position(feather) == tower.position(anvil));

    workbook::Plot plot("1.2", "The same force on twice the mass: half the acceleration");
    plot.x("time").y("velocity").line("20 kg", times, speed_light).line("40 kg", times, speed_heavy).write();
    return claim.result();
}
