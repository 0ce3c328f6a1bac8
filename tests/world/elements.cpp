// SPDX-License-Identifier: BSL-1.0
// The ids of what policies keep beside the bodies.

#include <ansatz/world/elements.hpp>

#include "tests/catch.hpp"

#include <ansatz/world/hash.hpp>

using namespace ansatz;

namespace {
struct Peg {
    using element = Peg;
};
struct NoElement {};
static_assert(Element<Peg> && !Element<NoElement> && !Element<int>);
using PegHandle = ElementHandle<Peg>;
} // namespace

TEST_CASE("ids of elements: given again with another generation, last freed first", "[world][elements]") {
    ElementIds ids;
    const auto a = ids.take(), b = ids.take(), c = ids.take();
    CHECK((a == 0 && b == 1 && c == 2));
    CHECK(ids.size() == 3);
    ids.give_back(a);
    ids.give_back(c);
    CHECK(ids.size() == 1);
    CHECK_FALSE(ids.contains(PegHandle{a, 0}));
    CHECK(ids.contains(PegHandle{b, 0}));
    CHECK(ids.next() == c);
    CHECK(ids.take() == c);
    CHECK(ids.generation(c) == 1);
    CHECK(ids.contains(PegHandle{c, 1}));
    CHECK_FALSE(ids.contains(PegHandle{c, 0}));
    CHECK_FALSE(ids.contains(PegHandle{}));
    CHECK_THROWS_AS(ids.id(PegHandle{a, 0}, "here"), std::out_of_range);
    CHECK(ids.id(PegHandle{b, 0}, "here") == b);
}

TEST_CASE("the hash of ids sees which live and which come next", "[world][elements]") {
    auto hash_of = [](const ElementIds& ids) {
        StateHash hash;
        ids.add_to(hash);
        return hash.value();
    };
    ElementIds one, two;
    for (auto* ids : {&one, &two})
        for (int i = 0; i < 3; ++i) ids->take();
    CHECK(hash_of(one) == hash_of(two));
    one.give_back(0);
    one.give_back(1);
    two.give_back(1);
    two.give_back(0);
    CHECK_FALSE(hash_of(one) == hash_of(two)); // the next handle is another
}
