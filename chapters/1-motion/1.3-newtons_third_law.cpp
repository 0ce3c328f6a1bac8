// SPDX-License-Identifier: BSL-1.0
// 1.3 Newton's third law: a force between two bodies acts on both, equal and opposite, at once

// Who writes a force between two bodies writes it once, and the world adds it to the first and takes it from the second
// (`view.add_force_pair`). The policy Attraction is such a force. Forget the second half, and a pair of bodies pulls
// itself through space by its own bootstraps: Lopsided below does, and the momentum of the closed system gives it away.

#include "claims.hpp"
#include "film.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/world.hpp>

#include <array>
#include <vector>

using namespace ansatz;

/// The slip: each body is pulled towards the first one, and the first feels nothing.
//! [slip]
struct Lopsided {
    using role = roles::Force;
    using reads = Columns<Position>;
    static constexpr bool couples_bodies = true;
    template <class S> struct In {
        explicit In(const Lopsided&) {}
        void couple(auto& view, const auto&) const {
            view.for_each([&](std::size_t i) {
                if (view.id(i) == 0) return;
                const auto to_the_first = view.template get<Position>(0) - view.template get<Position>(i);
                view.add_force(i, 1.0 * newton * direction(to_the_first));
            });
        }
    };
};
//! [slip]

struct Path {
    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Length>> first, second, centre;
    Quantity<unit::Momentum, Vector<double, 3>> momentum;
};

/// Two bodies of 1 kg and 3 kg, 4 m apart and at rest, for two seconds, or for so many steps of 1/60 s.
template <class Force> Path watch(Force force, int steps = 120) {
    //! [pair]
    World world{VelocityVerlet{}, force, Keep<InverseMass>{}};
    const auto light = world.add(position(metres(0, 0, 0)), mass(1.0 * kilogram));
    const auto heavy = world.add(position(metres(4, 0, 0)), mass(3.0 * kilogram));
    //! [pair]
    Path path;
    for (int i = 0; i <= steps; ++i) {
        if (i > 0) world.step(1.0 / 60 * second);
        path.times.push_back(world.time());
        path.first.push_back(x(world.position(light)));
        path.second.push_back(x(world.position(heavy)));
        path.centre.push_back(x(centre_of_mass(world)));
    }
    path.momentum = total_momentum(world);
    return path;
}

/// A film of both pairs, one above the other, until two of the bodies are about to touch.
void draw(const std::array<Path, 2>& pairs) {
    workbook::Film film(
        "1.3", "Action and reaction, and what happens without the reaction",
        "Two bodies pull on each other. With the law both move, and their centre of mass stays where it "
        "is. Without the reaction only the heavy one moves, and the centre of mass with it.",
        {.middle = metres(2.1, 0, 0), .width = 5.6 * metre, .height = 2.3 * metre});
    film.still(50);
    const auto in_row = [](std::size_t k, double place, double up) {
        return metres(place, 0.45 - 1.1 * double(k) + up, 0);
    };
    const std::array names{"with the reaction", "without the reaction"};
    for (std::size_t k = 0; k < 2; ++k) {
        film.scenery().note(in_row(k, -0.6, 0.42), names[k]);
        film.scenery().line(std::vector{in_row(k, 3, -0.38), in_row(k, 3, 0.38)}, workbook::paints::stone);
    }
    for (std::size_t n = 0; n < pairs[0].times.size(); n += 4) {
        auto& frame = film.frame(pairs[0].times[n]);
        for (std::size_t k = 0; k < 2; ++k)
            frame.ball(in_row(k, in(pairs[k].first[n], metre), 0), 0.2 * metre, workbook::paints::ball)
                .ball(in_row(k, in(pairs[k].second[n], metre), 0), 0.29 * metre, workbook::paints::rubber)
                .ball(in_row(k, in(pairs[k].centre[n], metre), 0), 0.05 * metre, workbook::paints::wire);
    }
    film.write();
}

int main() {
    workbook::Claims claim;
    const auto push = newtons(0, 0, 5);
    claim("what the wall does to the hand is minus what the hand does to the wall",
          mechanics::reaction(push) == newtons(0, 0, -5));

    // A constant of gravitation that lets a game see something within seconds.
    Attraction attraction;
    attraction.constant = 1.0 * (cubic_metre / (kilogram * second * second));
    const auto both = watch(attraction);
    const auto one = watch(Lopsided{});
    workbook::say() << "Two bodies attract each other for 2 s; they come to " << both.first.back() << " and "
                    << both.second.back() << ", their centre of mass is at " << both.centre.back() << '\n'
                    << "momentum with the third law: " << both.momentum
                    << "\nmomentum without:            " << one.momentum << '\n';
    claim("the centre of mass stays at 3 m", abs(both.centre.back() - 3.0 * metre) < 1e-12 * metre);
    claim("the light one went three times as far as the heavy one",
          abs((both.first.back() - 0.0 * metre) - 3.0 * (4.0 * metre - both.second.back())) < 1e-12 * metre);
    claim("momentum is zero, as it was", norm(both.momentum) < 1e-12 * kilogram_metre_per_second);
    claim("without the reaction the pair gains momentum from nothing",
          norm(one.momentum) > 1.0 * kilogram_metre_per_second);

    draw({watch(attraction, 252), watch(Lopsided{}, 252)});
    workbook::Plot plot("1.3", "Action and reaction: the centre of mass does not move");
    plot.x("time").y("position").line("1 kg", both.times, both.first).line("3 kg", both.times, both.second);
    plot.reference("centre of mass", both.times, both.centre).line("3 kg, by the slip", one.times, one.second).write();
    return claim.result();
}
