// SPDX-License-Identifier: BSL-1.0
// 1.4 Law of conservation of momentum: m1 u1 + m2 u2 = m1 v1 + m2 v2, whatever the two do to each other

// Follows from the third law: every force inside a closed system comes with its opposite, so the impulses cancel in the
// sum. It holds at every restitution e, for putty as for steel. What a collision loses is kinetic energy: a share 1 -
// e^2 of that part which the relative motion carries, (1/2) mu (u1 - u2)^2 with the reduced mass mu. (The notes' 2.2.1
// says that in an inelastic collision all momentum is dissipated; the table below says otherwise.)

#include "claims.hpp"
#include "columns.hpp"
#include "plot.hpp"

#include <ansatz/world.hpp>

#include <iostream>
#include <vector>

using namespace ansatz;

int main() {
    workbook::Claims claim;
    //! [bodies]
    const mechanics::PointMass cart{1.0 * kilogram, 2.0 * metre_per_second};
    const mechanics::PointMass wagon{3.0 * kilogram, -1.0 * metre_per_second};
    const auto before = mechanics::momentum(cart.mass, cart.velocity) + mechanics::momentum(wagon.mass, wagon.velocity);
    //! [bodies]
    const auto energy = [](const auto& a, const auto& b) {
        return mechanics::kinetic_energy(a.mass, a.velocity) + mechanics::kinetic_energy(b.mass, b.velocity);
    };
    const auto mu = mechanics::reduced_mass(cart.mass, wagon.mass);
    const auto closing = cart.velocity - wagon.velocity;

    std::cout << "before: " << cart.velocity << " and " << wagon.velocity << ", momentum " << before << ", energy "
              << energy(cart, wagon) << "\n\n";
    workbook::Columns table({"e", "cart", "wagon", "momentum", "energy"});
    std::vector<double> restitutions;
    std::vector<Quantity<unit::Energy>> energies;
    bool conserved = true, separated = true;
    for (const double e : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        //! [collide]
        const auto [one, other] = mechanics::collide(cart, wagon, e);
        const auto after =
            mechanics::momentum(one.mass, one.velocity) + mechanics::momentum(other.mass, other.velocity);
        //! [collide]
        table.row(e, one.velocity, other.velocity, after, energy(one, other));
        conserved = conserved && abs(after - before) < 1e-14 * kilogram_metre_per_second;
        separated = separated && abs((other.velocity - one.velocity) - e * closing) < 1e-14 * metre_per_second;
        restitutions.push_back(e);
        energies.push_back(energy(one, other));
    }
    std::cout << table;
    claim("momentum is the same before and after, at every e", conserved);
    claim("they separate with e times the speed at which they met", separated);
    claim("e = 1: -2.5 m/s and 0.5 m/s, and no energy is lost",
          abs(energies.back() - energy(cart, wagon)) < 1e-13 * joule);
    claim("e = 0: they go on together, 3.375 J are gone",
          abs(energies.front() - energy(cart, wagon) + 3.375 * joule) < 1e-13 * joule);

    // In a world: a closed system of three that attract each other, and none of them knows of the law.
    //! [closed]
    Attraction attraction;
    attraction.constant = 1.0 * (cubic_metre / (kilogram * second * second));
    attraction.softening = 0.1 * metre;
    World system{RungeKutta4{}, attraction};
    system.add(position(metres(0, 0, 0)), velocity(metres_per_second(1, 0, 0)), mass(2.0 * kilogram));
    system.add(position(metres(3, 1, 0)), velocity(metres_per_second(0, -1, 0)), mass(1.0 * kilogram));
    system.add(position(metres(-1, 3, 2)), velocity(metres_per_second(0, 0, 0.5)), mass(4.0 * kilogram));
    const auto total = total_momentum(system);
    while (system.time() < 10.0 * second) system.step(0.01 * second);
    //! [closed]
    std::cout << "\nThree bodies, ten seconds: momentum " << total << ", then " << total_momentum(system) << '\n';
    claim("three bodies in each other's field keep the sum of their momenta",
          norm(total_momentum(system) - total) < 1e-12 * kilogram_metre_per_second);

    workbook::Plot plot("1.4", "A collision may lose energy, never momentum");
    plot.x("restitution e").y("kinetic energy after the collision");
    std::vector<double> all;
    for (int i = 0; i <= 50; ++i) all.push_back(i / 50.0);
    plot.points("after the collision", restitutions, energies);
    plot.reference("E - (1 - e^2) mu (u1 - u2)^2 / 2", all,
                   [&](double e) { return energy(cart, wagon) - 0.5 * (1 - e * e) * mu * closing * closing; });
    plot.write();
    return claim.result();
}
