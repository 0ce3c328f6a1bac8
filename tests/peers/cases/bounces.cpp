// SPDX-License-Identifier: BSL-1.0
// Rows C: two that meet, balls that bounce, and what is too fast for a step.

#include "tests/peers/cases/rows.hpp"
#include "tests/peers/cases/scenes.hpp"

namespace peers {

namespace {

constexpr Scene::Detection discrete = Scene::Detection::discrete, continuous = Scene::Detection::continuous;

Scene weightless() { return {.gravity = Vector::Zero()}; }

struct Two {
    Vector a, b; // velocities, m/s
};
/// Two spheres of 0.5 m on the first axis, the gap between them `gap`, after so long.
Two meet(const Contestant& who, Ball a, Ball b, double gap, int steps) {
    const auto world = who.make(weightless());
    b.x = a.x + at(1 + gap);
    const int first = world->add(a), second = world->add(b);
    world->steps(steps);
    return {world->v(first), world->v(second)};
}
/// Elastic or not, by the closed form: the velocities along the first axis.
std::pair<double, double> closed_form(double m1, double v1, double m2, double v2, double e) {
    const double impulse = (1 + e) * (v2 - v1) / (1 / m1 + 1 / m2);
    return {v1 + impulse / m1, v2 - impulse / m2};
}
/// The rest height of a ball that is dropped on a fixed box, both this far away; to the side and up; above the box's
/// top.
double rest_height(const Contestant& who, double away) {
    const auto world = who.make({});
    world->box(at(away, away - 1), at(2, 1, 2), 0, 0);
    const int ball = world->add(Ball{.x = at(away, away + 1)});
    world->steps(300);
    return world->x(ball)[1] - away;
}
/// Balls of 0.1 m that are shot at a wall of 0.1 m: how many of a hundred are not in front of it.
double shot(const Contestant& who, double speed, Scene::Detection how) {
    int through = 0;
    for (int k = 0; k < 100; ++k) {
        Scene scene = weightless();
        scene.detection = how;
        const auto world = who.make(scene);
        world->box(at(0), at(0.05, 2, 2), 0, 0);
        const int ball = world->add(Ball{.x = at(-3 - speed * frame * k / 100), .v = at(speed), .radius = 0.1});
        world->steps(60);
        through += !(world->x(ball)[0] < 0);
    }
    return through;
}

} // namespace

double c1_impulse(const Contestant& who) {
    double error = 0;
    for (const double e : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const auto got =
            meet(who, {.v = at(2), .mass = 1, .bounce = e}, {.v = at(-1), .mass = 3, .bounce = e}, 0.02, 30);
        const auto [a, b] = closed_form(1, 2, 3, -1, e);
        error = worse(error, worse((got.a - at(a)).norm(), (got.b - at(b)).norm()));
    }
    return error;
}
double c2_side_by_side(const Contestant& who) {
    const auto got = meet(who, {.v = at(5), .bounce = 0.5}, {.v = at(5), .bounce = 0.5}, -0.01, 60);
    return worse((got.a - at(5)).norm(), (got.b - at(5)).norm());
}
double c3_parting(const Contestant& who) {
    const auto got = meet(who, {.v = at(-1), .bounce = 0.5}, {.v = at(1), .bounce = 0.5}, -0.01, 60);
    return worse((got.a - at(-1)).norm(), (got.b - at(1)).norm());
}
double c4_across(const Contestant& who) {
    const auto got =
        meet(who, {.v = at(2, 1.25), .bounce = 0.5}, {.v = at(-1, 1.25), .mass = 3, .bounce = 0.5}, 0.02, 30);
    return worse(std::abs(got.a[1] - 1.25), std::abs(got.b[1] - 1.25));
}
double c5_mass_ratio(const Contestant& who) {
    double error = 0;
    for (const double ratio : {1e3, 1e6, 1e9})
        for (const bool heavy_comes : {false, true}) {
            const double va = heavy_comes ? 0 : 2, vb = heavy_comes ? -2 : 0;
            const auto got =
                meet(who, {.v = at(va), .mass = 1, .bounce = 1}, {.v = at(vb), .mass = ratio, .bounce = 1}, 0.02, 30);
            const auto [a, b] = closed_form(1, va, ratio, vb, 1);
            error = worse(error, worse(std::abs(got.a[0] - a), std::abs(got.b[0] - b)));
        }
    return error;
}
double c6_fixed_in_fixed(const Contestant& who) {
    const auto world = who.make({});
    const int one = world->box(at(0), at(1, 1, 1), 0, 0), other = world->box(at(0.5, 0.5), at(1, 1, 1), 0, 0);
    const int ball = world->add(Ball{.x = at(0.5, 4)});
    world->steps(120);
    int bad = 0;
    for (const int i : {one, other, ball}) bad += !world->x(i).allFinite();
    return bad + (std::abs(world->x(ball)[1] - 2) > 0.02);
}
double c8_twenty_bounces(const Contestant& who) {
    const auto world = who.make({});
    world->plane(up, 0, 1, 0);
    const int ball = world->add(Ball{.x = at(0, 10), .bounce = 1});
    double worst = 0, highest = 0, last = 10;
    int bounces = 0;
    bool falls = true;
    for (int i = 0; i < 20000 && bounces < 21; ++i) {
        world->step();
        const double y = world->x(ball)[1];
        if (!std::isfinite(y)) return lost;
        if (falls && y > last) falls = false, highest = 0, ++bounces;
        else if (!falls && y < last) falls = true, worst = worse(worst, std::abs((highest - 0.5) / 9.5 - 1));
        highest = std::max(highest, y);
        last = y;
    }
    return bounces < 21 ? 1 : worst;
}
double c9_zeno(const Contestant& who) {
    const auto world = who.make({});
    world->plane(up, 0, 0.5, 0);
    const int ball = world->add(Ball{.x = at(0, 1.5), .bounce = 0.5});
    world->steps(90);
    double most = 0; // of the half second that follows: a velocity of zero at one moment is no rest
    for (int i = 0; i < 30; ++i) world->step(), most = worse(most, std::abs(world->v(ball)[1]));
    return most;
}
double c11_one_centre(const Contestant& who) {
    Vector apart[2];
    for (Vector& one : apart) {
        const auto world = who.make(weightless());
        const int a = world->add(Ball{}), b = world->add(Ball{});
        world->steps(300);
        one = world->x(a) - world->x(b);
    }
    if (!apart[0].allFinite() || apart[0] != apart[1]) return lost;
    return std::max(0.0, 1 - apart[0].norm());
}
double c14_swapped(const Contestant& who) {
    Vector end[2][2];
    for (const bool swapped : {false, true}) {
        const auto world = who.make(weightless());
        const Ball a{.x = at(0, 0.125), .v = at(2, 0.25), .bounce = 0.5},
            b{.x = at(1.25, -0.25), .v = at(-1), .mass = 3};
        const int first = world->add(swapped ? b : a), second = world->add(swapped ? a : b);
        world->steps(60);
        end[swapped][0] = world->x(swapped ? second : first);
        end[swapped][1] = world->x(swapped ? first : second);
    }
    return worse((end[0][0] - end[1][0]).norm(), (end[0][1] - end[1][1]).norm());
}
double c15_ten_kilometres(const Contestant& who) { return std::abs(rest_height(who, 1e4) - rest_height(who, 0)); }
/// Two that meet head on, ten thousand kilometres from the origin: what their velocities are off by.
double c15_ten_thousand_kilometres(const Contestant& who) {
    const auto got =
        meet(who, {.x = at(1e7), .v = at(2), .bounce = 1}, {.v = at(-1), .mass = 3, .bounce = 1}, 0.02, 30);
    const auto [a, b] = closed_form(1, 2, 3, -1, 1);
    return worse(std::abs(got.a[0] - a), std::abs(got.b[0] - b));
}
double c17_plane(const Contestant& who) {
    double height[2]{};
    for (const double shift : {0.0, 1000.0}) {
        const auto world = who.make({});
        world->plane(up, 2 + shift, 0, 0);
        const int ball = world->add(Ball{.x = at(0, 2.4 + shift)});
        world->steps(300);
        height[shift > 0] = world->x(ball)[1] - shift;
    }
    return std::abs(height[1] - height[0]);
}
double c18_discrete(const Contestant& who) { return shot(who, 17.9, discrete); }
double c18_continuous(const Contestant& who) { return shot(who, 200, continuous); }
double c19_swarm(const Contestant& who) {
    Scene scene = weightless();
    scene.detection = continuous;
    scene.bounces_above = 0;
    const auto world = who.make(scene);
    for (int k = 0; k < (who.flat ? 2 : 3); ++k)
        for (const double side : {-1.0, 1.0}) {
            Vector half(51, 51, 51), x = Vector::Zero();
            half[k] = 0.5, x[k] = side * 50.5;
            world->box(x, half, 1, 0);
        }
    Dice dice(1);
    std::vector<int> swarm;
    for (int i = 0; i < (who.flat ? 1000 : 5000); ++i) {
        Vector v(dice(), dice(), dice()), x(49 * dice(), 49 * dice(), 49 * dice());
        if (who.flat) v[2] = x[2] = 0;
        swarm.push_back(world->add(Ball{.x = x, .v = 250 * v.normalized(), .bounce = 1}));
    }
    world->steps(500);
    int escaped = 0;
    for (const int i : swarm) escaped += !(world->x(i).cwiseAbs().maxCoeff() < 50);
    return escaped;
}
double c20_bullets(const Contestant& who) {
    int through = 0;
    for (int k = 0; k < 100; ++k) {
        Scene scene = weightless();
        scene.detection = continuous;
        const auto world = who.make(scene);
        const double start = 2 + 200 * frame * k / 100;
        const int a = world->add(Ball{.x = at(-start), .v = at(100), .radius = 0.05, .bounce = 1});
        const int b = world->add(Ball{.x = at(start), .v = at(-100), .radius = 0.05, .bounce = 1});
        world->steps(60);
        through += !(world->x(a)[0] < world->x(b)[0]);
    }
    return through;
}
double c24_centre_of_mass(const Contestant& who) {
    const auto world = who.make(weightless());
    const int light = world->add(Ball{.mass = 1}), heavy = world->add(Ball{.x = at(0.9), .mass = 9});
    world->steps(120);
    return std::abs((world->x(light)[0] + 9 * world->x(heavy)[0]) / 10 - 0.81);
}
double c25_ramp(const Contestant& who) {
    double worst = 0;
    constexpr double slope = 0.25, t = 2;
    for (const double mu : {0.75, 0.5, 0.35, 0.26, 0.25, 0.1, 0.0}) {
        Scene scene{.gravity = at(-g * std::sin(slope), -g * std::cos(slope))};
        scene.rubs = true;
        const auto world = who.make(scene);
        world->plane(up, 0, 0, mu);
        const int ball = world->add(Ball{.x = at(0, 0.5), .mass = 3, .friction = mu});
        world->steps(120);
        const double a = std::max(0.0, g * (std::sin(slope) - mu * std::cos(slope)));
        worst = worse(worst, std::abs(-world->v(ball)[0] / t - a));
    }
    return worst;
}

} // namespace peers
