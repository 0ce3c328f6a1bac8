// SPDX-License-Identifier: BSL-1.0
// Observers and systems see the tables that they declare: contacts, springs, what policies of a user's own keep.

#include <ansatz/world/seen_tables.hpp>

#include <ansatz/collision.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include "tests/catch.hpp"

#include <memory>
#include <vector>

using namespace ansatz;

namespace {

//! [drawing]
/// Draws what holds and what touches: a line for each spring, a cross for each contact.
struct Drawing {
    using role = roles::Observer;
    using reads = Columns<Position>;
    using sees = Types<Springs<>, Contacts>;

    struct Line {
        Eigen::Vector3d from, to;
    };
    std::shared_ptr<std::vector<Line>> lines = std::make_shared<std::vector<Line>>();
    std::shared_ptr<std::vector<Eigen::Vector3d>> crosses = std::make_shared<std::vector<Eigen::Vector3d>>();

    void observe(const auto& view) {
        lines->clear(), crosses->clear();
        const auto& springs = view.template table<Springs<>>();
        springs.for_each([&](std::uint32_t id, const auto& spring) {
            const bool hangs = spring.b == springs.no_body;
            const auto from = view.template get<Position>(view.slot_of_id(spring.a));
            const auto to = hangs ? springs.anchor(id) : view.template get<Position>(view.slot_of_id(spring.b));
            lines->push_back({from.value(), to.value()});
        });
        for (const auto& contact : view.template table<Contacts>()) crosses->push_back(contact.point.value());
    }
};
//! [drawing]

/// A thermometer, and a system that reads it: what it keeps is another policy's.
struct Weather {
    using role = roles::System;
    static constexpr std::string_view name = "Weather";
    template <class S> struct State {
        double wind = 2;
        static void fields(auto& self, auto&& field) { field("wind", self.wind); }
    };
};
struct Sail {
    using role = roles::System;
    template <class S> struct Blow {
        static constexpr Phase phase = phases::end;
        static constexpr std::string_view name = "sail";
        using sees = Types<Weather, Contacts>;
        using writes = Columns<Velocity>;
        explicit Blow(const Sail&) {}
        void run(auto& view, const auto& context) const {
            const double wind = view.template table<Weather>().wind;
            const auto touching = view.template table<Contacts>().size();
            for (std::size_t slot = 0; slot < view.end(Motion::awake); ++slot)
                if (touching == 0)
                    view.template set<Velocity>(slot, view.template get<Velocity>(slot) +
                                                          wind * context.dt() * metres_per_second_squared(1, 0, 0));
        }
    };
    template <class S> using systems = Types<Blow<S>>;
};

/// Sees nothing but bodies.
struct Blind {
    using role = roles::Observer;
};

} // namespace

TEST_CASE("an observer draws springs and contacts as the step left them", "[world][observer]") {
    Drawing drawing;
    World world{SemiImplicitEuler{},          Gravity{},        Springs<>{}, AllPairs{},
                Narrowphase<Sphere, Plane>{}, SoftSubsteps<>{}, drawing};
    world.add(Plane::ground(), fixed);
    const auto low = world.add(Sphere{0.5 * metre}, position(metres(0, 0.5, 0)), mass(1.0 * kilogram));
    const auto high = world.add(Sphere{0.5 * metre}, position(metres(0, 3, 0)), mass(1.0 * kilogram));
    world.add(Spring{low, high, 50.0 * newton_per_metre, 0.5 * newton_second_per_metre});
    const auto hung = world.add(Spring{high, metres(0, 5, 0), 50.0 * newton_per_metre, 0.5 * newton_second_per_metre});
    for (int i = 0; i < 20; ++i) {
        world.step(1.0 / 60 * second);
        REQUIRE(drawing.lines->size() == 2);
        CHECK((*drawing.lines)[0].from == world.position(low).value());
        CHECK((*drawing.lines)[0].to == world.position(high).value());
        CHECK((*drawing.lines)[1].to == Eigen::Vector3d(0, 5, 0));
        REQUIRE(drawing.crosses->size() == world.contacts().size());
        for (std::size_t k = 0; k < drawing.crosses->size(); ++k)
            CHECK((*drawing.crosses)[k] == world.contacts()[k].point.value());
    }
    CHECK(drawing.crosses->size() == 1); // it lies on the ground
    world.remove(hung);
    world.step(1.0 / 60 * second);
    CHECK(drawing.lines->size() == 1);
    // From outside, too.
    CHECK(world.view<Drawing>().table<Contacts>().size() == world.contacts().size());
}

TEST_CASE("a system reads what another policy keeps, and what a module found", "[world][systems]") {
    World world{SemiImplicitEuler{}, Weather{}, Sail{}, AllPairs{}, Narrowphase<Sphere>{}, Impulse<>{}};
    const auto ball = world.add(Sphere{0.5 * metre}, velocity(metres_per_second(0, 1, 0)), mass(1.0 * kilogram));
    for (int i = 0; i < 10; ++i) world.step(0.1 * second);
    CHECK(world.velocity(ball).value()[0] == Catch::Approx(2));
    world.add(Sphere{0.5 * metre}, position(world.position(ball)), fixed); // from now on it touches
    const auto before = world.velocity(ball).value()[0];
    world.step(0.1 * second);
    REQUIRE(world.contacts().size() == 1);
    CHECK(world.velocity(ball).value()[0] <= before);
}

TEST_CASE("what is not seen takes no room in a view", "[world][observer]") {
    using S = Space<>;
    STATIC_REQUIRE(sizeof(ObserverView<S, Drawing>) >= sizeof(ObserverView<S, Blind>) + 2 * sizeof(void*));
    STATIC_REQUIRE(std::is_empty_v<SeenTables<S, Types<>>>);
}
