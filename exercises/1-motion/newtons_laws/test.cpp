// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on Newton's laws (notes 1.1 to 1.3).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using exercise::Act;
using Force = VectorQuantity<unit::Force, 3>;
using Acceleration = VectorQuantity<unit::Acceleration, 3>;
using InverseMass = Quantity<unit::InverseMass>;

const auto rounding = 1e-9 * newton;
Force zero_force() { return newtons(0, 0, 0); }

/// Who is who, how heavy they are (kg; 0 is fixed), and what they do to each other; each act with its reaction.
struct Scene {
    const char* name;
    std::vector<const char*> bodies;
    std::vector<double> masses;
    std::vector<Act> acts;
};
Scene scene(const char* name, std::vector<const char*> bodies, std::vector<double> masses,
            const std::vector<Act>& actions) {
    Scene made{name, std::move(bodies), std::move(masses), {}};
    for (const Act& act : actions) made.acts.push_back(act), made.acts.push_back({act.on, act.by, -act.force});
    // In no order: reactions do not stand behind their actions.
    std::stable_sort(made.acts.begin(), made.acts.end(),
                     [](const Act& a, const Act& b) { return 5 * a.by + 3 * a.on < 5 * b.by + 3 * b.on; });
    return made;
}
std::vector<Scene> scenes() {
    return {
        scene("two dogs and a sledge", {"the ground", "the sledge", "the left dog", "the right dog"}, {0, 20, 35, 30},
              {{2, 1, newtons(60, 0, 15)},
               {3, 1, newtons(55, 4, -12)},
               {0, 1, newtons(-80, 196, 2)},
               {0, 2, newtons(90, 343, 0)},
               {0, 3, newtons(75, 294, -1)}}),
        scene("a book on a table", {"the ground", "the table", "the book"}, {0, 12, 2},
              {{1, 2, newtons(0, 19.62, 0)}, {0, 2, newtons(0, -19.62, 0)}, {0, 1, newtons(3, 137.5, 0)}}),
        scene("two skaters and a ball", {"the wall", "the first skater", "the second skater", "the ball"},
              {0, 50, 80, 0.5}, {{1, 2, newtons(40, 0, 25)}, {1, 3, newtons(6, 2, -1)}, {0, 1, newtons(-12, 0, 7)}})};
}
std::string said(const Act& act, const Scene& s) {
    std::ostringstream text;
    text << s.bodies[std::size_t(act.by)] << " on " << s.bodies[std::size_t(act.on)] << " ("
         << act.force.value().transpose() << ") N";
    return text.str();
}
std::string said(const Scene& s) {
    std::string text = s.name;
    for (const Act& act : s.acts) text += "\n    " + said(act, s);
    return text + "\n";
}
Force right_resultant(int body, const Scene& s) {
    Force sum = zero_force();
    for (const Act& act : s.acts)
        if (act.on == body) sum += act.force;
    return sum;
}

struct Pushed {
    double mass; // kg; 0 is fixed
    Force force;
};
const std::vector<Pushed> pushed{{20, newtons(40, 0, -6)}, {0.5, newtons(1, 7, 2)}, {350, newtons(-90, 3000, 12)}};
const Acceleration gs[] = {metres_per_second_squared(0, -9.81, 0), metres_per_second_squared(0.5, -1.62, 0.25)};
InverseMass inverse(double mass) { return (mass == 0 ? 0 : 1 / mass) / kilogram; }
Acceleration yours(const Pushed& p, const Acceleration& g) {
    return exercise::acceleration(p.force, inverse(p.mass), g);
}
std::string said(const Pushed& p, const Acceleration& g) {
    std::ostringstream text;
    if (p.mass == 0) text << "a body that is fixed (inverse mass 0)";
    else text << "a body of " << p.mass << " kg (inverse mass " << 1 / p.mass << "/kg)";
    text << ", a resultant of (" << p.force.value().transpose() << ") N, g = (" << g.value().transpose()
         << ") m/s^2: its acceleration";
    return text.str();
}

using Group = std::vector<int>;
std::vector<InverseMass> inverse_masses(const Scene& s) {
    std::vector<InverseMass> all;
    for (const double m : s.masses) all.push_back(inverse(m));
    return all;
}
Acceleration centre(const Group& group, const Scene& s) {
    return exercise::centre_acceleration(group, inverse_masses(s), s.acts);
}
std::string said(const Group& group, const Scene& s) {
    std::ostringstream text;
    text << said(s) << "the group is";
    for (const char* between = " "; const int body : group)
        text << between << s.bodies[std::size_t(body)] << " (" << s.masses[std::size_t(body)] << " kg)", between = ", ";
    text << ": the acceleration of its centre of mass";
    return text.str();
}

} // namespace

TEST_CASE("what acts on a body adds up", "[task-1][on-it]") {
    for (const Scene& s : scenes())
        for (int body = 0; body < int(s.bodies.size()); ++body)
            expect_near(said(s) + "the resultant on " + s.bodies[std::size_t(body)], exercise::resultant(body, s.acts),
                        right_resultant(body, s), rounding,
                        "The vector sum of all that act on this body, and of no others: what it does itself acts on "
                        "somebody else.");
}

TEST_CASE("the order of the list does not matter", "[task-1][order]") {
    for (Scene s : scenes())
        for (int body = 0; body < int(s.bodies.size()); ++body) {
            const Force first = exercise::resultant(body, s.acts);
            std::vector<Act> turned(s.acts.rbegin(), s.acts.rend());
            expect_agree(said(s) + "the resultant on " + s.bodies[std::size_t(body)], "yours", first,
                         "yours, of the same list from behind", exercise::resultant(body, turned), rounding,
                         "Forces do not know of each other: each is added, whichever comes first.");
        }
}

TEST_CASE("where nobody acts there is no force", "[task-1][nobody]") {
    for (const Scene& s : scenes()) {
        std::vector<Act> others; // all that act on other bodies
        for (const Act& act : s.acts)
            if (act.on != 1) others.push_back(act);
        Scene left = s;
        left.acts = others;
        expect_near(said(left) + "the resultant on " + s.bodies[1], exercise::resultant(1, others), zero_force(),
                    rounding, "It does something to others here, and nobody does anything to it.");
    }
}

TEST_CASE("the book on the table is in balance", "[task-1][balance]") {
    const Scene s = scenes()[1];
    expect_near(
        said(s) + "the resultant on the book", exercise::resultant(2, s.acts), zero_force(), rounding,
        "Its weight and the push of the table cancel, and by the first law it stays where it is. They are not a force "
        "and its reaction: both act on the book.");
}

TEST_CASE("the force through the mass, and g", "[task-2][second-law]") {
    for (const Pushed& p : pushed)
        for (const Acceleration& g : gs)
            expect_near(said(p, g), yours(p, g), Acceleration(g + p.force / (p.mass * kilogram)),
                        1e-9 * metre_per_second_squared,
                        "F / m is the inverse mass times F; g is an acceleration already, the same for every mass.");
}

TEST_CASE("without a force everything falls alike", "[task-2][falls]") {
    for (const double mass : {0.001, 2.0, 5000.0})
        for (const Acceleration& g : gs)
            expect_near(said({mass, zero_force()}, g), yours({mass, zero_force()}, g), g,
                        1e-9 * metre_per_second_squared, "A feather and an anvil: in m g / m the mass cancels.");
}

TEST_CASE("what is fixed stays, whatever acts on it", "[task-2][fixed]") {
    for (const Force& force : {zero_force(), newtons(3, -1e6, 20)})
        for (const Acceleration& g : gs)
            expect_near(
                said({0, force}, g), yours({0, force}, g), metres_per_second_squared(0, 0, 0),
                1e-9 * metre_per_second_squared,
                "It is immune to physics, notes 1.1: no force moves an infinite mass, and gravity, which asks for no "
                "mass, must leave it alone too.");
}

TEST_CASE("the reaction is as large and opposite", "[task-3][opposite]") {
    for (const Scene& s : scenes())
        for (const Act& act : s.acts)
            expect_near(said(act, s) + ": the force of the reaction", exercise::reaction(act).force, Force(-act.force),
                        rounding, "The same size in the opposite direction, however different the two bodies are.");
}

TEST_CASE("the reaction acts on the other body", "[task-3][other-body]") {
    for (const Scene& s : scenes())
        for (const Act& act : s.acts) {
            const Act back = exercise::reaction(act);
            std::ostringstream text;
            text << said(act, s) << ": the reaction\n    yours  is by body " << back.by << " on body " << back.on
                 << "\n    right  is by body " << act.on << " on body " << act.by
                 << "\nIt comes from the body that was acted on, and acts on the one that began. So the two are never "
                    "summed up on one body.";
            expect(back.by == act.on && back.on == act.by, text.str());
        }
}

TEST_CASE("the reaction of the reaction is the act", "[task-3][twice]") {
    for (const Scene& s : scenes())
        for (const Act& act : s.acts) {
            const Act back = exercise::reaction(exercise::reaction(act));
            std::ostringstream text;
            text << said(act, s) << ": the reaction of its reaction\n    yours  is by body " << back.by << " on body "
                 << back.on << ", (" << back.force.value().transpose()
                 << ") N\nNeither of the two comes first: each is "
                 << "the reaction of the other.";
            expect(back.by == act.by && back.on == act.on && norm(Force(back.force - act.force)) < rounding,
                   text.str());
        }
}

TEST_CASE("a group that is alone does not move its centre", "[task-4][alone]") {
    for (Scene s : scenes()) {
        std::vector<Act> inner;
        for (const Act& act : s.acts)
            if (act.by != 0 && act.on != 0) inner.push_back(act); // without the ground, or the wall
        s.acts = inner;
        Group group;
        for (int body = 1; body < int(s.bodies.size()); ++body) group.push_back(body);
        expect_near(said(group, s), centre(group, s), metres_per_second_squared(0, 0, 0),
                    1e-9 * metre_per_second_squared,
                    "Every force among them comes with its reaction, and both act within the group.");
    }
}

TEST_CASE("a group follows what comes from outside, with all of its mass", "[task-4][outside]") {
    for (const Scene& s : scenes()) {
        std::vector<Group> groups{{1}, {2}, {1, 2}};
        if (s.bodies.size() > 3) groups.push_back({1, 2, 3}), groups.push_back({3, 2});
        for (const Group& group : groups) {
            // The other way: each body's own acceleration, weighted by its mass.
            auto sum = 0.0 * kilogram * metres_per_second_squared(0, 0, 0);
            auto all = 0.0 * kilogram;
            for (const int body : group) {
                const auto m = s.masses[std::size_t(body)] * kilogram;
                sum += m * Acceleration(right_resultant(body, s) / m), all += m;
            }
            expect_near(
                said(group, s), centre(group, s), Acceleration(sum / all), 1e-9 * metre_per_second_squared,
                "Right was found body by body: the mean of their accelerations, weighted by their masses. In that "
                "sum all that they do to each other cancels.");
        }
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    auto add = [&](const auto& vector) {
        for (int i = 0; i < 3; ++i) numbers.push_back(vector.value()[i]);
    };
    if (task == 2) {
        for (const Pushed& p : pushed)
            for (const Acceleration& g : gs) add(yours(p, g));
        add(yours({0, newtons(3, -1e3, 20)}, gs[1]));
    }
    for (const Scene& s : scenes()) {
        if (task == 1)
            for (int body = 0; body < int(s.bodies.size()); ++body) add(exercise::resultant(body, s.acts));
        if (task == 3)
            for (const Act& act : s.acts) {
                const Act back = exercise::reaction(act);
                add(back.force), numbers.push_back(back.by), numbers.push_back(back.on);
            }
        if (task == 4)
            for (const Group& group : {Group{1}, Group{1, 2}, Group{2, 1}}) add(centre(group, s));
    }
    return numbers;
}
