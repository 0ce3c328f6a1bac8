// SPDX-License-Identifier: BSL-1.0
// The contacts that act and those that sleep, against one plain list of both.

#include "tests/catch.hpp"
#include "tests/dice.hpp"

#include <ansatz/collision/contact_lists.hpp>
#include <ansatz/units.hpp>
#include <ansatz/world/space.hpp>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <thread>
#include <utility>
#include <vector>

using namespace ansatz;
using ansatz::test::Dice;

namespace {

using S = Space<float, 3>;
using Ids = std::pair<std::uint32_t, std::uint32_t>;

/// Contacts of a few bodies, in order, each pair once.
std::vector<Contact<S>> some_contacts(Dice& dice, std::uint32_t bodies) {
    std::map<Ids, Contact<S>> by_ids;
    for (auto n = dice.below(30); n > 0; --n) {
        Contact<S> c;
        c.first = {dice.below(bodies), 0};
        c.second = {c.first.id + 1 + dice.below(bodies), 0};
        c.steps = dice.below(std::uint32_t(5));
        by_ids[detail::ids_of(c)] = c;
    }
    std::vector<Contact<S>> all;
    for (const auto& [ids, c] : by_ids) all.push_back(c);
    return all;
}
std::map<Ids, std::uint32_t> steps_of(const std::vector<Contact<S>>& contacts) {
    std::map<Ids, std::uint32_t> steps;
    for (const auto& c : contacts) steps[detail::ids_of(c)] = c.steps;
    CHECK(steps.size() == contacts.size());
    CHECK(std::ranges::is_sorted(contacts, {}, [](const auto& c) { return detail::ids_of(c); }));
    return steps;
}

} // namespace

TEST_CASE("a contact has lasted as long, whether its bodies sleep or not", "[collision][contacts]") {
    Dice dice(4);
    ContactLists<S> lists;
    std::map<Ids, std::uint32_t> expected;
    bool some_slept = false;
    int came_back = 0;
    for (int round = 0; round < 3000; ++round) {
        if (dice.one_in(50)) { // other contacts
            lists = {};
            lists.acting = some_contacts(dice, 10);
            lists.changed();
            expected = steps_of(lists.acting);
        }
        if (dice.one_in(3)) { // a step
            lists.sleep_on();
            for (auto& c : lists.acting) ++c.steps;
            for (auto& [ids, steps] : expected) ++steps;
        }
        if (dice.one_in(4)) {
            const auto which = dice.below(10u);
            lists.make_room_to_sleep(lists.acting.size(), 20);
            lists.put_to_sleep([&](const auto& c) { return c.first.id == which; });
        }
        if (dice.one_in(10)) { // all wake, or some
            const bool all = dice.one_in(2);
            lists.make_room_to_wake();
            for (std::uint32_t id = 0; id < 20; ++id)
                if (all || dice.one_in(8)) {
                    lists.leave(id);
                    CHECK(!lists.has_sleeping(id));
                }
            lists.wake();
            CHECK(!lists.any_left());
            if (all) {
                CHECK(!lists.any_sleep());
                CHECK(steps_of(lists.acting) == expected);
            }
            steps_of(lists.acting); // are in order
        }
        if (dice.one_in(10)) { // as they are gone through, bodies wake
            lists.make_room_to_wake();
            const auto acting = steps_of(lists.acting);
            std::set<Ids> visited, come; // which have come back behind the one that was visited
            lists.each_acting([&](const auto& c) {
                const auto ids = detail::ids_of(c);
                CHECK(expected.at(ids) == c.steps);
                CHECK((visited.empty() || *visited.rbegin() < ids)); // in order
                visited.insert(ids);
                CHECK((acting.contains(ids) || come.contains(ids)));
                if (!dice.one_in(3)) return;
                const auto id = dice.one_in(2) ? ids.first : ids.second;
                lists.each_of(id, [&](const auto& sleeper) {
                    const auto its = detail::ids_of(sleeper);
                    if (!acting.contains(its) && ids < its) come.insert(its);
                });
                lists.leave(id, c);
            });
            for (const auto& [ids, steps] : acting) CHECK(visited.contains(ids));
            for (const auto& ids : come) CHECK(visited.contains(ids));
            came_back += int(come.size());
            lists.wake();
        }
        if (dice.one_in(10)) { // of a copy, and of what is assigned to one that has been asked
            const ContactLists<S> copy = lists;
            CHECK(steps_of(copy.all()) == expected);
            ContactLists<S> other;
            other.acting = some_contacts(dice, 10);
            other.make_room_to_sleep(other.acting.size(), 20);
            other.put_to_sleep([](const auto& c) { return c.first.id % 2 == 0; });
            CHECK(other.all().size() >= other.acting.size());
            other = lists;
            CHECK(steps_of(other.all()) == expected);
        }
        some_slept = some_slept || lists.any_sleep();
        const auto* const first = lists.all().data();
        CHECK(steps_of(lists.all()) == expected);
        CHECK(lists.all().data() == first); // put together once
        const auto a = dice.below(10u), b = dice.below(20u);
        CHECK(lists.has(a, b) == expected.contains({a, b}));
    }
    CHECK(some_slept);
    CHECK(came_back > 50);
}

TEST_CASE("several threads may ask for all contacts at once", "[collision][contacts]") {
    Dice dice(6);
    for (int round = 0; round < 50; ++round) {
        ContactLists<S> lists;
        while (lists.acting.size() < 3) lists.acting = some_contacts(dice, 10);
        const auto expected = steps_of(lists.acting);
        lists.make_room_to_sleep(lists.acting.size(), 20);
        lists.put_to_sleep([&](const auto& c) { return c.first.id != lists.acting.front().first.id; });
        std::vector<const Contact<S>*> seen(4);
        std::vector<std::thread> threads;
        for (auto& one : seen) threads.emplace_back([&] { one = lists.all().data(); });
        for (auto& thread : threads) thread.join();
        for (const auto* one : seen) CHECK(one == lists.all().data());
        CHECK(steps_of(lists.all()) == expected);
    }
}
