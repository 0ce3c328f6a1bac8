// SPDX-License-Identifier: BSL-1.0
// 3 Springs: a spring pulls back in proportion to its displacement, and a damper along its axis brings it to rest

// "The force required to displace a spring by distance x is F = -kx", say the notes. -kx is what the spring does to
// what displaces it; the force required is the opposite, +kx. A weight that hangs from a spring shows it: the spring
// must carry it, so it is displaced *along* the weight, by m g / k.
//
// For a simulation the notes add a damping, F = -kx - cv, where v is the velocity "in the axis of the spring". What
// moves across the axis is no lengthening, and a spring that damped it would stop a pendulum.

#include "claims.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <cmath>
#include <iostream>
#include <vector>

using namespace ansatz;

int main() {
    workbook::Claims claim;

    // The law by itself.
    //! [law]
    const auto k = 200.0 * newton_per_metre;
    const auto x = 0.1 * metre;
    std::cout << "Displaced by " << x << ", the spring pulls with " << springs::force(k, x) << " and holds "
              << springs::energy(k, x) << '\n';
    //! [law]
    claim("the force of the spring is against the displacement", springs::force(k, x) < 0.0 * newton);
    claim("twice as far, twice the force, four times the energy",
          springs::force(k, 2.0 * x) == 2.0 * springs::force(k, x) &&
              springs::energy(k, 2.0 * x) == 4.0 * springs::energy(k, x));

    // A scale: each weight hangs where the spring carries it.
    //! [scale]
    std::vector<Quantity<unit::Force>> weights;
    std::vector<Quantity<unit::Length>> displaced;
    for (const double kilograms : {0.5, 1.0, 1.5, 2.0, 2.5}) {
        World scale{SemiImplicitEuler{}, Gravity{}, Springs{}};
        const auto m = kilograms * kilogram;
        const auto pan = scale.add(position(metres(0, -1, 0)), mass(m));
        scale.add(Spring{metres(0, 0, 0), pan, k, springs::critical_damping(k, m)});
        while (scale.time() < 5.0 * second) scale.step(1.0 / 240 * second);
        weights.push_back(m * 9.81 * metre_per_second_squared);
        displaced.push_back(-1.0 * metre - y(scale.position(pan)));
    }
    //! [scale]
    bool on_the_line = true;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        std::cout << "  " << weights[i] << " displaces it by " << displaced[i] << '\n';
        on_the_line = on_the_line && abs(k * displaced[i] - weights[i]) < 1e-6 * newton;
    }
    claim("the force required is +kx: with the notes' sign the pan would hang above the hook", on_the_line);

    // Damped along the axis, and nothing else: a stiff pendulum keeps swinging.
    //! [axis]
    World pendulum{VelocityVerlet{}, Gravity{}, Springs{}};
    const auto bob = pendulum.add(position(metres(1, 0, 0)), mass(1.0 * kilogram));
    pendulum.add(Spring{metres(0, 0, 0), bob, 1e5 * newton_per_metre, 600.0 * newton_second_per_metre});
    double highest = -1;
    while (pendulum.time() < 60.0 * second) {
        pendulum.step(1.0 / 1000 * second);
        if (pendulum.time() > 55.0 * second) highest = std::max<double>(highest, y(pendulum.position(bob)) / metre);
    }
    //! [axis]
    workbook::say() << "A pendulum on a damped spring still rises to " << highest
                    << " m after a minute; its start was 0 m\n";
    claim("the damper takes the stretching, not the swing", highest > -0.02);

    workbook::Plot plot("3", "A spring is displaced in proportion to what it carries");
    plot.x("displacement").y("force of the weight");
    plot.reference("kx", displaced, [&](Quantity<unit::Length> d) { return k * d; })
        .points("the scale", displaced, weights)
        .write();
    return claim.result();
}
