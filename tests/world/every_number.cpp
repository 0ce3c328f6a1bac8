// SPDX-License-Identifier: BSL-1.0
// Every number counts (hard case V5): whichever number of a saved world is changed, loading refuses it, or the world
// that was loaded has another hash; the numbers of policies, which are no part of a hash, are those that the loaded
// world writes.
// Runs long with the sanitizers.

#include <ansatz/collision.hpp>
#include <ansatz/collision/hash_collisions.hpp>
#include <ansatz/motion.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>
#include <ansatz/world/save.hpp>

#include "tests/catch.hpp"

#include <nlohmann/json.hpp>

#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using namespace ansatz;

namespace {

using Json = nlohmann::ordered_json;

Json written(const auto& world) {
    std::ostringstream out;
    save(world, out);
    return Json::parse(out.str());
}
/// \return whether it was taken
template <class W> bool taken(W& world, const Json& file) {
    std::istringstream in(file.dump());
    try {
        load(world, in);
    } catch (const std::invalid_argument&) {
        return false;
    }
    return true;
}
void find_numbers(const Json& json, const Json::json_pointer& at, std::vector<Json::json_pointer>& all) {
    if (json.is_number()) all.push_back(at);
    if (json.is_object())
        for (const auto& [key, value] : json.items()) find_numbers(value, at / key, all);
    if (json.is_array())
        for (std::size_t i = 0; i < json.size(); ++i) find_numbers(json[i], at / i, all);
}
/// What a number of the file may become; none of them the same number in the world's scalar.
template <class Scalar> std::vector<Json> others(const Json& number, std::mt19937& random) {
    std::vector<Json> all;
    if (number.is_number_integer()) {
        const auto n = number.get<std::uint64_t>();
        for (const std::uint64_t other : {n + 1, n - 1, n + random() % 7 + 2, std::uint64_t(random())})
            if (other != n) all.push_back(other);
    }
    if (number.is_number_float() || number == 0) {
        const auto x = number.get<double>();
        const double share = std::ldexp(1.0, -int(random() % 20));
        for (const double other : {x * (1 + share), x * (1 - share), -x, x + 1, x - share, 0.0, 1e-30})
            if (Scalar(other) != Scalar(x)) all.push_back(other);
    }
    return all;
}

template <class W> void every_number_counts(const W& world) {
    using Scalar = typename W::Scalar;
    const Json file = written(world);
    {
        W same = world;
        REQUIRE(taken(same, file));
        REQUIRE(same.hash() == world.hash());
    }
    std::vector<Json::json_pointer> numbers;
    find_numbers(file, Json::json_pointer(), numbers);
    REQUIRE(numbers.size() > 100);
    std::mt19937 random(5);
    std::set<std::string> silent; // each kind of number once: places without their indices
    W loaded = world;
    for (const auto& at : numbers)
        for (const auto& other : others<Scalar>(file.at(at), random)) {
            auto changed = file;
            changed.at(at) = other;
            if (!taken(loaded, changed) || loaded.hash() != world.hash()) continue;
            const auto place = at.to_string();
            // A parameter is not a state: it is not forgotten either.
            if (place.starts_with("/policies/") &&
                written(loaded).at(at).template get<Scalar>() == other.template get<Scalar>())
                continue;
            std::string kind;
            for (const char c : place)
                if (c < '0' || c > '9') kind += c;
            if (silent.insert(kind).second)
                UNSCOPED_INFO(place << ": " << file.at(at) << " became " << other << " in silence");
        }
    CHECK(silent.empty());
}

} // namespace

TEST_CASE("every number of a saved world counts: springs that break, by a history", "[world][save][hash][V5]") {
    World world{Space<float, 2>{}, Verlet{},        Gravity{}, Drag{0.1 / second}, Springs<Breaking>{},
                AppliedForces{},   Interpolation{}, Rest{},    Datum<int>{}};
    std::vector<Handle> balls;
    for (int i = 0; i < 4; ++i)
        balls.push_back(
            world.add(position(metres(i, 0)), velocity(metres_per_second(0, 0.1 * i)), mass(1.0 * kilogram), datum(i)));
    world.add(position(metres(5, 5)), fixed);
    world.add(position(metres(7, 5)), velocity(metres_per_second(1, 0)), moving);
    world.add(position(metres(9, 5)), mass(1.0 * kilogram), resting);
    for (int i = 0; i + 1 < 4; ++i)
        world.add(Spring{balls[std::size_t(i)], balls[std::size_t(i) + 1], 200.0 * newton_per_metre,
                         0.5 * newton_second_per_metre, 1.0 * metre},
                  breaks_at(500.0 * newton));
    world.add(Spring{balls[0], metres(0, 1), 100.0 * newton_per_metre});
    for (int i = 0; i < 20; ++i) world.step(1.0 / 60 * second);
    world.remove(balls[3]); // an id and an element to be given again
    for (int i = 0; i < 5; ++i) world.step(1.0 / 50 * second);
    world.set_velocity(balls[1], metres_per_second(1, 1)); // a start that waits
    world.apply_force(balls[2], newtons(1, 1));
    every_number_counts(world);
}

TEST_CASE("every number of a saved world counts: a pile with friction, some of it asleep", "[world][save][hash][V5]") {
    World world{SemiImplicitEuler{},     Gravity{}, Rest{}, UniformGrid{}, Layers{}, Narrowphase<Sphere, Plane, Box>{},
                SoftSubsteps<Friction>{}};
    world.add(Plane::ground(), friction(0.6), fixed);
    std::vector<Handle> balls;
    for (int i = 0; i < 4; ++i)
        balls.push_back(world.add(Sphere{0.5 * metre}, position(metres(0.1 * i, 0.5 + 0.99 * i, 0)),
                                  mass((1.0 + i) * kilogram), friction(0.5), restitution(0.2)));
    world.add(Box{metres(0.5, 0.5, 0.5)}, position(metres(10, 0.5, 0)), mass(1.0 * kilogram), friction(0.5));
    world.add(Sphere{2.0 * metre}, sensor, position(metres(10, 0, 0)), fixed);
    world.add(Box{metres(0.5, 0.5, 0.5)}, position(metres(20, 0.5, 0)), velocity(metres_per_second(3, 0, 0)),
              mass(1.0 * kilogram), friction(0.5));
    const auto gone = world.add(Sphere{0.5 * metre}, position(metres(30, 0.5, 0)), mass(1.0 * kilogram));
    for (int i = 0; i < 50; ++i) world.step(1.0 / 60 * second);
    world.remove(gone);
    world.step(1.0 / 60 * second);
    REQUIRE(world.count(Motion::resting) > 0);
    REQUIRE(world.count(Motion::awake) > 0);
    every_number_counts(world);
}

TEST_CASE("every number of a saved world counts: contacts that act in the next step", "[world][save][hash][V5]") {
    World world{Space<float, 2>{},
                Verlet{},
                Gravity{},
                SortAndSweep{},
                Narrowphase<Sphere, Plane>{},
                Penalty{2000.0 * newton_per_metre, 20.0 * newton_second_per_metre}};
    world.add(Plane::ground(), fixed);
    for (int i = 0; i < 3; ++i)
        world.add(Sphere{0.5 * metre}, position(metres(0.1 * i, 0.4 + 0.9 * i)), mass(1.0 * kilogram));
    for (int i = 0; i < 10; ++i) world.step(1.0 / 120 * second);
    REQUIRE_FALSE(world.contacts().empty());
    every_number_counts(world);
}
