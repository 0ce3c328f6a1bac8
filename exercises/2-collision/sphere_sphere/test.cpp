// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on two balls that intersect (notes 2.1.2).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using exercise::Ball;
using exercise::Direction;
using exercise::Length;
using exercise::Place;

const Length tolerance = 1e-12 * metre;

/// Two balls, put down so that everything about them is known: the first is `distance` m from the second, along
/// `to_first`.
struct Pair {
    Direction to_first;
    double distance, first_radius, second_radius;

    Ball second() const { return {metres(3, -2, 0.5), second_radius * metre}; }
    Ball first() const { return {second().centre + distance * to_first * metre, first_radius * metre}; }
    Pair exchanged() const { return {-to_first, distance, second_radius, first_radius}; }
    Length depth() const { return (first_radius + second_radius - distance) * metre; }
    /// The middle of the two surfaces that are in each other, counted from the second's centre.
    Place middle() const {
        return second().centre + 0.5 * (second_radius + distance - first_radius) * to_first * metre;
    }
};
const Direction along(1, 0, 0), slanting(0.6, 0.8, 0),
    in_space(-2.0 / 3, 1.0 / 3, 2.0 / 3), diagonal = Direction(1, -1, 1).normalized(), down(0, 0, -1);

const std::vector<Pair> deep{{along, 1.5, 1, 0.75},
                             {slanting, 2.5, 2, 1},
                             {in_space, 3, 0.5, 2.75},
                             {diagonal, 1.7, 0.9, 0.9},
                             {slanting, 1.2, 1, 1}};
const std::vector<Pair> one_inside{{down, 0.5, 0.75, 1.5}, {in_space, 0.25, 2, 1}, {slanting, 0.125, 0.3, 2.2}};
const std::vector<Pair> apart{
    {along, 2, 1, 0.75}, {diagonal, 2.2, 1, 1}, {slanting, 7, 0.5, 6}, {down, 100, 0.1, 3}, {in_space, 3.3, 0.7, 2.4}};
const std::vector<Pair> exact{{along, 2, 1.25, 0.75}, {-along, 1, 0.5, 0.5}, {down, 3.5, 3, 0.5}};
std::vector<Pair> all_deep() {
    auto all = deep;
    all.insert(all.end(), one_inside.begin(), one_inside.end());
    return all;
}

std::string said(const Pair& p) {
    std::ostringstream text;
    text << "a ball of " << p.first().radius << " at " << p.first().centre << " and one of " << p.second().radius
         << " at " << p.second().centre;
    return text.str();
}
void expect_intersect(const std::vector<Pair>& pairs, bool right, const char* why) {
    for (const Pair& p : pairs)
        expect(exercise::intersect(p.first(), p.second()) == right, said(p) + ": do they intersect?\n    yours  " +
                                                                        (right ? "no" : "yes") + "\n    right  " +
                                                                        (right ? "yes" : "no") + '\n' + why);
}
void expect_depth(const std::vector<Pair>& pairs, const char* why) {
    for (const Pair& p : pairs)
        expect_near(said(p) + ": how deep they are in each other", exercise::penetration(p.first(), p.second()),
                    p.depth(), tolerance, why);
}
Direction normal_of(const Pair& p) { return exercise::unit_normal(p.first(), p.second()); }
Place point_of(const Pair& p) { return exercise::contact_point(p.first(), p.second(), p.to_first, p.depth()); }
void expect_normal(const std::string& what, const Direction& yours, const Direction& right, double within,
                   const char* why) {
    std::ostringstream text;
    text.precision(10);
    text << what << ": the normal\n    yours  (" << yours.transpose() << ")\n    right  ("
         << (right + Direction::Zero()).transpose() << ")\n"
         << why;
    expect(yours.allFinite() && (yours - right).norm() <= within, text.str());
}

const Ball centred{metres(1, 2, 3), 0.5 * metre}, around_it{metres(1, 2, 3), 2.0 * metre};
/// So near that one might take it for the same centre.
const Pair nearly_one{slanting, 1e-7, 0.5, 0.75};

} // namespace

TEST_CASE("balls with a gap between them do not intersect", "[task-1][gap]") {
    expect_intersect(apart, false, "Between their surfaces is air, in whatever direction the one lies from the other.");
}

TEST_CASE("balls whose surfaces have passed each other intersect", "[task-1][deep]") {
    expect_intersect(deep, true, "Neither centre need be inside the other ball.");
}

TEST_CASE("a ball inside another one intersects it", "[task-1][one-inside]") {
    expect_intersect(one_inside, true, "Balls are solid: what is inside is in the other with all of itself.");
}

TEST_CASE("balls that only touch do not intersect", "[task-1][exact-touch]") {
    expect_intersect(exact, false, "They have one point in common, and nothing that would have to be moved away.");
}

TEST_CASE("which of the two comes first does not matter", "[task-1][either-way]") {
    for (const auto& pairs : {apart, deep, one_inside})
        for (const Pair& p : pairs)
            expect(exercise::intersect(p.first(), p.second()) == exercise::intersect(p.second(), p.first()),
                   said(p) + ": yours says one thing, and the other when the two are exchanged");
}

TEST_CASE("moved apart by the depth, two balls only touch", "[task-2][until-they-touch]") {
    expect_depth(deep,
                 "Moved apart by so much, along the line through their centres, their surfaces meet in one point.");
}

TEST_CASE("so they do where one is inside the other", "[task-2][out-of-it]") {
    expect_depth(one_inside, "The inner one must come out altogether, past the surface of the outer one.");
}

TEST_CASE("the nearer, the deeper, by the same length", "[task-2][nearer]") {
    for (Pair p : deep) {
        const auto before = exercise::penetration(p.first(), p.second());
        p.distance -= 0.125;
        expect_agree(said(p) + ": how much deeper than when they were 0.125 m farther apart", "yours",
                     exercise::penetration(p.first(), p.second()) - before, "the way", 0.125 * metre, tolerance,
                     "Whatever the one comes nearer, it goes deeper.");
    }
}

TEST_CASE("a normal has the length 1", "[task-3][length-one]") {
    for (const Pair& p : all_deep()) {
        std::ostringstream text;
        text << said(p) << ": the normal (" << normal_of(p).transpose() << ") has the length " << normal_of(p).norm()
             << ".\nWhoever is moved by p along it would be moved by another distance than p.";
        expect(std::abs(normal_of(p).norm() - 1) <= 1e-12, text.str());
    }
}

TEST_CASE("it points from the second ball to the first", "[task-3][to-the-first]") {
    for (const Pair& p : all_deep()) {
        std::ostringstream text;
        const Direction yours = normal_of(p);
        text << said(p) << ": the normal\n    yours  (" << yours.transpose() << ")\n    right  along ("
             << p.to_first.transpose()
             << ")\nThe first ball is moved along it, and must get away from the second by that.";
        expect(yours.dot(p.to_first) >= (1 - 1e-12) * yours.norm() && yours.norm() > 0, text.str());
    }
}

TEST_CASE("seen from the other ball, the normal turns round", "[task-3][turns-round]") {
    for (const Pair& p : all_deep())
        expect_normal(said(p) + ", exchanged", normal_of(p.exchanged()), -normal_of(p), 1e-12,
                      "\"Right\" is yours before the exchange, turned round: what pushes one to the left pushes the "
                      "other to the right.");
}

TEST_CASE("balls with one centre have a normal too", "[task-3][one-centre]") {
    expect_normal("two balls with one centre", exercise::unit_normal(centred, around_it), Direction(0, 1, 0), 0,
                  "Every direction is as good as another, but there must be one, or they never come apart.");
}

TEST_CASE("centres that are close are not the same", "[task-3][close-centres]") {
    expect_normal(
        "centres that are 1e-7 m apart", normal_of(nearly_one), nearly_one.to_first, 1e-6,
        "Small as it is, there is a direction between them, and it says on which side the first one came in.");
}

TEST_CASE("the point is halfway between the two surfaces", "[task-4][halfway]") {
    for (const Pair& p : all_deep())
        expect_near(said(p) + ": the contact point", point_of(p), p.middle(), tolerance,
                    "On the line through both centres, as far inside the one surface as inside the other.");
}

TEST_CASE("it is the same point for (a, b) and (b, a)", "[task-4][one-point]") {
    for (const Pair& p : all_deep()) {
        const exercise::Place exchanged = exercise::contact_point(p.second(), p.first(), -p.to_first, p.depth());
        expect_agree(said(p) + ": the contact point", "yours", point_of(p), "yours, with the two exchanged", exchanged,
                     tolerance, "Who is called the first is no physics, and two balls meet in one place.");
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    auto add = [&](const auto& vector) { numbers.insert(numbers.end(), {vector[0], vector[1], vector[2]}); };
    if (task == 1)
        for (const auto& pairs : {apart, deep, one_inside, exact})
            for (const Pair& p : pairs)
                numbers.push_back(exercise::intersect(p.first(), p.second())),
                    numbers.push_back(exercise::intersect(p.second(), p.first()));
    else
        for (const Pair& p : all_deep()) {
            if (task == 2) numbers.push_back(exercise::penetration(p.first(), p.second()).value());
            if (task == 3) add(normal_of(p));
            if (task == 4) add(point_of(p).value());
        }
    if (task == 3) add(exercise::unit_normal(centred, around_it)), add(normal_of(nearly_one));
    return numbers;
}
