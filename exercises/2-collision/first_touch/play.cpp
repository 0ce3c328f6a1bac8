// SPDX-License-Identifier: BSL-1.0
// Section 2.1.2.3 with your first touch in it: bullets, shot at a row of balls.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

#include <optional>

using namespace ansatz;

/// A shape of one's own: a sphere where it stands, and yours while it moves.
struct Marble : Sphere {
    using shape = Marble;
    static constexpr std::string_view name = "Marble";
    template <class S> struct In : Sphere::In<S> {
        using description = Marble;
        explicit In(const Marble& marble) : Sphere::In<S>(marble) {}
    };
};

template <class S>
bool collide(const Marble::In<S>& a, const typename S::Position& xa, const Marble::In<S>& b,
             const typename S::Position& xb, Touch<S>& touch) {
    return collide(static_cast<const Sphere::In<S>&>(a), xa, static_cast<const Sphere::In<S>&>(b), xb, touch);
}

/// `deeper` is how deep they must be in each other: as if the second were so much smaller.
template <class S>
bool first_touch(const Marble::In<S>& a, const Marble::In<S>& b, const typename S::Position& between,
                 const typename S::Position& motion, const typename S::Length& deeper, FirstTouch<S>& first) {
    const typename S::Position none = S::template zero_vector<unit::Length>();
    const exercise::Ball one{between, motion, a.radius}, other{none, none, b.radius - deeper};
    const std::optional<double> share = exercise::first_touch(one, other);
    if (!share) return false;
    first.time = *share;
    first.normal = exercise::contact_then(one, other, *share).normal;
    first.arm = -a.radius * first.normal;
    return true;
}

/// A hundred bullets, each from a little farther away, at a row of balls that stand still. How many got behind it,
/// where they are on an average, and what is left of the momentum.
template <class Shape, class Contacts> void show(const char* who, Contacts contacts, workbook::Play& table) {
    World world{SemiImplicitEuler{}, BoundingBoxes{}, contacts, Impulse<>{}, Projection{}};
    std::vector<Handle> bullets;
    for (int i = 0; i < 100; ++i) {
        world.add(Shape{{0.3 * metre}}, position(metres(0, 2 * i, 0)), fixed);
        bullets.push_back(world.add(Shape{{0.1 * metre}}, position(metres(-2 - 0.037 * i, 2.001 * i, 0)),
                                    velocity(metres_per_second(250, 0, 0)), mass(0.02 * kilogram), restitution(0.5)));
    }
    for (int i = 0; i < 6; ++i) world.step(1.0 / 60 * second);
    double behind = 0, mean = 0;
    for (const auto bullet : bullets) {
        behind += x(world.position(bullet)).value() > 0;
        mean += x(world.velocity(bullet)).value() / 100;
    }
    table.row(who, {behind, mean}, 200, [world]() mutable { world.step(1.0 / 60 * second); });
}

int main() {
    workbook::Play table("100 bullets at 250 m/s, each at a ball of 0.3 m: Swept with a shape that asks you, with the "
                         "library's Sphere, and without",
                         {"bullets behind the balls", "mean velocity, m/s"});
    show<Marble>("yours", Swept<Narrowphase<Marble>>{}, table);
    show<Sphere>("library", Swept<Narrowphase<Sphere>>{}, table);
    show<Sphere>("not continuous", Narrowphase<Sphere>{}, table);
    return table.print();
}
