// SPDX-License-Identifier: BSL-1.0
// Rows C, R and V of heaps: many that lie on each other, heavy ones on light ones, and what energy becomes.

#include "tests/peers/cases/rows.hpp"
#include "tests/peers/cases/scenes.hpp"

#include <numeric>

namespace peers {

namespace {

/// A pyramid of ten spheres, a quarter of each in its neighbours, without gravity.
struct Pyramid {
    double fastest = 0, depth = 0;
    explicit Pyramid(const Contestant& who) {
        const auto world = who.make({.gravity = Vector::Zero()});
        std::vector<int> balls;
        for (int row = 0; row < 4; ++row)
            for (int k = 0; k < 4 - row; ++k)
                balls.push_back(world->add(Ball{.x = at(0.75 * (k + 0.5 * row), 5 + 0.75 * std::sqrt(0.75) * row)}));
        for (int i = 0; i < 120; ++i) world->step(), fastest = worse(fastest, peers::fastest(*world, balls));
        depth = deepest(*world, balls, 0.5);
    }
};
/// A heavy sphere on a light one for ten seconds.
struct HeavyOnLight {
    double moved = 0, speed = 0;
    HeavyOnLight(const Contestant& who, double ratio) {
        const auto world = who.make({});
        world->plane(up, 0, 0, 0);
        const int light = world->add(Ball{.x = at(0, 0.5)}), heavy = world->add(Ball{.x = at(0, 1.5), .mass = ratio});
        for (int i = 0; i < 600; ++i) {
            world->step();
            moved = worse(moved, (world->x(light) - at(0, 0.5)).norm());
            if (i >= 300) speed = worse(speed, worse(world->v(light).norm(), world->v(heavy).norm()));
        }
    }
};
/// Balls on the ground, one on the other, under a plate that comes down for 80 cm, whatever is in its way.
struct Press {
    double out = 0;     // how far a centre is below the ground, or above the middle of the plate, m
    double fastest = 0; // over the speed of the plate
    explicit Press(const Contestant& who) {
        for (const double speed : {0.3, 3.0})
            for (const int n : {1, 2, 5})
                for (const double ratio : {1.0, 3.0, 100.0}) press(who, speed, n, ratio);
    }
    void press(const Contestant& who, double speed, int n, double ratio) {
        const double half = 0.5;
        const auto world = who.make({});
        world->plane(up, 0, 0, 0);
        std::vector<int> balls;
        for (int i = 0; i < n; ++i) balls.push_back(world->add(Ball{.x = at(0, 0.5 + i), .mass = i % 2 ? ratio : 1}));
        const int plate = world->platform(at(0, n + 0.1 + half), at(4, half, 4));
        world->send(plate, at(0, -speed));
        for (int i = 0; i < 0.9 / speed * 60; ++i) {
            world->step();
            const double middle = world->x(plate)[1];
            for (const int b : balls) {
                const Vector x = world->x(b);
                const bool beside = std::hypot(x[0], x[2]) > 4; // squeezed out, and falls
                out = worse(out, beside ? 0 : std::max(-x[1], x[1] - middle));
                fastest = worse(fastest, (world->v(b).norm() - g * frame) / speed); // one step of falling is allowed
            }
        }
    }
};
struct Column {
    double aside = 0, energy = 0;
    explicit Column(const Contestant& who) {
        const auto world = who.make({});
        world->plane(up, 0, 0, 0);
        std::vector<int> balls;
        for (int i = 0; i < 10; ++i) balls.push_back(world->add(Ball{.x = at(0, 4 + 3 * i), .radius = 1}));
        world->steps(600);
        for (const int i : balls) {
            aside = worse(aside, std::hypot(world->x(i)[0], world->x(i)[2]));
            energy = worse(energy, 0.05 * world->v(i).squaredNorm());
        }
        // A column that is none any more has no energy, either.
        if (!(std::abs(world->x(balls.back())[1] - 19) < 1)) energy = aside = lost;
    }
};
/// Four balls that fall on each other, all lengths times `size`: their heights over it, step by step.
std::vector<double> heights(const Contestant& who, double size) {
    Scene scene{.gravity = at(0, -g * size), .size = size, .bounces_above = 0.25 * size};
    scene.slow = 0.05 * size;
    const auto world = who.make(scene);
    world->plane(up, 0, 0, 0);
    std::vector<int> balls;
    for (int i = 0; i < 4; ++i)
        balls.push_back(world->add(Ball{.x = at(0, (1 + 1.3 * i) * size), .mass = 1.0 + i, .radius = 0.5 * size}));
    std::vector<double> all;
    for (int i = 0; i < 240; ++i) {
        world->step();
        for (const int b : balls) all.push_back(world->x(b)[1] / size);
    }
    return all;
}
double scaled(const Contestant& who, std::size_t from) {
    const auto one = heights(who, 1);
    double most = 0;
    for (const double size : {1e-3, 1e3}) {
        const auto other = heights(who, size);
        for (std::size_t i = from; i < one.size(); ++i) most = worse(most, std::abs(one[i] - other[i]));
    }
    return most;
}
/// Fifteen balls in five columns, added in this order.
std::vector<Vector> dropped(const Contestant& who, const std::vector<int>& order, bool floor_first) {
    const auto world = who.make({});
    if (floor_first) world->plane(up, 0, 0, 0);
    std::vector<int> numbers(order.size());
    for (const int i : order)
        numbers[std::size_t(i)] =
            world->add(Ball{.x = at(3.0 * (i % 5), 1 + 1.5 * (i / 5)), .mass = 1.0 + i, .bounce = 0.1 * (i % 3)});
    if (!floor_first) world->plane(up, 0, 0, 0);
    world->steps(400);
    std::vector<Vector> places;
    for (const int i : numbers) places.push_back(world->x(i));
    return places;
}

} // namespace

double c21_speed(const Contestant& who) { return Pyramid(who).fastest; }
double c21_depth(const Contestant& who) { return Pyramid(who).depth; }
double c26_heap(const Contestant& who) {
    const int n = who.flat ? 225 : 216;
    const double half = half_of(who, n, 1.1);
    const auto world = who.make({});
    walls(*world, who, half);
    Dice dice(5);
    std::vector<int> balls;
    for (const Vector& x : grid(who, n, 1.1, 0.6, 0.01, dice)) balls.push_back(world->add(Ball{.x = x, .mass = 10}));
    world->steps(600);
    return deepest(*world, balls, 0.5, half);
}
/// Energies are those of flight, by places alone: the velocity between two steps is what both sides have in common,
/// whatever an engine calls its velocity. A ball that is on the ground has that of its last flight.
double c27_elastic(const Contestant& who) {
    const auto world = who.make({});
    world->plane(up, 0, 1, 0);
    struct Flight {
        int ball;
        double before, now, energy;
    };
    std::vector<Flight> all;
    double start = 0, most = 0;
    for (int i = 0; i < 49; ++i) {
        const double y = 2 + 0.1 * i;
        const Vector x = who.flat ? at(2.0 * i - 48, y) : at(2.0 * (i % 7), y, 2.0 * (i / 7));
        all.push_back({world->add(Ball{.x = x, .mass = 10, .bounce = 1}), y, y, 10 * g * (y - 0.5)});
        start += all.back().energy;
    }
    for (int i = 0; i < 6000; ++i) {
        world->step();
        double energy = 0;
        for (Flight& f : all) {
            const double next = world->x(f.ball)[1], v = 0.5 * (next - f.before) / frame;
            const bool flies = std::abs((next - 2 * f.now + f.before) / (-g * frame * frame) - 1) < 0.1;
            if (i > 0 && flies) f.energy = 10 * (0.5 * v * v + g * (f.now - 0.5));
            if (!std::isfinite(next)) return lost;
            f.before = f.now, f.now = next;
            energy += f.energy;
        }
        most = worse(most, std::abs(energy / start - 1));
    }
    return most;
}
double r4_60(const Contestant& who) { return HeavyOnLight(who, 60).moved; }
double r4_100(const Contestant& who) { return HeavyOnLight(who, 100).moved; }
double r4_300(const Contestant& who) { return HeavyOnLight(who, 300).moved; }
double r4_400(const Contestant& who) { return HeavyOnLight(who, 400).moved; }
double r4_speed(const Contestant& who) {
    double most = 0;
    for (const double ratio : {60.0, 100.0, 300.0, 400.0}) most = worse(most, HeavyOnLight(who, ratio).speed);
    return most;
}
double r17_out(const Contestant& who) { return Press(who).out; }
double r17_speed(const Contestant& who) { return Press(who).fastest; }
double r5_aside(const Contestant& who) { return Column(who).aside; }
double r5_energy(const Contestant& who) { return Column(who).energy; }
/// Above where the same engine lets the same two lie without a load.
double r7_rise(const Contestant& who) {
    double rise = 0, place[2]{};
    for (const bool loaded : {false, true}) {
        const auto world = who.make({});
        world->plane(up, 0, 0, 0);
        const int balls[2] = {world->add(Ball{.x = at(0, 0.5)}), world->add(Ball{.x = at(0, 1.5)})};
        const int load = loaded ? world->add(Ball{.x = at(0, 2.5), .mass = 100}) : -1;
        world->steps(120);
        if (loaded) world->remove(load);
        for (int i = 0; i < 120; ++i) {
            world->step();
            for (const int k : {0, 1}) {
                const double y = world->x(balls[k])[1];
                if (loaded) rise = worse(rise, y - place[k]);
                else place[k] = y;
            }
        }
    }
    return rise;
}
double r8_soft_floor(const Contestant& who) {
    double most = 0;
    for (const double k : {1e3, 1e4, 1e5, 1e6}) {
        Scene scene{.dt = 1.0 / 240};
        scene.soft = k, scene.soft_damping = 0.4 * std::sqrt(k);
        const auto world = who.make(scene);
        world->plane(up, 0, 0, 0);
        const int ball = world->add(Ball{.x = at(0, 0.6)});
        world->steps(50 * 240);
        most = worse(most, std::abs(0.5 - world->x(ball)[1] - g / k));
    }
    return most;
}
double r14_order(const Contestant& who) {
    std::vector<int> order(15);
    std::iota(order.begin(), order.end(), 0);
    const auto reference = dropped(who, order, true);
    double most = 0;
    std::mt19937 random(7);
    for (int k = 0; k < 4; ++k) {
        const auto other = dropped(who, order, k % 2 == 1);
        for (std::size_t i = 0; i < reference.size(); ++i) most = worse(most, (other[i] - reference[i]).norm());
        for (std::size_t i = order.size() - 1; i > 0; --i) std::swap(order[i], order[random() % (i + 1)]);
    }
    return most;
}
double r14_jitter(const Contestant& who) {
    const auto world = who.make({.gravity = at(0, -100)});
    world->plane(up, 0, 0, 0);
    const int ball = world->add(Ball{.x = at(0, 2), .bounce = 0.5});
    world->steps(300);
    double sum = 0;
    for (int i = 0; i < 60; ++i) world->step(), sum += world->v(ball).squaredNorm() / 60;
    return std::isfinite(sum) ? std::sqrt(sum) : lost;
}
double r15_long(const Contestant& who) {
    const auto world = who.make({});
    world->plane(up, 0, 0, 0);
    const int lower = world->add(Ball{.x = at(0, 0.5)}), upper = world->add(Ball{.x = at(0, 1.5), .mass = 2});
    world->steps(600);
    const Vector a = world->x(lower), b = world->x(upper);
    world->steps(100000);
    return worse((world->x(lower) - a).norm(), (world->x(upper) - b).norm());
}
double r16_way(const Contestant& who) { return scaled(who, 0); }
double r16_place(const Contestant& who) { return scaled(who, std::size_t(4 * 180)); }
double v3_energy(const Contestant& who) {
    double most = 0;
    for (const double e : {1.0, 0.5}) {
        const auto world = who.make({.gravity = Vector::Zero()});
        for (const double side : {1.0, -1.0})
            for (int k = 0; k < (who.flat ? 2 : 3); ++k) world->plane(side * Vector::Unit(k), -8, e, 0);
        Dice dice(3);
        std::vector<int> balls;
        double start = 0;
        for (const Vector& x : grid(who, who.flat ? 100 : 125, 1.5, 0, 0.1, dice)) {
            Vector v(15 * dice(), 15 * dice(), who.flat ? 0 : 15 * dice());
            balls.push_back(world->add(Ball{.x = x - at(0, who.flat ? 6.75 : 3), .v = v, .bounce = e}));
            start += v.squaredNorm();
        }
        for (int i = 0; i < 600; ++i) {
            world->step();
            double now = 0;
            for (const int b : balls) now += world->v(b).squaredNorm();
            most = worse(most, now / start - 1);
        }
    }
    return most;
}
double v7_far(const Contestant& who) {
    double most = 0;
    for (const double away : {512.0, 4096.0}) {
        const auto world = who.make({.dt = 1.0 / 240, .gravity = Vector::Zero(), .far = true});
        const int ball = world->add(Ball{.x = at(away), .v = at(0.05)});
        world->steps(240 * 20);
        most = worse(most, std::abs((world->x(ball)[0] - away) / 1.0 - 1));
    }
    return most;
}

} // namespace peers
