// SPDX-License-Identifier: BSL-1.0
// A filter says which pairs are tested.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

//! [model]
/// Who belongs to nobody meets everybody; others only those of another team.
struct Team {
    using Unit = unit::Dimensionless;
    static constexpr Shape shape = Shape::scalar;
    static constexpr std::string_view name = "team";
};
struct Opponents {
    using role = roles::Filter;
    using reads = Columns<Team>;

    template <class S> struct In {
        explicit In(const Opponents&) {}
        bool passes(const auto& a, const auto& b) const {
            const auto one = a.template get<Team>().value(), other = b.template get<Team>().value();
            return one == 0 || !(one == other);
        }
    };
};
//! [model]

int main() {
    World world{SemiImplicitEuler{}, AllPairs{}, Opponents{}, Narrowphase<Sphere>{}, Projection{}};
    const auto of = [&](double team) {
        return world.add(Sphere{0.5 * metre}, position(metres(0.2 * team, 0, 0)), mass(1.0 * kilogram),
                         with<Team>(Quantity<unit::Dimensionless>::from_value(team)));
    };
    of(1), of(1), of(2);
    world.step(0.01 * second);
    return world.contacts().size() == 2 ? 0 : 1;
}
