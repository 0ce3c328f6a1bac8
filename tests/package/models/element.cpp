// SPDX-License-Identifier: BSL-1.0
// Elements of a policy of your own: thrusters, each on one body, that burn until they are empty.

#include <ansatz/world.hpp>
#include <ansatz/world/save.hpp>
#include <cmath>
#include <sstream>

using namespace ansatz;

//! [model]
struct Thruster {
    using element = Thruster;
    Handle on;
    VectorParameter<unit::Acceleration> push;
    Parameter<unit::Time> burns = 1.0 * second;
};
template <class S> struct ThrusterRow {
    BodyId on;
    typename S::Acceleration push{};
    typename S::Time left{};
    static void fields(auto& self, auto&& field) {
        field("on", self.on), field("push", self.push), field("left", self.left);
    }
    static ThrusterRow from(const auto& asked, const Thruster& t) {
        return {asked.body(t.on), S::convert("push", t.push), S::convert("burns", t.burns)};
    }
};
struct Thrusters {
    using role = roles::System;
    using Element = Thruster;
    static constexpr std::string_view name = "Thrusters";
    template <class S> using State = ElementTable<S, Thruster, ThrusterRow<S>>;
    template <class S> struct Burn {
        static constexpr Phase phase = phases::begin;
        static constexpr std::string_view name = "thrusters";
        using writes = Columns<Velocity>;
        explicit Burn(const Thrusters&) {}
        void run(auto& view, const auto& context) const {
            view.state().for_each([&](std::uint32_t, auto& thruster) {
                const auto slot = view.slot(thruster.on);
                const typename S::Time dt = std::min<typename S::Time>(context.dt(), thruster.left);
                thruster.left -= dt;
                view.template set<Velocity>(slot, view.template get<Velocity>(slot) + dt * thruster.push);
            });
        }
    };
    template <class S> using systems = Types<Burn<S>>;
};
//! [model]

int main() {
    World world{SemiImplicitEuler{}, Thrusters{}}, loaded{SemiImplicitEuler{}, Thrusters{}};
    const auto ship = world.add();
    world.add(Thruster{ship, metres_per_second_squared(3, 0, 0), 0.5 * second});
    for (int i = 0; i < 30; ++i) world.step(0.01 * second);
    std::stringstream file;
    save(world, file);
    load(loaded, file);
    for (int i = 0; i < 70; ++i) loaded.step(0.01 * second);
    return std::abs(loaded.velocity(ship).value()[0] - 1.5) < 1e-12 ? 0 : 1;
}
