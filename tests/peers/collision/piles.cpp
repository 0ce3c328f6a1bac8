// SPDX-License-Identifier: BSL-1.0
// Whole steps: a thousand spheres and more, dropped into a box, by this library and by ODE and Bullet.

#include "tests/peers/collision/pile.hpp"
#include "tests/peers/contest.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/motion.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

using namespace ansatz;
using peers::Contest;
using peers::Depths;
using peers::Pile;
using peers::PileOf;

namespace {

/// \tparam Broadphase with which pairs are found
/// \tparam Response   with which contacts are answered
template <class S, class Broadphase, class Response> class OurPile : public PileOf {
public:
    explicit OurPile(const Pile& pile) {
        const double half = pile.half_side;
        for (const Eigen::Vector3d& inwards :
             {Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(-1, 0, 0), Eigen::Vector3d(0, 0, 1),
              Eigen::Vector3d(0, 0, -1)})
            world_.add(Plane{inwards, (inwards.y() > 0 ? 0.0 : -half) * metre}, fixed);
        for (const auto& x : pile.start)
            spheres_.push_back(world_.add(Sphere{Pile::radius * metre}, position(metres(x[0], x[1], x[2])),
                                          mass(Pile::mass * kilogram)));
    }
    void step() override { world_.step(Pile::dt * second); }
    std::array<double, 3> at(std::size_t i) const override {
        const auto x = world_.position(spheres_[i]).value();
        return {double(x[0]), double(x[1]), double(x[2])};
    }

private:
    World<S, SemiImplicitEuler, Gravity, Broadphase, Narrowphase<Sphere, Plane>, Response> world_{
        S{}, SemiImplicitEuler{}, Gravity{}, Broadphase{}, Narrowphase<Sphere, Plane>{}, Response{}};
    std::vector<Handle> spheres_;
};

struct Player {
    std::string name;
    std::function<std::unique_ptr<PileOf>()> start;
    std::string remark;
    std::vector<double> first{}, settled{}, all{}; // ms a step, of each repeat
    Depths depths{};
    std::unique_ptr<PileOf> world{};
};

std::vector<Player> players(const Pile& pile) {
    std::vector<Player> all;
    using Kept = Coherent<UniformGrid<>>;
    all.push_back({"ansatz SoftSubsteps",
                   [&] { return std::make_unique<OurPile<Space<>, UniformGrid<>, SoftSubsteps<>>>(pile); },
                   "double; spheres do not turn"});
    all.push_back({"ansatz SoftSubsteps float",
                   [&] { return std::make_unique<OurPile<Space<float, 3>, UniformGrid<>, SoftSubsteps<>>>(pile); },
                   "float; spheres do not turn"});
    all.push_back({"ansatz SoftSubsteps<Coloured>",
                   [&] { return std::make_unique<OurPile<Space<>, Kept, SoftSubsteps<Coloured>>>(pile); },
                   "double, Coherent<UniformGrid>; spheres do not turn"});
    all.push_back({"ansatz SoftSubsteps<Coloured> float",
                   [&] { return std::make_unique<OurPile<Space<float, 3>, Kept, SoftSubsteps<Coloured>>>(pile); },
                   "float, Coherent<UniformGrid>; spheres do not turn"});
#ifdef ANSATZ_PEER_ODE
    all.push_back({"ODE quick step", [&] { return peers::ode_pile(pile); },
                   "double; 20 passes; keeps turning and its inertia, too"});
#endif
#ifdef ANSATZ_PEER_BULLET_PILE
    all.push_back({"Bullet discrete world", [&] { return peers::bullet_pile(pile); },
                   "float; 10 passes; keeps turning and its inertia, too"});
#endif
    return all;
}

/// Everybody's worlds stand side by side, and each takes a few steps in turn.
void drop_once(std::vector<Player>& players, const Pile& pile) {
    constexpr int steps = 20, first = 5, blocks = 20, settled = 5; // 400 steps: the first 100, and the last 100
    for (Player& p : players) {
        p.world = p.start();
        p.first.push_back(0), p.settled.push_back(1e300), p.all.push_back(0);
    }
    for (int block = 0; block < blocks; ++block)
        for (Player& p : players) {
            const double start = Contest::thread_seconds();
            for (int k = 0; k < steps; ++k) p.world->step();
            const double ms = 1e3 * (Contest::thread_seconds() - start) / steps;
            p.all.back() += ms / blocks;
            if (block < first) p.first.back() += ms / first;
            if (block >= blocks - settled) p.settled.back() = std::min(p.settled.back(), ms);
        }
    for (Player& p : players) {
        p.depths = Depths::of(pile, *p.world);
        p.world.reset();
    }
}

} // namespace

void peers::play_piles(Contest& contest, int n) {
    const Pile pile = Pile::of(n);
    std::vector<Player> all = players(pile);
    const int repeats = std::clamp(contest.repeats() / (n / 500), 1, 5);
    for (int k = 0; k < repeats; ++k) drop_once(all, pile);
    std::printf("\n%d frictionless spheres dropped into a box, 400 steps of 1/60 s, smallest of %d repeats in turn\n",
                n, repeats);
    std::printf("  %-28s %10s %10s %10s   %10s %10s\n", "ms a step", "first 100", "settled", "all 400", "mean depth",
                "deepest");
    for (Player& p : all) {
        auto note = [&](const std::string& what, std::vector<double>& times) {
            std::sort(times.begin(), times.end());
            contest.note("spheres dropped into a box, " + what, n, p.name, times.front(), "ms a step",
                         times[times.size() / 2] / times.front() - 1);
            return times.front();
        };
        const double first = note("first 100 steps", p.first), settled = note("settled", p.settled),
                     whole = note("all 400 steps", p.all);
        std::printf("  %-28s %10.3f %10.3f %10.3f   %7.2f mm %7.2f mm  %s\n", p.name.c_str(), first, settled, whole,
                    1e3 * p.depths.mean, 1e3 * p.depths.largest, p.remark.c_str());
        contest.note("spheres dropped into a box, mean depth", n, p.name, p.depths.mean, "m");
        contest.note("spheres dropped into a box, largest depth", n, p.name, p.depths.largest, "m");
    }
    std::fflush(stdout);
}
