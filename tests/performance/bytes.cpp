// SPDX-License-Identifier: BSL-1.0
// Bytes per body by composition. The expected figures are lanes counted by hand; what a world says of itself
// (`bytes_per_body`) and what it takes from the heap, counted below its back, must both be that.

#include <ansatz/world.hpp>

#include <cstddef>
#include <string>

#include "tests/catch.hpp"
#include "tests/operator_new.hpp"

namespace {

std::size_t bytes_taken = 0; // from the heap, since the program began
std::size_t allocations = 0;
[[maybe_unused]] const bool counted = [] {
    ansatz::test::before_allocation = [](std::size_t bytes) noexcept {
        bytes_taken += bytes;
        return ++allocations > 0;
    };
    return true;
}();

} // namespace

using namespace ansatz;

namespace {

// What a world knows of a body beside its lanes.
constexpr std::size_t handles = 4 * 4;                // id by slot, slot by id, generation, list of free ids
constexpr std::size_t start_of_history = 1 + 4;       // Verlet: does it wait for its first step, and who does
constexpr std::size_t events = 2 * 3 * sizeof(Event); // Rest: two buffers of what may happen to a body in a step

/// The bytes that a world takes from the heap for each body when it is told how many there will be. Lanes end at
/// different places of a page, which is less than a byte a body here and rounded away.
template <class W> std::size_t taken_per_body(W world) {
    constexpr std::size_t bodies = 200'000;
    const std::size_t before = bytes_taken;
    world.reserve(bodies); // of an empty world: nothing is given back meanwhile
    return (bytes_taken - before) / bodies;
}

template <class W> void costs(const std::string& what, const W& world, std::size_t lanes, std::size_t beside) {
    INFO(what);
    CHECK(W::bytes_per_body == lanes * sizeof(typename W::Scalar));
    CHECK(taken_per_body(world) == lanes * sizeof(typename W::Scalar) + beside);
}

/// Nothing in it, not even bytes.
struct Idle {
    using role = roles::Effect;
    using writes = Columns<Velocity>;
    static constexpr Place place = Place::after_integration;
    template <class S> struct In {
        explicit In(const Idle&) {}
        [[gnu::always_inline]] void apply(auto&, const auto&) const {}
    };
};

} // namespace

TEST_CASE("A world stores the columns that its policies name, and nothing else") {
    // position and velocity: two vectors
    costs("free flight, double, 3-D", World{SemiImplicitEuler{}}, 3 + 3, handles);
    costs("free flight, double, 2-D", World{Space<double, 2>{}, SemiImplicitEuler{}}, 2 + 2, handles);
    costs("free flight, float, 3-D", World{Space<float, 3>{}, SemiImplicitEuler{}}, 3 + 3, handles);
    costs("free flight, float, 2-D", World{Space<float, 2>{}, SemiImplicitEuler{}}, 2 + 2, handles);
    // gravity accelerates every mass alike, damping multiplies: neither needs a column
    costs("fall", World{SemiImplicitEuler{}, Gravity{}}, 3 + 3, handles);
    costs("fall with drag", World{SemiImplicitEuler{}, Gravity{}, Drag{}}, 3 + 3, handles);
    costs("fall with the notes' drag and threshold", World{ExplicitEuler{}, Gravity{}, FrameDrag{}, StopBelow{}}, 3 + 3,
          handles);
    // a force needs the mass
    costs("fall in air, float", World{Space<float, 3>{}, SemiImplicitEuler{}, Gravity{}, QuadraticDrag{}}, 3 + 3 + 1,
          handles);
    costs("applied forces", World{SemiImplicitEuler{}, AppliedForces{}}, 3 + 3 + 1 + 3, handles);
    // the stages of an integrator are locals while nothing couples bodies
    costs("Runge-Kutta", World{RungeKutta4{}, Gravity{}}, 3 + 3, handles);
    costs("velocity Verlet", World{VelocityVerlet{}, Gravity{}}, 3 + 3, handles);
    costs("implicit Euler", World{ImplicitEuler{}, Gravity{}}, 3 + 3, handles);
    // position history stands in place of the velocity, also where an effect asks for the velocity
    costs("Verlet", World{Verlet{}, Gravity{}}, 3 + 3, handles + start_of_history);
    costs("Verlet with drag", World{Verlet{}, Gravity{}, Drag{}}, 3 + 3, handles + start_of_history);
    // how long a body has been slow
    costs("rest, float, 2-D", World{Space<float, 2>{}, SemiImplicitEuler{}, Rest{}}, 2 + 2 + 1, handles + events);
    // a force between bodies: mass, the sum of the forces, and what a stage leaves for the next
    costs("attraction", World{SemiImplicitEuler{}, Attraction{}}, 3 + 3 + 1 + 3, handles);
    costs("attraction, velocity Verlet", World{VelocityVerlet{}, Attraction{}}, 3 + 3 + 1 + 3 + 3, handles);
    costs("attraction, Runge-Kutta", World{RungeKutta4{}, Attraction{}}, 3 + 3 + 1 + 3 + 4 * 3, handles);
    // and, where the velocity is derived, the sums before a change through the door
    costs("attraction, Verlet", World{Verlet{}, Attraction{}}, 3 + 3 + 1 + 3,
          handles + start_of_history + 3 * sizeof(double));
    // what a user asks for
    costs("masses kept", World{SemiImplicitEuler{}, Gravity{}, Keep<InverseMass>{}}, 3 + 3 + 1, handles);
    costs("a datum of the user's", World{SemiImplicitEuler{}, Gravity{}, Datum<double>{}}, 3 + 3,
          handles + sizeof(double));
    costs("interpolation", World{SemiImplicitEuler{}, Gravity{}, Interpolation{}}, 3 + 3 + 3, handles);
}

TEST_CASE("The order of the policies does not change what a body costs") {
    STATIC_REQUIRE(World<Rest, QuadraticDrag, SemiImplicitEuler, Gravity>::bytes_per_body ==
                   World<SemiImplicitEuler, Gravity, QuadraticDrag, Rest>::bytes_per_body);
}

TEST_CASE("What is not in a world is not in its size either", "[performance][N2]") {
    // A policy without parameters has no byte (hard case N2).
    STATIC_REQUIRE(sizeof(World<SemiImplicitEuler, Gravity, Idle>) == sizeof(World<SemiImplicitEuler, Gravity>));
    STATIC_REQUIRE(sizeof(World<SemiImplicitEuler, Gravity, Keep<Position>>) ==
                   sizeof(World<SemiImplicitEuler, Gravity>));
    STATIC_REQUIRE(sizeof(World<RungeKutta4, Gravity>) == sizeof(World<SemiImplicitEuler, Gravity>));
    // Gravity costs its vector twice, as given and as bound; drag its rate twice, the factor of the step, and a gap
    // before them.
    STATIC_REQUIRE(sizeof(World<SemiImplicitEuler, Gravity>) - sizeof(World<SemiImplicitEuler>) <= 2 * sizeof(Gravity));
    STATIC_REQUIRE(sizeof(World<SemiImplicitEuler, Drag>) - sizeof(World<SemiImplicitEuler>) <= 4 * sizeof(double));
    // The buffers of events, and the list of bodies that wait for the start of their history, stand only where they
    // have a use.
    STATIC_REQUIRE(sizeof(World<SemiImplicitEuler, Rest>) >= sizeof(World<SemiImplicitEuler>) + sizeof(Events));
    STATIC_REQUIRE(sizeof(World<Verlet>) >= sizeof(World<SemiImplicitEuler>) + sizeof(detail::Starts));
    // The empty world: the directory of the bodies, the lanes, the clock, and five words more; one of them says whether
    // a step was broken off.
    STATIC_REQUIRE(sizeof(World<SemiImplicitEuler>) <= sizeof(Bodies) +
                                                           sizeof(Lanes<Space<>, Columns<Position, Velocity>>) +
                                                           sizeof(StepClock<Space<>>) + 5 * sizeof(void*));
}

TEST_CASE("A world that knows how many bodies there will be takes its memory once") {
    World world{SemiImplicitEuler{}, Gravity{}, QuadraticDrag{}, Rest{}};
    world.reserve(1000);
    const std::size_t before = allocations;
    for (int i = 0; i < 1000; ++i) world.add(position(metres(i, 0, 0)), mass(1.0 * kilogram));
    for (int i = 0; i < 10; ++i) world.step(0.01 * second);
    const std::size_t after = allocations; // the macro below allocates
    CHECK(after - before == 0);
}
