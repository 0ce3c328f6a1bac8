// SPDX-License-Identifier: BSL-1.0
// What a state of a user's own consists of, said once: every kind of field is hashed, saved and read back, to the bit,
// and a file that cannot be is refused by name and place, with the world as it was.

#include <ansatz/world.hpp>
#include <ansatz/world/fields.hpp>
#include <ansatz/world/save.hpp>
#include <ansatz/world/table_door.hpp>

#include <catch2/catch.hpp>

#include <array>
#include <sstream>
#include <string>
#include <vector>

using namespace ansatz;

namespace {

/// A policy that does nothing but keep one field of every kind.
struct Notebook {
    using role = roles::System;
    static constexpr std::string_view name = "Notebook";
    template <class S> struct State {
        bool open = true;
        int pages = 3;
        std::uint64_t serial = 1ull << 60;
        typename S::Scalar number = typename S::Scalar(0.1);
        typename S::Length length = S::Length::from_value(typename S::Scalar(1) / 3);
        typename S::Position place = S::template zero_vector<unit::Length>();
        std::vector<typename S::Scalar> many{1, 2, 3};
        std::vector<typename S::Velocity> fast;
        std::array<int, 2> pair{4, -5};
        std::vector<bool> flags{true, false};
        std::vector<std::vector<int>> nested{{-2147483647 - 1}, {}, {2, 3}};
        static void fields(auto& self, auto&& field) {
            field("open", self.open);
            field("pages", self.pages);
            field("serial", self.serial);
            field("number", self.number);
            field("length", self.length);
            field("place", self.place);
            field("many", self.many);
            field("fast", self.fast);
            field("pair", self.pair);
            field("flags", self.flags);
            field("nested", self.nested);
        }
        void check() const {
            if (pages < 0 || pages > 100) refuse_value("Notebook", "pages", std::to_string(pages), "it is 0 to 100");
        }
    };
    template <class W, class C> class Door : public TableDoor<W, Notebook> {
    public:
        const auto& notes() const { return this->kept(); }
        template <class F> void note(F&& f) { this->change("World::note", f); }
    };
};
template <class S> auto world_of() { return World{S{}, SemiImplicitEuler{}, Notebook{}}; }

template <class W> std::string text_of(const W& world) {
    std::stringstream file;
    save(world, file);
    return file.str();
}
template <class W> void read(W& world, const std::string& text) {
    std::stringstream file(text);
    load(world, file);
}
std::string with(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

} // namespace

TEMPLATE_TEST_CASE("Every kind of field is a part of the world's value", "[fields]", (Space<double, 3>),
                   (Space<float, 2>)) {
    using S = TestType;
    using Scalar = typename S::Scalar;
    auto world = world_of<S>();
    const auto plain = world.hash();
    CHECK(world_of<S>().hash() == plain);
    auto changes_the_hash = [&](auto&& change) {
        auto other = world;
        other.note(change);
        CHECK(other.hash() != plain);
        auto loaded = world_of<S>();
        read(loaded, text_of(other));
        CHECK(loaded.hash() == other.hash());
        CHECK(text_of(loaded) == text_of(other));
        const auto copy = other;
        CHECK(copy.hash() == other.hash());
    };
    changes_the_hash([](auto& n) { n.open = false; });
    changes_the_hash([](auto& n) { n.pages = 4; });
    changes_the_hash([](auto& n) { n.serial += 1; });
    changes_the_hash([](auto& n) { n.number = Scalar(0.2); });
    changes_the_hash([](auto& n) { n.length = S::Length::from_value(Scalar(2) / 3); });
    changes_the_hash([](auto& n) {
        auto x = n.place.value();
        x[1] = Scalar(1) / 7;
        n.place = S::Position::from_value(x);
    });
    changes_the_hash([](auto& n) { n.many[2] = Scalar(1) / 9; });
    changes_the_hash([](auto& n) { n.many.push_back(Scalar(0)); });
    changes_the_hash([](auto& n) { n.many.clear(); });
    changes_the_hash([](auto& n) { n.fast.resize(2, S::template zero_vector<unit::Velocity>()); });
    changes_the_hash([](auto& n) { n.pair[1] = 6; });
    changes_the_hash([](auto& n) { n.flags[1] = true; });
    changes_the_hash([](auto& n) { n.nested = {{}, {1}, {2, 3}}; }); // the same numbers in other lists
}

TEST_CASE("A file whose fields are not acceptable is refused by name and place, and changes nothing", "[fields]") {
    auto world = world_of<Space<>>();
    const auto text = text_of(world);
    const auto refused = [&](const std::string& from, const std::string& to, const std::string& expected) {
        const auto before = world.hash();
        try {
            read(world, with(text, from, to));
            FAIL("it was accepted: " << to);
        } catch (const std::invalid_argument& e) {
            CHECK_THAT(e.what(), Catch::Contains(expected));
        }
        CHECK(world.hash() == before);
    };
    refused("\"open\": true", "\"open\": 1", "states.Notebook.open is 1; expected true or false");
    refused("\"pages\": 3", "\"pages\": 300", "states.Notebook: Notebook: pages is 300; it is 0 to 100");
    refused("\"pages\": 3", "\"pages\": -1", "states.Notebook: Notebook: pages is -1; it is 0 to 100");
    refused("\"pages\": 3", "\"pages\": -3000000000",
            "states.Notebook.pages is -3000000000; expected a whole number from -2147483648 to 2147483647");
    refused("\"serial\"", "\"serial\": -1, \"was\"", "states.Notebook.serial is -1; expected a whole number from 0 to");
    refused("\"number\": 0.1", "\"number\": \"x\"", "states.Notebook.number is \"x\"; expected a finite number");
    refused("\"pair\"", "\"pear\"", "states.Notebook: expected \"pair\", but there is none");
    refused("\"states\"", "\"stated\"", "expected \"states\", but there is none");
}

TEST_CASE("What a door refuses to change is as it was", "[fields]") {
    auto world = world_of<Space<>>();
    const auto before = world.hash();
    CHECK_THROWS_AS(world.note([](auto& n) {
        n.pages = 7;
        n.many.clear();
        throw std::runtime_error("half done");
    }),
                    std::runtime_error);
    CHECK(world.hash() == before);
    CHECK(world.notes().pages == 3);
}
