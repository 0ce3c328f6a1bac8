// SPDX-License-Identifier: BSL-1.0
// 2.1 Detection: testing every pair, or only those that may touch

// N bodies make N (N - 1) / 2 pairs: twice as many bodies, four times as many tests. The notes divide the work into a
// broadphase, which leaves out what cannot touch, and a narrowphase, which tests the rest exactly. The world is the
// same with both, to the last bit; only the broadphase in its list is another one.

#include "claims.hpp"
#include "columns.hpp"
#include "plot.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

#include <iostream>
#include <vector>

using namespace ansatz;

namespace {

/// A narrowphase that also counts how often it is asked: everything else it leaves to the library's.
struct Looks : Narrowphase<Sphere> {
    static inline long count = 0;
    template <class S>
    static bool collide_bodies(const Shapes<S>& shapes, std::uint32_t a, const typename S::Position& xa,
                               std::uint32_t b, const typename S::Position& xb, Touch<S>& touch) {
        ++count;
        return Narrowphase<Sphere>::collide_bodies<S>(shapes, a, xa, b, xb, touch);
    }
};

//! [gas]
template <class Broadphase> std::uint64_t gas(int n) {
    World world{SemiImplicitEuler{}, Broadphase{}, Looks{}, Impulse<>{}};
    for (int i = 0; i < n; ++i) // on a lattice, each flying off in a direction of its own
        world.add(Sphere{0.2 * metre}, position(metres(i % 10, i / 10 % 10, i / 100)),
                  velocity(metres_per_second(i % 7 - 3, i % 5 - 2, i % 3 - 1)), mass(1.0 * kilogram), restitution(1));
    for (int step = 0; step < 30; ++step) world.step(1.0 / 60 * second);
    return world.hash();
}
//! [gas]
template <class Broadphase> double tests(int n) {
    Looks::count = 0;
    gas<Broadphase>(n);
    return double(Looks::count) / 30;
}

} // namespace

int main() {
    workbook::Claims claim;
    std::vector<double> sizes, all, few;
    workbook::Columns table({"bodies", "tests a step", "behind a broadphase"});
    for (const int n : {50, 100, 200, 400, 800}) {
        sizes.push_back(n);
        all.push_back(tests<AllPairs>(n));
        few.push_back(tests<UniformGrid<>>(n));
        table.row(n, all.back(), few.back());
    }
    std::cout << table;
    claim("all pairs are N (N - 1) / 2", all.back() == 800.0 * 799 / 2);
    claim("twice the bodies are four times the tests", all[4] / all[3] > 3.9);
    claim("behind a broadphase they grow two and a half times at most from 400 to 800 bodies", few[4] / few[3] < 2.5);
    claim("the motion is the same, to the last bit", gas<AllPairs>(200) == gas<UniformGrid<>>(200));

    workbook::Plot plot("2.1", "A broadphase leaves few pairs to test");
    plot.x("bodies").y("tests of the narrowphase in a step").log_x().log_y();
    plot.linked_points("all pairs", sizes, all).linked_points("UniformGrid", sizes, few).write();
    return claim.result();
}
