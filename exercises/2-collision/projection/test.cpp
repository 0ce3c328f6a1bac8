// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on moving bodies apart (notes 2.2).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using exercise::Body;
using Metres = Quantity<unit::Length>;
using Vector3 = Vector<double, 3>;

/// Two bodies that are in each other: 1/m of both in 1/kg, the normal, and the depth in m.
struct Overlap {
    double first, second;
    Vector3 normal;
    double depth;
    Body a() const { return {metres(4, -1, 2), first / kilogram}; }
    Body b() const { return {metres(3.5, 0.25, 2), second / kilogram}; }
    Metres deep() const { return depth * metre; }
};
const std::vector<Overlap> movable{{0.5, 0.5, {1, 0, 0}, 0.25},
                                   {2, 0.25, {0, -1, 0}, 0.5},
                                   {0.125, 3, {0.6, 0, 0.8}, 0.1},
                                   {0.2, 0.7, {-2.0 / 3, 1.0 / 3, 2.0 / 3}, 1.5}};
const std::vector<Overlap> against_a_wall{{0, 0.5, {0, 1, 0}, 0.25}, {3, 0, {0.6, 0, 0.8}, 0.5}, {0, 8, {-1, 0, 0}, 2}};
const Overlap two_walls{0, 0, {0, 0, 1}, 0.5};
const char* const whole_way = "Less, and they are still in each other; more, and there is a gap.";

std::string mass_of(double inverse) {
    std::ostringstream text;
    if (inverse > 0) text << 1 / inverse << " kg";
    else text << "something immovable";
    return text.str();
}
std::string said(const Overlap& m) {
    std::ostringstream text;
    text << mass_of(m.first) << " and " << mass_of(m.second) << ", " << m.depth << " m deep in each other, N = ("
         << m.normal.transpose() << ")";
    return text.str();
}
std::pair<double, double> shares_of(const Overlap& m) {
    return exercise::shares(m.first / kilogram, m.second / kilogram);
}
std::string shares_said(const Overlap& m) {
    std::ostringstream text;
    text << mass_of(m.first) << " and " << mass_of(m.second) << ": your shares are " << shares_of(m).first << " and "
         << shares_of(m).second << ".\n";
    return text.str();
}
/// By how much each of them is moved.
struct Moves {
    Vector3 a, b;
};
Moves moves_of(const Overlap& m) {
    Body a = m.a(), b = m.b();
    exercise::push_apart(a, b, m.normal, m.deep());
    return {a.position.value() - m.a().position.value(), b.position.value() - m.b().position.value()};
}
void expect_moved(const std::string& what, const Vector3& yours, const Vector3& right, const char* why) {
    expect_near(what + ", m", VectorQuantity<unit::Length, 3>::from_value(yours),
                VectorQuantity<unit::Length, 3>::from_value(right), 1e-12 * metre, why);
}
template <class Check> void each(Check&& check) {
    for (const auto* all : {&movable, &against_a_wall})
        for (const Overlap& m : *all) check(m);
}

struct Deep {
    double depth, slop, share;
    Metres taken() const { return exercise::correction(depth * metre, slop * metre, share); }
};
std::string said(const Deep& d) {
    std::ostringstream text;
    text << d.depth << " m deep, of which " << d.slop << " m may stay, a share of " << d.share
         << " of the rest: how much goes";
    return text.str();
}
const std::vector<Deep> too_deep{{0.3, 0.1, 0.5}, {2, 0.25, 0.2}, {0.015, 0.01, 1}, {0.7, 0, 0.25}};
const std::vector<Deep> deep_enough{{0.05, 0.1, 0.5}, {0.001, 0.25, 1}, {0.01, 0.01, 0.3}};

} // namespace

TEST_CASE("together both go the whole way", "[task-1][whole-way]") {
    each([](const Overlap& m) {
        const auto [a, b] = shares_of(m);
        expect(std::abs(a + b - 1) <= 1e-12, shares_said(m) + whole_way);
    });
}

TEST_CASE("the centre of mass stays", "[task-1][centre]") {
    for (const Overlap& m : movable) {
        const auto [a, b] = shares_of(m);
        std::ostringstream text;
        text << shares_said(m) << "Mass times way is " << a / m.first << " kg for the first and " << b / m.second
             << " kg for the second, for each metre.\nThe centre of mass of two bodies stays where it is if these are "
                "equal.";
        expect(std::abs(a / m.first - b / m.second) <= 1e-12 * std::abs(a / m.first), text.str());
    }
}

TEST_CASE("what is immovable does not move", "[task-1][immovable]") {
    for (const Overlap& m : against_a_wall) {
        const auto [a, b] = shares_of(m);
        expect((m.first > 0 ? b : a) == 0 && (m.first > 0 ? a : b) == 1,
               shares_said(m) + "The other one has to go all of the way by itself.");
    }
}

TEST_CASE("between two that are immovable nobody moves", "[task-1][two-walls]") {
    const auto [a, b] = shares_of(two_walls);
    expect(a == 0 && b == 0, shares_said(two_walls) + "Walls are built into each other; that is how a corner is made.");
}

TEST_CASE("pushed apart, they only touch", "[task-2][only-touch]") {
    each([](const Overlap& m) {
        const Moves moves = moves_of(m);
        expect_near(said(m) + ": how much farther apart they are, along N", (moves.a - moves.b).dot(m.normal) * metre,
                    m.deep(), 1e-12 * metre, whole_way);
    });
}

TEST_CASE("pushing apart leaves the centre of mass where it was", "[task-2][centre-stays]") {
    for (const Overlap& m : movable) {
        const Moves moves = moves_of(m);
        const Vector3 of_both = moves.a / m.first + moves.b / m.second;
        expect_moved(said(m) + ": by how much their centre of mass is moved", of_both / (1 / m.first + 1 / m.second),
                     Vector3(0, 0, 0), "Nothing pushes from outside, and a light body gives way to a heavy one.");
    }
}

TEST_CASE("bodies are moved along the normal and nowhere else", "[task-2][along]") {
    each([](const Overlap& m) {
        const Moves moves = moves_of(m);
        for (const Vector3& move : {moves.a, moves.b})
            expect_moved(said(m) + ": by how much one of them is moved across N", move - move.dot(m.normal) * m.normal,
                         Vector3(0, 0, 0), "Along the normal is the shortest way out.");
    });
}

TEST_CASE("what is immovable stays where it is", "[task-2][wall-stays]") {
    for (const Overlap& m : {against_a_wall[0], against_a_wall[1], against_a_wall[2], two_walls}) {
        const Moves moves = moves_of(m);
        if (!(m.first > 0))
            expect_moved(said(m) + ": by how much the first is moved", moves.a, Vector3(0, 0, 0),
                         "Nobody moves a wall.");
        if (!(m.second > 0))
            expect_moved(said(m) + ": by how much the second is moved", moves.b, Vector3(0, 0, 0),
                         "Nobody moves a wall.");
    }
}

TEST_CASE("of what is too deep a share goes", "[task-3][share]") {
    for (const Deep& d : too_deep) {
        const double too_much = d.depth - d.slop;
        expect_near(said(d), d.taken(), d.share * too_much * metre, 1e-12 * metre,
                    "The slop stays, and is not asked for its share.");
    }
}

TEST_CASE("within the slop nothing is moved", "[task-3][slop]") {
    for (const Deep& d : deep_enough)
        expect_near(
            said(d), d.taken(), 0.0 * metre, 0.0 * metre,
            "They may stay as they are. Neither must they be moved into each other until it is as much as the slop.");
}

TEST_CASE("step by step the depth comes down to the slop", "[task-3][step-by-step]") {
    for (Deep d : too_deep) {
        const std::string what = said(d);
        for (int i = 0; i < 200; ++i) d.depth -= d.taken().value();
        expect_near("begun with " + what + ", and again, 200 times: the depth that is left", d.depth * metre,
                    d.slop * metre, 1e-9 * metre,
                    "In each step a share of what is too much goes, so that in the end nothing is too much.");
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 3)
        for (const auto* all : {&too_deep, &deep_enough})
            for (const Deep& d : *all) numbers.push_back(d.taken().value());
    for (const auto& m : {movable[0], movable[1], movable[2], movable[3], against_a_wall[0], against_a_wall[1],
                          against_a_wall[2], two_walls}) {
        if (task == 1) numbers.insert(numbers.end(), {shares_of(m).first, shares_of(m).second});
        if (task == 2)
            for (const Vector3& move : {moves_of(m).a, moves_of(m).b})
                numbers.insert(numbers.end(), {move[0], move[1], move[2]});
    }
    return numbers;
}
