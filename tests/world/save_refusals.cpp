// SPDX-License-Identifier: BSL-1.0
// Files that are not what they should be: each is refused with the place in it and what was expected, and the world is
// left as it was.

#include <ansatz/world/save.hpp>

#include "tests/catch.hpp"
#include "tests/world/worlds.hpp"

#include <nlohmann/json.hpp>

#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

using namespace ansatz;
using namespace ansatz::test;

namespace {

using Json = nlohmann::ordered_json;
using W = World<Space<float, 2>, Verlet, Gravity, Drag, AppliedForces, Rest>;

W make() {
    W world{Space<float, 2>{}, Verlet{}, Gravity{}, Drag{}, AppliedForces{}, Rest{}};
    const auto gone = world.add(mass(1.0 * kilogram));
    world.add(position(metres(1, 2)), mass(2.0 * kilogram));
    world.add(position(metres(3, 4)), mass(4.0 * kilogram), resting);
    world.add(position(metres(5, 6)), moving);
    world.add(position(metres(7, 8)), fixed);
    world.remove(gone);
    for (int i = 0; i < 3; ++i) world.step(1.0 / 64 * second);
    return world;
}

std::string text_of(const W& world) {
    std::ostringstream out;
    save(world, out);
    return out.str();
}
std::string load_of(W& world, const std::string& text) {
    return sentence<std::invalid_argument>([&] {
        std::istringstream in(text);
        load(world, in, "game.json");
    });
}

/// The file of a good world, changed by `spoil`, is refused with a sentence that begins as given and names what belongs
/// there; the world it should have gone into stays as it was.
void refused(const std::function<void(Json&)>& spoil, const std::string& place, const std::string& expected) {
    Json file = Json::parse(text_of(make()));
    spoil(file);
    W world = make();
    world.set(Drag{3.0 / second});
    world.step(1.0 / 64 * second);
    const W before = world;
    const auto text = load_of(world, file.dump());
    INFO(text);
    INFO("should begin: " << place);
    INFO("should contain: " << expected);
    CHECK(text.find("game.json" + (place.substr(0, 3) == " is" ? place : ": " + place)) == 0);
    CHECK(text.find(expected) != std::string::npos);
    CHECK(world.hash() == before.hash());
    CHECK(world.handles() == before.handles());
    CHECK(world.get<Drag>().rate == 3.0 / second);
    W after = world, twin = before;
    after.step(1.0 / 64 * second);
    twin.step(1.0 / 64 * second);
    CHECK(after.hash() == twin.hash());
}

} // namespace

TEST_CASE("the file that is spoiled below is a good one", "[world][save]") {
    const auto world = make();
    auto other = make();
    other.step(1.0 / 64 * second);
    CHECK(load_of(other, Json::parse(text_of(world)).dump()) == "nothing");
    CHECK(other.hash() == world.hash());
}

TEST_CASE("a file of something else, of another version, scalar, dimension or columns is refused", "[world][save]") {
    refused([](Json& f) { f["format"] = "tileset"; }, "format is \"tileset\"; expected \"ansatz world\"", "");
    refused([](Json& f) { f["version"] = 2; }, "version is 2; expected 1", "the version that this library reads");
    refused([](Json& f) { f["version"] = "1"; }, "version is \"1\"; expected 1", "");
    refused([](Json& f) { f["scalar"] = "double"; }, "scalar is \"double\"; expected \"float\"",
            "the scalar of this world");
    refused([](Json& f) { f["dimension"] = 3; }, "dimension is 3; expected 2", "the dimension of this world");
    refused([](Json& f) { f["columns"].erase(0); }, "columns is [", "expected [\"position\",");
    refused([](Json& f) { f["columns"].push_back("heat"); }, "columns is [", "the columns of this world");
    refused([](Json& f) { f = Json::array(); }, " is []; expected an object with \"format\"", "");
    refused([](Json& f) { f = 7; }, " is 7; expected an object", "");
}

TEST_CASE("a file that lacks something is refused with what is missing", "[world][save]") {
    for (const char* key : {"format", "version", "scalar", "dimension", "columns", "policies", "clock", "unsolved",
                            "generations", "free", "bodies"})
        refused([&](Json& f) { f.erase(key); }, "expected \"" + std::string(key) + "\", but there is none", "");
    for (const char* key :
         {"id", "motion", "waiting", "position", "previous position", "inverse mass", "applied force", "rest time"})
        refused([&](Json& f) { f["bodies"][1].erase(key); },
                "bodies[1]: expected \"" + std::string(key) + "\", but there is none", "");
    for (const char* key : {"start", "dt", "steps", "tick"})
        refused([&](Json& f) { f["clock"].erase(key); },
                "clock: expected \"" + std::string(key) + "\", but there is none", "");
    refused([](Json& f) { f["policies"].erase("Drag"); }, "policies: expected \"Drag\", but there is none", "");
    refused([](Json& f) { f["policies"]["Drag"].erase("rate"); }, "policies.Drag: expected \"rate\", but there is none",
            "");
}

TEST_CASE("numbers in a file are held to what the world would take at its door", "[world][save]") {
    refused([](Json& f) { f["bodies"][0]["position"][1] = "nan"; },
            "bodies[0].position[1] is \"nan\"; expected a finite number", "");
    refused([](Json& f) { f["bodies"][0]["position"][1] = nullptr; },
            "bodies[0].position[1] is null; expected a finite number", "");
    refused([](Json& f) { f["bodies"][0]["position"][1] = 1e300; },
            "bodies[0].position[1] is 1e+300; expected a finite number", "that the world's scalar can hold");
    refused([](Json& f) { f["bodies"][0]["position"].push_back(1.0); }, "bodies[0].position is [",
            "expected a list of 2 numbers");
    refused([](Json& f) { f["bodies"][0]["rest time"] = "long"; },
            "bodies[0].rest time is \"long\"; expected a finite number", "");
    refused([](Json& f) { f["bodies"][0]["inverse mass"] = 0.0; },
            "bodies[0].inverse mass is 0.0; expected a number greater than 0", "");
    refused([](Json& f) { f["bodies"][0]["inverse mass"] = -0.5; },
            "bodies[0].inverse mass is -0.5; expected a number greater than 0", "");
    refused([](Json& f) { f["bodies"][3]["inverse mass"] = 1.0; }, "bodies[3].inverse mass is 1.0; expected 0",
            "fixed or moving");
    refused([](Json& f) { f["bodies"][0]["waiting"] = 1; }, "bodies[0].waiting is 1; expected true or false", "");
    refused([](Json& f) { f["unsolved"] = -1; }, "unsolved is -1; expected a whole number", "");
    refused([](Json& f) { f["clock"]["tick"] = 2.5; }, "clock.tick is 2.5; expected a whole number", "");
    refused([](Json& f) { f["clock"]["dt"] = -1.0; }, "clock.dt is -1.0; expected a time step", "not negative");
    refused([](Json& f) { f["clock"]["steps"] = 99; }, "clock.steps is 99; expected a whole number from 0 to 3", "");
    refused([](Json& f) { f["policies"]["Drag"]["rate"] = -1.0; },
            "policies: Drag: rate is -1 1/s; it must be finite and not negative", "");
    refused([](Json& f) { f["policies"]["Gravity"]["acceleration"] = 9.81; }, "policies.Gravity.acceleration is 9.81; ",
            "a list of numbers");
}

TEST_CASE("a clock whose steps have no length is refused, because history is divided by it", "[world][save]") {
    refused([](Json& f) { f["clock"]["dt"] = 0.0; }, "clock.dt is 0.0; expected", "greater than 0");
    refused([](Json& f) { f["clock"]["dt"] = 1e-60; }, "clock.dt is 1e-60; expected",
            "that the world's scalar can hold");
}

TEST_CASE("a directory of bodies that contradicts itself is refused", "[world][save]") {
    refused([](Json& f) { f["bodies"][1]["id"] = f["bodies"][0]["id"]; }, "bodies[1].id is ",
            "expected an id that no other body has");
    refused([](Json& f) { f["bodies"][1]["id"] = 77; }, "bodies[1].id is 77; expected a whole number from 0 to 4", "");
    refused([](Json& f) { f["bodies"][1]["id"] = "ball"; }, "bodies[1].id is \"ball\"; expected a whole number", "");
    refused([](Json& f) { f["bodies"][1]["motion"] = "flying"; },
            "bodies[1].motion is \"flying\"; expected \"awake\", \"resting\"", "");
    refused([](Json& f) { std::swap(f["bodies"][0], f["bodies"][3]); }, "bodies[1].motion is ",
            "expected bodies in the order awake, resting, moving, fixed");
    refused([](Json& f) { f["free"] = Json::array(); }, "free is []; expected a list of 1 free ids", "");
    refused([](Json& f) { f["free"][0] = 3; }, "free[0] is 3; expected an id that is free, once", "");
    refused([](Json& f) { f["generations"].erase(0); }, "bodies[", "");
    refused([](Json& f) { f["generations"] = 5; }, "generations is 5; expected a list of generations", "");
    refused([](Json& f) { f["bodies"] = "none"; }, "bodies is \"none\"; expected a list of bodies", "");
}

TEST_CASE("a file of a world with other policies is refused, not half understood", "[world][save]") {
    refused([](Json& f) { f["policies"]["QuadraticDrag"] = {{"coefficient", 0.5}}; }, "policies", "QuadraticDrag");
}

TEST_CASE("a file that is no JSON is refused with line and column", "[world][save]") {
    const auto good = text_of(make());
    for (const std::string& text : {std::string(), std::string("once upon a time"), good.substr(0, good.size() / 2),
                                    good + "}", "\xff" + good, std::string("{\"format\": NaN}")}) {
        W world = make();
        const auto before = world.hash();
        const auto refusal = load_of(world, text);
        INFO(refusal);
        CHECK(refusal.find("game.json: parse error at line ") == 0);
        CHECK(refusal.find("column") != std::string::npos);
        CHECK(world.hash() == before);
    }
    // Cut at any place, a file is refused and never half loaded.
    for (std::size_t length = 0; length + 2 < good.size(); length += 37) {
        W world = make();
        const auto before = world.hash();
        CHECK(load_of(world, good.substr(0, length)).find("game.json: ") == 0);
        CHECK(world.hash() == before);
    }
}

TEST_CASE("no single word of a good file can be lost or replaced without harm or a sentence", "[world][save]") {
    // Every value in turn becomes a null: refused, since no value of a world is null.
    const Json good = Json::parse(text_of(make()));
    const auto flat = good.flatten();
    for (const auto& [pointer, value] : flat.items()) {
        Json file = good;
        file[Json::json_pointer(pointer)] = nullptr;
        W world = make();
        INFO(pointer);
        CHECK(load_of(world, file.dump()).find("game.json: ") == 0);
    }
}

TEST_CASE("resting bodies are refused by a world that puts no bodies to rest", "[world][save]") {
    World restful{SemiImplicitEuler{}, Rest{}};
    World restless{SemiImplicitEuler{}, Keep<RestTime>{}};
    restful.add(resting);
    std::ostringstream out;
    save(restful, out);
    // The columns agree but for their order, which the file spells.
    auto file = Json::parse(out.str());
    std::ostringstream other;
    save(restless, other);
    file["columns"] = Json::parse(other.str())["columns"];
    file["policies"] = Json::object();
    const auto text = sentence<std::invalid_argument>([&] {
        std::istringstream in(file.dump());
        load(restless, in);
    });
    INFO(text);
    CHECK(text.find("load: bodies[0].motion is \"resting\"; expected another state") == 0);
    CHECK(restless.size() == 0);
}

TEST_CASE("a file that nests a hundred thousand lists is refused, not followed down", "[world][save]") {
    W world = make();
    std::string deep = "{\"format\":";
    deep.append(100000, '[').append(100000, ']').append("}");
    CHECK_THAT(load_of(world, deep), Catch::Matchers::ContainsSubstring("format is a list; expected \"ansatz world\""));
    deep.back() = ','; // what stands behind it moves it to a longer list of members
    CHECK_THAT(load_of(world, deep + "\"version\":1}"), Catch::Matchers::ContainsSubstring("format is a list"));
    CHECK(load_of(world, deep) != ""); // and it may end in the midst of it
}

TEST_CASE("a body that stands still has no velocity in a file either", "[world][save]") {
    refused(
        [](Json& file) {
            file["bodies"].back()["previous position"] = {1, 1};
        },
        "bodies[3].previous position", "the body's position, because it stands still");
    World stored{SemiImplicitEuler{}, Gravity{}};
    stored.add(fixed);
    std::ostringstream out;
    save(stored, out);
    auto file = Json::parse(out.str());
    file["bodies"][0]["velocity"] = {5, 6, 7};
    std::istringstream in(file.dump());
    CHECK_THAT(sentence<std::invalid_argument>([&] { load(stored, in); }),
               Catch::Matchers::ContainsSubstring("zeros, because the body stands still"));
}

TEST_CASE("a clock and a mass beyond all numbers are refused", "[world][save]") {
    World wide{SemiImplicitEuler{}};
    wide.step(1.0 * second);
    std::ostringstream out;
    save(wide, out);
    auto text = Json::parse(out.str());
    text["clock"]["dt"] = 1e307, text["clock"]["tick"] = text["clock"]["steps"] = 1000;
    std::istringstream in(text.dump());
    CHECK_THAT(sentence<std::invalid_argument>([&] { load(wide, in); }),
               Catch::Matchers::ContainsSubstring("a number of steps after which the time is finite"));
    refused([](Json& file) { file["bodies"][0]["inverse mass"] = 1e-45; }, "bodies[0].inverse mass",
            "the inverse of a finite mass");
}

TEST_CASE("what is no file, and a disk that is full, are sentences", "[world][save]") {
    W world = make();
    const auto hash = world.hash();
    CHECK_THAT(sentence<std::invalid_argument>([&] { load(world, "/"); }), Catch::Matchers::ContainsSubstring("/"));
    CHECK(world.hash() == hash);
    if (!std::ifstream("/dev/full")) SKIP("no /dev/full on this system");
    CHECK_THAT(sentence<std::invalid_argument>([&] { save(world, "/dev/full"); }),
               Catch::Matchers::ContainsSubstring("/dev/full could not be written to the end"));
}

TEST_CASE("the order of the policies means nothing to a file", "[world][save]") {
    World one{SemiImplicitEuler{}, Gravity{}, QuadraticDrag{}, Rest{}, Datum<int>{}};
    World other{Rest{}, Datum<int>{}, QuadraticDrag{}, Gravity{}, SemiImplicitEuler{}};
    one.add(mass(1.0 * kilogram), datum(1));
    one.step(0.1 * second);
    other.add(mass(2.0 * kilogram), datum(666));
    std::ostringstream out;
    save(one, out);
    std::istringstream in(out.str());
    load(other, in);
    CHECK(other.hash() == one.hash());
    CHECK(other.datum(other.body_at(0)) == 1); // it came with the file
}
