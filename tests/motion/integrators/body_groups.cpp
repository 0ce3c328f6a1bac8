// SPDX-License-Identifier: BSL-1.0
// Bodies in groups of neighbours: who is in one, how large they are, and that each hangs together.

#include <ansatz/motion/integrators/body_groups.hpp>

#include "tests/catch.hpp"
#include "tests/dice.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

using namespace ansatz;

namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

BodyGroups groups_of(std::size_t bodies, const Pairs& pairs) {
    BodyGroups groups;
    groups.make(bodies, [&](const auto& f) {
        for (const auto& [a, b] : pairs) f(a, b);
    });
    return groups;
}

/// Bodies that are connected have the same root.
class Components {
public:
    explicit Components(std::size_t bodies) : parent_(bodies) { std::iota(parent_.begin(), parent_.end(), 0u); }
    std::size_t root(std::size_t body) {
        while (parent_[body] != body) body = parent_[body] = parent_[parent_[body]];
        return body;
    }
    void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }

private:
    std::vector<std::size_t> parent_;
};

/// A sheet of n x n with the springs of its threads and both diagonals.
Pairs sheet(std::size_t n) {
    Pairs pairs;
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) {
            if (i + 1 < n) pairs.emplace_back(j * n + i, j * n + i + 1);
            if (j + 1 < n) pairs.emplace_back(j * n + i, (j + 1) * n + i);
            if (i + 1 < n && j + 1 < n) pairs.emplace_back(j * n + i, (j + 1) * n + i + 1);
            if (i + 1 < n && j + 1 < n) pairs.emplace_back(j * n + i + 1, (j + 1) * n + i);
        }
    return pairs;
}

std::size_t wanted(std::size_t coupled) {
    return std::max<std::size_t>(32, std::size_t(std::sqrt(double(coupled)) / 2));
}

/// What holds for all groups, whatever the pairs.
void check(std::size_t bodies, const Pairs& pairs) {
    const BodyGroups groups = groups_of(bodies, pairs);
    Components all(bodies), inside(bodies);
    std::vector<std::size_t> degree(bodies), size(groups.size()), in_component(bodies);
    for (const auto& [a, b] : pairs) {
        ++degree[a], ++degree[b];
        all.join(a, b);
        if (groups.of(a) == groups.of(b)) inside.join(a, b);
    }
    std::size_t coupled = 0, mistakes = 0;
    for (std::size_t body = 0; body < bodies; ++body) {
        coupled += degree[body] > 0;
        ++in_component[all.root(body)];
    }
    const std::size_t least = (wanted(coupled) + 1) / 2;
    std::vector<std::size_t> a_member(groups.size(), bodies);
    for (std::size_t body = 0; body < bodies; ++body) {
        const auto group = groups.of(body);
        const bool in_one = group != BodyGroups::none;
        mistakes += in_one != (degree[body] > 0 && in_component[all.root(body)] >= least);
        if (!in_one) continue;
        REQUIRE(group < groups.size());
        ++size[group];
        if (a_member[group] == bodies) a_member[group] = body;
        mistakes += inside.root(body) != inside.root(a_member[group]); // hangs together
    }
    CHECK(mistakes == 0);
    for (const std::size_t of_group : size) mistakes += of_group < least;
    CHECK(mistakes == 0);
}

} // namespace

TEST_CASE("groups of bodies hang together, are large enough, and hold all that are coupled to enough others",
          "[springs][implicit]") {
    for (const std::size_t n : {2u, 3u, 7u, 20u, 41u, 90u}) check(n * n, sheet(n));
    test::Dice dice(5);
    for (int round = 0; round < 200; ++round) {
        const auto bodies = 1 + dice.below<std::size_t>(3000);
        Pairs pairs;
        for (auto n = dice.below<std::size_t>(3 * bodies + 1); n > 0; --n) {
            const auto a = dice.below(bodies), b = dice.one_in(2) ? std::min(bodies - 1, a + 1) : dice.below(bodies);
            if (a != b) pairs.emplace_back(a, b); // a pair may come twice
        }
        check(bodies, pairs);
    }
}

TEST_CASE("a sheet has about twice as many groups as it has rows, each about as wide as it is long",
          "[springs][implicit]") {
    constexpr std::size_t n = 100;
    std::vector<std::size_t> place(n * n); // of each body in the sheet: numbers need not follow its rows
    std::iota(place.begin(), place.end(), 0u);
    test::Dice dice(4);
    for (std::size_t k = n * n; k > 1; --k) std::swap(place[k - 1], place[dice.below(k)]);
    std::vector<std::size_t> body_at(n * n);
    for (std::size_t body = 0; body < n * n; ++body) body_at[place[body]] = body;
    Pairs pairs = sheet(n);
    for (auto& [a, b] : pairs) a = body_at[a], b = body_at[b];
    const BodyGroups groups = groups_of(n * n, pairs);
    CHECK(groups.size() >= 2 * n * 9 / 10); // of half as many bodies as a row has
    CHECK(groups.size() <= 2 * n * 11 / 10);
    double spread = 0; // the mean square of the distance from the middle of one's group
    std::vector<double> x(groups.size()), y(groups.size()), count(groups.size());
    for (std::size_t body = 0; body < n * n; ++body) {
        x[groups.of(body)] += double(place[body] % n), y[groups.of(body)] += double(place[body] / n);
        ++count[groups.of(body)];
    }
    for (std::size_t body = 0; body < n * n; ++body) {
        const auto group = groups.of(body);
        const double dx = double(place[body] % n) - x[group] / count[group],
                     dy = double(place[body] / n) - y[group] / count[group];
        spread += (dx * dx + dy * dy) / double(n * n);
    }
    // Of a square of 50 bodies it is (50 - 1) / 6; of a row of them (50^2 - 1) / 12.
    CHECK(spread <= 1.5 * 49 / 6);
    // Groups beside each other have numbers near each other: a row of their matrix begins late.
    std::vector<std::size_t> first(groups.size());
    std::iota(first.begin(), first.end(), 0u);
    for (const auto& [a, b] : pairs) {
        const std::size_t i = groups.of(a), j = groups.of(b);
        first[std::max(i, j)] = std::min(first[std::max(i, j)], std::min(i, j));
    }
    double inside = 0;
    for (std::size_t group = 0; group < groups.size(); ++group) inside += double(group - first[group]);
    CHECK(inside <= 0.25 * double(groups.size() * groups.size()) / 2);
}

TEST_CASE("bodies that nothing couples, or only few others, are in no group", "[springs][implicit]") {
    CHECK(groups_of(0, {}).size() == 0);
    CHECK(groups_of(10, {}).size() == 0);
    Pairs twos;
    for (std::size_t n = 0; n < 1000; ++n) twos.emplace_back(2 * n, 2 * n + 1);
    CHECK(groups_of(2000, twos).size() == 0);
    Pairs rope;
    for (std::size_t n = 0; n < 99; ++n) rope.emplace_back(n, n + 1);
    const BodyGroups groups = groups_of(200, rope);
    CHECK(groups.size() == 3); // of 32, 32 and 36
    CHECK(groups.of(99) != BodyGroups::none);
    CHECK(groups.of(100) == BodyGroups::none);
}
