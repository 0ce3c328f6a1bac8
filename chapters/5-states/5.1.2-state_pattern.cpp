// SPDX-License-Identifier: BSL-1.0
// 5.1.2 Hard coded state pattern: each state is a class and manages its own behaviour and data

// "All states are child classes of a base class State, each state class is responsible for managing its own behaviour
// and state." The large conditional structure is gone: what belongs to a state stands in its class, also its data. The
// price is a virtual call. By hand, and by the library, which derives a class for each state of the description. There
// a state's behaviour is any struct with enter, update or exit; it need not derive from anything, and works in every
// representation.

#include "claims.hpp"
#include "guard_npc.hpp"

#include <iostream>
#include <memory>

using namespace guard;

namespace {

//! [by hand]
/// The base class of all states, written by hand.
class State {
public:
    virtual ~State() = default;
    virtual std::string_view name() const = 0;
    virtual void enter(Npc&) {}
    virtual State* noise(Npc&) { return this; } ///< the next state
    virtual State* decide(Npc&) = 0;            ///< the next state
    virtual void behave(Npc&, Time) {}
    Time age{}; ///< since it was entered

protected:
    bool waited(Time t) const {
        return age > t - 1e-9 * second;
    } // 180 steps of 1/60 s are 3 s, however their sum was rounded
};

struct States; // all of them, so that each can name the next
struct Patrol final : State {
    States& all;
    Walk walk; // nobody else sees this
    explicit Patrol(States& s) : all(s) {}
    std::string_view name() const override { return "patrol"; }
    State* noise(Npc&) override;
    State* decide(Npc&) override;
    void behave(Npc& npc, Time dt) override { walk.update(npc, dt); }
};
//! [by hand]
struct Search final : State {
    States& all;
    explicit Search(States& s) : all(s) {}
    std::string_view name() const override { return "search"; }
    State* decide(Npc&) override;
};
struct ChaseState final : State {
    States& all;
    Chase chase;
    explicit ChaseState(States& s) : all(s) {}
    std::string_view name() const override { return "chase"; }
    void enter(Npc& npc) override { chase.enter(npc); }
    State* decide(Npc&) override;
    void behave(Npc& npc, Time dt) override { chase.update(npc, dt); }
};
struct Strike final : State {
    States& all;
    explicit Strike(States& s) : all(s) {}
    std::string_view name() const override { return "strike"; }
    void enter(Npc& npc) override { strike(npc); }
    State* decide(Npc&) override;
};
struct States {
    Patrol patrol{*this};
    Search search{*this};
    ChaseState chase{*this};
    Strike strike{*this};
    States() = default;
    States(const States&) = delete; // its states refer to it
};
//! [decide]
State* Patrol::noise(Npc&) { return &all.search; }
State* Patrol::decide(Npc& npc) {
    if (npc.distance() < 7.0 * metre) return &all.chase;
    return this;
}
//! [decide]
State* Search::decide(Npc& npc) {
    if (npc.distance() < 7.0 * metre) return &all.chase;
    if (waited(3.0 * second)) return &all.patrol;
    return this;
}
State* ChaseState::decide(Npc& npc) {
    if (npc.distance() < 1.0 * metre) return &all.strike;
    if (npc.distance() > 9.0 * metre) return &all.search;
    return this;
}
State* Strike::decide(Npc&) {
    if (waited(2.0 * second)) return &all.chase;
    return this;
}

/// The machine around them.
class HandWritten {
public:
    void noise(Npc& npc) { go(npc, now_->noise(npc)); }
    void update(Npc& npc, Time dt) {
        now_->age += dt;
        go(npc, now_->decide(npc));
        now_->behave(npc, dt);
    }
    std::string_view name() const { return now_->name(); }
    const States& states() const { return all_; }

private:
    void go(Npc& npc, State* next) {
        if (next == now_) return;
        now_ = next;
        now_->age = {};
        now_->enter(npc);
    }
    States all_;
    State* now_ = &all_.patrol;
};

} // namespace

int main() {
    workbook::Claims claim;
    Npc of_hand, of_library;
    HandWritten by_hand;
    Machine<GuardNpc, StatePattern> generated;

    const Trace hand = evening(
        of_hand, [](Npc&) {}, [&](Npc& n) { by_hand.noise(n); }, [&](Npc& n, Time dt) { by_hand.update(n, dt); },
        [&] { return by_hand.name(); });
    const Trace library = evening(of_library, generated);
    std::cout << hand.size() - 1 << " changes of state by hand, " << library.size() - 1 << " by the library\n";
    claim("the classes by hand and the generated ones have the same trace", hand == library);
    claim("and did the same", of_hand.place == of_library.place && of_hand.blows == of_library.blows &&
                                  of_hand.shouts == of_library.shouts);

    // A state's data outlives its being left: after the chase the guard goes on to the post that he was going to.
    //! [own]
    const Walk& walk = generated.own<Walk>(generated.state("patrol"));
    //! [own]
    std::cout << "The state patrol remembers: next post at " << walk.post << ", " << walk.legs << " legs walked\n";
    claim("each class kept the data of its own state",
          walk.legs == by_hand.states().patrol.walk.legs && walk.post == by_hand.states().patrol.walk.post);

    // A machine by hand refers to itself, so that it cannot simply be copied. That of the library is a value.
    claim("the machine by hand is no value", !std::is_copy_constructible_v<HandWritten>);
    auto snapshot = generated;
    Npc elsewhere = of_library;
    for (int i = 0; i < 600; ++i) snapshot.update(elsewhere, 1.0 / 60 * second);
    claim("a copy of the other walks on by itself",
          snapshot.own<Walk>(snapshot.state("patrol")).legs > walk.legs && elsewhere.place != of_library.place);
    return claim.result();
}
