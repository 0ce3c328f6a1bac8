// SPDX-License-Identifier: BSL-1.0
// 7.4.4 One spring, two surfaces: what sinks breaks it over a soft body, and over ripples

// "This approach works well when representing the fluid surface as a soft body or when functional rippling is triggered
// by an entity entering the fluid body as it provides realistic response from the fluid surface." The same stone on the
// same spring, once over a net of bodies, which gives way and swings back, and once over rings that begin where the
// stone enters, and where it breaks its spring. The net is simulated; the rings are a formula. (A part of 7.4.)

#include "claims.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/water.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace ansatz;
using Length = Quantity<unit::Length>;

namespace {

constexpr int rate = 240, steps = 3 * rate;
const auto dt = 1.0 / rate * second;
const auto at_rest = 3.0 * metre; // both surfaces
const SurfaceSpring spring{
    .stiffness = 400.0 * newton_per_metre, .damping = 40.0 * newton_second_per_metre, .breaks_at = 0.6 * metre};
const auto beside = 4.125 * metre, middle = 3.125 * metre; // a metre from the stone, and where it falls

/// What a surface did.
struct Run {
    std::vector<Length> stone{}, level{}; ///< the stone's height, and the surface's a metre beside it
    double broke = 0;                     ///< when the spring did, s
    Length deep{};                        ///< how deep under the level at rest the stone was then
};

Run over_soft_body() {
    Run run;
    //! [soft]
    World world{SemiImplicitEuler{}, Gravity{}, Springs{}, SurfaceContacts{}};
    const auto pond = add_soft_surface(world, {.grid = ColumnGrid(25, 25, 0.25 * metre),
                                               .level = at_rest,
                                               .mass_per_area = 50.0 * kilogram / square_metre,
                                               .tension = 2000.0 * newton_per_metre,
                                               .damping = 2.0 / second});
    const auto stone = world.add(position(metres(3.125, 3.5, 3.125)), mass(30.0 * kilogram));
    const auto on_it = world.add(SurfaceContact::of(pond, stone, spring));
    //! [soft]
    for (int n = 1; n <= steps; ++n) {
        world.step(dt);
        run.stone.push_back(y(world.position(stone)));
        run.level.push_back(y(world.position(pond.bodies[12 * 25 + 16])));
        if (run.broke == 0 && surface_touch(world, on_it).broken) {
            run.broke = double(n) / rate;
            run.deep = at_rest - run.stone.back();
        }
    }
    return run;
}

Run over_ripples() {
    Run run;
    //! [ripples]
    World world{SemiImplicitEuler{}, Gravity{}, AppliedForces{}};
    Ripples pond(8);
    const auto stone = world.add(position(metres(3.125, 3.5, 3.125)), mass(30.0 * kilogram));
    bool entered = false, broken = false;
    for (int n = 0; n < steps; ++n) {
        const auto now = double(n) / rate * second;
        const Length depth = at_rest + pond.height(middle, middle, now) - y(world.position(stone));
        auto ring = [&](Length amplitude) {
            pond.begin({.x = middle, .z = middle, .begun = now, .amplitude = amplitude, .damping = 1.0 / second});
        };
        if (depth > 0.0 * metre && !entered) ring(0.05 * metre); // the stone enters
        entered = entered || depth > 0.0 * metre;
        if (depth > spring.breaks_at && !broken) {
            ring(0.1 * metre); // and the surface is free again
            run.broke = now.value();
            run.deep = at_rest - y(world.position(stone));
        }
        broken = broken || depth > spring.breaks_at;
        if (entered && !broken) {
            const auto push = spring.stiffness * depth - spring.damping * y(world.velocity(stone));
            world.apply_force(stone, newtons(0, std::max(0.0, push.value()), 0));
        }
        world.step(dt);
        run.stone.push_back(y(world.position(stone)));
        run.level.push_back(at_rest + pond.height(beside, middle, now + dt));
    }
    //! [ripples]
    return run;
}
double swing(const Run& run) {
    const auto [low, high] = std::minmax_element(run.level.begin(), run.level.end());
    return (*high - *low).value();
}

} // namespace

int main() {
    workbook::Claims claim;
    const Run soft = over_soft_body(), rings = over_ripples();
    for (const auto& [name, run] : {std::pair("soft body", &soft), std::pair("ripples", &rings)})
        workbook::say() << "Over the " << name << " the spring broke after " << std::round(run->broke * 100) / 100
                        << " s, " << std::round(run->deep.value() * 1000) / 10
                        << " cm under the level at rest; a metre beside it the surface moved by "
                        << std::round(swing(*run) * 1000) / 10 << " cm\n";
    claim("the stone breaks its spring over both", soft.broke > 0 && rings.broke > 0);
    claim("over the soft body it is deeper by then: the surface has given way",
          soft.deep > rings.deep + 0.02 * metre && soft.broke > rings.broke);
    claim("both surfaces answer, a metre away", swing(soft) > 0.002 && swing(rings) > 0.002);
    claim("without its spring the stone falls as if there were no water",
          std::abs((soft.stone.back() - 2.0 * soft.stone[steps - 2] + soft.stone[steps - 3]).value() * rate * rate +
                   9.81) < 1e-6);
    claim("and both surfaces come to rest", std::abs((soft.level.back() - at_rest).value()) < 0.005 &&
                                                std::abs((rings.level.back() - at_rest).value()) < 0.02);

    std::vector<Quantity<unit::Time>> times;
    std::vector<Length> soft_level, rings_level;
    for (int n = 0; n < steps; ++n) {
        times.push_back(double(n + 1) / rate * second);
        soft_level.push_back((soft.level[std::size_t(n)] - at_rest));
        rings_level.push_back((rings.level[std::size_t(n)] - at_rest));
    }
    workbook::Plot plot("7.4.4", "A metre beside a stone that breaks its spring");
    plot.x("time").y("surface over its level");
    plot.line("soft body", times, soft_level).line("ripples", times, rings_level);
    plot.write();
    return claim.result();
}
