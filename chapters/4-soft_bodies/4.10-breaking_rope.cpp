// SPDX-License-Identifier: BSL-1.0
// 4.10 A rope that breaks: pull slowly and it breaks above the load, jerk and it breaks below

// A load hangs on a rope, and a rope hangs on the load. Who pulls slowly at the lower end breaks the rope above the
// load, which carries the load as well. Who jerks breaks the one below: the load is heavy and hardly moves in so short
// a time, so that the rope above does not come to know of it. Nothing says which of them is weaker: all links are
// alike. (A part of section 4, which the notes do not divide.)

#include "claims.hpp"
#include "plot.hpp"

#include <ansatz/soft_bodies/soft_rope.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <iomanip>
#include <iostream>
#include <vector>

using namespace ansatz;

namespace {

constexpr std::uint32_t links = 20;
constexpr auto strength = 150.0 * newton;
constexpr auto load = 5.0 * kilogram;

struct Pull {
    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Force>> above, below; ///< what the first and the last link pull with
    std::vector<std::size_t> broken;                 ///< which links, in this order
    Quantity<unit::Force> then{};                    ///< what the last link pulled with before anything broke
    Quantity<unit::Length> falls{};                  ///< how far the load is below where it hung, half a second later
};

/// Two metres of rope with the load in its middle, whose lower end is drawn down.
Pull pull(Quantity<unit::Velocity> speed) {
    //! [rope]
    World hall{SemiImplicitEuler{}, Gravity{}, Ropes<Breaking>{}, Drag{2.0 / second}};
    const auto rope = add_rope(hall, {.from = metres(0, 2, 0),
                                      .to = metres(0, 0, 0),
                                      .bodies = links + 1,
                                      .mass_per_length = 0.05 * kilogram_per_metre,
                                      .links = {.stiffness = 20000.0 * newton_per_metre,
                                                .damping = 5.0 * newton_second_per_metre,
                                                .breaks = breaks_at(strength)},
                                      .pins = {0},
                                      .dragged = {links}});
    hall.set_mass(rope.bodies[links / 2], load);
    //! [rope]
    const auto dt = 1.0 / 10000 * second;
    for (int i = 0; i < 80000; ++i) hall.step(dt); // until it hangs still
    hall.set(Drag{0.0 / second});
    const auto tension = [&](std::size_t link) {
        if (!hall.contains(rope.links[link])) return 0.0 * newton;
        const auto length = norm(hall.position(rope.bodies[link + 1]) - hall.position(rope.bodies[link]));
        const auto longer = length - 2.0 / links * metre;
        return longer > 0.0 * metre ? 20000.0 * newton_per_metre * longer : 0.0 * newton;
    };
    const auto hung = y(hall.position(rope.bodies[links / 2]));
    const auto begin = hall.time();
    Pull result;
    hall.set_velocity(rope.bodies[links], metres_per_second(0, -1, 0) * (speed / metre_per_second).value());
    auto until = begin + 10.0 * second;
    for (int i = 0; hall.time() < until; ++i) {
        const auto before = tension(links - 1);
        hall.step(dt);
        //! [broken]
        for (const auto& broken : hall.elements<Rope>().broken())
            for (std::size_t k = 0; k < links; ++k)
                if (broken.which == rope.links[k]) result.broken.push_back(k);
        //! [broken]
        if (until > begin + 9.0 * second && !result.broken.empty()) {
            result.then = before;
            until = hall.time() + 0.5 * second;
            hall.set_velocity(rope.bodies[links], metres_per_second(0, 0, 0));
        }
        if (result.broken.empty() || i % 10 == 0) {
            result.times.push_back(hall.time() - begin);
            result.above.push_back(tension(0));
            result.below.push_back(tension(links - 1));
        }
    }
    result.falls = hung - y(hall.position(rope.bodies[links / 2]));
    return result;
}

} // namespace

int main() {
    workbook::Claims claim;
    const auto slow = pull(0.02 * metre_per_second), jerk = pull(5.0 * metre_per_second);
    const auto carried = (load + 0.1 * kilogram) * (9.81 * metre_per_second_squared);
    std::cout << std::fixed << std::setprecision(1);
    std::cout << "   pulled slowly, link " << slow.broken.front() + 1 << " of " << links
              << " breaks, when the hand pulls with " << slow.then / newton << " N\n   jerked, link "
              << jerk.broken.front() + 1 << " of " << links << " breaks, the one at the hand being the last\n";
    claim("pulled slowly, it breaks above the load", slow.broken.front() < links / 2);
    claim("at the first link, which carries all", slow.broken.front() == 0);
    claim("when the hand pulls with what the rope holds, less what hangs on it",
          abs(slow.then / (strength - carried) - 1.0) < 0.03);
    claim("and the load falls", slow.falls > 0.4 * metre);
    claim("jerked, it breaks below the load", jerk.broken.front() >= links / 2);
    claim("and the load hangs where it hung", abs(jerk.falls) < 0.015 * metre);

    workbook::Plot plot("4.10", "A load of 5 kg in the middle of a rope that is jerked");
    plot.x("time").y("pull");
    plot.line("the rope above the load", jerk.times, jerk.above).line("the rope below it", jerk.times, jerk.below);
    plot.horizontal(strength, "what it holds").x_range(0.0 * second, 0.1 * second).write();
    return claim.result();
}
