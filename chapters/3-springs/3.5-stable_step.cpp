// SPDX-License-Identifier: BSL-1.0
// 3.5 The stable step: a spring that is too stiff for its step explodes, and damping makes it worse

// "A damping factor is added to ensure that objects eventually come to rest", say the notes. In a simulation it does so
// only below a step that the spring itself decides: 2 / omega for semi-implicit Euler and Verlet, and with explicit
// damping *less*: (sqrt(c^2 + 4 k m) - c) / k. `stable_step` asks the integrator itself; StepLimit holds every step to
// it; ImplicitEuler has no such limit and pays with damping that was not asked for. (A part of section 3, which the
// notes do not divide.)

#include "claims.hpp"
#include "columns.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <cmath>
#include <iostream>
#include <stdexcept>
#include <vector>

using namespace ansatz;

namespace {

/// A mass of 1 kg on a spring, stretched by 1 mm.
template <class Integrator, class... More>
auto spring(Quantity<unit::Stiffness> k, Quantity<unit::Damping> c, More... more) {
    World world{Integrator{}, Springs{}, more...};
    const auto body = world.add(position(metres(1.001, 0, 0)), mass(1.0 * kilogram));
    world.add(Spring{metres(0, 0, 0), body, k, c, 1.0 * metre});
    return world;
}
/// How far it gets within 2000 steps, in mm, late enough that what decays has decayed.
template <class World_> double reach(World_ world, Quantity<unit::Time> dt) {
    double most = 0;
    for (int i = 0; i < 2000; ++i) {
        world.step(dt);
        const double now = 1000 * std::abs(x(world.position(world.handles()[0])) / metre - 1);
        if (i > 500) most = std::max(most, now);
        if (!(now < 100)) return 100;
    }
    return most;
}

} // namespace

int main() {
    workbook::Claims claim;
    const auto k = 100.0 * newton_per_metre;

    // The limit with more and more damping, by the integrator itself and by its closed form; and both sides of it.
    std::vector<double> ratios;
    std::vector<Quantity<unit::Time>> limits, closed;
    bool sharp = true;
    workbook::Columns table({"c in N s/m", "limit of the step", "at 0.99 of it", "at 1.01 of it"});
    for (const double c : {0.0, 2.0, 20.0, 200.0}) {
        //! [advice]
        const auto world = spring<SemiImplicitEuler>(k, c * newton_second_per_metre);
        const auto limit = stable_step(world);
        //! [advice]
        const double below = reach(world, 0.99 * limit), above = reach(world, 1.01 * limit);
        table.row(c, limit, workbook::printed(below, " mm"), above < 100 ? "stays" : "explodes");
        sharp = sharp && below < 20 && above >= 100;
        ratios.push_back(c / 20);
        limits.push_back(limit);
        closed.push_back((std::sqrt(c * c + 400) - c) / 100 * second);
    }
    std::cout << table;
    claim("the limit is sharp: it stays at 0.99, it explodes at 1.01", sharp);
    claim("without damping it is 2/omega", abs(limits[0] - 0.2 * second) < 1e-9 * second);
    claim("ten times the critical damping makes it twenty times smaller",
          std::abs(double(limits[0] / limits[3]) - 20.05) < 0.01);

    // A stiff spring at 60 Hz.
    const auto frame = 1.0 / 60 * second;
    const auto stiff = 1e6 * newton_per_metre;
    const auto none = 0.0 * newton_second_per_metre;
    //! [refuse]
    auto refused = spring<SemiImplicitEuler>(stiff, none, StepLimit<Refuse>{});
    std::string sentence;
    try {
        refused.step(frame);
    } catch (const std::invalid_argument& error) {
        sentence = error.what();
    }
    //! [refuse]
    workbook::say() << sentence << '\n';
    claim("StepLimit<Refuse> says what would do, and nothing has happened",
          refused.tick() == 0 && sentence.find("0.002 s") != std::string::npos);
    //! [divide]
    auto divided = spring<SemiImplicitEuler>(stiff, none, StepLimit<Divide>{});
    divided.step(frame);
    //! [divide]
    std::cout << "Divided, the frame took " << divided.tick() << " steps\n";
    claim("StepLimit<Divide> takes the frame in nine", divided.tick() == 9);

    // Implicit Euler has no limit, and is not free: it eats the energy of what it cannot follow.
    auto implicit = spring<ImplicitEuler>(stiff, none);
    const auto before = total_energy(implicit);
    implicit.step(frame);
    std::cout << "Implicit Euler took one step of 60 Hz and left " << total_energy(implicit) / before
              << " of the energy\n";
    claim("implicit Euler has no limit", !is_finite(stable_step(implicit)));
    claim("and damps what swings faster than its step", total_energy(implicit) < 0.01 * before);

    workbook::Plot plot("3.5", "Explicit damping makes the stable step smaller");
    std::vector<double> fine;
    for (double r = 0.05; r < 11; r *= 1.05) fine.push_back(r);
    std::vector<double> seldom; // points, or the curve would hide them
    for (std::size_t i = 0; i < fine.size(); i += 8) seldom.push_back(fine[i]);
    plot.x("damping ratio").y("largest stable step").log_x().log_y();
    auto asked = [&](double r) { return stable_step<SemiImplicitEuler>(100.0 / (second * second), 20 * r / second); };
    plot.line("semi-implicit Euler", fine, asked);
    plot.points("its closed form", seldom,
                [](double r) { return (std::sqrt(400 * r * r + 400) - 20 * r) / 100 * second; });
    plot.line("velocity Verlet", fine,
              [](double r) { return stable_step<VelocityVerlet>(100.0 / (second * second), 20 * r / second); });
    plot.line("Runge-Kutta 4", fine,
              [](double r) { return stable_step<RungeKutta4>(100.0 / (second * second), 20 * r / second); })
        .write();
    return claim.result();
}
