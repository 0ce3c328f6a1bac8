// SPDX-License-Identifier: BSL-1.0
// A world that was saved, loaded or copied after any verb goes on as the one that was not (hard case V5), where
// velocities are derived from a history and forces between bodies read them; and what writes what no force reads
// changes no motion.

#include <ansatz/motion.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>
#include <ansatz/world/save.hpp>

#include "tests/catch.hpp"

#include <functional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace ansatz;

namespace {

struct Warmth {
    static constexpr std::string_view name = "warmth";
    using Unit = unit::Length; // of a mercury column
    static constexpr Shape shape = Shape::scalar;
};

struct Net {
    World<Verlet, Gravity, Drag, Springs<>, AppliedForces, Keep<Warmth>> world{
        Verlet{}, Gravity{}, Drag{0.2 / second}, Springs<>{}, AppliedForces{}, Keep<Warmth>{}};
    std::vector<Handle> balls;
    std::vector<SpringHandle> springs;

    Net() {
        for (int i = 0; i < 4; ++i)
            balls.push_back(world.add(position(metres(i, 0.1 * i * i, 0)),
                                      velocity(metres_per_second(0.3 * i, -0.2, 0.1)), mass((1.0 + i) * kilogram)));
        for (std::size_t i = 0; i + 1 < 4; ++i) springs.push_back(world.add(spring(balls[i], balls[i + 1])));
        springs.push_back(world.add(spring(balls[0], metres(0, 1, 0))));
        for (int i = 0; i < 12; ++i) world.step(1.0 / 60 * second);
    }
    static Spring spring(SpringEnd a, SpringEnd b) {
        return {a, b, 90.0 * newton_per_metre, 7.0 * newton_second_per_metre, 0.8 * metre};
    }
};
const std::pair<std::string, std::function<void(Net&)>> verbs[] = {
    {"nothing", [](Net&) {}},
    {"apply_force", [](Net& n) { n.world.apply_force(n.balls[1], newtons(3, 20, -4)); }},
    {"apply_force twice",
     [](Net& n) {
         n.world.apply_force(n.balls[1], newtons(3, 20, -4)), n.world.apply_force(n.balls[2], newtons(1, 0, 0));
     }},
    {"apply_impulse", [](Net& n) { n.world.apply_impulse(n.balls[2], newton_seconds(1, 2, 3)); }},
    {"write", [](Net& n) { n.world.write<Warmth>(n.balls[1], 3.0 * metre); }},
    {"set_mass", [](Net& n) { n.world.set_mass(n.balls[1], 5.0 * kilogram); }},
    {"set_position", [](Net& n) { n.world.set_position(n.balls[3], metres(3, 2, 1)); }},
    {"set_velocity", [](Net& n) { n.world.set_velocity(n.balls[0], metres_per_second(3, 2, 1)); }},
    {"wake", [](Net& n) { n.world.wake(n.balls[0]); }},
    {"remove", [](Net& n) { n.world.remove(n.balls[1]); }},
    {"add", [](Net& n) { n.world.add(position(metres(9, 9, 9)), mass(1.0 * kilogram)); }},
    {"add a spring", [](Net& n) { n.world.add(Net::spring(n.balls[0], n.balls[3])); }},
    {"remove a spring", [](Net& n) { n.world.remove(n.springs[1]); }},
    {"set a spring", [](Net& n) { n.world.set(n.springs[1], Net::spring(n.balls[0], n.balls[2])); }},
    {"set gravity", [](Net& n) { n.world.set(Gravity{metres_per_second_squared(1, 0, 0)}); }},
    {"set drag", [](Net& n) { n.world.set(Drag{1.0 / second}); }},
};

} // namespace

TEST_CASE("a world that is saved, loaded or copied after any verb goes on to the bit", "[world][save][V5]") {
    for (const auto& [name, verb] : verbs)
        for (const auto& [second_name, second_verb] : verbs) {
            if (name == "remove" && second_name != "nothing") continue; // handles that the second would use are gone
            if (name == "remove a spring" && (second_name == "remove a spring" || second_name == "set a spring"))
                continue;
            CAPTURE(name, second_name);
            Net net;
            verb(net);
            second_verb(net);
            std::stringstream file;
            save(net.world, file);
            Net loaded;
            load(loaded.world, file);
            auto copy = net.world;
            REQUIRE(loaded.world.hash() == net.world.hash());
            for (int i = 0; i < 3; ++i) {
                net.world.step(1.0 / 60 * second);
                loaded.world.step(1.0 / 60 * second);
                copy.step(1.0 / 60 * second);
                REQUIRE(loaded.world.hash() == net.world.hash());
                REQUIRE(copy.hash() == net.world.hash());
            }
        }
}

TEST_CASE("what writes a column that no force reads changes no motion", "[world][V5]") {
    Net written, left;
    for (int i = 0; i < 30; ++i) {
        for (const auto ball : written.balls) written.world.write<Warmth>(ball, 0.1 * i * metre);
        written.world.step(1.0 / 60 * second);
        left.world.step(1.0 / 60 * second);
        for (const auto ball : left.balls) REQUIRE(written.world.position(ball) == left.world.position(ball));
    }
}
