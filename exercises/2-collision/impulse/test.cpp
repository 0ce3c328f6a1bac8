// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on the impulse of a collision (notes 2.2.1).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using exercise::Body;
using MetresPerSecond = Quantity<unit::Velocity>;
using Vector3 = Vector<double, 3>;
using Velocity3 = VectorQuantity<unit::Velocity, 3>;

const MetresPerSecond tolerance = 1e-12 * metre_per_second;

/// Two bodies, where they go, and the normal; the speed of separation by their way to each other.
struct Flight {
    Velocity3 first, second;
    Vector3 normal;
    double parting;
    MetresPerSecond yours() const { return exercise::parting_speed(first, second, normal); }
};
const std::vector<Flight> approaching{
    {metres_per_second(-3, 0, 0), metres_per_second(2, 0, 0), {1, 0, 0}, -5},     // head-on
    {metres_per_second(1, 4, 0), metres_per_second(-2, 4.5, 1), {0, 1, 0}, -0.5}, // overtaken by the second
    {metres_per_second(0, 0, 0), metres_per_second(3, 4, -7), {0.6, 0.8, 0}, -5}, // the first at rest
    {metres_per_second(2, 1, -2), metres_per_second(0, 0, 0), {-2.0 / 3, 1.0 / 3, 2.0 / 3}, -7.0 / 3}};
const std::vector<Flight> parting{{metres_per_second(3, 1, 0), metres_per_second(-2, 1, 0), {1, 0, 0}, 5},
                                  {metres_per_second(0, 6, 0), metres_per_second(2, 5.5, 1), {0, 1, 0}, 0.5}};
const std::vector<Flight> side_by_side{{metres_per_second(5, 0, 0), metres_per_second(5, 0, 0), {1, 0, 0}, 0},
                                       {metres_per_second(3, -4, 2), metres_per_second(-3, -4, 2), {0, 1, 0}, 0}};

std::string said(const Flight& f) {
    std::ostringstream text;
    text << "the first with " << f.first << ", the second with " << f.second << ", N = (" << f.normal.transpose()
         << ")";
    return text.str();
}
void expect_parting(const std::vector<Flight>& flights, const char* why) {
    for (const Flight& f : flights)
        expect_near(said(f) + ": how fast they separate", f.yours(), f.parting * metre_per_second, tolerance, why);
}

/// Two materials that meet.
struct Materials {
    double first, second, approach, threshold, right;
    double yours() const {
        return exercise::bounce(first, second, -approach * metre_per_second, threshold * metre_per_second);
    }
};
const std::vector<Materials> fast{{0.5, 0.5, 4, 0.25, 0.5},
                                  {0.9, 0.2, 4, 0.25, 0.9},
                                  {0.3, 0.8, 0.3, 0.25, 0.8},
                                  {0, 0.7, 30, 1, 0.7},
                                  {1, 0.4, 2, 0, 1}};
const std::vector<Materials> slow{{0.5, 0.7, 0.2, 0.25, 0}, {1, 1, 0.9, 1, 0}, {0.3, 0.8, 0.25, 0.25, 0}};
void expect_bounce(const std::vector<Materials>& all, const char* why) {
    for (const Materials& m : all) {
        std::ostringstream text;
        text << "e = " << m.first << " meets e = " << m.second << " at " << m.approach << " m/s, with a threshold of "
             << m.threshold << " m/s: e of this meeting";
        expect_near(text.str(), m.yours(), m.right, 1e-12, why);
    }
}

/// What an impulse is made of; 1/m in 1/kg.
struct Hit {
    double parting, first, second, e;
    auto yours() const { return exercise::impulse(parting * metre_per_second, first / kilogram, second / kilogram, e); }
};
const std::vector<Hit> hits{{-3, 0.5, 0.5, 1}, {-2, 2, 0.25, 0.5}, {-0.7, 0.125, 3, 0}, {-40, 0.2, 0.7, 0.8}};
const std::vector<Hit> at_walls{{-3, 0, 0.5, 0.5}, {-0.5, 4, 0, 1}, {-7, 0, 0.25, 0}};
const std::vector<Hit> parts{{3, 0.5, 0.5, 1}, {2, 2, 0.25, 0}, {0.1, 0, 3, 0.5}, {0, 1, 2, 0.5}};
std::string mass_of(double inverse) {
    std::ostringstream text;
    if (inverse > 0) text << 1 / inverse << " kg";
    else text << "something immovable";
    return text.str();
}
std::string said(const Hit& h) {
    std::ostringstream text;
    text << mass_of(h.first) << " and " << mass_of(h.second) << " that separate with " << h.parting
         << " m/s, e = " << h.e << ": ";
    return text.str();
}
/// By the impulse the speed of separation changes by J (w1 + w2).
void expect_after(const std::vector<Hit>& all, const char* why) {
    for (const Hit& h : all)
        expect_near(said(h) + "how fast they separate afterwards",
                    h.parting * metre_per_second + (h.first + h.second) / kilogram * h.yours(),
                    -h.e * h.parting * metre_per_second, 1e-12 * abs(h.parting) * metre_per_second, why);
}

/// Bodies that are given an impulse, in N s.
struct Push {
    double first, second;
    Vector3 normal;
    double impulse;
    Body a() const { return {metres_per_second(1, -2, 4), first / kilogram}; }
    Body b() const { return {metres_per_second(0.5, 3, -1), second / kilogram}; }
};
const std::vector<Push> pushes{{0.5, 0.5, {1, 0, 0}, 3},
                               {2, 0.25, {0, -1, 0}, 0.75},
                               {0.125, 3, {0.6, 0, 0.8}, 10},
                               {0, 0.2, {-2.0 / 3, 1.0 / 3, 2.0 / 3}, 2},
                               {4, 0, {0, 1, 0}, 0.5}};
std::string said(const Push& p) {
    std::ostringstream text;
    text << "an impulse of " << p.impulse << " N s on " << mass_of(p.first) << ", and its opposite on "
         << mass_of(p.second) << ", N = (" << p.normal.transpose() << "): ";
    return text.str();
}
/// By how much both velocities are changed, in m/s.
std::pair<Vector3, Vector3> changes(const Push& p) {
    Body a = p.a(), b = p.b();
    exercise::apply(a, b, p.normal, p.impulse * newton_second);
    return {a.velocity.value() - p.a().velocity.value(), b.velocity.value() - p.b().velocity.value()};
}
Velocity3 as_velocity(const Vector3& v) {
    return Velocity3::from_value(v + Vector3::Zero());
} // no -0 where it is printed

} // namespace

TEST_CASE("while two approach, they separate with a negative speed", "[task-1][approach]") {
    expect_parting(approaching, "It is what the second sees of the first, along the normal.");
}

TEST_CASE("those that fly apart separate with a positive speed", "[task-1][fly-apart]") {
    expect_parting(parting, "The sign tells approach from separation: along N means away from each other.");
}

TEST_CASE("side by side, two do not separate", "[task-1][side-by-side]") {
    expect_parting(side_by_side, "Their distance does not change, however fast they fly together.");
}

TEST_CASE("seen from a train, they separate with the same speed", "[task-1][train]") {
    const auto train = metres_per_second(-3, 10, 2);
    for (const auto* all : {&approaching, &parting})
        for (Flight f : *all) {
            const auto before = f.yours();
            f.first += train, f.second += train;
            expect_agree(said(f), "yours", f.yours(), "yours, without (-3, 10, 2) m/s added to both", before,
                         1e-11 * metre_per_second,
                         "Whoever looks on from a train sees other velocities, and the same collision.");
        }
}

TEST_CASE("the larger e counts", "[task-2][larger]") {
    expect_bounce(
        fast,
        "A rubber ball bounces on stone, and a stone on rubber; it does not matter which of the two is the first.");
}

TEST_CASE("a slow approach does not bounce", "[task-2][slow]") {
    expect_bounce(slow,
                  "In every step gravity gives a little speed to what lies on the ground. It must not hop for that.");
}

TEST_CASE("they separate with e times the speed of the approach", "[task-3][part]") {
    expect_after(hits, "The impulse must first end the approach, and then separate them with e of it.");
}

TEST_CASE("so they do where one is immovable", "[task-3][wall]") {
    expect_after(at_walls, "A wall takes any impulse without moving; the other one's velocity changes for both.");
}

TEST_CASE("those that separate are left alone", "[task-3][no-glue]") {
    for (const Hit& h : parts)
        expect_near(said(h) + "the impulse", h.yours(), 0.0 * newton_second, 0.0 * newton_second,
                    "They may still be in each other, but they are on their way out, and nothing sticks them together "
                    "or throws them.");
}

TEST_CASE("which of the two is the first makes no difference", "[task-3][either]") {
    for (const auto* all : {&hits, &at_walls})
        for (const Hit& h : *all) {
            const Hit exchanged{h.parting, h.second, h.first, h.e};
            expect_agree(said(h) + "the impulse", "yours", h.yours(), "yours, with the masses exchanged",
                         exchanged.yours(), 1e-12 * abs(h.yours()),
                         "What the one does to the other, the other does to the one.");
        }
}

TEST_CASE("the sum of the momenta stays", "[task-4][momentum]") {
    for (const Push& p : pushes) {
        if (!(p.first > 0 && p.second > 0)) continue;
        const auto [a, b] = changes(p);
        expect_near(said(p) + "by how much the momentum of both together changes, in kg m/s",
                    as_velocity(a / p.first + b / p.second), as_velocity(Vector3(0, 0, 0)), 1e-11 * metre_per_second,
                    "At every e: what the one gets, the other loses.");
    }
}

TEST_CASE("the velocity of the first changes by the impulse over its mass", "[task-4][first]") {
    for (const Push& p : pushes)
        expect_near(said(p) + "how the first velocity changes", as_velocity(changes(p).first),
                    as_velocity(p.first * p.impulse * p.normal), tolerance,
                    "It is pushed away from the second, the more the lighter it is.");
}

TEST_CASE("so does that of the second, the other way", "[task-4][second]") {
    for (const Push& p : pushes)
        expect_near(said(p) + "how the second velocity changes", as_velocity(changes(p).second),
                    as_velocity(-p.second * p.impulse * p.normal), tolerance,
                    "It is pushed away from the first, the more the lighter it is.");
}

TEST_CASE("across the normal no velocity changes", "[task-4][across]") {
    for (const Push& p : pushes)
        for (const Vector3& change : {changes(p).first, changes(p).second})
            expect_near(said(p) + "how a velocity changes across the normal",
                        as_velocity(change - change.dot(p.normal) * p.normal), as_velocity(Vector3(0, 0, 0)), tolerance,
                        "Without friction a body slides on as it did.");
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1)
        for (const auto* all : {&approaching, &parting, &side_by_side})
            for (const Flight& f : *all) numbers.push_back(f.yours().value());
    if (task == 2)
        for (const auto* all : {&fast, &slow})
            for (const Materials& m : *all) numbers.push_back(m.yours());
    if (task == 3)
        for (const auto* all : {&hits, &at_walls, &parts})
            for (const Hit& h : *all) numbers.push_back(h.yours().value());
    if (task == 4)
        for (const Push& p : pushes)
            for (const Vector3& v : {changes(p).first, changes(p).second})
                numbers.insert(numbers.end(), {v[0], v[1], v[2]});
    return numbers;
}
