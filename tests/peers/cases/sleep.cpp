// SPDX-License-Identifier: BSL-1.0
// Rows R of rest and wake.

#include "tests/peers/cases/rows.hpp"
#include "tests/peers/cases/scenes.hpp"

#include <functional>

namespace peers {

namespace {

Scene sleepy(const Vector& gravity = at(0, -g)) {
    Scene scene{.gravity = gravity};
    scene.sleeps = true;
    return scene;
}
/// A ball that sleeps on a fixed box, or on a platform, if it ever falls asleep there.
struct Sleeper {
    std::unique_ptr<Engine> world;
    int support, ball;
    bool fell_asleep = false;

    explicit Sleeper(const Contestant& who, bool on_platform = false)
        : world(who.make(sleepy())),
          support(on_platform ? world->platform(at(0, -0.5), at(2, 0.5, 2))
                              : world->box(at(0, -0.5), at(2, 0.5, 2), 0, 0)),
          ball(world->add(Ball{.x = at(0, 0.5)})) {
        for (int i = 0; i < 600 && !fell_asleep; ++i) world->step(), fell_asleep = world->asleep(ball);
    }
    /// Whether it falls like a stone from now on.
    bool falls() {
        const double before = world->x(ball)[1];
        world->steps(15);
        return before - world->x(ball)[1] >= 0.99 * 0.5 * g * (15 * frame) * (15 * frame);
    }
};

} // namespace

double r9_apex(const Contestant& who) {
    int slept = 0;
    for (const double weak : {0.01, 0.1, 1.62, 9.81})
        for (const double thrown : {0.0, 0.04}) {
            const auto world = who.make(sleepy(at(0, -weak)));
            world->plane(up, 0, 0, 0);
            const int ball = world->add(Ball{.x = at(0, 100), .v = at(0, thrown)});
            bool once = false;
            for (int i = 0; i < 240; ++i) world->step(), once = once || world->asleep(ball);
            slept += once;
        }
    return slept;
}
double r10_exact(const Contestant& who) {
    int faults = 0;
    Vector end[2];
    for (const bool sleeps : {false, true}) {
        Scene scene = sleepy();
        scene.sleeps = sleeps;
        const auto world = who.make(scene);
        world->plane(up, 0, 0, 0);
        std::vector<int> column;
        for (int i = 0; i < 3; ++i) column.push_back(world->add(Ball{.x = at(0, 0.5 + i)}));
        const int flying = world->add(Ball{.x = at(20, 500), .v = at(3)});
        world->steps(300);
        end[sleeps] = world->x(flying);
        if (sleeps)
            for (const int i : column) faults += !(world->asleep(i) && world->v(i).norm() == 0);
    }
    return faults + (end[0] != end[1]);
}
/// Seven ways to lose one's rest: how many of them go unnoticed. Who never fell asleep has nothing to notice, and may
/// move on.
double r11_wake(const Contestant& who) {
    const std::vector<std::function<bool()>> woken{[&] { // the support is removed
                                                       Sleeper s(who);
                                                       s.world->remove(s.support);
                                                       return s.falls();
                                                   },
                                                   [&] { // it is put aside
                                                       Sleeper s(who);
                                                       s.world->put(s.support, at(20, -0.5));
                                                       return s.falls();
                                                   },
                                                   [&] { // it goes up
                                                       Sleeper s(who, true);
                                                       s.world->send(s.support, at(0, 1));
                                                       s.world->steps(60);
                                                       return std::abs(s.world->x(s.ball)[1] - 1.5) <= 0.05;
                                                   },
                                                   [&] { // it goes down, faster than anything falls
                                                       Sleeper s(who, true);
                                                       s.world->send(s.support, at(0, -20));
                                                       return s.falls();
                                                   },
                                                   [&] { // a ball hits it at a centimetre in a second
                                                       Sleeper s(who);
                                                       s.world->add(Ball{.x = at(1.0001, 0.5), .v = at(-0.01)});
                                                       s.world->steps(2);
                                                       return !s.world->asleep(s.ball);
                                                   },
                                                   [&] { // a force
                                                       Sleeper s(who);
                                                       s.world->push(s.ball, at(1));
                                                       s.world->step();
                                                       return !s.world->asleep(s.ball) && s.world->v(s.ball)[0] > 0.01;
                                                   },
                                                   [&] { // gravity turns round
                                                       Sleeper s(who);
                                                       s.world->set_gravity(at(0, g));
                                                       s.world->steps(60);
                                                       return s.world->x(s.ball)[1] > 4;
                                                   }};
    int unnoticed = 0;
    for (const auto& way : woken) unnoticed += !way();
    return unnoticed;
}
double r12_pile(const Contestant& who) {
    Scene scene = sleepy();
    scene.rubs = true;
    scene.slow = 0;
    const auto world = who.make(scene);
    walls(*world, who, half_of(who, 1000, 1.25), 0, 0.3);
    Dice dice(3);
    std::vector<int> balls;
    for (const Vector& x : grid(who, 1000, 1.25, 1, 0.1, dice))
        balls.push_back(world->add(Ball{.x = x, .friction = 0.3}));
    for (int i = 1; i <= 3600; ++i) {
        world->step();
        if (std::all_of(balls.begin(), balls.end(), [&](int b) { return world->asleep(b); })) return i * frame;
    }
    return lost;
}
/// A ball that slides at 0.9 of the threshold: it goes on for ever or stops once. Told is how often it began anew, and
/// one more where it did neither.
double r13_creep(const Contestant& who) {
    const auto world = who.make(sleepy());
    world->plane(up, 0, 0, 0);
    const int ball = world->add(Ball{.x = at(0, 0.5), .v = at(0.045)});
    int begun = 0;
    bool asleep = false, ever = false;
    for (int i = 0; i < 3600; ++i) {
        world->step();
        begun += asleep && !world->asleep(ball);
        asleep = world->asleep(ball);
        ever = ever || asleep;
    }
    return begun + (!ever && !(std::abs(world->x(ball)[0] / 2.7 - 1) <= 0.01));
}

} // namespace peers
