// SPDX-License-Identifier: BSL-1.0
// 3.4 A rope that breaks: it pulls and never pushes, and a short fall is enough

// A rope is a spring that only pulls. Slack, it does nothing; when a falling load makes it taut, it must take the speed
// out of the load within its own stretch, and the stiffer it is, the harder it pulls: the peak is m g + sqrt((m g)^2 +
// k m v^2). That is why climbers use ropes that give. (A part of section 3, which the notes do not divide.)

#include "claims.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <cmath>
#include <vector>

using namespace ansatz;

namespace {

struct Fall {
    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Force>> pulls;
    Quantity<unit::Force> peak{};
    bool broke = false;
    Broken<Rope> how{};
};

/// A load of 80 kg falls 4 m before its rope is taut.
//! [fall]
Fall fall(Quantity<unit::Stiffness> k, Quantity<unit::Force> strength) {
    World wall{SemiImplicitEuler{}, Gravity{}, Ropes<Breaking>{}};
    const auto climber = wall.add(position(metres(0, 0, 0)), mass(80.0 * kilogram));
    const auto rope =
        wall.add(Rope{.first = metres(0, 0, 0), .second = climber, .stiffness = k, .rest_length = 4.0 * metre},
                 breaks_at(strength));
    //! [fall]
    Fall result;
    while (wall.time() < 2.0 * second) {
        wall.step(1.0 / 2000 * second);
        const auto pull = 80.0 * kilogram * (y(wall.acceleration(climber)) + 9.81 * metre_per_second_squared);
        result.times.push_back(wall.time());
        result.pulls.push_back(pull);
        result.peak = max(result.peak, pull);
        //! [broken]
        for (const auto& broken : wall.elements<Rope>().broken()) {
            result.broke = !wall.contains(rope);
            result.how = broken;
        }
        //! [broken]
    }
    return result;
}

} // namespace

int main() {
    workbook::Claims claim;
    const auto soft = 1500.0 * newton_per_metre, stiff = 40000.0 * newton_per_metre;
    const auto strong = 1e6 * newton, usual = 12000.0 * newton;

    const auto gives = fall(soft, strong), does_not = fall(stiff, strong), breaks = fall(stiff, usual);
    auto expected = [](Quantity<unit::Stiffness> k) {
        const auto weight = 80.0 * kilogram * (9.81 * metre_per_second_squared);
        const auto v = sqrt(2.0 * (9.81 * metre_per_second_squared) * (4.0 * metre));
        return weight + sqrt(weight * weight + k * (80.0 * kilogram) * v * v);
    };
    workbook::say() << "A fall of 4 m, 80 kg: a rope of " << soft << " pulls with at most " << gives.peak << ", one of "
                    << stiff << " with " << does_not.peak << '\n';
    claim("the peak is what the energy of the fall says, soft", abs(gives.peak / expected(soft) - 1.0) < 0.005);
    claim("and stiff", abs(does_not.peak / expected(stiff) - 1.0) < 0.02);
    bool pushed = false;
    for (const auto& pull : does_not.pulls) pushed = pushed || pull < -1e-6 * newton;
    claim("no rope ever pushed", !pushed);

    workbook::say() << "A rope of " << stiff << " that holds " << usual << " broke at " << breaks.how.tension
                    << ", stretched by " << 100 * breaks.how.strain << " %\n";
    claim("the stiff rope breaks in a fall that the soft one catches", breaks.broke && gives.peak < usual);
    claim("it breaks in the step after which it pulls too hard",
          breaks.how.tension > usual && breaks.how.tension < 1.1 * usual);

    workbook::Plot plot("3.4", "The stiffer the rope, the harder the fall");
    plot.x("time").y("pull of the rope");
    plot.line("soft", gives.times, gives.pulls)
        .line("stiff", does_not.times, does_not.pulls)
        .line("stiff, breaks", breaks.times, breaks.pulls);
    plot.horizontal(usual, "what it holds").x_range(0.7 * second, 2.0 * second).write();
    return claim.result();
}
