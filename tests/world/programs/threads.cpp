// SPDX-License-Identifier: BSL-1.0
// A small world of each kind whose loops run on three threads, for the thread sanitizer: laws in one loop, with an
// integrator that solves for no body, so that the world counts all as unsolved; stages with springs, a history of
// positions, rest; contacts that are solved by colours, in groups. Ends with 0 if the bits are those of one thread.
// With ANSATZ_RACE it has an effect that counts what it has slowed, in one number for all bodies.

#include <ansatz/collision.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstdio>
#include <thread>
#include <vector>

using namespace ansatz;

struct Threads {
    using role = roles::Execution;
    int threads = 3;
    void execute(std::size_t count, std::size_t, const auto& loop) const {
        const auto n = std::size_t(threads);
        std::vector<std::thread> others;
        for (std::size_t i = 1; i < n; ++i)
            others.emplace_back([=, &loop] { loop(i * count / n, (i + 1) * count / n); });
        loop(0, count / n);
        for (auto& other : others) other.join();
    }
};

struct Slowed {
    using role = roles::Effect;
    using writes = Columns<Velocity>;
    static constexpr Place place = Place::after_integration;
#ifdef ANSATZ_RACE
    static inline std::uint64_t count = 0;
#endif
    template <class S> struct In {
        explicit In(const Slowed&) {}
        void apply(typename S::Velocity& v, const auto&) const {
            v = typename S::Scalar(0.99) * v;
#ifdef ANSATZ_RACE
            ++count;
#endif
        }
    };
};

/// Finds no solution, and says so.
struct Unsolving {
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    static bool solve(auto& x, auto& v, const auto& laws, const auto& dt) {
        v += laws(x, v, 0) * dt;
        x += v * dt;
        return false;
    }
};

constexpr int steps = 20;
int wrong_counts = 0;

template <class World_> std::uint64_t hash_of(World_ world, int bodies) {
    std::vector<Handle> all;
    for (int i = 0; i < bodies; ++i) {
        const double t = i;
        all.push_back(world.add(position(metres(t, std::sin(t), std::cos(3 * t))), mass((1 + 0.1 * (i % 7)) * kilogram),
                                velocity(metres_per_second(std::cos(t), 0, 0.1 * t))));
        if constexpr (World_::composition::coupled)
            if (i > 3) world.add(Spring{all[std::size_t(i - 3)], all.back(), 20.0 * newton_per_metre});
    }
    for (int i = 0; i < steps; ++i) world.step(0.01 * second);
    const auto status = world.status();
    if constexpr (std::same_as<typename World_::composition::Integrator, Unsolving>)
        if (status.unsolved != std::uint64_t(bodies) * steps) return ++wrong_counts;
    return world.hash();
}
/// Whether three threads come to what one comes to.
int differs(int bodies, const auto&... policies) {
    return hash_of(World{policies..., Threads{1}}, bodies) != hash_of(World{policies..., Threads{3}}, bodies);
}

/// A pile of so many bodies that contacts are in several groups.
/// \param side in so many rows; where there are many of them, bodies of several groups lie on the ground
template <class World_> std::uint64_t hash_of_pile(World_ world, int side) {
    world.add(Plane::ground(), fixed);
    for (int i = 0; i < 2200; ++i)
        world.add(Sphere{0.5 * metre}, mass((1.0 + i % 3) * kilogram),
                  position(metres(0.99 * (i % side), 0.5 + 0.98 * (i / (side * side)),
                                  0.99 * (i / side % side) + 0.01 * (i % 2))));
    for (int i = 0; i < 3; ++i) world.step(0.01 * second);
    return world.hash();
}
int piles_differ(const auto&... policies) {
    int faults = 0;
    for (const int side : {13, 47})
        faults +=
            hash_of_pile(World{policies..., Threads{1}}, side) != hash_of_pile(World{policies..., Threads{3}}, side);
    return faults;
}

int main() {
    int faults = differs(101, Unsolving{}, Gravity{}, QuadraticDrag{}, Slowed{}, Keep<InverseMass>{});
    // so many that springs are divided
    faults += differs(2500, Verlet{}, Gravity{}, Springs{}, Slowed{}, Rest{});
    faults += piles_differ(SemiImplicitEuler{}, Gravity{}, Rest{}, Coherent{}, Narrowphase<Sphere, Plane>{},
                           SoftSubsteps<Coloured, Friction>{});
    std::printf("%d of 4 worlds differ, %d wrong counts\n", faults, wrong_counts);
    return faults + wrong_counts;
}
