// SPDX-License-Identifier: BSL-1.0
// 6.3.8 Walking a path: a body with a greatest speed and acceleration, that shoots past no way point and touches no
// wall

// A* answers with places. Who goes there has a speed that he must gather and lose, and corners that he cannot take at
// full speed. The usual way is to steer at the next place until it is near: whoever is too fast for that shoots past
// it, turns, and shoots past it again. Here the walker knows the whole of its way, and how fast it can be on each part
// of it: corners are cut as far as walls allow, on a curve that turns with the greatest acceleration. (A part of
// section 6.3, beyond the notes.)

#include "claims.hpp"
#include "drawing.hpp"
#include "film.hpp"

#include <ansatz/paths.hpp>
#include <ansatz/paths/walking.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <vector>

using namespace ansatz;
using namespace ansatz::paths;

namespace {

/// How far from a place somebody still gets, after a minute of steering at it with full speed.
Quantity<unit::Length> still_away() {
    auto x = metres(0, 0);
    auto v = metres_per_second(0, 3);
    const auto den = metres(2, 0);
    const auto dt = 0.02 * second;
    auto farthest = 0.0 * metre;
    for (int i = 0; i < 4000; ++i) {
        //! [seek]
        v = steered(v, seek(x, den, 3.0 * metre / second), 2.0 * metre / second / second, dt);
        x = x + v * dt;
        //! [seek]
        if (i >= 3000) farthest = max(farthest, norm(den - x));
    }
    return farthest;
}
double clearance(const Grid<>& map, double x, double y) {
    double least = 1e9;
    for (int i = -1; i <= int(map.width()); ++i)
        for (int k = -1; k <= int(map.height()); ++k)
            if (i < 0 || k < 0 || !map.passable(Cell{std::uint16_t(i), std::uint16_t(k)}))
                least =
                    std::min(least, std::hypot(std::max({i - x, 0.0, x - i - 1}), std::max({k - y, 0.0, y - k - 1})));
    return least;
}

} // namespace

int main() {
    workbook::Claims claim;
    const auto fox_speed = 3.0 * metre / second;
    const auto fox_acceleration = 2.0 * metre / second / second;

    // Steering at a place.
    std::cout << "`seek` is still up to " << std::fixed << std::setprecision(1) << still_away().value()
              << " m away from the place after a minute\n";
    claim("who steers at a place at full speed shoots past it for ever", still_away() > 1.0 * metre);
    auto x = metres(0, 0);
    auto v = metres_per_second(0, 3);
    const auto den = metres(2, 0);
    int steps = 0;
    for (; steps < 1000 && norm(v).value() + norm(den - x).value() > 1e-12; ++steps) {
        const auto dt = 0.02 * second;
        v = steered(v, arrive(x, den, fox_speed, fox_acceleration, dt), fox_acceleration, dt);
        x = x + v * dt;
    }
    std::cout << "`arrive` stands at the place after " << steps << " steps of 0.02 s\n";
    claim("`arrive` stands there, to the rounding", steps < 1000);

    // A path.
    auto map = grid_from<Grid<>>({"....................", ".######.............", "......#....######...",
                                  "......#.........#...", "..###.#....#....#...", "..#...#....#....#...",
                                  "..#........#........"});
    //! [go]
    AStar search{map};
    World world{Space<double, 2>{}, SemiImplicitEuler{}, Walkers{}};
    const auto fox = world.add(position(map.position(Cell{0, 0})));
    Traveller traveller{
        search, fox,
        Gait{.speed = 3.0 * metre / second, .acceleration = 2.0 * metre / second / second, .radius = 0.45 * metre}};
    traveller.go(world, Cell{14, 5});
    //! [go]
    const auto planned = world.walking(traveller.walk());
    std::cout << "The way has " << planned.way_points << " way points and is " << std::fixed << std::setprecision(1)
              << planned.left.value() << " m long; it takes " << planned.time_left.value() << " s\n";

    workbook::Film film(
        "6.3.8", "There and back, and a tree falls across the way",
        "A fox walks through gaps of walls to its goal, slower round the corners, and stands there. On "
        "its way back a tree falls across its path; it finds another one, and comes home.",
        {.middle = metres(10, -3.3, 0), .width = workbook::Film::wide / 60.0 * metre, .height = 8.4 * metre});
    film.may_change();
    film.scenery().tiles(drawing::in_film(map, drawing::cells(map, true)), map.tile(), {0xeef0f1, 0});
    film.scenery().tiles(drawing::in_film(map, drawing::cells(map, false)), map.tile(), workbook::paints::stone);
    std::vector<VectorQuantity<unit::Length>> trail;
    std::vector<Cell> fallen; // trees
    int step = 0;
    // After each step; each twelfth is a frame, until the fox is home again. A film has y upwards, the map downwards.
    auto draw_step = [&] {
        const auto place = world.position(fox);
        trail.push_back(metres(place.value()[0], -place.value()[1], 0));
        if (step++ % 12 != 0 || (!fallen.empty() && traveller.arrived(world))) return;
        auto& frame = film.frame(world.time());
        if (!fallen.empty()) frame.tiles(drawing::in_film(map, fallen), map.tile(), workbook::paints::wood);
        auto ahead = drawing::in_film(map, traveller.route().ahead());
        ahead.insert(ahead.begin(), trail.back());
        if (ahead.size() > 1) frame.line(ahead, workbook::paints::water);
        if (trail.size() > 1) frame.line(trail, workbook::paints::ball);
        frame.ball(trail.back(), 0.45 * metre, workbook::paints::ball);
    };

    std::vector<Quantity<unit::Length>> east, north;
    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Velocity>> speeds;
    double least = 1e9, fastest = 0, hardest = 0, time = 0;
    auto before = world.velocity(fox);
    //! [loop]
    while (!traveller.arrived(world)) {
        world.step(0.02 * second);
        traveller.update(world); // polls the walker and the map
        //! [loop]
        draw_step();
        time += 0.02;
        const auto place = world.position(fox);
        const auto now = world.velocity(fox);
        least = std::min(least, clearance(map, place.value()[0], place.value()[1]));
        fastest = std::max(fastest, norm(now).value());
        hardest = std::max(hardest, norm(now - before).value() / 0.02);
        before = now;
        for (const auto& event : world.walk_events())
            std::cout << "  " << std::setw(4) << time
                      << " s: " << (event.news == WalkNews::way_point ? "passed a way point" : "arrived") << " at "
                      << place.value()[0] << ", " << place.value()[1] << '\n';
        east.push_back(ansatz::x(place)), north.push_back(double(map.height()) * map.tile() - ansatz::y(place));
        times.push_back(time * second), speeds.push_back(norm(now));
        if (time > 60) break;
    }
    std::cout << "Fastest " << std::setprecision(2) << fastest << " m/s, hardest " << hardest
              << " m/s^2, nearest to a wall " << least << " m\n";
    claim("it arrives when its profile says, but for the step in which it is told",
          std::abs(time - planned.time_left.value()) <= 0.05);
    claim("it was never too fast, and never turned or braked too hard", fastest <= 3.0001 && hardest <= 2.0001);
    claim("its disc of 0.45 m touched no wall", least >= 0.45 - 1e-9);
    claim("it stands at the goal, to the rounding",
          norm(world.position(fox) - map.position(Cell{14, 5})).value() < 1e-12 &&
              norm(world.velocity(fox)).value() == 0);

    // The map changes; the picture shows it as it was.
    workbook::Plot plot("6.3.8", "Corners are cut as far as the walls allow");
    drawing::with_walls(plot, map).line("fox", east, north);
    traveller.go(world, Cell{0, 0});
    trail.clear();
    const auto searches = traveller.route().searches();
    auto go_on = [&](double seconds) {
        for (double t = 0; t < seconds; t += 0.02) world.step(0.02 * second), traveller.update(world), draw_step();
    };
    go_on(1);
    map.set_passable(Cell{19, 0}, false); // far from the way
    fallen.push_back(Cell{19, 0});
    go_on(0.1);
    claim("a tree far from its way makes it search no more", traveller.route().searches() == searches);
    //! [falls]
    const auto ahead = traveller.route().ahead();
    map.set_passable(ahead[ahead.size() / 2], false); // a tree falls across the way
    //! [falls]
    fallen.push_back(ahead[ahead.size() / 2]);
    go_on(60);
    claim("one across its way makes it search once more, and it arrives",
          traveller.route().searches() == searches + 1 && traveller.arrived(world));

    film.write();
    plot.write();
    workbook::Plot profile("6.3.8-speed", "It slows down for corners, and for the end");
    profile.x("time").y("speed").line("fox", times, speeds);
    profile.write();
    return claim.result();
}
