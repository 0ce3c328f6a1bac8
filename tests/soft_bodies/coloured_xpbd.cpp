// SPDX-License-Identifier: BSL-1.0
// ColouredXpbd: the formula of Xpbd in the order of the colours, to the bit; what both come to in the end; what it
// keeps.

#include <ansatz/soft_bodies/coloured_xpbd.hpp>

#include "tests/soft_bodies/patches.hpp"
#include "tests/soft_bodies/solvers.hpp"

#include <ansatz/world/save.hpp>

#include <limits>
#include <random>
#include <sstream>

using namespace soft_bodies_tests;

namespace {

template <class Scalar> auto coloured(const ColouredXpbd& policy) {
    return World{Space<Scalar, 3>{}, SemiImplicitEuler{}, Springs<>{}, Ropes<>{}, policy};
}
/// A sheet of springs that are rougher than their numbers, with some ropes across it and velocities of its own.
template <class World_> std::vector<Handle> add_wild_sheet(World_& world, int n, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> push(-1, 1);
    auto all = lay_sheet(world, n, 1, 0, 0.1, 700, 0.3);
    for (int i = 0; i < 3 * n; ++i) {
        const auto a = random() % all.size(), b = random() % all.size();
        const double rest = 0.3 + 0.3 * push(random);
        if (a != b)
            world.add(Rope{all[a], all[b], 200.0 * newton_per_metre, 0.1 * newton_second_per_metre, rest * metre});
    }
    for (const Handle body : all) {
        const double x = push(random), y = push(random), z = push(random);
        world.set_velocity(body, metres_per_second(x, y, z));
    }
    world.add(Spring{all[0], metres(0, 1, 0), 100.0 * newton_per_metre});
    return all;
}

/// One spring after the other, colour by colour, by the formula of the header: no chunk, no vector unit.
template <class Scalar> class Plain {
public:
    using Vec = Eigen::Matrix<Scalar, 3, 1>;
    struct Link {
        std::uint32_t a, b;
        Scalar rest_length, stiffness, damping;
    };
    struct Network {
        bool pulls;
        std::vector<Link> all;
        std::vector<Scalar> multipliers{};
        const std::vector<Link>& pairs() const { return all; }
        static std::uint64_t arrangement() { return 1; }
    };
    std::vector<Vec> x, v;
    std::vector<Scalar> w;
    std::vector<Network> networks;

    void substep(Scalar h, int iterations) {
        for (std::size_t i = 0; i < x.size(); ++i) x[i] += v[i] * h;
        for (auto& network : networks) network.multipliers.assign(network.all.size(), Scalar(0));
        for (int n = 0; n < iterations; ++n)
            for (auto& network : networks) {
                SpringColours<Scalar> colours;
                colours.colour(network, x.size());
                for (std::size_t k = 0; k < colours.size(); ++k) hold(colours, k, network, h);
            }
    }

private:
    void hold(const SpringColours<Scalar>& s, std::size_t n, Network& network, Scalar h) {
        const auto a = s.a[n], b = s.b[n];
        const Vec to = x[b] - x[a], going = v[b] - v[a];
        const Scalar length = std::sqrt(to[0] * to[0] + to[1] * to[1] + to[2] * to[2]), per_length = 1 / length;
        const Scalar along = (to[0] * going[0] + to[1] * going[1] + to[2] * going[2]) * per_length;
        const Scalar by_value = h * h * s.stiffness[n], by_rate = h * s.damping[n], value = length - s.rest[n];
        const Scalar before = network.multipliers[n];
        Scalar next =
            before - (before + by_value * value + by_rate * (h * along)) / (1 + (by_value + by_rate) * (w[b] + w[a]));
        if (network.pulls && (next > 0 || (before == 0 && !(value > 0)))) next = 0;
        network.multipliers[n] = next;
        const Scalar by = (next - before) * per_length, rate = 1 / h;
        for (int k = 0; k < 3; ++k) {
            const Scalar way_a = (-w[a] * by) * to[k], way_b = (w[b] * by) * to[k];
            x[a][k] += way_a;
            v[a][k] += rate * way_a;
            x[b][k] += way_b;
            v[b][k] += rate * way_b;
        }
    }
};
template <class Scalar, class World_> Plain<Scalar> plain_of(const World_& world) {
    Plain<Scalar> plain;
    for (const Handle body : world.handles()) { // none was removed or sleeps: ids are slots
        plain.x.push_back(world.position(body).value());
        plain.v.push_back(world.velocity(body).value());
        plain.w.push_back(world.template lane<InverseMass>()[body.id]);
    }
    const auto take = [&](const auto& table, bool pulls) {
        plain.networks.push_back({pulls, {}});
        table.for_each([&](std::uint32_t, const auto& l) {
            if (l.b != table.no_body)
                plain.networks.back().all.push_back({l.a, l.b, l.rest_length, l.stiffness, l.damping});
        });
    };
    take(world.template elements<Spring>(), false);
    take(world.template elements<Rope>(), true);
    return plain;
}

} // namespace

TEMPLATE_TEST_CASE("Many springs at once are one after the other in the order of their colours, to the bit",
                   "[soft_bodies][colours]", double, float) {
    const auto [substeps, iterations] = GENERATE(std::pair{1, 1}, std::pair{4, 1}, std::pair{2, 3});
    auto world = coloured<TestType>(ColouredXpbd{substeps, iterations});
    const auto all = add_wild_sheet(world, 13, 5);
    const auto springs = world.template elements<Spring>().handles();
    world.remove(springs.back()); // the anchored one, which the plain model has not
    auto plain = plain_of<TestType>(world);
    for (int i = 0; i < 20; ++i) {
        world.step(frame);
        for (int s = 0; s < substeps; ++s) plain.substep(TestType(1.0 / 60) / TestType(substeps), iterations);
        for (const Handle body : all) {
            const auto x = world.position(body).value(), v = world.velocity(body).value();
            for (int k = 0; k < 3; ++k) {
                REQUIRE(x[k] == plain.x[body.id][k]);
                REQUIRE(v[k] == plain.v[body.id][k]);
            }
        }
    }
}

TEST_CASE("Iterated to the end it is Xpbd, where directions do not turn meanwhile", "[soft_bodies][colours]") {
    // In several dimensions the end depends on the way to it: each part of a multiplier moves along the spring as it
    // lies then.
    World by_one{SemiImplicitEuler{}, Springs<>{}, Ropes<>{}, Xpbd{1, 1}};
    auto many = coloured<double>(ColouredXpbd{1, 1});
    const auto add = [](auto& world) {
        const auto all = hang_chain(world, 20, 0.05, 500, 0.4);
        for (std::size_t i = 1; i < all.size(); ++i) {
            const double turn = double(i);
            world.set_velocity(all[i], metres_per_second(0, std::sin(turn), 0));
            if (i % 5 == 0) world.add(Rope{all[i], all[i - 4], 300.0 * newton_per_metre, {}, 0.39 * metre});
        }
        return all;
    };
    const auto all = add(by_one), same = add(many);
    const auto apart = [&](int iterations) {
        auto one = by_one;
        auto other = many;
        one.set(Xpbd{1, iterations});
        other.set(ColouredXpbd{1, iterations});
        double most = 0;
        for (int i = 0; i < 5; ++i) {
            one.step(frame);
            other.step(frame);
            for (std::size_t k = 0; k < all.size(); ++k)
                most = std::max(most, double(norm(one.position(all[k]) - other.position(same[k])).value()));
        }
        return most;
    };
    CHECK(apart(1) > 1e-4);
    CHECK(apart(2000) < 1e-12);
}

TEMPLATE_TEST_CASE("Held by colours a free sheet keeps its momentum", "[soft_bodies][colours]", double, float) {
    auto world = coloured<TestType>(ColouredXpbd{5, 2});
    add_wild_sheet(world, 8, 3);
    world.remove(world.template elements<Spring>().handles().back());
    const auto before = total_momentum(world).value();
    for (int i = 0; i < 200; ++i) world.step(frame);
    CHECK((total_momentum(world).value() - before).norm() < 64 * 400 * std::numeric_limits<TestType>::epsilon());
    CHECK(world.status().ok());
}

TEST_CASE("Ends in one place, ends too near and too far apart for squares, and ropes that hang",
          "[soft_bodies][colours]") {
    // Among springs that are none of this, in the same chunk.
    auto world = coloured<double>(ColouredXpbd{2, 2});
    World by_one{SemiImplicitEuler{}, Springs<>{}, Ropes<>{}, Xpbd{2, 2}};
    std::vector<Handle> all, same;
    const auto add = [&](double x, double rest) {
        for (const double at : {0., x}) {
            const auto down = position(metres(at, double(all.size() / 2), 0));
            all.push_back(world.add(down, mass(1.0 * kilogram)));
            same.push_back(by_one.add(down, mass(1.0 * kilogram)));
        }
        const auto n = all.size();
        world.add(Spring{all[n - 2], all[n - 1], 50.0 * newton_per_metre, 1.0 * newton_second_per_metre, rest * metre});
        by_one.add(
            Spring{same[n - 2], same[n - 1], 50.0 * newton_per_metre, 1.0 * newton_second_per_metre, rest * metre});
        world.add(
            Rope{all[n - 2], all[n - 1], 50.0 * newton_per_metre, 1.0 * newton_second_per_metre, 2 * rest * metre});
        by_one.add(
            Rope{same[n - 2], same[n - 1], 50.0 * newton_per_metre, 1.0 * newton_second_per_metre, 2 * rest * metre});
    };
    for (const double x : {1.2, 0., 1e-200, 1e200, 0.5, 3.}) add(x, 1);
    world.set_velocity(all[4], metres_per_second(1, 2, 3));
    by_one.set_velocity(same[4], metres_per_second(1, 2, 3));
    for (int i = 0; i < 5; ++i) {
        world.step(frame);
        by_one.step(frame);
        for (std::size_t k = 0; k < all.size(); ++k) { // no spring sees another's bodies: the order is the same
            const auto x = world.position(all[k]).value(), y = by_one.position(same[k]).value();
            CAPTURE(i, k);
            CHECK((x - y).norm() <= 1e-12 * (1 + y.norm()));
        }
    }
    CHECK(world.status().ok());
}

TEST_CASE("Copies, worlds from files and worlds that are assigned go on bit for bit under ColouredXpbd",
          "[soft_bodies][colours]") {
    auto world = coloured<double>(ColouredXpbd{3, 2});
    add_wild_sheet(world, 9, 6);
    for (int i = 0; i < 5; ++i) world.step(frame);
    const auto springs = world.elements<Spring>().handles();
    for (std::size_t n = 0; n < springs.size(); n += 7) world.remove(springs[n]);
    auto assigned = coloured<double>(ColouredXpbd{3, 2}); // has colours of another sheet, of as many springs
    add_wild_sheet(assigned, 9, 7);
    for (int i = 0; i < 5; ++i) assigned.step(frame);
    const auto others = assigned.elements<Spring>().handles();
    for (std::size_t n = 3; n < others.size(); n += 7) assigned.remove(others[n]);
    assigned.step(frame);
    auto copy = world;
    std::stringstream file;
    save(world, file);
    auto loaded = coloured<double>(ColouredXpbd{3, 2});
    load(loaded, file);
    assigned = world;
    for (int i = 0; i < 20; ++i) {
        for (auto* one : {&world, &copy, &loaded, &assigned}) one->step(frame);
        REQUIRE(copy.hash() == world.hash());
        REQUIRE(loaded.hash() == world.hash());
        REQUIRE(assigned.hash() == world.hash());
    }
}

TEST_CASE("What ColouredXpbd is told wrongly it refuses", "[soft_bodies][colours]") {
    auto world = coloured<double>(ColouredXpbd{});
    CHECK_THROWS_WITH(world.set(ColouredXpbd{0, 1}), Catch::Matchers::Contains("substeps is 0"));
    CHECK_THROWS_WITH(world.set(ColouredXpbd{1, -2}), Catch::Matchers::Contains("iterations is -2"));
}

TEST_CASE("A world that was moved from has no colours of the springs that it had", "[soft_bodies][colours]") {
    auto world = coloured<double>(ColouredXpbd{3, 2});
    add_wild_sheet(world, 9, 6);
    world.step(frame);
    const auto other = std::move(world);
    CHECK(other.elements<Spring>().size() > 0);
    world.step(frame); // NOLINT(bugprone-use-after-move): it is empty, and a world
    CHECK(world.size() == 0);
    auto fresh = coloured<double>(ColouredXpbd{3, 2});
    fresh.step(frame);
    for (auto* one : {&world, &fresh}) {
        add_wild_sheet(*one, 9, 6);
        for (int i = 0; i < 3; ++i) one->step(frame);
    }
    const auto lowest = [](auto& one) {
        double least = HUGE_VAL;
        one.for_each([&](Handle body) { least = std::min(least, one.position(body).value()[1]); });
        return least;
    };
    CHECK(lowest(world) == lowest(fresh));
}
