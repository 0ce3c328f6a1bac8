// SPDX-License-Identifier: BSL-1.0
// ContactGroups: each contact stands in one group, groups of a stage push different bodies, and all that follows from
// ids and contacts alone.

#include <ansatz/collision/response/contact_groups.hpp>

#include "tests/catch.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <utility>
#include <vector>

using ansatz::ContactGroups;

namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

/// As wide as a block of so many ids must be: the least power of two that makes 32 of them enough.
std::size_t width_of(std::size_t ids) {
    std::size_t width = 1024;
    while (width * 32 < ids) width *= 2;
    return width;
}
/// A loop in two ranges, the second one first.
const auto in_halves = [](std::size_t count, std::size_t, const auto& loop) {
    loop(count / 2, count);
    loop(std::size_t(0), count / 2);
};
ContactGroups divided(const std::vector<Pair>& pairs, std::size_t ids) {
    ContactGroups groups;
    groups.divide(
        pairs.size(), ids, [&](std::size_t n) { return pairs[n]; }, in_halves);
    return groups;
}
std::uint32_t at(const ContactGroups& groups, std::uint32_t place) {
    return groups.order() ? groups.order()[place] : place;
}
Pair blocks_of(const Pair& pair, std::size_t width) {
    return {std::uint32_t(pair.first / width), std::uint32_t(pair.second / width)};
}
std::vector<Pair> by_chance(std::size_t ids, std::size_t count, std::size_t reach, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<Pair> pairs;
    for (std::size_t n = 0; n < count; ++n) {
        const auto a = std::uint32_t(random() % ids);
        const auto b = std::uint32_t(std::min<std::size_t>(ids - 1, a + random() % reach));
        pairs.push_back(random() % 5 == 0 ? Pair(a, a) : Pair(a, b));
    }
    return pairs;
}

/// All that is promised, by looking at every contact.
void check(const std::vector<Pair>& pairs, std::size_t ids) {
    INFO(pairs.size() << " contacts of " << ids << " ids");
    const auto groups = divided(pairs, ids);
    const std::size_t width = width_of(ids);
    std::vector<int> times(pairs.size(), 0);
    std::uint32_t next_place = 0, next_group = 0;
    for (std::size_t stage = 0; stage < groups.stages().size(); ++stage) {
        const auto range = groups.stages()[stage];
        REQUIRE(range.begin == next_group);
        REQUIRE(range.end > range.begin);
        next_group = range.end;
        std::set<std::uint32_t> pushed; // blocks
        for (auto group = range.begin; group < range.end; ++group) {
            const auto places = groups[group];
            REQUIRE(places.begin == next_place);
            REQUIRE(places.end > places.begin);
            next_place = places.end;
            const auto blocks = blocks_of(pairs[at(groups, places.begin)], width);
            for (auto place = places.begin; place < places.end; ++place) {
                const auto n = at(groups, place);
                REQUIRE(n < pairs.size());
                ++times[n];
                REQUIRE(blocks_of(pairs[n], width) == blocks);
                if (place > places.begin) REQUIRE(at(groups, place - 1) < n); // in their order
            }
            const auto first_of_stage = blocks_of(pairs[at(groups, groups[range.begin].begin)], width);
            CHECK((blocks.first == blocks.second) == (first_of_stage.first == first_of_stage.second));
            if (blocks.first == blocks.second) CHECK(stage == 0);
            CHECK(pushed.insert(blocks.first).second);
            if (blocks.second != blocks.first) CHECK(pushed.insert(blocks.second).second);
        }
    }
    CHECK(next_group == groups.size());
    CHECK(next_place == pairs.size());
    CHECK(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; }));
    CHECK(groups.stages().size() <= 62);
}

} // namespace

TEST_CASE("Groups of contacts: each contact once, and no block twice in a stage", "[collision][soft]") {
    for (const std::size_t ids : {1u, 7u, 1024u, 1025u, 2048u, 2049u, 9000u, 32768u, 32769u, 70000u, 200000u})
        for (const std::size_t count : {std::size_t(0), std::size_t(1), std::size_t(500), std::size_t(6000)})
            for (const std::size_t reach : {std::size_t(1), std::size_t(40), std::size_t(3000), ids})
                check(by_chance(ids, count, reach, unsigned(ids + count + reach)), ids);
}

TEST_CASE("Groups of contacts: one of up to 1024 ids, in the order of the contacts", "[collision][soft]") {
    const auto pairs = by_chance(1024, 300, 1024, 5);
    const auto groups = divided(pairs, 1024);
    REQUIRE(groups.size() == 1);
    CHECK(groups.stages().size() == 1);
    for (std::uint32_t n = 0; n < 300; ++n) CHECK(at(groups, n) == n);
    CHECK(divided(pairs, 1025).size() > 0);
    CHECK(divided({{0, 0}, {1024, 1024}}, 1025).size() == 2); // and two of one more
}

TEST_CASE("Groups of contacts: neighbours in a row take two stages behind the first", "[collision][soft]") {
    std::vector<Pair> chain;
    for (std::uint32_t n = 0; n + 1 < 32 * 1024; ++n) chain.emplace_back(n, n + 1);
    const auto groups = divided(chain, 32 * 1024);
    REQUIRE(groups.stages().size() == 3);
    CHECK(groups.stages()[0].size() == 32);
    CHECK(groups.stages()[1].size() == 16); // blocks 0 and 1, 2 and 3, ...
    CHECK(groups.stages()[2].size() == 15); // 1 and 2, ...
    CHECK(groups[32].size() == 1);
}

TEST_CASE("Groups of contacts: every block with every other one fits", "[collision][soft]") {
    std::vector<Pair> all;
    for (std::uint32_t p = 0; p < 32; ++p)
        for (std::uint32_t q = p; q < 32; ++q) all.emplace_back(p * 1024, q * 1024);
    check(all, 32 * 1024);
    CHECK(divided(all, 32 * 1024).size() == 32 * 33 / 2);
}

TEST_CASE("Groups of contacts: what runs them is told whole stages, and a thread is not woken for little",
          "[collision][soft]") {
    const auto pairs = by_chance(9000, 6000, 2000, 3);
    const auto groups = divided(pairs, 9000);
    std::vector<std::size_t> visited, counts;
    groups.each(
        [&](std::size_t count, std::size_t grain, const auto& loop) {
            const auto stage = groups.stages()[counts.size()];
            CHECK(count == stage.size());
            const std::size_t contacts = groups[stage.end - 1].end - groups[stage.begin].begin;
            CHECK(grain >= 1);
            CHECK(grain * contacts >= 512 * count); // a range has 512 or more, if groups are alike
            if (grain > 1) CHECK((grain - 1) * contacts < 512 * count);
            counts.push_back(count);
            loop(count, count); // an empty range
            for (std::size_t n = count; n-- > 0;) loop(n, n + 1);
        },
        [&](std::size_t group) { visited.push_back(group); });
    CHECK(counts.size() == groups.stages().size());
    REQUIRE(visited.size() == groups.size());
    std::size_t before = 0; // groups of the stages before
    for (const auto count : counts) {
        for (std::size_t n = 0; n < count; ++n) CHECK(visited[before + n] == before + count - 1 - n);
        before += count;
    }
    ContactGroups none;
    none.each([](std::size_t, std::size_t, const auto&) { FAIL("of no contacts there is no stage"); },
              [](std::size_t) {});
}

TEST_CASE("Groups of contacts: used again, they are those of the last contacts", "[collision][soft]") {
    ContactGroups groups;
    const auto many = by_chance(9000, 6000, 9000, 4), few = by_chance(600, 30, 600, 4);
    for (const auto* pairs : {&many, &few, &many}) {
        const std::size_t ids = pairs == &few ? 600 : 9000;
        groups.divide(
            pairs->size(), ids, [&](std::size_t n) { return (*pairs)[n]; }, in_halves);
        const auto fresh = divided(*pairs, ids);
        REQUIRE(groups.size() == fresh.size());
        REQUIRE(groups.stages().size() == fresh.stages().size());
        for (std::uint32_t n = 0; n < pairs->size(); ++n) REQUIRE(at(groups, n) == at(fresh, n));
    }
    ContactGroups copy;
    copy.make_room_for(groups);
    copy = groups;
    for (std::uint32_t n = 0; n < many.size(); ++n) REQUIRE(at(copy, n) == at(groups, n));
}
