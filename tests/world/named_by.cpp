// SPDX-License-Identifier: BSL-1.0
// Which elements name a body: against a look at all of them, through random verbs; and how much n removals cost.

#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>
#include <ansatz/world/element_table.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

using namespace ansatz;

namespace {

/// A table in which every look at an element is counted.
struct Ties {
    std::vector<std::vector<std::uint32_t>> bodies; // by id; one without bodies is gone
    mutable long looks = 0;
    void for_each(auto&& f) const {
        for (std::uint32_t id = 0; id < bodies.size(); ++id)
            if (!bodies[id].empty()) f(id, bodies[id]);
    }
    void for_each_backwards(auto&& f) const {
        for (auto id = std::uint32_t(bodies.size()); id-- > 0;)
            if (!bodies[id].empty()) f(id);
    }
    void for_each_body(std::uint32_t id, auto&& f) const {
        ++looks;
        for (const auto body : bodies[id]) f(body);
    }
    bool names(std::uint32_t id, std::uint32_t body) const {
        return std::find(bodies[id].begin(), bodies[id].end(), body) != bodies[id].end();
    }
    std::vector<std::uint32_t> all_naming(std::uint32_t body) const {
        std::vector<std::uint32_t> all;
        for (std::uint32_t id = 0; id < bodies.size(); ++id)
            if (names(id, body)) all.push_back(id);
        return all;
    }
};

} // namespace

TEST_CASE("The elements of a body are those that a look at all of them finds, by id", "[named_by]") {
    std::mt19937 random(7);
    for (int round = 0; round < 200; ++round) {
        Ties ties;
        detail::NamedBy named;
        std::uint32_t bodies = 1 + std::uint32_t(random() % 40);
        const auto some = [&] {
            std::vector<std::uint32_t> ends(1 + random() % 4);
            for (auto& body : ends) body = std::uint32_t(random() % bodies);
            return ends;
        };
        for (int verb = 0; verb < 300; ++verb) {
            const auto what = random() % 10;
            if (what < 4 || ties.bodies.empty()) {
                ties.bodies.push_back(some());
                named.note(std::uint32_t(ties.bodies.size() - 1));
            } else if (what < 5) {
                const auto id = std::uint32_t(random() % ties.bodies.size());
                ties.bodies[id] = some(); // another description, or an id that is given out again
                named.note(id);
            } else if (what < 7) ties.bodies[random() % ties.bodies.size()].clear();
            else if (what < 8) ++bodies;
            else if (what < 9) {
                const detail::NamedBy copy = named; // knows nothing, and has to find its own
                CHECK(!copy.known());
                if (random() % 2) named = copy;
            } else {
                named.find(ties, bodies);
                const auto body = std::uint32_t(random() % bodies);
                std::vector<std::uint32_t> found;
                named.each(body, [&](std::uint32_t id) {
                    if (ties.names(id, body)) found.push_back(id);
                });
                CHECK(found == ties.all_naming(body));
            }
        }
    }
}
TEST_CASE("n removals look at each element a few times, not n times", "[named_by]") {
    constexpr std::uint32_t n = 4000;
    Ties chain;
    for (std::uint32_t i = 0; i + 1 < n; ++i) chain.bodies.push_back({i, i + 1});
    detail::NamedBy named;
    for (std::uint32_t body = 0; body < n; ++body) {
        named.find(chain, n);
        named.each(body, [&](std::uint32_t id) { chain.bodies[id].clear(); });
    }
    CHECK(chain.looks == 2 * (n - 1)); // both when all were found
    // With as many added in between, the square root of n at a time.
    Ties changing;
    for (std::uint32_t i = 0; i + 1 < n; ++i) changing.bodies.push_back({i, i + 1});
    for (std::uint32_t body = 0; body < n; ++body) {
        named.find(changing, n);
        named.each(body, [&](std::uint32_t id) { changing.bodies[id].clear(); });
        changing.bodies.push_back({n - 1, n - 1});
        named.note(std::uint32_t(changing.bodies.size() - 1));
    }
    CHECK(changing.looks < 100 * long(n));
}
TEST_CASE("Springs go with their bodies, in a world, in its copy and in one that is assigned", "[named_by]") {
    World world{SemiImplicitEuler{}, Springs{}};
    std::mt19937 random(11);
    std::vector<Handle> bodies;
    std::vector<std::array<Handle, 2>> ends;
    std::vector<ElementHandle<Spring>> springs;
    const auto check = [&](const auto& in) {
        std::size_t alive = 0;
        for (std::size_t i = 0; i < springs.size(); ++i) {
            const bool there = in.contains(ends[i][0]) && in.contains(ends[i][1]);
            alive += there;
            CHECK(in.contains(springs[i]) == there);
        }
        CHECK(in.template elements<Spring>().size() == alive);
    };
    auto other = world;
    for (int verb = 0; verb < 600; ++verb) {
        const auto what = random() % 8;
        if (what < 3 || bodies.size() < 2)
            bodies.push_back(world.add(position(metres(double(verb), 0, 0)), mass(1.0 * kilogram)));
        else if (what < 6) {
            const auto a = bodies[random() % bodies.size()], b = bodies[random() % bodies.size()];
            if (a == b) continue;
            springs.push_back(world.add(Spring{a, b, 1.0 * newton_per_metre}));
            ends.push_back({a, b});
        } else if (what < 7) {
            const auto which = random() % bodies.size();
            world.remove(bodies[which]);
            bodies.erase(bodies.begin() + long(which));
            check(world);
        } else {
            other.remove(other.add(position(metres(0, 0, 0)), fixed)); // it has found its own, of what it holds
            other = world;
            if (!bodies.empty()) {
                auto copy = other;
                copy.remove(bodies[random() % bodies.size()]);
                check(copy);
                const auto same = bodies[random() % bodies.size()];
                other.remove(same);
                check(other);
                auto third = world;
                third.remove(same);
                CHECK(third.hash() == other.hash()); // which handles come next is state
            }
        }
    }
}
