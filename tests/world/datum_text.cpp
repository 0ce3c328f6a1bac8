// SPDX-License-Identifier: BSL-1.0
// A user's own datum in a file: numbers, texts, bytes, and types with two functions of their own.

#include <ansatz/world/datum_text.hpp>

#include <ansatz/world.hpp>
#include <ansatz/world/save.hpp>

#include "tests/catch.hpp"
#include "tests/refusal.hpp"
#include "tests/world/files.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

using namespace ansatz;
using namespace ansatz::test;

namespace {

enum class Team : std::int8_t { red = -3, blue = 7 };
struct Colour {
    float r = 0, g = 0, b = 0;
    bool operator==(const Colour&) const = default;
};
/// With two functions, which need not know the library.
struct Inventory {
    std::vector<std::string> things;
    bool operator==(const Inventory&) const = default;
};
std::string datum_to_text(const Inventory& inventory) {
    std::string text;
    for (const auto& thing : inventory.things) text += thing + ";";
    return text;
}
void datum_from_text(Inventory& inventory, const std::string& text) {
    inventory.things.clear();
    std::istringstream in(text);
    for (std::string thing; std::getline(in, thing, ';');) {
        if (thing.empty()) throw std::invalid_argument("things with a name");
        inventory.things.push_back(thing);
    }
}

/// Saves and loads bodies with these data, into a new world and into one that has other bodies of the same handles.
template <class T> void come_back(const std::vector<T>& data) {
    using W = World<SemiImplicitEuler, Gravity, Rest, Datum<T>>;
    W world{SemiImplicitEuler{}, Gravity{}, Rest{}, Datum<T>{}};
    const auto gone = world.add(datum(data[0]));
    std::vector<Handle> bodies;
    for (const auto& one : data) bodies.push_back(world.add(datum(one)));
    world.remove(gone);
    for (int i = 0; i < 3; ++i) world.step(1.0 / 60 * second);
    W fresh{SemiImplicitEuler{}, Gravity{}, Rest{}, Datum<T>{}}, other = world;
    for (const auto body : bodies) other.datum(body) = T{};
    for (auto* into : {&fresh, &other}) {
        load_text(*into, text_of(world));
        CHECK(into->hash() == world.hash());
        for (std::size_t i = 0; i < data.size(); ++i) {
            CAPTURE(i);
            CHECK(into->datum(bodies[i]) == data[i]);
        }
        CHECK(into->datum(into->add()) == T{}); // a body that takes a free id begins with a new one
    }
}
template <class T> std::string refused(const T& datum_, const std::string& instead) {
    World world{SemiImplicitEuler{}, Datum<T>{}};
    const auto body = world.add(datum(datum_));
    auto text = text_of(world);
    const auto at = text.find("\"datum\": ") + 9, end = text.find('\n', at);
    text.replace(at, end - at, instead);
    const auto said = refusal([&] { load_text(world, text); });
    CHECK(world.datum(body) == datum_);
    return said;
}

} // namespace

TEST_CASE("a datum comes back from a file", "[world][save][keep]") {
    come_back<int>({0, -1, std::numeric_limits<int>::min()});
    come_back<std::uint64_t>({0, std::numeric_limits<std::uint64_t>::max()});
    come_back<char>({'a', '\0', '"'});
    come_back<bool>({true, false});
    come_back<Team>({Team::red, Team::blue});
    come_back<double>({0.1, -0.0, 5e-324, std::numeric_limits<double>::infinity()});
    come_back<std::string>({"ball", "", "with \"quotes\"\n and a line", "zwölf"});
    come_back<Colour>({{1, 0.5f, 0.1f}, {}});
    come_back<Inventory>({{{"rope", "lamp"}}, {}});
    STATIC_REQUIRE_FALSE(detail::datum_is_saved<int*>); // means nothing in another run
    STATIC_REQUIRE_FALSE(detail::datum_is_saved<std::shared_ptr<int>>);
    STATIC_REQUIRE_FALSE(detail::datum_is_saved<std::vector<int>>);
    STATIC_REQUIRE_FALSE(detail::datum_is_saved<void>);
}

TEST_CASE("a datum that cannot be read is refused with its place and what was expected, and nothing is lost",
          "[world][save][keep]") {
    CHECK(refused<int>(7, "7") == "load: bodies[0].datum is 7; expected the body's datum as text");
    CHECK(refused<int>(7, "\"seven\"") ==
          "load: bodies[0].datum is \"seven\"; expected a whole number, as text, that the datum's type can hold");
    CHECK(refused<std::int8_t>(7, "\"300\"").find("that the datum's type can hold") != std::string::npos);
    CHECK(refused<bool>(true, "\"1\"") == "load: bodies[0].datum is \"1\"; expected \"true\" or \"false\"");
    CHECK(refused<Colour>({}, "\"00ff\"") ==
          "load: bodies[0].datum is \"00ff\"; expected the 12 bytes of the datum as hexadecimal digits, two a byte");
    CHECK(refused<Inventory>({{"rope"}}, "\"rope;;\"") ==
          "load: bodies[0].datum is \"rope;;\"; expected things with a name");
}

TEST_CASE("a text that is no UTF-8 is refused by save, in a sentence", "[world][save][keep]") {
    World world{SemiImplicitEuler{}, Datum<std::string>{}};
    world.add(datum(std::string("ball\xff")));
    CHECK(refusal([&] { text_of(world); }) ==
          "save: a datum is not a text in UTF-8, as a file needs it: invalid UTF-8 byte at index 4: 0xFF");
}
