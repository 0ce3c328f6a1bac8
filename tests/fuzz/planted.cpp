// SPDX-License-Identifier: BSL-1.0
// Compiled alone: one of its faults is planted at a time, for the whole program.
// The fuzzer finds what it is for: each fault that is planted here (planted.hpp), of kinds that have been in worlds, is
// found within its minute and shrunk to a program of less than 30 lines.
// Runs long with the sanitizers.

#include "tests/fuzz/planted.hpp"
#include "tests/fuzz/hunt.hpp"
#include "tests/fuzz/pasted.hpp"
#include "tests/fuzz/subject_of.hpp"

#include <nlohmann/json.hpp>

#include <iostream>
#include <memory>
#include <string>

namespace {

/// While it is there, a fault is.
struct Planted {
    explicit Planted(fuzz::Plant plant) { fuzz::planted = plant; }
    Planted(const Planted&) = delete;
    Planted& operator=(const Planted&) = delete;
    ~Planted() { fuzz::planted = fuzz::Plant::nothing; }
};

/// One type for both, so that the compiler makes one world: where nothing falls there is gravity of nothing.
std::unique_ptr<fuzz::Subject> faulty_subject(bool falls = false) {
    const double gravity = falls ? -10 : 0;
    const auto text = [&](const std::string& either) {
        return "SemiImplicitEuler{}, Gravity{metres_per_second_squared(0, " + std::string(falls ? "-10" : "0") +
               ", 0)}, fuzz::Either<fuzz::ShortSighted>{" + either +
               "}, Narrowphase<Sphere, Plane, Box>{}, fuzz::Bouncing{}, fuzz::Dozing{}, Keep<InverseMass>{}, "
               "Datum<int>{}";
    };
    return fuzz::subject({.type = "fuzz::Faulty",
                          .text = text(""),
                          .other = text("{}, true"),
                          .falls = falls,
                          .closed = !falls,
                          .settles = falls,
                          .stays = true,
                          .keeps_energy = !falls,
                          .bounded = true},
                         [gravity](bool every_pair) { return fuzz::faulty(gravity, every_pair); });
}

void check_found(fuzz::Plant plant, const std::string& law, bool falls = false) {
    const Planted now(plant);
    const double begin = fuzz::processor_time();
    const auto subject = faulty_subject(falls);
    const auto hunt = fuzz::hunt(*subject, 1, 60);
    REQUIRE(hunt.found);
    std::cout << hunt.found->program << "in scene " << hunt.scenes << ", " << hunt.found->lines << " lines, "
              << fuzz::processor_time() - begin << " s\n\n";
    CHECK(hunt.found->law == law);
    CHECK(hunt.found->lines < 30);
}

} // namespace

TEST_CASE("a planted fault is found and shrunk: a slot that is stale after waking", "[fuzz]") {
    check_found(fuzz::Plant::stale_slot, "a verb touches nobody else");
}
TEST_CASE("a planted fault is found and shrunk: energy that is given back twice", "[fuzz]") {
    check_found(fuzz::Plant::energy_twice, "V3: no energy from nothing");
}
TEST_CASE("a planted fault is found and shrunk: a hash that leaves a number out", "[fuzz]") {
    check_found(fuzz::Plant::forgotten_number, "every number counts in the hash");
}
TEST_CASE("a planted fault is found and shrunk: a pair that is not seen", "[fuzz]") {
    check_found(fuzz::Plant::missed_pair, "another broadphase: the same bits");
}
TEST_CASE("a planted fault is found and shrunk: a push that is none for one of two", "[fuzz]") {
    check_found(fuzz::Plant::uneven_push, "momentum is kept");
}
TEST_CASE("a planted fault is found and shrunk: a verb that is refused when it has begun", "[fuzz]") {
    check_found(fuzz::Plant::half_changed, "a refusal changes nothing");
}
TEST_CASE("a planted fault is found and shrunk: a copy that leaves a number out", "[fuzz]") {
    check_found(fuzz::Plant::poor_copy, "a copy continues to the bit");
}
TEST_CASE("a planted fault is found and shrunk: a step that takes memory", "[fuzz]") {
    check_found(fuzz::Plant::lasting_garbage, "a warm step does not allocate");
}
TEST_CASE("a planted fault is found and shrunk: a copy with too little room", "[fuzz]") {
    check_found(fuzz::Plant::little_room, "a verb that finds no memory changes nothing");
}
TEST_CASE("a planted fault is found and shrunk: a sleeper in the air", "[fuzz]") {
    check_found(fuzz::Plant::early_sleep, "no sleeper is without support", true);
}
TEST_CASE("without a fault nothing is found in the world of the faults", "[fuzz]") {
    for (const bool falls : {false, true}) {
        const auto subject = faulty_subject(falls);
        const auto hunt = fuzz::hunt(*subject, 1, 1);
        INFO((hunt.found ? hunt.found->program : ""));
        CHECK_FALSE(hunt.found);
    }
}

// What was printed, pasted and laid out, with the fault beside it: each compiles, and what its last line says does not
// hold.
TEST_CASE("a verb touches no other body (seed 9)", "[fuzz]") {
    const Planted now(fuzz::Plant::stale_slot);
    fuzz::Faulty world{SemiImplicitEuler{},
                       Gravity{metres_per_second_squared(0, 0, 0)},
                       fuzz::Either<fuzz::ShortSighted>{},
                       Narrowphase<Sphere, Plane, Box>{},
                       fuzz::Bouncing{},
                       fuzz::Dozing{},
                       Keep<InverseMass>{},
                       Datum<int>{}};
    const auto b3 = world.add(Sphere{0.5 * metre}, position(metres(0, 0, 0)), velocity(metres_per_second(0, 0, 0)),
                              mass(1.0 * kilogram), restitution(0.0), datum(3));
    const auto b5 = world.add(Sphere{0.5 * metre}, position(metres(0, 0, 0)), velocity(metres_per_second(0, 0, 0)),
                              mass(1.0 * kilogram), restitution(0.0), datum(5));
    world.step(1.0 * second);
    const auto before = world;
    world.set_velocity(b3, metres_per_second(0, 0, 1));
    CHECK_FALSE(world.velocity(b5) == before.velocity(b5));
}
TEST_CASE("V3: no energy from nothing (seed 10)", "[fuzz]") {
    const Planted now(fuzz::Plant::energy_twice);
    fuzz::Faulty world{SemiImplicitEuler{},
                       Gravity{metres_per_second_squared(0, 0, 0)},
                       fuzz::Either<fuzz::ShortSighted>{},
                       Narrowphase<Sphere, Plane, Box>{},
                       fuzz::Bouncing{},
                       fuzz::Dozing{},
                       Keep<InverseMass>{},
                       Datum<int>{}};
    world.add(Plane{Eigen::Vector3d(0, 1, 0), -0.0 * metre}, fixed, datum(0));
    world.add(Sphere{0.5 * metre}, position(metres(0, 0, 0)), velocity(metres_per_second(0, -1, 0)),
              mass(1.0 * kilogram), restitution(1.0), datum(1));
    const auto before = world;
    world.step(1.0 * second);
    CHECK_FALSE(kinetic_energy(world).value() <= kinetic_energy(before).value() + 5e-13);
}
TEST_CASE("every number counts in the hash (seed 1)", "[fuzz]") {
    const Planted now(fuzz::Plant::forgotten_number);
    fuzz::Faulty world{SemiImplicitEuler{},
                       Gravity{metres_per_second_squared(0, 0, 0)},
                       fuzz::Either<fuzz::ShortSighted>{},
                       Narrowphase<Sphere, Plane, Box>{},
                       fuzz::Bouncing{},
                       fuzz::Dozing{},
                       Keep<InverseMass>{},
                       Datum<int>{}};
    const auto b0 = world.add(shapeless, position(metres(0, 0, 0)), velocity(metres_per_second(0, 0, 0)),
                              mass(3.6 * kilogram), datum(0));
    const auto before = world;
    world.write<Restitution>(b0, Quantity<unit::Dimensionless>(0.5));
    CHECK_FALSE(world.hash() != before.hash());
}
TEST_CASE("a verb that finds no memory changes nothing (seed 1)", "[fuzz]") {
    const Planted now(fuzz::Plant::little_room);
    fuzz::Faulty world{SemiImplicitEuler{},
                       Gravity{metres_per_second_squared(0, 0, 0)},
                       fuzz::Either<fuzz::ShortSighted>{},
                       Narrowphase<Sphere, Plane, Box>{},
                       fuzz::Bouncing{},
                       fuzz::Dozing{},
                       Keep<InverseMass>{},
                       Datum<int>{}};
    CHECK_THROWS(world.add(shapeless, position(metres(0, 0, 0)), velocity(metres_per_second(0, 0, 0)),
                           mass(0.0 * kilogram), datum(0)));
    CHECK_FALSE(fuzz::is_whole_without_memory(world, [&](auto& w) {
        w.add(shapeless, position(metres(0, 0, 0)), velocity(metres_per_second(0, 0, 0)), mass(1.0 * kilogram),
              datum(1));
    }));
}
