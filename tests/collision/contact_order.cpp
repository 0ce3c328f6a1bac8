// SPDX-License-Identifier: BSL-1.0
// The order of contacts: that of a stable sort by the ids of their bodies, however many one body has.

#include "tests/collision/support.hpp"
#include "tests/dice.hpp"

#include <ansatz/collision/contact_order.hpp>

#include <algorithm>
#include <map>
#include <set>
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
        if (dice.one_in(4)) std::stable_sort(contacts.begin(), contacts.end(), before); // as kept pairs come
        auto ordered = any(dice.one_in(2) ? 0 : dice.below(std::size_t(300)));
        std::stable_sort(ordered.begin(), ordered.end(), before);
        contacts.insert(contacts.end(), ordered.begin(), ordered.end());
        for (std::size_t i = 0; i < contacts.size(); ++i) contacts[i].steps = std::uint32_t(i); // which is which
        auto expected = contacts;
        std::stable_sort(expected.begin(), expected.end(), before);
        order.sort(contacts, ids, ordered.size());
        REQUIRE(contacts.size() == expected.size());
        for (std::size_t i = 0; i < contacts.size(); ++i) REQUIRE(contacts[i].steps == expected[i].steps);
    }
}

TEST_CASE("a list that is in order stays where it is, and one that is not is put in order behind it",
          "[collision][contacts]") {
    using S = Space<>;
    ContactOrder<S> order;
    std::vector<Contact<S>> contacts(100);
    for (std::uint32_t n = 0; n < 100; ++n) {
        contacts[n].first = {n / 2, 0};
        contacts[n].second = {100 + n % 2, 0};
    }
    const auto* const place = contacts.data();
    order.sort(contacts, 200);
    CHECK(contacts.data() == place);
    std::swap(contacts.front(), contacts.back());
    order.sort(contacts, 200);
    for (std::uint32_t n = 0; n < 100; ++n) {
        CHECK(contacts[n].first.id == n / 2);
        CHECK(contacts[n].second.id == 100 + n % 2);
    }
}

namespace {
struct Acting {
    struct One {
        std::uint32_t a, b;
        double impulse;
    };
    std::vector<One> all;
};
} // namespace

TEST_CASE("of the contacts that were found those stay that touch or press, and what has ended is told",
          "[collision][contacts]") {
    using S = Space<>;
    Dice dice(11);
    int stayed = 0, pressed = 0;
    std::vector<Contact<S>> known;
    for (int round = 0; round < 300; ++round) {
        std::vector<Contact<S>> found;
        Acting acting;
        std::vector<std::uint32_t> touch, touch_or_press;
        for (std::uint32_t a = 0; a < 10; ++a)
            for (std::uint32_t b = a + 1; b < 10; ++b) {
                const bool is_found = dice.one_in(2), acts = dice.one_in(2), presses = dice.one_in(2);
                if (acts) acting.all.push_back({a, b, presses ? 1.0 : 0.0});
                if (!is_found) continue;
                Contact<S> contact;
                contact.normal = Eigen::Vector3d::UnitX();
                contact.point = metres(0, 0, 0);
                contact.first = {a, 0};
                contact.second = {b, 0};
                contact.depth = (dice.one_in(3) ? 0.0 : dice.one_in(2) ? 0.1 : -0.1) * metre;
                found.push_back(contact);
                const bool deep = contact.depth > 0.0 * metre;
                if (deep) touch.push_back(a * 10 + b);
                if (deep || (acts && presses)) touch_or_press.push_back(a * 10 + b);
                pressed += !deep && acts && presses;
            }
        const auto pairs = [](const std::vector<Contact<S>>& all) {
            std::vector<std::uint32_t> made;
            for (const auto& c : all) made.push_back(c.first.id * 10 + c.second.id);
            return made;
        };
        // Those of the round before are known; of one pair in three the first body is another one with that id.
        for (auto& c : known)
            if (dice.one_in(3)) c.first.generation = 1;
        std::map<std::uint32_t, Contact<S>> before;
        for (const auto& c : known) before[c.first.id * 10 + c.second.id] = c;
        const auto check = [&](std::vector<Contact<S>>& all, auto stays, const std::vector<std::uint32_t>& right) {
            std::vector<std::pair<Handle, Handle>> ended;
            detail::compare_contacts(known, all, ended, false, stays);
            REQUIRE(pairs(all) == right);
            std::set<std::uint32_t> go_on;
            for (const auto& c : all) {
                const auto old = before.find(c.first.id * 10 + c.second.id);
                const bool goes_on = old != before.end() && old->second.first == c.first;
                REQUIRE(c.steps == (goes_on ? old->second.steps + 1 : 0));
                if (goes_on) go_on.insert(old->first);
            }
            REQUIRE(ended.size() == before.size() - go_on.size());
            for (const auto& [first, second] : ended) REQUIRE(go_on.count(first.id * 10 + second.id) == 0);
        };
        auto both = found;
        check(found, detail::KeepThoseThatTouch<false, Acting>(acting), touch);
        check(both, detail::KeepThoseThatTouch<true, Acting>(acting), touch_or_press);
        known = both;
        stayed += int(found.size());
    }
    CHECK(stayed > 1000);
    CHECK(pressed > 1000);
}
