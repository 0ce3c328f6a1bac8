// SPDX-License-Identifier: BSL-1.0
// 4.5 Pressure: a skin that is held up by what is in it

// A ball of springs keeps its shape by spokes from its middle. A football has none: it is a skin, and air. The air acts
// on no spring and on no single body but on a volume, and presses every part of the skin outwards. This is a balloon,
// what its skin carries, and what a ball is without its air. (A part of section 4, which the notes do not divide.)

#include "claims.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/soft_bodies/pressure.hpp>
#include <ansatz/soft_bodies/soft_ball.hpp>
#include <ansatz/soft_bodies/xpbd.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>
#include <vector>

using namespace ansatz;

namespace {

SoftBall football(const std::optional<Filling>& filling) {
    return {.centre = metres(0, 1, 0),
            .radius = 0.3 * metre,
            .density = 4.0 * kilogram_per_cubic_metre,
            .divisions = 2,
            .structural = {20'000.0 * newton_per_metre, 0.1 * newton_second_per_metre},
            .velocity = metres_per_second(0, -5, 0),
            .filling = filling};
}

/// What the springs pull with, each by how long it is: twice the virial of the skin.
template <class World_> Quantity<unit::Energy> pull_by_length(const World_& world) {
    Quantity<unit::Energy> sum{};
    for (const SpringHandle handle : world.template elements<Spring>().handles()) {
        const Spring spring = world.get(handle);
        const auto length = norm(world.position(spring.second.body()) - world.position(spring.first.body()));
        sum += spring.stiffness * (length - *spring.rest_length) * length;
    }
    return sum;
}

/// How high the lowest and the highest of some bodies are.
template <class World_> auto extent(const World_& world, const std::vector<Handle>& bodies) {
    auto low = y(world.position(bodies[0])), high = low;
    for (const Handle body : bodies) {
        low = std::min(low, y(world.position(body)));
        high = std::max(high, y(world.position(body)));
    }
    return std::pair(low, high);
}

} // namespace

int main() {
    workbook::Claims claim;

    // A balloon: a ball with a filling and without spokes.
    //! [balloon]
    World world{SemiImplicitEuler{}, Springs{}, Pressure{}};
    const SoftBallParts balloon =
        add_soft_ball(world, {.radius = 0.3 * metre,
                              .density = 20.0 * kilogram_per_cubic_metre,
                              .divisions = 2,
                              .structural = {300.0 * newton_per_metre, 2.0 * newton_second_per_metre},
                              .filling = Filling{.inside = 101'500.0 * pascal, .outside = 101'000.0 * pascal}});
    //! [balloon]
    const auto built = enclosed_volume(world, balloon.enclosure);
    const auto pressed = excess_pressure(world, balloon.enclosure);
    for (int i = 0; i < 6000; ++i) world.step(1.0 / 2000 * second);
    //! [balance]
    const auto volume = enclosed_volume(world, balloon.enclosure);
    const auto excess = excess_pressure(world, balloon.enclosure);
    const auto pull = pull_by_length(world); // the sum of tension times length
    //! [balance]
    std::cout << "As built the balloon holds " << built << " with " << pressed << " more inside than outside.\n"
              << "It swells to " << volume << ", where " << excess << " are left.\n"
              << "3 p V = " << 3.0 * excess * volume << ", the sum of tension times length = " << pull << '\n';
    claim("it has swollen, and the gas has thinned", volume > built && excess < pressed);
    claim("the skin carries what presses it: sum of tension times length = 3 p V",
          std::abs(pull / (3.0 * excess * volume) - 1) < 1e-6);
    claim("nothing pushes it away: what presses one side presses the other",
          norm(total_momentum(world)) < 1e-12 * newton_second);

    // Thrown to the ground, with its air and without.
    //! [ground]
    World ground{SemiImplicitEuler{},
                 Gravity{},
                 Springs{},
                 Pressure{},
                 Xpbd{},
                 SortAndSweep{},
                 Narrowphase<Sphere, Plane>{},
                 SoftSubsteps<>{.parts = 20}};
    ground.add(Plane::ground(), fixed, restitution(0));
    //! [ground]
    const auto thrown = [&](const std::optional<Filling>& filling, auto&& each) {
        auto here = ground;
        const auto ball = add_soft_ball(here, football(filling), Sphere{0.01 * metre}, restitution(0));
        while (here.time() < 1.0 * second) {
            here.step(1.0 / 120 * second);
            each(here, ball);
        }
    };
    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Length>> of_ball, of_skin; // how high their lowest point is
    auto flattest = 1.0 * metre;
    auto least = 1.0 * cubic_metre, most = 0.0 * cubic_metre;
    const Filling air{.inside = 106'000.0 * pascal, .outside = 101'000.0 * pascal};
    thrown(air, [&](const auto& here, const auto& ball) {
        const auto now = enclosed_volume(here, ball.enclosure);
        const auto [low, high] = extent(here, ball.bodies);
        if (here.time() > 0.05 * second) { // as built it is under way to its own size
            least = std::min(least, now);
            most = std::max(most, now);
            flattest = std::min(flattest, high - low);
        }
        times.push_back(here.time());
        of_ball.push_back(low);
    });
    thrown({}, [&](const auto& here, const auto& ball) {
        const std::vector<Handle> skin(ball.bodies.begin(), ball.bodies.end() - 1); // its middle is on no spoke
        of_skin.push_back(extent(here, skin).first);
    });
    const auto jump = [](const auto& heights) { return *std::max_element(heights.begin() + 24, heights.end()); };
    workbook::say() << "Thrown down at 5 m/s the ball is pressed to " << flattest
                    << " of height, its volume stays between " << least << " and " << most << ", and it jumps to "
                    << jump(of_ball) << ". Its skin alone jumps to " << jump(of_skin) << ".\n";
    claim("it is pressed flat by a twentieth, and its volume changes by less than a hundredth",
          flattest < 0.95 * 0.6 * metre && most / least < 1.01);
    claim("with its air it jumps four times as high as its skin alone", jump(of_ball) > 4.0 * jump(of_skin));

    workbook::Plot plot("4.5", "A ball is thrown to the ground: how high its lowest point is");
    plot.x("time").y("height").line("with air", times, of_ball).line("its skin alone", times, of_skin).write();
    return claim.result();
}
