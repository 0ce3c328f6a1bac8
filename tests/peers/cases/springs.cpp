// SPDX-License-Identifier: BSL-1.0
// Rows S and I: springs along one axis, orbits, free fall and drag.

#include "tests/peers/cases/rows.hpp"
#include "tests/peers/cases/scenes.hpp"

namespace peers {

namespace {

const double pi = std::acos(-1.0);

/// Nobody collides and nothing falls.
Scene free_flight(double dt, bool resolved = true) {
    Scene scene{.dt = dt, .gravity = Vector::Zero()};
    scene.springs = true;
    scene.resolved = resolved;
    return scene;
}
/// One mass of 1 kg on a spring of 3 m along the first axis, stretched by x0.
struct OnASpring {
    std::unique_ptr<Engine> world;
    int ball;
    OnASpring(const Contestant& who, const Scene& scene, double k, double c, double x0)
        : world(who.make(scene)), ball(world->add(Ball{.x = at(3 + x0)})) {
        world->add(SpringOf{.a = ball, .stiffness = k, .damping = c, .rest = 3});
    }
    double stretched() const { return world->x(ball)[0] - 3; }
};
/// A damped swing from x0 = 1 at rest, by its closed form; omega = 10/s.
double damped(double zeta, double t) {
    constexpr double w = 10;
    if (zeta < 1) {
        const double wd = w * std::sqrt(1 - zeta * zeta);
        return std::exp(-zeta * w * t) * (std::cos(wd * t) + zeta * w / wd * std::sin(wd * t));
    }
    if (zeta == 1) return std::exp(-w * t) * (1 + w * t);
    const double s = w * std::sqrt(zeta * zeta - 1), a = -zeta * w + s, b = -zeta * w - s;
    return (a * std::exp(b * t) - b * std::exp(a * t)) / (a - b);
}
/// A chain that hangs down, its links 0.1 m long: how much longer it is in the end than unloaded.
double hung(const Contestant& who, int links, double m, double k, double c, double last) {
    Scene scene{};
    scene.springs = true;
    scene.resolved = false;
    const auto world = who.make(scene);
    int before = -1;
    for (int i = 1; i <= links; ++i) {
        const int ball = world->add(Ball{.x = at(0, -0.1 * i), .mass = i == links ? last : m, .radius = 0.02});
        world->add(SpringOf{.a = ball, .b = before, .stiffness = k, .damping = c, .rest = 0.1});
        before = ball;
    }
    world->steps(60 * 120);
    return -world->x(before)[1] - 0.1 * links;
}

} // namespace

double i8_free_fall(const Contestant& who) {
    Scene scene{};
    scene.springs = true;
    const auto world = who.make(scene);
    const int ball = world->add(Ball{.x = at(0, 10)});
    world->steps(60);
    return std::abs(world->x(ball)[1] - (10 - 0.5 * g));
}
double i13_kepler(const Contestant& who) {
    constexpr double e = 0.6;
    Scene scene = free_flight(2 * pi / 1000);
    scene.pull_of_sun = 1;
    const auto world = who.make(scene);
    const int planet = world->add(Ball{.x = at(1 - e), .v = at(0, std::sqrt((1 + e) / (1 - e))), .radius = 0.01});
    double most = 0;
    for (int i = 0; i < 100 * 1000; ++i) {
        world->step();
        most = worse(most, std::abs((0.5 * world->v(planet).squaredNorm() - 1 / world->x(planet).norm()) / -0.5 - 1));
    }
    return most;
}
double i23_damping(const Contestant& who) {
    double least = 1e300, most = 0;
    for (const double rate : {30.0, 60.0, 120.0}) {
        Scene scene = free_flight(1 / rate);
        scene.drag = 0.6;
        scene.drag_dt = frame;
        const auto world = who.make(scene);
        const int ball = world->add(Ball{.v = at(1)});
        world->steps(int(rate));
        least = std::min(least, world->v(ball)[0]), most = worse(most, world->v(ball)[0]);
    }
    return most - least;
}
double s1_recurrence(const Contestant& who) {
    const double w = 2 * pi * 2, k = w * w, c = 2 * 0.1 * w, h = frame;
    const OnASpring s(who, free_flight(h, false), k, c, 1);
    double x = 1, v = 0, most = 0;
    for (int i = 0; i < 120; ++i) {
        v = (v - h * k * x) / (1 + h * c + h * h * k);
        x += h * v;
        s.world->step();
        most = worse(most, std::abs(s.stretched() - x));
    }
    return most;
}
double s2_damped(const Contestant& who) {
    double most = 0;
    for (const double zeta : {0.1, 1.0, 10.0}) {
        const OnASpring s(who, free_flight(1.0 / 240), 100, 2 * zeta * 10, 1);
        for (int i = 1; i <= 240; ++i) {
            s.world->step();
            most = worse(most, std::abs(s.stretched() - damped(zeta, i / 240.0)));
        }
    }
    return most;
}
double s2_swings_over(const Contestant& who) {
    double most = 0;
    for (const double zeta : {1.0, 10.0}) {
        const OnASpring s(who, free_flight(1.0 / 240), 100, 2 * zeta * 10, 1);
        for (int i = 0; i < 2400; ++i) s.world->step(), most = worse(most, -s.stretched());
    }
    return std::max(0.0, most);
}
double s3_stiff(const Contestant& who) {
    const OnASpring s(who, free_flight(frame, false), 1e6, 0, 1e-2);
    double most = 0;
    for (int i = 0; i < 120; ++i) s.world->step(), most = worse(most, std::abs(s.stretched()));
    return most / 1e-2;
}
double s4_no_length(const Contestant& who) {
    int bad = 0;
    for (const double rest : {0.0, 1.0}) {
        const auto world = who.make(free_flight(0.01));
        const int a = world->add(Ball{.x = at(1, 2, who.flat ? 0 : 3)});
        const int b = world->add(Ball{.x = at(1, 2, who.flat ? 0 : 3), .mass = 2});
        world->add(SpringOf{.a = a, .b = b, .stiffness = 100, .damping = 1, .rest = rest});
        world->steps(100);
        bad += !(world->x(a).allFinite() && world->x(b).allFinite() && (world->x(a) - world->x(b)).norm() < 3);
    }
    return bad;
}
namespace {
/// Two free masses, 1 : 1000, for 20 s.
struct Pair {
    double drift = 0, off = 0; // m, of the centre; of the frequency
    explicit Pair(const Contestant& who) {
        const double k = 1e3, M = 1000, h = 1e-3, omega = std::sqrt(k * (1 + 1 / M));
        const auto world = who.make(free_flight(h));
        const int a = world->add(Ball{.x = at(1.1)}), b = world->add(Ball{.mass = M});
        world->add(SpringOf{.a = a, .b = b, .stiffness = k, .rest = 1});
        auto centre = [&] { return (world->x(a)[0] + M * world->x(b)[0]) / (1 + M); };
        const double start = centre();
        double last = 0.1, first_cross = 0, last_cross = 0;
        int crossings = 0;
        for (int i = 1; i <= 20000; ++i) {
            world->step();
            const double now = world->x(a)[0] - world->x(b)[0] - 1;
            if (last > 0 && now <= 0) {
                last_cross = h * (i - 1 + last / (last - now));
                if (crossings++ == 0) first_cross = last_cross;
            }
            last = now;
        }
        drift = std::abs(centre() - start);
        off = crossings < 50 ? lost : std::abs(2 * pi * (crossings - 1) / (last_cross - first_cross) / omega - 1);
    }
};
} // namespace
double s5_centre(const Contestant& who) { return Pair(who).drift; }
double s5_frequency(const Contestant& who) { return Pair(who).off; }
double s6_chain(const Contestant& who) {
    const double m = 0.05, k = 500;
    return std::abs(hung(who, 20, m, k, 0.5, m) - m * g * 20 * 21 / 2 / k);
}
double s8_ball_and_chain(const Contestant& who) {
    const double m = 0.05, k = 2e4, M = 200 * m;
    const double right = (40 * M + m * 39 * 40 / 2) * g / k;
    return std::abs(hung(who, 40, m, k, 50, M) / right - 1);
}
double s9_resonance(const Contestant& who) {
    const double F = 0.2, c = 0.4, omega = 10, h = 0.001;
    const OnASpring s(who, free_flight(h), 100, c, 0);
    double late = 0;
    for (int i = 0; i < 100000; ++i) {
        s.world->push(s.ball, at(F * std::sin(omega * h * (i + 0.5))));
        s.world->step();
        if (i >= 90000) late = worse(late, std::abs(s.stretched()));
    }
    return std::abs(late / (F / (c * omega)) - 1);
}

} // namespace peers
