// SPDX-License-Identifier: BSL-1.0
// What goes on from step to step: contacts that come, stay and go, and bodies that become sensors. Each that was there
// in the step before keeps its impulses, and no other has any, whatever list they are put together in.

#include "tests/collision/support.hpp"
#include "tests/dice.hpp"

#include <ansatz/collision/response/soft_contacts.hpp>

#include <array>
#include <map>
#include <utility>
#include <vector>

using namespace collision_tests;
using ansatz::test::Dice;

namespace {
/// What `take` asks of a world.
template <class S> struct Asked {
    struct {
        std::array<bool, 12> sensors{};
        bool is_sensor(std::uint32_t id) const { return sensors[id]; }
    } collisions;
    struct {
        std::uint32_t slot_of_id(std::uint32_t id) const { return 11 - id; }
    } bodies;
    struct {
        template <class Column> typename S::Position get(std::size_t slot) const {
            return metres(double(slot), double(slot * slot), 0);
        }
    } lanes;
};

/// Random pairs in order, some, none or all of them.
template <class S> std::vector<Contact<S>> any_pairs(Dice& dice) {
    std::vector<Contact<S>> all;
    const std::size_t one_in = 1 + dice.below(std::size_t(5));
    for (std::uint32_t a = 0; a < 12; ++a)
        for (std::uint32_t b = a + 1; b < 12; ++b) {
            if (!dice.one_in(int(one_in))) continue;
            Contact<S> contact;
            contact.first = {a, 0};
            contact.second = {b, 0};
            contact.normal = Eigen::Vector3d(0, 1, 0);
            contact.depth = 0.01 * double(a + b) * metre;
            all.push_back(contact);
        }
    return all;
}
} // namespace

TEST_CASE("contacts that go on keep their impulses, whichever come and go beside them", "[collision][soft]") {
    using S = Space<>;
    SoftContacts<S, true> contacts;
    Asked<S> asked;
    Dice dice(3);
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> known;
    std::size_t went_on = 0, came = 0;
    for (int step = 0; step < 2000; ++step) {
        for (auto& is : asked.collisions.sensors) is = dice.one_in(20);
        const auto found = any_pairs<S>(dice);
        contacts.take(asked, found);
        auto c = contacts.all.begin();
        for (const auto& one : found) {
            if (asked.collisions.is_sensor(one.first.id) || asked.collisions.is_sensor(one.second.id)) continue;
            REQUIRE(c != contacts.all.end());
            REQUIRE(detail::ids_of(*c) == detail::ids_of(one));
            const auto before = known.find(detail::ids_of(one));
            const double impulse = before == known.end() ? 0 : before->second;
            (before == known.end() ? came : went_on) += 1;
            REQUIRE(c->impulse == impulse);
            REQUIRE(c->rubbing == Eigen::Vector3d(-impulse, 0, impulse));
            const double y_a = double((11 - c->a) * (11 - c->a)), y_b = double((11 - c->b) * (11 - c->b));
            REQUIRE(c->touching == y_a - y_b + one.depth.value());
            ++c;
        }
        REQUIRE(c == contacts.all.end());
        known.clear();
        double next = step;
        for (auto& one : contacts.all) {
            one.impulse = known[detail::ids_of(one)] = ++next;
            one.rubbing = Eigen::Vector3d(-next, 0, next);
        }
    }
    CHECK(went_on > 10'000);
    CHECK(came > 10'000);
}
