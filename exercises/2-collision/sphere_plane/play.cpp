// SPDX-License-Identifier: BSL-1.0
// The scene of section 2.1.2.2 with your plane in it: balls that roll down two slopes into a valley.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

#include <algorithm>

using namespace ansatz;

/// A plane of one's own: where it is, and how it faces; everything else is asked of you.
struct Hillside {
    using shape = Hillside;
    static constexpr bool bounded = false;
    static constexpr std::string_view name = "Hillside";
    Vector<double, 3> facing;
    template <class S> struct In {
        using description = Hillside;
        exercise::HalfSpace plane;
        explicit In(const Hillside& hillside) : plane(exercise::half_space(hillside.facing, metres(0, 0, 0))) {}
    };
};

template <class S>
bool collide(const Sphere::In<S>& sphere, const typename S::Position& xs, const Hillside::In<S>& hillside,
             const typename S::Position& xp, Touch<S>& touch) {
    const typename S::Position seen_from_it = xs - xp;
    const auto contact = exercise::contact({seen_from_it, sphere.radius}, hillside.plane);
    if (!contact) return false;
    touch.point = contact->point + xp;
    touch.normal = contact->normal;
    touch.depth = contact->depth;
    return true;
}

template <class Ground> void show(const char* who, workbook::Play& table) {
    World world{SemiImplicitEuler{},           Gravity{},   BoundingBoxes{},
                Narrowphase<Sphere, Ground>{}, Impulse<>{}, Projection{}};
    for (const double side : {-1, 1})
        world.add(Ground{Vector<double, 3>(-3 * side, 4, 0)}, position(metres(10 * side, 7.5, 0)), fixed);
    std::vector<Handle> balls;
    for (int i = 0; i < 25; ++i)
        balls.push_back(world.add(Sphere{0.5 * metre}, position(metres(0.75 * (i - 12), 9 + i % 5, 3 * (i % 5))),
                                  mass(1.0 * kilogram), restitution(0.3)));
    double contacts = 0, deepest = 0;
    for (int i = 0; i < 240; ++i) {
        world.step(1.0 / 60 * second);
        for (const auto& contact : world.contacts()) contacts += 1, deepest = std::max(deepest, contact.depth.value());
    }
    double height = 0;
    for (const auto ball : balls) height += y(world.position(ball)).value() / 25;
    table.row(who, {contacts, deepest, height}, 25, [world]() mutable { world.step(1.0 / 60 * second); });
}

int main() {
    workbook::Play table(
        "25 balls of 0.5 m fall into a valley between two planes, 4 s: planes that ask you, beside the library's own",
        {"contacts in all", "deepest, m", "mean height, m"});
    show<Hillside>("yours", table);
    show<Plane>("library", table);
    return table.print();
}
