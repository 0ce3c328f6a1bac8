// SPDX-License-Identifier: BSL-1.0
// Colours: no two springs of one hold the same body, none is lost, and what sleeps changes nothing.

#include <ansatz/soft_bodies/spring_colours.hpp>

#include "tests/catch.hpp"

#include <map>
#include <numeric>
#include <random>
#include <set>

using namespace ansatz;

namespace {
/// What SpringColours asks of a network.
struct Network {
    struct Link {
        std::uint32_t a, b;
        double rest_length, stiffness, damping;
    };
    std::vector<Link> all;
    std::uint64_t version = 1;
    const std::vector<Link>& pairs() const { return all; }
    std::uint64_t arrangement() const { return version; }
};
Network random_network(std::mt19937& random, std::uint32_t bodies, std::size_t springs) {
    Network network;
    while (network.all.size() < springs) {
        const auto a = std::uint32_t(random() % bodies), b = std::uint32_t(random() % bodies);
        const double rest = double(network.all.size()); // by which one is known again
        if (a != b) network.all.push_back({a, b, rest, rest + 0.25, rest + 0.5});
    }
    return network;
}
/// The colour of each spring, by its rest length; and that each is there once, with its numbers.
std::map<double, std::size_t> colours_of(const SpringColours<double>& colours, const Network& network) {
    std::map<double, std::size_t> found;
    for (std::size_t c = 0; c <= SpringColours<double>::most; ++c) {
        std::set<std::uint32_t> held;
        for (std::size_t n = colours.begin(c); n < colours.end(c); ++n) {
            const auto& link = network.all.at(std::size_t(colours.rest[n]));
            CHECK((colours.a[n] == link.a && colours.b[n] == link.b));
            CHECK((colours.stiffness[n] == link.stiffness && colours.damping[n] == link.damping));
            if (c < SpringColours<double>::most) CHECK((held.insert(link.a).second && held.insert(link.b).second));
            CHECK(found.emplace(link.rest_length, c).second);
        }
    }
    CHECK(found.size() == network.all.size());
    return found;
}
} // namespace

TEST_CASE("No two springs of a colour hold the same body, and each spring has one", "[soft_bodies][colours]") {
    std::mt19937 random(3);
    for (const std::uint32_t bodies : {2U, 5U, 40U, 300U}) {
        auto network = random_network(random, bodies, 600);
        SpringColours<double> colours;
        colours.colour(network, bodies);
        const auto by_spring = colours_of(colours, network);
        // A spring has the first colour that its bodies do not have: each colour below has a reason.
        for (const auto& [rest, colour] : by_spring) {
            const auto& link = network.all[std::size_t(rest)];
            std::set<std::size_t> reasons;
            for (std::size_t n = 0; n < std::size_t(rest); ++n) {
                const auto& other = network.all[n];
                if (other.a == link.a || other.a == link.b || other.b == link.a || other.b == link.b)
                    reasons.insert(by_spring.at(double(n)));
            }
            for (std::size_t c = 0; c < colour; ++c) CHECK(reasons.count(c) == 1);
            if (colour < SpringColours<double>::most) CHECK(reasons.count(colour) == 0);
        }
        // Bodies that are stored elsewhere have springs of the same colours.
        std::vector<std::uint32_t> slot(bodies);
        std::iota(slot.begin(), slot.end(), 0U);
        std::shuffle(slot.begin(), slot.end(), random);
        for (auto& link : network.all) link.a = slot[link.a], link.b = slot[link.b];
        colours.colour(network, bodies);
        CHECK(colours.a.size() == 600); // not checked again: it says that it is the same
        ++network.version;
        colours.colour(network, bodies);
        CHECK(colours_of(colours, network) == by_spring);
    }
}

TEST_CASE("What finds none of 64 colours is held by itself; a grid has about a dozen", "[soft_bodies][colours]") {
    Network star;
    for (std::uint32_t n = 1; n <= 70; ++n)
        star.all.push_back({0, n, double(n - 1), double(n) - 0.75, double(n) - 0.5});
    SpringColours<double> colours;
    colours.colour(star, 71);
    CHECK(colours.colours() == 64);
    CHECK(colours.end(64) - colours.begin(64) == 6);
    colours_of(colours, star);
    Network grid;
    grid.version = 2;
    constexpr std::uint32_t side = 50;
    const auto link = [&](std::uint32_t a, std::uint32_t b) {
        const double rest = double(grid.all.size());
        grid.all.push_back({a, b, rest, rest + 0.25, rest + 0.5});
    };
    for (std::uint32_t j = 0; j < side; ++j)
        for (std::uint32_t i = 0; i < side; ++i) {
            if (i + 1 < side) link(j * side + i, j * side + i + 1);
            if (j + 1 < side) link(j * side + i, (j + 1) * side + i);
            if (i + 1 < side && j + 1 < side) {
                link(j * side + i, (j + 1) * side + i + 1);
                link(j * side + i + 1, (j + 1) * side + i);
            }
        }
    colours.colour(grid, side * side);
    CAPTURE(colours.colours());
    CHECK(colours.colours() >= 8);  // springs at each body
    CHECK(colours.colours() <= 15); // and no more than those at both of its ends
    colours_of(colours, grid);
}
