// SPDX-License-Identifier: BSL-1.0
// The step: what acts where, that its two ways of running are one, and the smallest and largest steps.

#include <ansatz/world/step.hpp>

#include "tests/catch.hpp"
#include "tests/world/same_motion.hpp"

using namespace ansatz;
using namespace ansatz::test;

TEMPLATE_TEST_CASE(
    "a force between bodies that is nothing changes nothing, to the bit: both ways to run a step are one",
    "[world][step][N1]", ExplicitEuler, VelocityVerlet, Verlet, RungeKutta4) {
    using I = TestType;
    CHECK(
        same_motion(World{I{}, spring, QuadraticDrag{}, Drag{0.3 / second}, StopBelow{}, Interpolation{}},
                    World{I{}, spring, QuadraticDrag{}, Drag{0.3 / second}, StopBelow{}, Interpolation{}, Nothing{}}));
}

TEST_CASE("bodies that attract each other with a constant of zero move as if they did not", "[world][step][N1]") {
    CHECK(same_motion(World{Verlet{}, spring, Keep<InverseMass>{}},
                      World{Verlet{}, spring, Attraction{0.0 * (cubic_metre / (kilogram * second * second))}}));
}

namespace {

/// Writes down in which order, and on what, effects act.
template <Place At> struct Note {
    using role = roles::Effect;
    using reads = Columns<Position>;
    using writes = Columns<Heat>;
    static constexpr Place place = At;
    template <class S> struct In {
        explicit In(const Note&) {}
        void apply(typename S::Energy& heat, const typename S::Position& x, const auto&) const {
            // A digit for the place, and whether the body has been moved already (it begins at 0).
            const double digit = 1 + 2 * int(At) + (x.value()[0] != 0);
            heat = S::Energy::from_value(10 * heat.value() + typename S::Scalar(digit));
        }
    };
};

} // namespace

TEMPLATE_TEST_CASE("effects act at the place that they name, in whatever order they are listed", "[world][step]",
                   SemiImplicitEuler, Verlet, ImplicitEuler) {
    using I = TestType;
    auto digits = [](auto world) {
        const auto body = world.add(velocity(metres_per_second(1, 0, 0)));
        world.step(1.0 / 60 * second);
        return world.template read<Heat>(body).value();
    };
    // 1: before the forces, not moved; 4: after the integration, moved; 6: at the end, moved.
    CHECK(digits(World{I{}, Note<Place::before_forces>{}, Note<Place::after_integration>{},
                       Note<Place::end_of_step>{}}) == 146);
    CHECK(digits(World{Note<Place::end_of_step>{}, Note<Place::after_integration>{}, I{},
                       Note<Place::before_forces>{}}) == 146);
}

TEST_CASE("the stages of a step that couples are between the same effects", "[world][step]") {
    World world{RungeKutta4{}, Nothing{}, Note<Place::end_of_step>{}, Note<Place::before_forces>{},
                Note<Place::after_integration>{}};
    const auto body = world.add(velocity(metres_per_second(1, 0, 0)), mass(1.0 * kilogram));
    const auto ground = world.add(fixed);
    world.step(1.0 / 60 * second);
    CHECK(world.read<Heat>(body).value() == 146);
    CHECK(world.read<Heat>(ground).value() == 0);
}

namespace {
/// Says into how many substeps a step is to be divided, whatever that is.
struct Parts {
    using role = roles::StepControl;
    struct Kept {};
    int number = 1;
    int parts(const auto&, const Quantity<unit::Time>&, Kept&) const { return number; }
};
} // namespace

TEST_CASE("a number of substeps that is none, or substeps too short to be steps, are refused before anything moves",
          "[world][step]") {
    World world{Space<float, 2>{}, SemiImplicitEuler{}, Gravity{}, Parts{}};
    const auto body = world.add();
    const auto before = world.hash();
    for (const int wrong : {0, -2}) {
        world.set(Parts{wrong});
        CHECK_THROWS_WITH(world.step(0.1 * second), Catch::Contains("World::step") &&
                                                        Catch::Contains("is " + std::to_string(wrong)) &&
                                                        Catch::Contains("at least 1"));
    }
    world.set(Parts{4});
    CHECK_THROWS_WITH(world.step(2e-31 * second), Catch::Contains("World::step") && Catch::Contains("at least"));
    CHECK(!world.status().lost);
    CHECK(world.hash() == before);
    world.set(Parts{1});
    world.step(2e-31 * second); // in one part it is none too short
    world.set(Parts{4});
    world.step(0.1 * second);
    CHECK(world.velocity(body).value()[1] < 0);
}
