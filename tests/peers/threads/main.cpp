// SPDX-License-Identifier: BSL-1.0
// `./workbook peers threads`: the same scenes with none and with two threads, and with one for each core: what a step
// gains; and what it would gain on more cores than there are (rehearsal.hpp). By the clock on the wall, since threads
// that wait for each other use none of the processor's time; so close all other programs first.

#include "tests/peers/contest.hpp"

#if !__has_include(<oneapi/tbb/parallel_for.h>)

int main() { peers::Contest::left_out("oneTBB", "libtbb-dev"); }

#else

#include "tests/peers/collision/pile.hpp"
#include "tests/peers/flight.hpp"
#include "tests/peers/threads/rehearsal.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/execution/threads.hpp>
#include <ansatz/motion.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace ansatz;
using peers::Contest;
using peers::Rehearsal;
using peers::wall_seconds;

namespace {

using S = Space<float, 3>;

/// A square sheet of so many bodies, with springs along its edges and across its cells.
auto sheet(int n, auto... execution) {
    World world{S{}, SemiImplicitEuler{}, Gravity{}, Springs{}, execution...};
    const int row = int(std::lround(std::sqrt(n)));
    std::vector<Handle> all;
    for (int i = 0; i < n; ++i)
        all.push_back(
            world.add(position(metres(0.1 * (i % row), 0.01 * std::sin(i), 0.1 * (i / row))), mass(0.01 * kilogram)));
    for (int i = 0; i < n; ++i)
        for (const auto& [dx, dz] : {std::pair(1, 0), std::pair(0, 1), std::pair(1, 1), std::pair(-1, 1)}) {
            const int x = i % row + dx, z = i / row + dz;
            if (x >= 0 && x < row && z < row)
                world.add(Spring{all[std::size_t(i)], all[std::size_t(z * row + x)], 10.0 * newton_per_metre});
        }
    return world;
}
/// Spheres, each on its way: an eighth of their number in each cube as wide as one.
auto gas(int n, auto... execution) {
    World world{S{}, SemiImplicitEuler{}, UniformGrid{}, Narrowphase<Sphere>{}, Impulse{}, execution...};
    std::mt19937 random(2);
    std::uniform_real_distribution<double> at(0, 2 * std::cbrt(double(n))), speed(-1, 1);
    for (int i = 0; i < n; ++i) {
        const double x = at(random), y = at(random), z = at(random);
        const double u = speed(random), v = speed(random), w = speed(random);
        world.add(Sphere{0.5 * metre}, position(metres(x, y, z)), velocity(metres_per_second(u, v, w)),
                  mass(1.0 * kilogram), restitution(1.0));
    }
    return world;
}
/// Spheres that have settled in a box.
auto pile(int n, auto... execution) {
    const peers::Pile pile = peers::Pile::of(n);
    World world{S{},         SemiImplicitEuler{},          Gravity{},
                Coherent{},  Narrowphase<Sphere, Plane>{}, SoftSubsteps<Coloured>{},
                execution...};
    world.add(Plane::ground(), fixed);
    for (const double side : {-1.0, 1.0}) {
        world.add(Plane{Eigen::Vector3d(side, 0, 0), -pile.half_side * metre}, fixed);
        world.add(Plane{Eigen::Vector3d(0, 0, side), -pile.half_side * metre}, fixed);
    }
    for (const auto& x : pile.start)
        world.add(Sphere{pile.radius * metre}, position(metres(x[0], x[1], x[2])), mass(pile.mass * kilogram));
    for (int step = 0; step < 300; ++step) world.step(pile.dt * second);
    return world;
}

/// The pairs of boxes of the gas, by the search that a world divides.
struct Search {
    static constexpr std::size_t shares = 64;
    Boxes<S> boxes;
    UniformGrid<>::In<S> grid{UniformGrid<>{}};
    std::size_t pairs = 0;

    explicit Search(int n) {
        const auto world = gas(n);
        for (const auto handle : world.handles()) {
            const auto x = world.position(handle);
            const auto half = S::Position::from_value(Eigen::Vector3f::Constant(0.5f));
            boxes.push_back(x - half, x + half);
        }
        boxes.set_active(std::size_t(n));
    }
    void serial() {
        pairs = 0;
        grid.find(boxes, [this](std::size_t, std::size_t) { ++pairs; });
    }
    void divided(const auto& threads) {
        const auto run = [&](std::size_t count, std::size_t grain, const auto& loop) {
            threads.execute(count, grain, loop);
        };
        grid.prepare(boxes, run);
        std::array<std::size_t, shares> of_share{};
        const std::size_t all = grid.pieces();
        run(shares, 1, [&](std::size_t begin, std::size_t end) {
            for (; begin < end; ++begin) {
                std::size_t found = 0;
                grid.find(boxes, all * begin / shares, all * (begin + 1) / shares,
                          [&](std::size_t, std::size_t) { ++found; });
                of_share[begin] = found;
            }
        });
        pairs = 0;
        for (const std::size_t found : of_share) pairs += found;
    }
};

/// One who plays, and its times, ns a body and step.
struct Player {
    std::string name;
    std::function<void()> step;
    std::function<double()> gained{}; ///< of one who rehearses: s, by how much its steps would have been shorter
    std::vector<double> times{};
};

/// All take their steps in turn.
void play(Contest& contest, const std::string& scene, int n, std::vector<Player> players) {
    int steps = 1;
    for (double used = 0; used < 0.03; steps *= 2) {
        const double start = wall_seconds();
        for (int i = 0; i < steps; ++i) players.front().step();
        used = wall_seconds() - start;
        for (std::size_t k = 1; k < players.size(); ++k) // as far as the first: they end in the same state
            for (int i = 0; i < steps; ++i) players[k].step();
    }
    for (int repeat = 0; repeat < contest.repeats(); ++repeat)
        for (Player& player : players) {
            if (player.gained) player.gained(); // before
            const double start = wall_seconds();
            for (int i = 0; i < steps; ++i) player.step();
            const double used = wall_seconds() - start - (player.gained ? player.gained() : 0);
            player.times.push_back(1e9 * used / steps / n);
        }
    std::printf("\n%s, n = %d, smallest of %d repeats in turn\n", scene.c_str(), n, contest.repeats());
    double serial = 0;
    for (Player& player : players) {
        std::sort(player.times.begin(), player.times.end());
        const double best = player.times.front();
        if (serial == 0) serial = best;
        std::printf("  %-20s %10.3f ns a body   %.2f times as fast\n", player.name.c_str(), best, serial / best);
        contest.note(scene, n, "ansatz " + player.name, best, "ns a body",
                     player.times[player.times.size() / 2] / best - 1);
    }
    std::fflush(stdout);
}

/// How many threads are tried.
std::vector<int> counts() {
    const int cores = Threads().threads();
    std::vector<int> all{2};
    if (cores > 2) all.push_back(cores);
    return all;
}
/// s, until another thread has begun with what it is handed, the least of many times; a hundredth of a second where
/// there is no other one.
double time_to_wake() {
    const Threads two(2);
    double least = 0.01;
    for (int repeat = 0; repeat < 2000; ++repeat) {
        std::atomic<int> begun = 0;
        const double start = wall_seconds();
        two.execute(2, 1, [&](std::size_t, std::size_t) { // each waits for the other
            for (++begun; begun < 2 && wall_seconds() - start < 0.01;) {
            }
        });
        if (begun == 2) least = std::min(least, wall_seconds() - start);
    }
    return least;
}
/// Of how many cores one wants to know.
constexpr int rehearsed[] = {2, 8, 64};
std::string name_of_rehearsed(int cores) { return "rehearsed, " + std::to_string(cores) + " cores"; }

/// A scene whose worlds must come to the same bits.
/// \return whether they do
template <class Make> bool play_world(Contest& contest, const std::string& scene, int n, const Make& make) {
    std::vector<Player> players;
    std::vector<std::function<std::uint64_t()>> hashes;
    const auto add = [&](const std::string& name, auto made) {
        const auto world = std::make_shared<decltype(made)>(std::move(made));
        players.push_back({name, [world] { world->step(1.0 / 60 * second); }});
        hashes.push_back([world] { return world->hash(); });
    };
    add("serial", make(n));
    for (const int threads : counts()) add(std::to_string(threads) + " threads", make(n, Threads{threads}));
    for (const int cores : rehearsed) {
        const Rehearsal by(cores, time_to_wake());
        const auto world = std::make_shared<decltype(make(n, by))>(make(n, by));
        players.push_back(
            {name_of_rehearsed(cores), [world] { world->step(1.0 / 60 * second); }, [by] { return by.take_gained(); }});
        hashes.push_back([world] { return world->hash(); });
    }
    play(contest, scene, n, std::move(players));
    for (const auto& hash : hashes)
        if (hash() != hashes.front()()) {
            std::printf("%s: other bits with threads than without\n", scene.c_str());
            return false;
        }
    return true;
}

} // namespace

/// usage: peers_threads <folder for threads.json> [repeats]
int main(int argc, char** argv) {
    const std::string folder = argc > 1 ? argv[1] : ".";
    Contest contest("threads", argc > 2 ? std::max(1, std::atoi(argv[2])) : 15, "time on the wall");
    bool same = true;
    const auto world = [&](const char* scene, int n, const auto& make) {
        same = play_world(contest, scene, n, make) && same;
    };
    world("free flight, RungeKutta4 with drag", 100000, [](int n, auto... by) { return peers::flight(n, by...); });
    for (const int n : {100 * 100, 300 * 300})
        world("sheet of springs", n, [](int m, auto... by) { return sheet(m, by...); });
    {
        const auto search = std::make_shared<Search>(100000);
        std::vector<Player> players{{"serial", [search] { search->serial(); }}};
        for (const int threads : counts())
            players.push_back(
                {std::to_string(threads) + " threads", [search, by = Threads(threads)] { search->divided(by); }});
        for (const int cores : rehearsed) {
            const Rehearsal by(cores, time_to_wake());
            players.push_back(
                {name_of_rehearsed(cores), [search, by] { search->divided(by); }, [by] { return by.take_gained(); }});
        }
        play(contest, "pairs of spheres by UniformGrid", 100000, std::move(players));
    }
    world("spheres that meet, UniformGrid and Impulse", 100000, [](int n, auto... by) { return gas(n, by...); });
    world("settled pile, Coherent and coloured SoftSubsteps", 8000, [](int n, auto... by) { return pile(n, by...); });
    if (!same) return 1;
    contest.write(folder);
    return 0;
}

#endif
