// SPDX-License-Identifier: BSL-1.0
// NamedBy against a plain list: whatever was added, renamed and removed since it was found, no element that names a
// body is missed, and each is told once, by id.

#include <ansatz/world/named_by.hpp>

#include "tests/catch.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <iterator>
#include <map>
#include <random>
#include <vector>

using ansatz::detail::NamedBy;

namespace {

/// Elements by id, and the bodies that each names: what NamedBy asks of a table, and no more.
struct Elements {
    std::map<std::uint32_t, std::vector<std::uint32_t>> rows;

    void for_each(auto&& f) const {
        for (const auto& [id, bodies] : rows) f(id, bodies);
    }
    void for_each_backwards(auto&& f) const {
        for (auto row = rows.rbegin(); row != rows.rend(); ++row) f(row->first);
    }
    void for_each_body(std::uint32_t id, auto&& f) const {
        for (const auto body : rows.at(id)) f(body);
    }
};

std::vector<std::uint32_t> told(const NamedBy& named, std::uint32_t body) {
    std::vector<std::uint32_t> ids;
    named.each(body, [&](std::uint32_t id) { ids.push_back(id); });
    return ids;
}

} // namespace

TEST_CASE("what names a body is told as a plain list tells it, whatever happened since it was found", "[world]") {
    std::mt19937 random(GENERATE(1u, 2u, 3u, 4u));
    const auto number = [&](std::uint32_t below) { return std::uint32_t(random() % below); };
    constexpr std::uint32_t bodies = 12;
    Elements table;
    NamedBy named;
    std::uint32_t next = 0;
    int found = 0;

    const auto names = [&](std::uint32_t id) {
        table.rows[id].clear();
        for (auto n = number(4); n > 0; --n) table.rows[id].push_back(number(bodies)); // no body, or one twice, too
        named.note(id);
    };
    for (int turn = 0; turn < 4000; ++turn) {
        const auto what = number(10);
        if (what < 5 || table.rows.empty()) names(next += 1 + number(2));
        else {
            const auto row = std::next(table.rows.begin(), number(std::uint32_t(table.rows.size())));
            if (what < 7) names(row->first);
            else table.rows.erase(row);
        }
        if (turn % 7 != 0) continue;
        if (!named.known()) ++found;
        named.find(table, bodies);
        REQUIRE(named.known());
        for (std::uint32_t body = 0; body < bodies; ++body) {
            const auto ids = told(named, body);
            REQUIRE(std::adjacent_find(ids.begin(), ids.end(), std::greater_equal<>()) == ids.end());
            for (const auto& [id, all] : table.rows)
                if (std::find(all.begin(), all.end(), body) != all.end())
                    REQUIRE(std::binary_search(ids.begin(), ids.end(), id));
        }
    }
    CHECK(found > 3);         // it grew old,
    CHECK(found < 4000 / 14); // and was not found anew each time
}

TEST_CASE("what was found costs nothing again, and a copy finds its own", "[world]") {
    Elements table{{{3, {0, 1}}, {5, {1}}, {8, {2, 2}}}};
    NamedBy named;
    CHECK_FALSE(named.known());
    named.find(table, 3);
    CHECK(told(named, 0) == std::vector<std::uint32_t>{3});
    CHECK(told(named, 1) == std::vector<std::uint32_t>{3, 5});
    CHECK(told(named, 2) == std::vector<std::uint32_t>{8});
    CHECK(told(named, 77).empty()); // a body that is newer than what was found

    table.rows.erase(5);
    named.find(table, 3); // known: it does not search
    CHECK(told(named, 1) == std::vector<std::uint32_t>{3, 5});
    named.note(9);
    CHECK(told(named, 1) == std::vector<std::uint32_t>{3, 5, 9});
    CHECK(told(named, 77) == std::vector<std::uint32_t>{9});

    NamedBy copy = named;
    CHECK_FALSE(copy.known());
    copy.find(table, 3);
    CHECK(told(copy, 1) == std::vector<std::uint32_t>{3});
    named = copy;
    CHECK_FALSE(named.known());
}
