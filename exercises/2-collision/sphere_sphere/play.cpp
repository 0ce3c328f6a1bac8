// SPDX-License-Identifier: BSL-1.0
// The scene of section 2.1.2.1 with your contacts in it: balls that are thrown together.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

#include <algorithm>

using namespace ansatz;

/// A shape of one's own: a sphere to the broadphase, and yours to the narrowphase.
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
    const exercise::Ball first{xa, a.radius}, second{xb, b.radius};
    if (!exercise::intersect(first, second)) return false;
    touch.normal = exercise::unit_normal(first, second);
    touch.depth = exercise::penetration(first, second);
    touch.point = exercise::contact_point(first, second, touch.normal, touch.depth);
    return true;
}

/// A heap of 64 balls, each some way in its neighbours, that flies at another such heap.
template <class Shape> void show(const char* who, workbook::Play& table) {
    World world{SemiImplicitEuler{}, UniformGrid{}, Narrowphase<Shape>{}, Impulse<>{}, Projection{}};
    for (int i = 0; i < 128; ++i) {
        const double side = i < 64 ? -1 : 1, radius = 0.25 + 0.05 * (i % 3);
        world.add(Shape{{radius * metre}},
                  position(metres(3 * side + 0.5 * (i % 4), 0.5 * (i / 4 % 4), 0.5 * (i / 16 % 4) + 0.1 * side)),
                  velocity(metres_per_second(-4 * side, 0, 0)), mass(radius * kilogram), restitution(0.5));
    }
    const auto momentum = total_momentum(world);
    const auto energy = kinetic_energy(world);
    double contacts = 0, deepest = 0;
    for (int i = 0; i < 120; ++i) {
        world.step(1.0 / 60 * second);
        for (const auto& contact : world.contacts()) contacts += 1, deepest = std::max(deepest, contact.depth.value());
    }
    table.row(
        who,
        {contacts, deepest, norm(total_momentum(world) - momentum).value(), double(kinetic_energy(world) / energy)},
        128, [world]() mutable { world.step(1.0 / 60 * second); });
}

int main() {
    workbook::Play table("Two heaps of 64 balls meet at 8 m/s: a shape that asks you about contacts, beside the "
                         "library's Sphere; 120 steps",
                         {"contacts in all", "deepest, m", "momentum off by, kg m/s", "energy left"});
    show<Marble>("yours", table);
    show<Sphere>("library", table);
    return table.print();
}
