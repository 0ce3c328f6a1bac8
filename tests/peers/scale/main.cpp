// SPDX-License-Identifier: BSL-1.0
// `./workbook peers scale`: the same scenes with ten thousand, a hundred thousand and a million bodies: what a step
// costs a body, and how much memory. What grows faster than the bodies shows as a ratio above one. One thread.

#include "tests/peers/contest.hpp"
#include "tests/peers/flight.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/motion.hpp>
#include <ansatz/world.hpp>

#include <malloc.h> // mallinfo2: glibc

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace ansatz;
using peers::Contest;

namespace {

using S = Space<float, 3>;

/// Bytes that the heap has given out.
double heap() {
    const auto now = mallinfo2();
    return double(now.uordblks) + double(now.hblkhd);
}

/// Spheres of a tenth of the space, each on its way.
auto gas(int n) {
    World world{S{}, SemiImplicitEuler{}, UniformGrid{}, Narrowphase<Sphere>{}, Impulse{}, Projection{}};
    const int row = int(std::ceil(std::cbrt(double(n))));
    const double apart = std::cbrt(4 * std::numbers::pi / 3 * 0.125 / 0.1); // m, from centre to centre
    std::mt19937 random(2);
    std::uniform_real_distribution<double> number(-1, 1);
    for (int i = 0; i < n; ++i) {
        const double x = i % row + 0.3 * number(random), y = i / row % row + 0.3 * number(random),
                     z = i / row / row + 0.3 * number(random);
        const double u = number(random), v = number(random), w = number(random);
        world.add(Sphere{0.5 * metre}, position(apart * metres(x, y, z)), velocity(2.0 * metres_per_second(u, v, w)),
                  mass(1.0 * kilogram));
    }
    return world;
}
/// Spheres in an open box, ten layers of them, however many there are.
auto pile(int n) {
    World world{S{}, SemiImplicitEuler{}, Gravity{}, UniformGrid{}, Narrowphase<Sphere, Plane>{}, SoftSubsteps{}};
    const int row = int(std::ceil(std::sqrt(n / 10.0)));
    const double half = 0.52 * row;
    for (const Eigen::Vector3d& inwards :
         {Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(-1, 0, 0), Eigen::Vector3d(0, 0, 1),
          Eigen::Vector3d(0, 0, -1)})
        world.add(Plane{inwards, (inwards.y() > 0 ? 0.0 : -half) * metre}, fixed);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> beside(-0.02, 0.02);
    for (int i = 0; i < n; ++i) {
        const double x = (i % row + 0.5) * 1.04 - half + beside(random),
                     z = (i / row % row + 0.5) * 1.04 - half + beside(random);
        world.add(Sphere{0.5 * metre}, position(metres(x, 0.5 + i / (row * row), z)), mass(1.0 * kilogram));
    }
    return world;
}

/// A scene with so many bodies: its world, and what it was measured to cost.
struct Size {
    int n;
    std::function<void()> step;
    int steps = 1;                  ///< that are timed at once: a twentieth of a second
    double bytes = 0;               ///< a body
    std::vector<double> times = {}; ///< ns a body and step
};
template <class Make> Size of(int n, int warm, const Make& make) {
    const double before = heap();
    auto world = std::make_shared<decltype(make(n))>(make(n));
    Size size{n, [world] { world->step(1.0 / 60 * second); }};
    for (int i = 0; i < warm; ++i) size.step();
    size.bytes = (heap() - before) / n;
    const double start = Contest::thread_seconds();
    int steps = 0;
    double used = 0;
    for (; used < 0.05; used = Contest::thread_seconds() - start, ++steps) size.step();
    size.steps = std::max(1, int(steps * 0.05 / used));
    return size;
}
/// All sizes take their steps in turn, so that a busy minute hurts none of them alone.
template <class Make> void play(Contest& contest, const std::string& scene, int most, int warm, const Make& make) {
    std::vector<Size> sizes;
    for (int n = 10000; n <= most; n *= 10) sizes.push_back(of(n, warm, make));
    for (int repeat = 0; repeat < contest.repeats(); ++repeat)
        for (Size& size : sizes) {
            const double start = Contest::thread_seconds();
            for (int i = 0; i < size.steps; ++i) size.step();
            size.times.push_back(1e9 * (Contest::thread_seconds() - start) / size.steps / size.n);
        }
    std::printf("\n%s, smallest of %d repeats in turn\n  %10s %18s %14s %14s\n", scene.c_str(), contest.repeats(),
                "bodies", "ns a body, a step", "of the first's", "bytes a body");
    for (Size& size : sizes) {
        std::sort(size.times.begin(), size.times.end());
        const double best = size.times.front(), first = sizes.front().times.front();
        std::printf("  %10d %18.1f %14.2f %14.0f\n", size.n, best, best / first, size.bytes);
        contest.note(scene, size.n, "ansatz", best, "ns a body and step", size.times[size.times.size() / 2] / best - 1);
        contest.note(scene + ", memory", size.n, "ansatz", size.bytes, "bytes a body");
    }
    std::fflush(stdout);
}

} // namespace

/// usage: peers_scale <folder for scale.json> [repeats [largest number of bodies]]
int main(int argc, char** argv) {
    const std::string folder = argc > 1 ? argv[1] : ".";
    Contest contest("scale", argc > 2 ? std::max(1, std::atoi(argv[2])) : 7);
    const int most = argc > 3 ? std::max(10000, std::atoi(argv[3])) : 1000000;
    play(contest, "free flight, RungeKutta4 with drag", most, 3, [](int n) { return peers::flight(n); });
    play(contest, "spheres that meet, UniformGrid and Impulse", most, 3, gas);
    play(contest, "ten layers of spheres in a box, SoftSubsteps", most, 30, pile);
    contest.write(folder);
    return 0;
}
