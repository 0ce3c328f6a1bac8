// SPDX-License-Identifier: BSL-1.0
// A ball that bounces for ever: hard case C8, with every integrator and every response.
// Compiles like 20 kB: a world for each of seven integrators and of four responses.

#include "tests/collision/support.hpp"

#include <ansatz/collision/response/impulse.hpp>
#include <ansatz/collision/response/projection.hpp>
#include <ansatz/collision/restitution.hpp>

#include <ansatz/motion/integrators/conjugate_gradient.hpp>

#include <numbers>

using namespace collision_tests;

namespace {
/// The lowest, the highest and the last apex of a ball dropped from 10 m with e = 1, over the first, and how deep it
/// was at most.
struct Apexes {
    double least = HUGE_VAL, most = 0, last = 0, depth = 0;
};
template <class I, class S, class... R> Apexes apexes(double dt, int wanted, R... responses) {
    auto world = world_of(I{}, S{}, Gravity{}, responses...);
    const auto ball = [&] {
        if constexpr (decltype(world)::composition::template stores<Restitution>)
            return world.add(Sphere{0.5 * metre}, at<S>(0, 10), mass(1.0 * kilogram), restitution(1));
        else return world.add(Sphere{0.5 * metre}, at<S>(0, 10), mass(1.0 * kilogram));
    }();
    world.add(Plane::ground(), fixed);
    Apexes apex;
    double top = 0, before = 0;
    int bounces = 0;
    for (int i = 0; bounces <= wanted && i < 10 * wanted / dt; ++i) {
        world.step(dt * second);
        const double v = speed_along(world, ball, 1), y = height_of(world, ball) - 0.5;
        if (before < 0 && v > 0) {
            if (bounces++ > 0) {
                apex.last = top / 9.5;
                apex.least = std::min(apex.least, apex.last);
                apex.most = std::max(apex.most, apex.last);
            }
            top = 0;
        }
        // Between two steps the apex is where the rest of its speed takes it.
        top = std::max(top, y);
        apex.depth = std::max(apex.depth, -y);
        before = v;
    }
    return bounces == wanted + 1 ? apex : Apexes{0, 0, 0, HUGE_VAL};
}
} // namespace

TEST_CASE("C8: a ball with e = 1 comes back to its height, with every integrator and response",
          "[collision][impulse]") {
    for_each_type(Types<ExplicitEuler, SemiImplicitEuler, ImplicitEuler, Verlet, VelocityVerlet, RungeKutta4,
                        OdeintRungeKutta4>{},
                  []<class I>() {
                      for (const double dt : {1.0 / 60, 1.0 / 100, 1.0 / 30}) {
                          INFO("dt = " << dt);
                          auto check = [](const Apexes& apex, double deepest) {
                              CHECK(apex.least >= 0.99);
                              CHECK(apex.most <= 1.01);
                              CHECK(apex.depth <= deepest);
                          };
                          // An impulse lets it come as deep as it falls in a step, and once more where the integrator's
                          // velocity is turned late.
                          const double way = 1.01 * std::sqrt(2 * 9.81 * 9.5) * dt + 9.81 * dt * dt;
                          check(apexes<I, Space<double, 3>>(dt, 20, Impulse<>{}), way);
                          check(apexes<I, Space<double, 3>>(dt, 20, Impulse<>{}, Projection{}), 1e-12);
                          check(apexes<I, Space<double, 3>>(dt, 20, SoftSubsteps<>{}),
                                0.5 * 9.81 * dt * dt / 16); // what gravity bends its way in one of four substeps
                      }
                      if constexpr (!std::same_as<I, OdeintRungeKutta4>) {
                          const auto apex = apexes<I, Space<float, 2>>(1.0 / 60, 20, Impulse<>{}, Projection{});
                          CHECK((apex.least >= 0.99 && apex.most <= 1.01));
                      }
                  });
}

TEST_CASE("C8, penalty: an undamped contact gives back what it takes, but for what the integrator is known to add",
          "[collision][penalty]") {
    // Five bounces on 1000 N/m: omega = 31.6/s, and a contact lasts half a swing, pi/omega.
    const double k = 1000, dt = 5e-4, omega_dt = std::sqrt(k) * dt;
    const int n = 5;
    for_each_type(Types<SemiImplicitEuler, Verlet, VelocityVerlet, RungeKutta4>{}, [&]<class I>() {
        const auto apex = apexes<I, Space<double, 3>>(dt, n, Penalty{k * newton_per_metre});
        // The spring begins and ends up to a step late: twice k (v dt)^2 / 2 of m v^2 / 2 in each bounce.
        const double late = 2 * omega_dt * omega_dt * n;
        CHECK(apex.least >= 1 - late);
        CHECK(apex.most <= 1 + late);
        CHECK(std::abs(apex.depth / (std::sqrt(2 * 9.5 * 9.81 / k + std::pow(9.81 / k, 2)) + 9.81 / k) - 1) <=
              omega_dt); // k p^2 / 2 = m g (9.5 m + p)
    });
    // Each step of explicit Euler multiplies the energy of a swing by 1 + (omega dt)^2, implicit Euler divides it.
    const double grown = std::exp(n * std::numbers::pi * omega_dt);
    const auto gains = apexes<ExplicitEuler, Space<double, 3>>(dt, n, Penalty{k * newton_per_metre});
    CHECK(std::abs(std::log(gains.last) / std::log(grown) - 1) <= 0.1);
    const auto loses = apexes<ImplicitEuler, Space<double, 3>>(dt, n, Penalty{k * newton_per_metre});
    CHECK(std::abs(std::log(loses.last) / -std::log(grown) - 1) <= 0.1);
}
