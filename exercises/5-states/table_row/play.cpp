// SPDX-License-Identifier: BSL-1.0
// A turnstile on a busy morning: your table beside the library's, which is made while it is compiled.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/states.hpp>

#include <array>
#include <random>

using namespace ansatz;
using namespace ansatz::states;
using exercise::Gate;

namespace {

bool paid(const Gate& g) { return g.coins >= 1; }
void take(Gate& g) { ++g.coins; }
void use(Gate& g) { g.coins = 0; }
void pass(Gate& g) { ++g.passed; }
void give_back(Gate& g) { ++g.returned; }

struct Turnstile {
    using Context = Gate;
    static constexpr auto machine = states::machine(
        state("locked", transition(on("coin"), when(paid), then(use), to("unlocked")),
              transition(on("coin"), then(take))),
        state("unlocked", transition(on("push"), then(pass), to("locked")), transition(on("coin"), then(give_back))));
};
const exercise::Rows rows{
    {exercise::State::locked, exercise::Event::coin, paid, use, exercise::State::unlocked},
    {exercise::State::locked, exercise::Event::coin, nullptr, take, exercise::State::locked},
    {exercise::State::unlocked, exercise::Event::push, nullptr, pass, exercise::State::locked},
    {exercise::State::unlocked, exercise::Event::coin, nullptr, give_back, exercise::State::unlocked},
};

} // namespace

int main() {
    workbook::Play table("A turnstile takes 10000 coins and pushes in a random order.",
                         {"people", "coins given back", "coins kept"});
    table.timed("ns an event");
    std::mt19937 random(1);
    std::array<int, 10000> morning{};
    for (int& event : morning) event = int(random() % 2); // 0 is a coin, 1 a push

    Gate mine;
    auto state = exercise::State::locked;
    for (const int event : morning) state = exercise::handle(rows, state, exercise::Event(event), mine);
    table.row("yours", {double(mine.passed), double(mine.returned), double(mine.coins)}, 1, [=, i = 0]() mutable {
        state = exercise::handle(rows, state, exercise::Event(morning[std::size_t(i++ % 10000)]), mine);
    });

    Gate theirs;
    Machine<Turnstile, Table> machine;
    machine.start(theirs);
    const std::array<EventId, 2> events{machine.event("coin"), machine.event("push")};
    for (const int event : morning) machine.handle(theirs, events[std::size_t(event)]);
    table.row("library", {double(theirs.passed), double(theirs.returned), double(theirs.coins)}, 1,
              [=, i = 0]() mutable { machine.handle(theirs, events[std::size_t(morning[std::size_t(i++ % 10000)])]); });
    return table.print();
}
