// SPDX-License-Identifier: BSL-1.0
// What becomes of contacts where a body is divided: siblings against a plain model of sets; contacts and impulses by
// their laws. Whole worlds stand in tests/soft_bodies/tearing_in_collisions.cpp.

#include <ansatz/collision/division.hpp>
#include <ansatz/world/space.hpp>

#include "tests/catch.hpp"

#include <array>
#include <map>
#include <random>
#include <set>

using namespace ansatz;

namespace {
/// Which bodies were one, as sets.
struct Sets {
    std::map<std::uint32_t, int> group;
    int next = 1;
    void divided(std::uint32_t id, std::uint32_t part) {
        if (group.count(id) == 0) group[id] = next++;
        group[part] = group[id];
    }
    void leave(std::uint32_t id) {
        if (group.count(id) == 0) return;
        const int left = group[id];
        group.erase(id);
        std::vector<std::uint32_t> others;
        for (const auto& [other, of] : group)
            if (of == left) others.push_back(other);
        if (others.size() == 1) group.erase(others[0]);
    }
    bool are(std::uint32_t a, std::uint32_t b) const {
        return group.count(a) > 0 && group.count(b) > 0 && group.at(a) == group.at(b);
    }
};
struct Impulse_ {
    std::uint32_t a, b;
    Eigen::Vector3d normal;
    double impulse;
    Eigen::Vector3d rubbing;
    Eigen::Vector3d on(std::uint32_t body) const { return (body == a ? 1 : -1) * (impulse * normal + rubbing); }
};
} // namespace

TEST_CASE("Siblings are those that were one and have not been apart, as sets say it", "[collision][division]") {
    std::mt19937 random(4);
    Siblings siblings;
    Sets sets;
    constexpr std::uint32_t most = 40;
    for (std::uint32_t id = 0; id < most; ++id) siblings.make_room(id);
    std::set<std::uint32_t> there{0, 1, 2, 3};
    std::size_t compared = 0;
    for (int i = 0; i < 600; ++i) {
        const auto any = [&] { return *std::next(there.begin(), std::ptrdiff_t(random() % there.size())); };
        const auto one = any();
        if (random() % 3 > 0 && there.size() < most) {
            std::uint32_t part = 0; // the smallest free id, which is often below that of the body it comes from
            while (there.count(part) > 0) ++part;
            siblings.divided(one, part);
            sets.divided(one, part);
            there.insert(part);
        } else if (there.size() > 4) {
            siblings.leave(one);
            sets.leave(one);
            if (random() % 2 == 0) there.erase(one);
        }
        CHECK(siblings.any() == !sets.group.empty());
        for (const auto a : there)
            for (const auto b : there)
                if (a != b) {
                    REQUIRE(siblings.are(a, b) == sets.are(a, b));
                    compared += sets.are(a, b);
                }
    }
    CHECK(compared > 1000);
    // Those that no body meets leave; the others stay together.
    const auto before = sets;
    siblings.part([](std::uint32_t a, std::uint32_t b) { return a % 2 == b % 2; });
    for (const auto a : there)
        for (const auto b : there) {
            if (a == b || !before.are(a, b)) continue;
            if (a % 2 == b % 2) CHECK(siblings.are(a, b));
        }
    siblings.part([](std::uint32_t, std::uint32_t) { return false; });
    CHECK_FALSE(siblings.any());
}

TEST_CASE("A divided body's contacts are its part's, from the same sides, and their impulses add up to what they were",
          "[collision][division]") {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> number(0.1, 1);
    std::vector<Impulse_> all;
    std::vector<Contact<Space<>>> contacts;
    for (std::uint32_t a = 0; a < 9; ++a)
        for (std::uint32_t b = a + 1; b < 9; ++b) {
            if (a == 2 || b == 2 || (a + b) % 3 == 0) continue; // 2 is free
            std::array<double, 7> x{};
            for (double& one : x) one = number(random);
            const Eigen::Vector3d normal = Eigen::Vector3d(x[0], x[1], x[2]).normalized();
            all.push_back({a, b, normal, x[3], Eigen::Vector3d(x[4], x[5], x[6])});
            Contact<Space<>> contact;
            contact.first = {a, 0};
            contact.second = {b, 0};
            contact.normal = normal;
            contacts.push_back(contact);
        }
    const auto before = all;
    const auto contacts_before = contacts;
    const double share = 0.3;
    detail::divide_impulses<true>(all, 5, 2, share);
    detail::copy_contacts(contacts, Handle{5, 0}, Handle{2, 1});
    const auto sorted = [](const auto& list, auto&& ids) {
        return std::is_sorted(list.begin(), list.end(), [&](const auto& x, const auto& y) { return ids(x) < ids(y); });
    };
    CHECK(sorted(all, [](const auto& c) { return std::pair(c.a, c.b); }));
    CHECK(sorted(contacts, [](const auto& c) { return std::pair(c.first.id, c.second.id); }));
    const auto find = [&](std::uint32_t a, std::uint32_t b) -> const Impulse_* {
        for (const auto& c : all)
            if (c.a == std::min(a, b) && c.b == std::max(a, b)) return &c;
        return nullptr;
    };
    std::size_t copies = 0;
    for (const auto& old : before) {
        const auto* now = find(old.a, old.b);
        REQUIRE(now != nullptr);
        if (old.a != 5 && old.b != 5) {
            CHECK(now->on(old.a) == old.on(old.a));
            continue;
        }
        const auto other = old.a == 5 ? old.b : old.a;
        const auto* part = find(2, other);
        REQUIRE(part != nullptr);
        CHECK((part->on(2) - share * old.on(5)).norm() < 1e-15);
        CHECK((now->on(other) + part->on(other) - old.on(other)).norm() < 1e-15);
        ++copies;
    }
    CHECK(copies > 3);
    CHECK(all.size() == before.size() + copies);
    REQUIRE(contacts.size() == contacts_before.size() + copies);
    for (const auto& c : contacts) {
        if (c.first.id != 2 && c.second.id != 2) continue;
        const bool first = c.first.id == 2;
        CHECK((first ? c.first : c.second) == Handle{2, 1});
        const auto other = first ? c.second : c.first;
        for (const auto& old : contacts_before)
            if ((old.first.id == 5 && old.second == other) || (old.second.id == 5 && old.first == other)) {
                const bool was_first = old.first.id == 5;
                CHECK((first == was_first ? c.normal : -c.normal) == old.normal);
            }
    }
}
