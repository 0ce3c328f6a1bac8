// SPDX-License-Identifier: BSL-1.0
// The door of section 5.2.1 with your guard at it, beside the library's.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/states.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;
using namespace ansatz::states;

namespace {

using Corridor = World<SemiImplicitEuler>;
struct Scene {
    Corridor world{SemiImplicitEuler{}};
    Handle walker{};
    explicit Scene(double speed) : walker(world.add(velocity(metres_per_second(speed, 0, 0)))) {}
    auto place() const { return x(world.position(walker)); }
};
struct Door {
    using Context = Scene;
    static constexpr auto machine = states::machine(
        state("waiting", transition(when(crosses(value("place", &Scene::place), 5.0 * metre)), to("alarm"))),
        final_state("alarm"));
};

/// For how many of a hundred walkers `alarm(scene)`, asked at every update, answers yes at least once.
int seen(auto&& new_guard) {
    int n = 0;
    for (int i = 1; i <= 100; ++i) {
        Scene scene(0.07 * i);
        auto alarm = new_guard(scene);
        bool rang = false;
        while (scene.place() < 10.0 * metre) {
            scene.world.step(0.1 * second);
            rang = alarm(scene) || rang;
        }
        n += rang;
    }
    return n;
}

} // namespace

int main() {
    workbook::Play table("A hundred people walk past a door at 5 m, with 0.07 m/s to 7 m/s and ten updates a second.",
                         {"seen"});
    table.timed("ns an update");

    const int mine = seen([](const Scene& scene) {
        exercise::CrossingGuard guard(5.0 * metre);
        guard.update(scene.place());
        return [guard](const Scene& s) mutable { return guard.update(s.place()); };
    });
    const int theirs = seen([](Scene& scene) {
        Machine<Door> machine;
        machine.start(scene);
        return [machine](Scene& s) mutable { return machine.update(s); };
    });
    const int equality = seen([](const Scene&) { return [](const Scene& s) { return s.place() == 5.0 * metre; }; });

    Scene scene(1);
    exercise::CrossingGuard guard(5.0 * metre);
    volatile bool sink = false;
    table.row("yours", {double(mine)}, 1, [=, &sink]() mutable { sink = guard.update(scene.place()); });
    Machine<Door> machine;
    machine.start(scene);
    table.row("library", {double(theirs)}, 1, [=, &sink]() mutable { sink = machine.update(scene); });
    table.row("equality", {double(equality)}, 1, [=, &sink]() mutable { sink = scene.place() == 5.0 * metre; });
    return table.print();
}
