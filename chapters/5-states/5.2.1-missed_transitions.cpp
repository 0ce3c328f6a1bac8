// SPDX-License-Identifier: BSL-1.0
// 5.2.1 Missed transitions: a body that moves in steps is never at the boundary; a crossing guard sees it pass

// "Comparison using equality at a spatial boundary." A body that goes 0.3 m in a step is before the door at one update
// and behind it at the next; it is never *at* the door, and a machine that waits for that waits for ever. A tolerance
// only makes it rarer: who comes at a random moment is seen within +-e with the probability 2 e / (v dt), so a faster
// body, or a slower clock, is missed again. A crossing guard compares the previous update with this one, and misses
// none.

#include "claims.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/states.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using namespace ansatz;
using namespace ansatz::states;

namespace {

constexpr auto dt = 0.1 * second;
constexpr auto door = 10.0 * metre;
constexpr auto e = 0.1 * metre;

/// A walker in a world; the machine reads where he is.
struct Scene {
    World<SemiImplicitEuler> world{SemiImplicitEuler{}};
    Handle walker{};
    Scene(double speed, double from)
        : walker(world.add(position(metres(from, 0, 0)), velocity(metres_per_second(speed, 0, 0)))) {}
    auto place() const { return x(world.position(walker)); }
};

//! [machines]
constexpr auto place = value("place", &Scene::place);
struct ByEquality {
    using Context = Scene;
    static constexpr auto machine =
        states::machine(state("waiting", transition(when(place == door), to("alarm"))), final_state("alarm"));
};
struct ByTolerance {
    using Context = Scene;
    static constexpr auto machine = states::machine(
        state("waiting", transition(when(place > door - e && place < door + e), to("alarm"))), final_state("alarm"));
};
struct ByCrossing {
    using Context = Scene;
    static constexpr auto machine =
        states::machine(state("waiting", transition(when(crosses(place, door)), to("alarm"))), final_state("alarm"));
};
//! [machines]

/// Whether the alarm goes when somebody walks past, for 20 m.
template <class Description> bool alarm(double speed, double from) {
    Scene scene(speed, from);
    Machine<Description> machine;
    machine.start(scene);
    while (scene.place() < 20.0 * metre) {
        scene.world.step(dt);
        machine.update(scene);
    }
    return machine.is_in("alarm");
}
/// The share of 200 walkers, who start at other places within one step, for whom the alarm goes.
template <class Description> double share(double speed) {
    int seen = 0;
    for (int i = 0; i < 200; ++i) seen += alarm<Description>(speed, (i + 0.5) / 200 * speed * dt.value());
    return seen / 200.0;
}

} // namespace

int main() {
    workbook::Claims claim;

    // One walker, 3 m/s, ten updates a second.
    Scene scene(3, 0);
    for (int i = 0; i < 33; ++i) scene.world.step(dt);
    const auto before = scene.place();
    scene.world.step(dt);
    std::cout << "At one update he is at " << before << ", at the next at " << scene.place() << '\n';
    claim("the machine that asks for equality has missed him", !alarm<ByEquality>(3, 0));
    // Who starts at 0.1 m should be at 10 m after 33 steps, and is not: 0.3 is no binary fraction, and sums are
    // rounded.
    claim("also one whose steps should end at the door itself", !alarm<ByEquality>(3, 0.1));
    claim("the one that asks for a crossing has missed neither", alarm<ByCrossing>(3, 0) && alarm<ByCrossing>(3, 0.1));

    // Two hundred of them, at many speeds.
    std::vector<Quantity<unit::Length>> steps;
    std::vector<double> equality, tolerance, crossing;
    bool follows = true;
    for (double speed = 0.5; speed <= 10; speed += 0.5) {
        steps.push_back(speed * metre_per_second * dt);
        equality.push_back(share<ByEquality>(speed)), tolerance.push_back(share<ByTolerance>(speed)),
            crossing.push_back(share<ByCrossing>(speed));
        follows = follows && std::abs(tolerance.back() - std::min(1.0, double(2.0 * e / steps.back()))) < 0.02;
    }
    std::cout << "With steps of " << steps.back() << " the equality saw " << 100 * equality.back()
              << " %, the tolerance " << 100 * tolerance.back() << " %, the crossing " << 100 * crossing.back()
              << " %\n";
    claim("a tolerance sees the share 2 e / (v dt), and no more", follows);
    claim("a crossing sees everybody, at every speed",
          std::count(crossing.begin(), crossing.end(), 1.0) == std::ptrdiff_t(crossing.size()));

    // Nobody need find this by hand: the guards know what they compare.
    //! [check]
    const auto findings = check(outline_of<ByEquality>());
    for (const auto& finding : findings) workbook::say() << finding.text << '\n';
    //! [check]
    claim("the checker reports the equality", findings.size() == 1 && findings[0].what == Finding::What::equality);
    claim("and has nothing to say about the others",
          check(outline_of<ByTolerance>()).empty() && check(outline_of<ByCrossing>()).empty());

    workbook::Plot plot("5.2.1", "Of those who walk past the door, equality sees hardly anybody, a crossing everybody");
    plot.x("way in a step").y("share that is seen");
    plot.reference("2 e / (v dt)", steps, [](Quantity<unit::Length> s) { return std::min(1.0, double(2.0 * e / s)); });
    plot.points("place == door", steps, equality)
        .points("within e = 0.1 m", steps, tolerance)
        .points("crosses(place, door)", steps, crossing)
        .write();
    return claim.result();
}
