// SPDX-License-Identifier: BSL-1.0
// Systems that change what another policy keeps, and that divide bodies, at the place of the step where springs break.

#include <ansatz/world/edited_elements.hpp>

#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>
#include <ansatz/world/save.hpp>

#include "tests/catch.hpp"

#include <random>
#include <sstream>

using namespace ansatz;

namespace {

//! [moth]
/// Eats every spring that is longer than its mouth, whichever policy keeps it.
struct Moth {
    using role = roles::System;
    Parameter<unit::Length> mouth = 1.5 * metre;

    template <class S> struct Eat {
        static constexpr Phase phase = between(phases::breaking, phases::sums);
        static constexpr std::string_view name = "moth";
        using edits = Types<Spring, Rope>;
        using reads = Columns<Position>;
        typename S::Length mouth;
        explicit Eat(const Moth& moth) : mouth(S::convert(moth.mouth)) {}

        void run(auto& view, const auto&) const {
            const auto eat = [&](auto& springs) {
                if constexpr (requires { springs.size(); }) // this world has some
                    springs.for_each([&](std::uint32_t id, const auto& link) {
                        const auto along = view.template get<Position>(view.slot_of_id(link.b)) -
                                           view.template get<Position>(view.slot_of_id(link.a));
                        if (norm(along) > mouth) springs.erase(id);
                    });
            };
            eat(view.template edit<Spring>());
            eat(view.template edit<Rope>());
        }
    };
    template <class S> using systems = Types<Eat<S>>;
};
//! [moth]

/// Divides the body of id 0 in every step, so often.
struct Amoeba {
    using role = roles::System;
    static constexpr std::string_view name = "Amoeba";
    int times = 4;
    template <class S> struct State {
        int done = 0;
        static void fields(auto& self, auto&& field) { field("done", self.done); }
        std::size_t bodies_to_come(const Amoeba& amoeba) const { return std::size_t(amoeba.times - done); }
    };
    template <class S> struct Divide {
        static constexpr Phase phase = between(phases::breaking, phases::sums);
        static constexpr std::string_view name = "amoeba";
        int times;
        explicit Divide(const Amoeba& amoeba) : times(amoeba.times) {}
        void run(auto& view, const auto&) const {
            if (view.state().done == times) return;
            ++view.state().done;
            view.divide(0, typename S::Scalar(0.25));
        }
    };
    template <class S> using systems = Types<Divide<S>>;
};

template <class World_> Eigen::Vector3d momentum(const World_& world) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Handle h : world.handles())
        if (world.motion(h) == Motion::awake) sum += world.mass(h).value() * world.velocity(h).value();
    return sum;
}
/// A chain of `n` bodies between two fixed ones, all in motion.
template <class World_> std::vector<Handle> chain(World_& world, int n) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> number(-1, 1);
    std::vector<Handle> all;
    for (int i = 0; i < n; ++i) {
        all.push_back(world.add(position(metres(i, number(random), 0)), mass((2 + number(random)) * kilogram),
                                velocity(metres_per_second(number(random), number(random), number(random)))));
        if (i > 0) world.add(Spring{all[std::size_t(i) - 1], all[std::size_t(i)], 50.0 * newton_per_metre});
    }
    all.push_back(world.add(position(metres(n, 0, 0)), fixed));
    world.add(Spring{all[std::size_t(n) - 1], all[std::size_t(n)], 50.0 * newton_per_metre});
    return all;
}

} // namespace

TEMPLATE_TEST_CASE("What a system takes out of another's table is gone, and no body is pushed by it", "[world]",
                   SemiImplicitEuler, VelocityVerlet, Verlet) {
    World world{TestType{}, Gravity{}, Springs<>{}, Moth{}};
    const auto all = chain(world, 6);
    world.set(Moth{100.0 * metre});
    for (int i = 0; i < 3; ++i) world.step(0.01 * second);
    CHECK(world.template elements<Spring>().size() == 6);
    auto other = world;
    world.set(Moth{1.2 * metre});
    world.step(0.01 * second);
    other.step(0.01 * second);
    std::size_t eaten = 0;
    other.template elements<Spring>().for_each([&](std::uint32_t id, const auto& link) {
        const auto along = other.position(all[link.b]) - other.position(all[link.a]);
        CHECK(world.template elements<Spring>().contains(other.template elements<Spring>().handle(id)) ==
              (norm(along) <= 1.2 * metre));
        eaten += norm(along) > 1.2 * metre;
    });
    CHECK(eaten > 1);
    CHECK(eaten < 6);
    for (const Handle h : all) {
        CHECK(world.position(h) == other.position(h));
        CHECK(norm(world.velocity(h) - other.velocity(h)).value() < 1e-12); // of a history to rounding
    }
}

TEMPLATE_TEST_CASE("A body that is divided within a step leaves mass, momentum, place and forces what they were",
                   "[world]", SemiImplicitEuler, Verlet) {
    World world{TestType{}, Gravity{}, Springs<>{}, AppliedForces{}, Amoeba{}};
    const auto all = chain(world, 4);
    auto whole = world;
    whole.set(Amoeba{0});
    world.set_velocity(all[0], metres_per_second(3, 2, 1)); // which a history waits for
    whole.set_velocity(all[0], metres_per_second(3, 2, 1));
    const double mass = world.mass(all[0]).value();
    for (int i = 1; i <= 4; ++i) {
        world.step(0.01 * second);
        whole.step(0.01 * second);
        CHECK(world.size() == 5 + std::size_t(i));
        CHECK(world.mass(all[0]).value() == Approx(mass * std::pow(0.75, i)).epsilon(1e-14));
        double sum = 0;
        for (const Handle h : world.handles())
            if (h.id == 0 || h.id > 4) sum += world.mass(h).value();
        CHECK(sum == Approx(mass).epsilon(1e-14));
        const Handle part{std::uint32_t(4 + i), 0};
        REQUIRE(world.contains(part));
        CHECK(world.motion(part) == Motion::awake);
        CHECK(world.position(part) == world.position(all[0]));
        CHECK(norm(world.velocity(part) - world.velocity(all[0])).value() < 1e-12);
        if (i == 1) CHECK((momentum(world) - momentum(whole)).norm() < 1e-12);
    }
    world.step(0.01 * second);
    CHECK(world.size() == 9);

    auto copy = world;
    std::stringstream file;
    save(world, file);
    World loaded{TestType{}, Gravity{}, Springs<>{}, AppliedForces{}, Amoeba{}};
    load(loaded, file);
    for (auto* one : {&world, &copy, &loaded}) {
        one->set(Amoeba{7});
        for (int i = 0; i < 5; ++i) one->step(0.01 * second);
    }
    CHECK(world.size() == 12);
    CHECK(copy.hash() == world.hash());
    CHECK(loaded.hash() == world.hash());
}
