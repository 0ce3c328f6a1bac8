// SPDX-License-Identifier: BSL-1.0
// 5.1.1 Hard coded switch: simple and fast, and every new condition is written once for each state

// "States are enumerated and transition conditions are checked based on the current state in a single conditional
// structure." Here it is, by hand: the whole guard on one screen. Beside it stands the switch that the library
// generates from the description; both live through the same evening. Then a fifth state is wanted, for which the guard
// must go home from wherever he is: in the switch by hand that is a line in every case, and whoever forgets one has a
// bug that no compiler sees.

#include "claims.hpp"
#include "guard_npc.hpp"
#include "say.hpp"

#include <iostream>

using namespace guard;

namespace {

//! [by hand]
/// The guard as a switch, written by hand.
class HandWritten {
public:
    enum class State { patrol, search, chase, strike };

    void start(Npc&) { state_ = State::patrol; }
    void noise(Npc&) {
        if (state_ == State::patrol) go(State::search);
    }
    void update(Npc& npc, Time dt) {
        in_state_ += dt;
        switch (state_) {
        case State::patrol:
            if (npc.distance() < 7.0 * metre) ++npc.shouts, go(State::chase);
            break;
        case State::search:
            if (npc.distance() < 7.0 * metre) ++npc.shouts, go(State::chase);
            else if (waited(3.0 * second)) go(State::patrol);
            break;
        case State::chase:
            if (npc.distance() < 1.0 * metre) strike(npc), go(State::strike);
            else if (npc.distance() > 9.0 * metre) go(State::search);
            break;
        case State::strike:
            if (waited(2.0 * second)) ++npc.shouts, go(State::chase);
            break;
        }
        if (state_ == State::patrol) walk_.update(npc, dt);
        if (state_ == State::chase) npc.walk(npc.intruder, 2.0 * metre_per_second, dt);
    }
    State state() const { return state_; }

private:
    void go(State to) { state_ = to, in_state_ = 0.0 * second; }
    bool waited(Time t) const {
        return in_state_ > t - 1e-9 * second;
    } // 180 steps of 1/60 s are 3 s, however their sum was rounded
    State state_ = State::patrol;
    Time in_state_{};
    Walk walk_;
};
//! [by hand]

constexpr std::string_view name(HandWritten::State s) {
    constexpr std::string_view names[] = {"patrol", "search", "chase", "strike"};
    return names[std::size_t(s)];
}

} // namespace

int main() {
    workbook::Claims claim;
    Npc of_hand, of_library;
    HandWritten by_hand;
    Machine<GuardNpc, Switch> generated;

    const Trace hand = evening(
        of_hand, [&](Npc& n) { by_hand.start(n); }, [&](Npc& n) { by_hand.noise(n); },
        [&](Npc& n, Time dt) { by_hand.update(n, dt); }, [&] { return name(by_hand.state()); });
    const Trace library = evening(of_library, generated);
    std::cout << hand.size() - 1 << " changes of state by hand, " << library.size() - 1
              << " by the library, the last to \"" << hand.back().state << "\"\n";
    claim("the switch by hand and the generated one have the same trace", hand == library);
    claim("and did the same", of_hand.place == of_library.place && of_hand.blows == of_library.blows &&
                                  of_hand.shouts == of_library.shouts);

    // Take the shout: by hand it stands at every door to chase, three times. In the description it is said once, in
    // chase.
    claim("every chase began with a shout, by hand too",
          of_hand.shouts ==
              int(std::count_if(hand.begin(), hand.end(), [](const Began& b) { return b.state == "chase"; })));
    workbook::say() << "Doors to chase, each of which must not forget the shout: 3 by hand, 1 in the description\n";
    return claim.result();
}
