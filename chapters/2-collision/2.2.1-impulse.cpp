// SPDX-License-Identifier: BSL-1.0
// 2.2.1 The impulse method: the difference of two velocities, and what restitution conserves

// J = -(1 + e) v_N / (1/m_a + 1/m_b) along N. The notes take v_ab = v_a + v_b: the relative velocity is the difference.
// With a sum two bodies that fly side by side push each other, and gain energy from nowhere. They also say that an
// elastic collision conserves all momentum and an inelastic one dissipates it: momentum is conserved by both, because
// the impulses are opposite; what is lost is kinetic energy, mu (1 - e^2) v_N^2 / 2. Two conditions are missing. The
// impulse is for bodies that approach: applied to two that separate already, it holds them together. And restitution
// needs a threshold, or a ball that lies on the ground keeps bouncing off what gravity gives it in a single step.

#include "claims.hpp"
#include "columns.hpp"
#include "film.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using namespace ansatz;

namespace {

struct After {
    double momentum, energy; // kg m/s, J
};
//! [meet]
/// 1 kg at 2 m/s meets 3 kg at -1 m/s.
After meet(double e) {
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Impulse<>{}};
    const auto a =
        world.add(Sphere{0.5 * metre}, velocity(metres_per_second(2, 0, 0)), mass(1.0 * kilogram), restitution(e));
    const auto b = world.add(Sphere{0.5 * metre}, position(metres(0.9, 0, 0)), velocity(metres_per_second(-1, 0, 0)),
                             mass(3.0 * kilogram));
    world.step(1e-6 * second);
    //! [meet]
    const double va = in(x(world.velocity(a)), metre_per_second), vb = in(x(world.velocity(b)), metre_per_second);
    return {va + 3 * vb, 0.5 * va * va + 1.5 * vb * vb};
}

/// The highest point of a ball with e = 1, bounce after bounce, over the height that it was dropped from.
template <class Integrator> std::vector<double> heights() {
    World world{Integrator{}, Gravity{}, BoundingBoxes{}, Narrowphase<Sphere, Plane>{}, Impulse<>{}, Projection{}};
    world.add(Plane::ground(), fixed);
    const auto ball = world.add(Sphere{0.5 * metre}, position(metres(0, 10, 0)), mass(1.0 * kilogram), restitution(1));
    std::vector<double> tops;
    double top = 0, before = 0;
    while (tops.size() < 20 && world.tick() < 10000) {
        world.step(1.0 / 60 * second);
        const double v = in(y(world.velocity(ball)), metre_per_second);
        if (before < 0 && v > 0) {
            tops.push_back(top / 9.5);
            top = 0;
        }
        top = std::max(top, in(y(world.position(ball)), metre) - 0.5);
        before = v;
    }
    return tops;
}

//! [formula alone]
/// The impulse on a along N by the formula alone, whether they approach or separate: N s, for two bodies of 1 kg.
double impulse_without_condition(double v_n, double e) { return -(1 + e) * v_n / (1.0 + 1.0); }
//! [formula alone]

//! [trembles]
/// A ball that lies on the ground gets g dt in each step, and the formula without a threshold bounces it off: m/s.
double trembles_with(double e) {
    double v = 0;
    for (int step = 0; step < 1000; ++step) {
        v -= 9.81 / 240;
        if (v < 0) v = -e * v;
    }
    return v;
}
//! [trembles]

struct Settled {
    double came_to_rest; // s: after it the ball is slower than 0.05 m/s
    double way;          // m: up and down, all together
    double trembles;     // m/s: the highest speed in the last half second
};
//! [zeno]
/// A ball with e = 0.5 is dropped from 1 m, and has three seconds to come to rest.
Settled settle(Quantity<unit::Velocity> threshold) {
    World world{SemiImplicitEuler{},
                Gravity{},
                BoundingBoxes{},
                Narrowphase<Sphere, Plane>{},
                Impulse<>{.threshold = threshold},
                Projection{0.0001 * metre}};
    world.add(Plane::ground(), fixed);
    const auto ball =
        world.add(Sphere{0.1 * metre}, position(metres(0, 1.1, 0)), mass(1.0 * kilogram), restitution(0.5));
    //! [zeno]
    Settled all{};
    double before = 1.1;
    while (world.time() < 3.0 * second) {
        world.step(1.0 / 240 * second);
        const double speed = std::abs(in(y(world.velocity(ball)), metre_per_second));
        const double height = in(y(world.position(ball)), metre);
        all.way += std::abs(height - before);
        before = height;
        // The top of a flight is slow, too: only near the ground a low speed may be rest.
        if (speed > 0.05 || height > 0.1 + 0.001) all.came_to_rest = in(world.time(), second);
        if (world.time() > 2.5 * second) all.trembles = std::max(all.trembles, speed);
    }
    return all;
}

/// Five balls with e = 0, 1/4, 1/2, 3/4 and 1 fall side by side, for the film; how high each comes after its first
/// bounce, over how high it was.
std::vector<double> side_by_side() {
    World world{SemiImplicitEuler{},          Gravity{},   BoundingBoxes{},
                Narrowphase<Sphere, Plane>{}, Impulse<>{}, Projection{}};
    world.add(Plane::ground(), fixed);
    workbook::Film film(
        "2.2.1", "Five balls, from e = 0 to e = 1",
        "Five balls fall from the same height. The first stays where it hits the ground, the last comes back "
        "to where it was, and those between leap the lower the smaller their restitution is.",
        {.middle = metres(0, 0.78, 0),
         .width = 3.2 * metre,
         .height = 1.95 * metre,
         .turn = degrees(12),
         .above = degrees(9)});
    film.still(14).scenery().ground(metres(-1.35, 0, -0.35), metres(1.35, 0, 0.35), 0.1 * metre);
    const auto radius = 0.14 * metre;
    std::vector<Handle> balls;
    for (int k = 0; k < 5; ++k) {
        const auto place = metres(0.55 * (k - 2), 1.5, 0);
        balls.push_back(world.add(Sphere{radius}, position(place), mass(1.0 * kilogram), restitution(0.25 * k)));
        film.scenery().note(metres(0.55 * (k - 2) - 0.1, -0.12, 0),
                            std::array{"e = 0", "1/4", "1/2", "3/4", "1"}[std::size_t(k)]);
    }
    std::vector<double> tops(5, 0.0);
    std::vector<bool> has_hit(5, false);
    for (int n = 0; n < 84 * 12; ++n) {
        if (n % 12 == 0) {
            auto& frame = film.frame(world.time());
            for (const Handle ball : balls) {
                const auto at = world.position(ball);
                std::vector<VectorQuantity<unit::Length>> rim;
                for (int corner = 0; corner < 12; ++corner) {
                    const double angle = corner * std::acos(-1.0) / 6;
                    rim.push_back(at + metres(0.14 * std::cos(angle), 0, 0.14 * std::sin(angle)));
                }
                frame.shadow(rim, 0.0 * metre).ball(at, radius, workbook::paints::ball);
            }
        }
        world.step(1.0 / 240 * second);
        for (std::size_t k = 0; k < 5; ++k) {
            const double speed = y(world.velocity(balls[k])).value();
            const double height = (y(world.position(balls[k])) - radius).value();
            if (has_hit[k] && n < 300) tops[k] = std::max(tops[k], height / 1.36);
            has_hit[k] = has_hit[k] || (height < 0.05 && speed > -0.1);
        }
    }
    film.write();
    return tops;
}

} // namespace

int main() {
    workbook::Claims claim;
    for (const double e : {0.0, 0.5, 1.0}) {
        const auto after = meet(e);
        std::cout << "e = " << e << ": momentum " << after.momentum << " kg m/s, energy " << after.energy << " J\n";
    }
    claim("momentum is what it was, whatever e is",
          std::abs(meet(0).momentum + 1) < 1e-12 && std::abs(meet(1).momentum + 1) < 1e-12);
    claim("e = 1 keeps the energy, 3.5 J", std::abs(meet(1).energy - 3.5) < 1e-12);
    claim("e = 0 loses mu v^2 / 2 of it, 3.375 J", std::abs(3.5 - meet(0).energy - 3.375) < 1e-12);

    //! [side by side]
    const auto both = metres_per_second(5, 0, 0);
    const auto w = 1.0 / (1.0 * kilogram);
    const auto j = collision_impulse(both, both, w, w, Eigen::Vector3d(-1, 0, 0), 1.0);
    //! [side by side]
    const double of_the_sum = -2 * (5 + 5) * -1.0 / 2; // J with v_a + v_b
    workbook::say() << "Side by side at 5 m/s: J = " << j << "; with the sum of the velocities it would be "
                    << of_the_sum << " N s\n";
    claim("bodies that move together do not push each other", j.value() == 0);

    // Two bodies of 1 kg that overlap by 0.1 m and separate at 1 m/s each: v_N = 2 m/s.
    //! [separating]
    World separating{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Impulse<>{}};
    const auto left = separating.add(Sphere{0.5 * metre}, velocity(metres_per_second(-1, 0, 0)), mass(1.0 * kilogram));
    const auto right = separating.add(Sphere{0.5 * metre}, position(metres(0.9, 0, 0)),
                                      velocity(metres_per_second(1, 0, 0)), mass(1.0 * kilogram));
    for (int step = 0; step < 60; ++step) separating.step(1.0 / 60 * second);
    const auto apart = x(separating.position(right)) - x(separating.position(left));
    //! [separating]
    const double stopped = 2 + 2 * impulse_without_condition(2, 0), turned = 2 + 2 * impulse_without_condition(2, 1);
    workbook::say() << "Two that separate at 2 m/s are " << apart
                    << " apart after 1 s; the formula alone would leave them v_N = " << stopped << " m/s (e = 0) or "
                    << turned << " m/s (e = 1)\n";
    claim("bodies that separate get no impulse", std::abs(in(apart, metre) - 2.9) < 1e-12);
    claim("the formula alone would glue them together, or drive them back into each other",
          stopped == 0 && turned == -2);

    const double g_dt = 9.81 / 240, by_formula = trembles_with(0.5);
    workbook::say() << "What lies on the ground trembles by the formula alone with " << by_formula
                    << " m/s (e = 0.5), gravity gives " << g_dt << " m/s in a step\n";
    claim("the formula without a threshold leaves e / (1 + e) of what gravity gives in a step",
          std::abs(by_formula - 0.5 / 1.5 * g_dt) < 1e-12);

    const auto without_threshold = settle(0.0 * metre_per_second), with_threshold = settle(0.25 * metre_per_second);
    const double one_fall = std::sqrt(2 / 9.81);
    workbook::say() << "Dropped from 1 m with e = 0.5: at rest after " << with_threshold.came_to_rest << " s and "
                    << with_threshold.way << " m, by the series " << 3 * one_fall << " s and " << 5.0 / 3 << " m\n"
                    << "In the last half second it moves at " << with_threshold.trembles
                    << " m/s, in a world with a threshold of zero at " << without_threshold.trembles << " m/s\n";
    // What is slower than the threshold does not bounce any more: of the series up to 2 e v / (g (1 - e)) is left out.
    const double v = 0.25, left_out = 2 * v / 9.81, way_left_out = v * v * 0.25 / (9.81 * 0.75);
    claim("with a threshold it rests when the series ends, but for the bounces below the threshold",
          with_threshold.came_to_rest < 3 * one_fall + 1.0 / 240 &&
              with_threshold.came_to_rest > 3 * one_fall - left_out - 1.0 / 240 && with_threshold.trembles < 1e-9);
    claim("and has gone the way of the series",
          with_threshold.way < 5.0 / 3 && with_threshold.way > 5.0 / 3 - way_left_out);
    claim("without one its velocity never becomes zero", without_threshold.trembles > 0.1 * g_dt);

    const auto euler = heights<ExplicitEuler>(), half = heights<SemiImplicitEuler>(),
               verlet = heights<VelocityVerlet>();
    workbook::say() << "After 20 bounces with e = 1: " << euler.back() << " (explicit Euler), " << half.back()
                    << " (semi-implicit), " << verlet.back() << " (velocity Verlet) of the height\n";
    bool all = true;
    for (const auto& tops : {euler, half, verlet})
        for (const double top : tops) all = all && top > 0.99 && top < 1.01;
    claim("a ball with e = 1 comes back to its height, with every integrator", all);

    const auto tops = side_by_side();
    std::string come_back;
    double off = 0;
    for (std::size_t k = 0; k < 5; ++k) {
        const double e = 0.25 * double(k);
        off = std::max(off, std::abs(tops[k] - e * e));
        come_back += (k == 0 ? "" : ", ") + workbook::printed(std::round(100 * tops[k]), " %");
    }
    workbook::say() << "Dropped side by side, balls come back to " << come_back
                    << " of their height, with e = 0, 1/4, 1/2, 3/4, 1\n";
    claim("that is e^2 of it, but for what a step takes or gives", off < 0.03);

    workbook::Plot plot("2.2.1", "Twenty bounces with e = 1");
    std::vector<double> bounces;
    for (int i = 1; i <= 20; ++i) bounces.push_back(i);
    plot.x("bounce").y("height over the first").y_range(0.9, 1.1);
    plot.linked_points("explicit Euler", bounces, euler)
        .linked_points("semi-implicit Euler", bounces, half)
        .linked_points("velocity Verlet", bounces, verlet)
        .write();
    return claim.result();
}
