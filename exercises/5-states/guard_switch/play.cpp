// SPDX-License-Identifier: BSL-1.0
// The evening of section 5.1 with your switch in it, beside the machine that the library makes of a description.

#include "play.hpp"
#include "guard_npc.hpp"
#include "subject.hpp"

using namespace guard;

namespace {

std::string_view name_of(exercise::State s) {
    constexpr std::string_view names[] = {"patrol", "search", "chase", "strike"};
    return names[std::size_t(s)];
}

/// The guard of the chapter, who asks your functions what to do.
class Yours {
public:
    void noise(Npc&) { go(exercise::heard(now_)); }
    void update(Npc& npc, Time dt) {
        in_state_ += dt;
        const auto before = now_;
        go(exercise::next(now_, npc.distance(),
                          in_state_ + 1e-9 * second)); // 180 steps of 1/60 s are 3 s, however they were summed
        if (now_ != before && now_ == exercise::State::strike) strike(npc);
        if (now_ == exercise::State::patrol) walk_.update(npc, dt);
        if (now_ == exercise::State::chase) npc.walk(npc.intruder, 2.0 * metre_per_second, dt);
    }
    std::string_view name() const { return name_of(now_); }

private:
    void go(exercise::State to) {
        if (to != now_) now_ = to, in_state_ = {};
    }
    exercise::State now_ = exercise::State::patrol;
    Time in_state_{};
    Walk walk_;
};

} // namespace

int main() {
    workbook::Play table("A guard's evening of 45 s, 60 updates a second.",
                         {"changes of state", "blows", "place at the end, m"});
    table.timed("ns an update");

    Npc npc;
    Yours guard;
    const Trace mine = evening(
        npc, [](Npc&) {}, [&](Npc& n) { guard.noise(n); }, [&](Npc& n, Time dt) { guard.update(n, dt); },
        [&] { return guard.name(); });
    table.row("yours", {double(mine.size()) - 1, double(npc.blows), npc.place.value()}, 1,
              [=]() mutable { guard.update(npc, 1.0 / 60 * second); });

    Npc other;
    Machine<GuardNpc, Switch> machine;
    const Trace theirs = evening(other, machine);
    table.row("library", {double(theirs.size()) - 1, double(other.blows), other.place.value()}, 1,
              [=]() mutable { machine.update(other, 1.0 / 60 * second); });
    print(mine);
    return table.print();
}
