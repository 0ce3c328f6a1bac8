// SPDX-License-Identifier: BSL-1.0
// How fast springs are: a grid of 100 x 100 bodies, beside a loop over lanes that was written by hand for it.

#include <ansatz/springs/springs.hpp>
#include <ansatz/world.hpp>

#include "tests/performance/race.hpp"

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

using namespace ansatz;
using namespace ansatz::test;

namespace {

constexpr int side = 100;
constexpr double apart = 0.1, m = 0.1, k = 100, c = 0.1, dt = 1e-3, g = -9.81;

/// Calls `f(a, b)` for each spring of the grid: to the right and to the next row.
template <class F> void each_spring(F&& f) {
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const int a = row * side + column;
            if (column + 1 < side) f(a, a + 1);
            if (row + 1 < side) f(a, a + side);
        }
}

template <class Scalar> std::function<void(int)> in_a_world() {
    using W = World<SemiImplicitEuler, Gravity, Springs<>, Space<Scalar, 3>>;
    auto world = std::make_shared<W>(SemiImplicitEuler{}, Gravity{}, Springs<>{}, Space<Scalar, 3>{});
    std::vector<Handle> bodies;
    for (int i = 0; i < side * side; ++i)
        bodies.push_back(world->add(position(metres(apart * (i % side), 0, apart * (i / side))), mass(m * kilogram)));
    each_spring([&](int a, int b) {
        world->add(Spring{bodies[std::size_t(a)], bodies[std::size_t(b)], k * newton_per_metre,
                          c * newton_second_per_metre, apart * metre});
    });
    return [world](int steps) {
        for (int s = 0; s < steps; ++s) world->step(dt * second);
    };
}

/// The same by hand: lanes, and nothing that is not needed for this one grid.
template <class Scalar> class ByHand {
public:
    ByHand() {
        for (auto* lane : {&x, &y, &z, &u, &v, &w, &fx, &fy, &fz}) lane->resize(side * side);
        for (int i = 0; i < side * side; ++i) {
            x[std::size_t(i)] = Scalar(apart * (i % side));
            z[std::size_t(i)] = Scalar(apart * (i / side));
        }
        each_spring([&](int a, int b) {
            springs.push_back({std::uint32_t(a), std::uint32_t(b), Scalar(apart), Scalar(k), Scalar(c)});
        });
    }
    [[gnu::noinline]] void step() {
        for (auto* lane : {&fx, &fy, &fz}) std::fill(lane->begin(), lane->end(), Scalar(0));
        add_forces(x.data(), y.data(), z.data(), u.data(), v.data(), w.data(), fx.data(), fy.data(), fz.data());
        advance(x.data(), u.data(), fx.data(), Scalar(0));
        advance(y.data(), v.data(), fy.data(), Scalar(g));
        advance(z.data(), w.data(), fz.data(), Scalar(0));
    }

private:
    struct Link {
        std::uint32_t a, b;
        Scalar rest, stiffness, damping;
    };
    [[gnu::noinline]] void add_forces(const Scalar* px, const Scalar* py, const Scalar* pz, const Scalar* pu,
                                      const Scalar* pv, const Scalar* pw, Scalar* gx, Scalar* gy, Scalar* gz) const {
        for (const Link& s : springs) {
            const Scalar dx = px[s.b] - px[s.a], dy = py[s.b] - py[s.a], dz = pz[s.b] - pz[s.a];
            const Scalar length = std::sqrt(dx * dx + dy * dy + dz * dz);
            if (!(length > 0)) continue;
            const Scalar per_length = 1 / length;
            const Scalar speed =
                ((pu[s.b] - pu[s.a]) * dx + (pv[s.b] - pv[s.a]) * dy + (pw[s.b] - pw[s.a]) * dz) * per_length;
            const Scalar pull = (s.stiffness * (length - s.rest) + s.damping * speed) * per_length;
            gx[s.a] += pull * dx;
            gy[s.a] += pull * dy;
            gz[s.a] += pull * dz;
            gx[s.b] -= pull * dx;
            gy[s.b] -= pull * dy;
            gz[s.b] -= pull * dz;
        }
    }
    [[gnu::noinline]] static void advance(Scalar* __restrict place, Scalar* __restrict speed,
                                          const Scalar* __restrict force, Scalar falling) {
        for (int i = 0; i < side * side; ++i) {
            speed[i] += (falling + force[i] * Scalar(1 / m)) * Scalar(dt);
            place[i] += speed[i] * Scalar(dt);
        }
    }
    std::vector<Scalar> x, y, z, u, v, w, fx, fy, fz;
    std::vector<Link> springs;
};
template <class Scalar> std::function<void(int)> by_hand() {
    auto grid = std::make_shared<ByHand<Scalar>>();
    return [grid](int steps) {
        for (int s = 0; s < steps; ++s) grid->step();
    };
}

} // namespace

TEST_CASE("the springs of a grid of 100 x 100 bodies take at most 1.15 times a loop that was written by hand",
          "[springs][performance]") {
    std::size_t springs = 0;
    each_spring([&](int, int) { ++springs; });
    Race race;
    auto& world = race.add("19,800 springs in a World, double", springs, in_a_world<double>());
    auto& hand = race.add("the same by hand", springs, by_hand<double>());
    auto& world_float = race.add("in a World, float", springs, in_a_world<float>());
    auto& hand_float = race.add("the same by hand, float", springs, by_hand<float>());
    race.bound("a World over the loop by hand, double", world, {&hand}, 1.15);
    race.bound("a World over the loop by hand, float", world_float, {&hand_float}, 1.15);
    race.run();
}
