// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on a ball and a plane (notes 2.1.2).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using exercise::HalfSpace;
using Metres = Quantity<unit::Length>;
using Vector3 = Vector<double, 3>;
using Point = VectorQuantity<unit::Length, 3>;

/// A plane, by where it is and how it faces: `normal` has the length 1, `across` is at right angles to it.
struct Slope {
    Vector3 normal, across;
    Point point;
    HalfSpace right() const { return {normal, Metres::from_value(-normal.dot(point.value()))}; }
    /// A place so many metres above it, and some way along it.
    Point at(double height) const { return point + (height * normal + 1.75 * across) * metre; }
};
const std::vector<Slope> slopes{
    {{0, 1, 0}, {1, 0, 0}, metres(2, 0, 7)},                       // the ground, through the origin
    {{0, 1, 0}, {0, 0, 1}, metres(-1, 3, 4)},                      // a floor at 3 m
    {{-1, 0, 0}, {0, 1, 0}, metres(5, 1, 1)},                      // a wall at 5 m
    {{0.6, 0.8, 0}, {-0.8, 0.6, 0}, metres(2, -4, 1)},             // a slope
    {{2.0 / 3, -1.0 / 3, 2.0 / 3}, {0, 2, 1}, metres(0.5, 6, -2)}, // one in space, facing downwards
};
const double lengths[] = {1, 0.5, 12}; // of the direction that is given
const double heights[] = {2.5, 0.3, 0, -0.2, -7};
const double radius = 0.75;
const double deep[] = {0.5, 0.125, 0.7};   // heights of the centre, less than the radius
const double below[] = {-0.25, -0.75, -4}; // the centre is below the surface
const double clear_of_it[] = {0.8, 3, 41};

std::string said(const Slope& s) {
    std::ostringstream text;
    text << "a plane through " << s.point << " that faces (" << s.normal.transpose() << ")";
    return text.str();
}
std::string said(const Slope& s, double height) {
    std::ostringstream text;
    text << "a ball of " << radius << " m, its centre " << std::abs(height) << " m "
         << (height < 0 ? "below " : "above ") << said(s);
    return text.str();
}
auto contact_of(const Slope& s, double height, double r = radius) {
    return exercise::contact({s.at(height), r * metre}, s.right());
}
/// The contact of a ball that is known to intersect.
auto there(const Slope& s, double height) {
    const auto contact = contact_of(s, height);
    expect(contact.has_value(), said(s, height) + ": yours finds no contact.\nA part of it is in what is solid.");
    return *contact;
}
template <class Heights, class Check> void each(const Heights& at, Check&& check) {
    for (const Slope& s : slopes)
        for (const double height : at) check(s, height);
}
void expect_nothing(const Slope& s, double height, double r, const char* why) {
    std::ostringstream text;
    text << "a ball of " << r << " m, its centre " << height << " m above " << said(s) << ": yours finds a contact.\n"
         << why;
    expect(!contact_of(s, height, r).has_value(), text.str());
}

} // namespace

TEST_CASE("the normal has the length 1, whatever was given", "[task-1][length-one]") {
    for (const Slope& s : slopes)
        for (const double length : lengths) {
            const auto plane = exercise::half_space(length * s.normal, s.point);
            std::ostringstream text;
            text << said(s) << ", given by a direction of length " << length << ": the normal\n    yours  ("
                 << plane.normal.transpose() << ")\n    right  (" << s.normal.transpose()
                 << ")\nHow long the arrow was that somebody drew says nothing about the plane.";
            expect((plane.normal - s.normal).norm() <= 1e-12, text.str());
        }
}

TEST_CASE("the point is on the plane", "[task-1][on-it]") {
    for (const Slope& s : slopes)
        for (const double length : lengths) {
            const auto plane = exercise::half_space(length * s.normal, s.point);
            std::ostringstream what;
            what << said(s) << ", given by a direction of length " << length << ": your N . x + d, for that point";
            expect_near(what.str(), dot(s.point, s.normal) + plane.d, 0.0 * metre, 1e-11 * metre,
                        "The equation N . x + d = 0 holds for every point of the plane, with N of length 1; and for "
                        "this one in particular.");
        }
}

TEST_CASE("it does not matter through which of its points a plane is laid", "[task-1][any-point]") {
    for (const Slope& s : slopes) {
        const auto one = exercise::half_space(s.normal, s.point), other = exercise::half_space(s.normal, s.at(0));
        expect_agree(said(s) + ": the constant d", "yours", one.d, "yours, from another point of it", other.d,
                     1e-11 * metre, "It is the same plane, and it has one d.");
    }
}

TEST_CASE("the height above a plane is that along its normal", "[task-2][height]") {
    each(heights, [](const Slope& s, double height) {
        if (height >= 0)
            expect_near("the height above " + said(s), exercise::height(s.at(height), s.right()), height * metre,
                        1e-11 * metre, "Measured with a plumb line along N, from the surface to the place.");
    });
}

TEST_CASE("below the plane the height is negative", "[task-2][below]") {
    each(heights, [](const Slope& s, double height) {
        if (height < 0)
            expect_near("the height of a place below " + said(s), exercise::height(s.at(height), s.right()),
                        height * metre, 1e-11 * metre,
                        "Its sign says on which side of the surface a place is; without it nobody could tell.");
    });
}

TEST_CASE("plane and place moved together, the height stays", "[task-2][origin]") {
    const auto by = metres(-3, 8, 5);
    each(heights, [&](const Slope& s, double height) {
        const Slope moved{s.normal, s.across, s.point + by};
        expect_agree("the height above " + said(s), "yours", exercise::height(s.at(height), s.right()),
                     "yours, with both moved by (-3, 8, 5) m", exercise::height(moved.at(height), moved.right()),
                     1e-11 * metre, "Nobody in the scene can see where the origin of the coordinates is.");
    });
}

TEST_CASE("a ball above the plane has no contact", "[task-3][above]") {
    each(clear_of_it, [](const Slope& s, double height) {
        expect_nothing(s, height, radius, "Its lowest point is above the surface.");
    });
}

TEST_CASE("a ball that only touches has none either", "[task-3][exact-touch]") {
    for (const Slope& s : {slopes[0], slopes[1], slopes[2]})
        expect_nothing(s, 0.5, 0.5, "One point of it is on the surface, and none below.");
}

TEST_CASE("raised by the depth, the ball only touches", "[task-3][depth]") {
    each(deep, [](const Slope& s, double height) {
        expect_near(said(s, height) + ": the depth", there(s, height).depth, (radius - height) * metre, 1e-11 * metre,
                    "Raised by so much along the normal, its centre is one radius above the surface.");
    });
}

TEST_CASE("a ball whose centre is below the surface is raised all the way", "[task-3][centre-below]") {
    each(below, [](const Slope& s, double height) {
        expect_near(
            said(s, height) + ": the depth", there(s, height).depth, (radius - height) * metre, 1e-11 * metre,
            "All that is below the surface is solid: the ball must come up until its centre is one radius above.");
    });
}

TEST_CASE("it is pushed out of what is solid", "[task-3][outwards]") {
    for (const auto& at : {deep, below})
        for (const Slope& s : slopes)
            for (int i = 0; i < 3; ++i) {
                const auto normal = there(s, at[i]).normal;
                std::ostringstream text;
                text << said(s, at[i]) << ": the normal\n    yours  (" << normal.transpose() << ")\n    right  ("
                     << s.normal.transpose()
                     << ")\nThere is one way out of the ground, however deep somebody is in it.";
                expect((normal - s.normal).norm() <= 1e-12, text.str());
            }
}

TEST_CASE("the point is halfway between the ball's lowest point and the surface", "[task-3][point]") {
    for (const auto& at : {deep, below})
        for (const Slope& s : slopes)
            for (int i = 0; i < 3; ++i)
                expect_near(
                    said(s, at[i]) + ": the contact point", there(s, at[i]).point, s.at(0.5 * (at[i] - radius)),
                    1e-11 * metre,
                    "Straight below the centre, and as far from the lowest point of the ball as from the surface.");
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    auto add = [&](const auto& vector) { numbers.insert(numbers.end(), {vector[0], vector[1], vector[2]}); };
    for (const Slope& s : slopes) {
        if (task == 1)
            for (const double length : lengths) {
                const auto plane = exercise::half_space(length * s.normal, s.at(0));
                add(plane.normal), numbers.push_back(plane.d.value());
            }
        if (task == 2)
            for (const double height : {2.5, 0.3, -0.2, -7.0})
                numbers.push_back(exercise::height(s.at(height), s.right()).value());
        if (task == 3)
            for (const double height : {0.5, 0.125, 0.7, -0.25, -0.9, -4.0, 0.8, 3.0, 41.0}) {
                const auto contact = contact_of(s, height);
                numbers.push_back(contact.has_value());
                if (contact)
                    add(contact->point.value()), add(contact->normal), numbers.push_back(contact->depth.value());
            }
    }
    if (task == 3)
        for (int i = 0; i < 3; ++i) numbers.push_back(contact_of(slopes[i], 0.5, 0.5).has_value());
    return numbers;
}
