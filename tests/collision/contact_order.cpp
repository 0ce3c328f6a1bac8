// SPDX-License-Identifier: BSL-1.0
// The order of contacts: that of a stable sort by the ids of their bodies, however many one body has.

#include "tests/collision/support.hpp"
#include "tests/dice.hpp"

#include <ansatz/collision/contact_order.hpp>

#include <algorithm>
#include <utility>
#include <vector>

using namespace collision_tests;
using ansatz::test::Dice;

TEST_CASE("contacts are put in order, however many one body has", "[collision][contacts]") {
    using S = Space<float, 3>;
    ContactOrder<S> order;
    Dice dice(5);
    for (int round = 0; round < 200; ++round) {
        const std::size_t ids = 1 + dice.below(std::size_t(round < 100 ? 60 : 400));
        const auto any = [&](std::size_t n) {
            std::vector<Contact<S>> all(n);
            for (auto& c : all) {
                const auto a = dice.one_in(2) ? std::uint32_t(0) : std::uint32_t(dice.below(ids)); // 0: the ground
                c.first = {a, 0};
                c.second = {std::uint32_t(dice.below(ids)), 0};
            }
            return all;
        };
        const auto before = [](const Contact<S>& x, const Contact<S>& y) {
            return std::pair(x.first.id, x.second.id) < std::pair(y.first.id, y.second.id);
        };
        auto contacts = any(dice.below(std::size_t(300)));
        auto ordered = any(dice.one_in(2) ? 0 : dice.below(std::size_t(300)));
        std::stable_sort(ordered.begin(), ordered.end(), before);
        contacts.insert(contacts.end(), ordered.begin(), ordered.end());
        for (std::size_t i = 0; i < contacts.size(); ++i) contacts[i].steps = std::uint32_t(i); // who is who
        auto expected = contacts;
        std::stable_sort(expected.begin(), expected.end(), before);
        order.sort(contacts, ids, ordered.size());
        REQUIRE(contacts.size() == expected.size());
        for (std::size_t i = 0; i < contacts.size(); ++i) REQUIRE(contacts[i].steps == expected[i].steps);
    }
}
