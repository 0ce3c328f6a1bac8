// SPDX-License-Identifier: BSL-1.0
// A machine that runs on your three functions, beside the library's: the same random conditions, the same states.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/states.hpp>

#include <array>
#include <random>

using namespace ansatz;
using namespace ansatz::states;

namespace {

/// Which reasons there are at an update.
struct Reasons {
    bool tired = false, sees = false, lost = false, hurt = false, healed = false;
    int entries = 0; ///< of on duty, which both count
};
struct GuardNpc {
    using Context = Reasons;
    static constexpr auto machine = states::machine(
        state("on duty", on_entry([](Reasons& r) { ++r.entries; }),
              transition(when([](const Reasons& r) { return r.hurt; }), to("flee")),
              state("patrol", transition(when([](const Reasons& r) { return r.sees; }), to("combat")),
                    state("walk", transition(when([](const Reasons& r) { return r.tired; }), to("look"))),
                    state("look", transition(when([](const Reasons& r) { return r.tired; }), to("walk")))),
              state("combat", transition(when([](const Reasons& r) { return r.lost; }), to("patrol")))),
        state("flee", transition(when([](const Reasons& r) { return r.healed; }), to("on duty"))));
};

/// The same machine by your functions; the numbers of its states are those of the description.
class Yours {
public:
    enum : int { machine, on_duty, patrol, walk, look, combat, flee };
    void update(Reasons& r) {
        const std::vector<exercise::Transition> transitions{{on_duty, r.hurt}, {patrol, r.sees}, {walk, r.tired},
                                                            {look, r.tired},   {combat, r.lost}, {flee, r.healed}};
        const int taken = exercise::taken(parents_, now_, transitions);
        if (taken < 0) return;
        const int target = targets_[std::size_t(taken)];
        for (const int s : exercise::way(parents_, now_, target).entered) r.entries += s == on_duty;
        now_ = begin_[std::size_t(target)];
    }
    int now() const { return now_; }

private:
    exercise::Parents parents_{-1, machine, on_duty, patrol, patrol, on_duty, machine};
    std::array<int, 6> targets_{flee, combat, look, walk, patrol, on_duty};
    std::array<int, 7> begin_{walk, walk, walk, walk, look, combat, flee}; // the innermost state in which each begins
    int now_ = walk;
};

} // namespace

int main() {
    workbook::Play table("A guard with three behaviours, and 10000 updates with random reasons.",
                         {"same state", "entries of on duty"});
    table.timed("ns an update");
    std::mt19937 random(3);
    Yours guard;
    Reasons mine, theirs;
    mine.entries = 1; // it begins there
    Machine<GuardNpc> machine;
    machine.start(theirs);
    int same = 0;
    for (int i = 0; i < 10000; ++i) {
        for (bool Reasons::*reason :
             {&Reasons::tired, &Reasons::sees, &Reasons::lost, &Reasons::hurt, &Reasons::healed})
            mine.*reason = theirs.*reason = random() % 3 == 0;
        guard.update(mine);
        machine.update(theirs);
        same += guard.now() == int(index(machine.active()));
    }
    table.row("yours", {double(same), double(mine.entries)}, 1, [=]() mutable { guard.update(mine); });
    table.row("library", {10000, double(theirs.entries)}, 1, [=]() mutable { machine.update(theirs); });
    return table.print();
}
