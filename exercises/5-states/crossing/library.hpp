// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise: its guard `crosses`, asked outside a machine.
#include <ansatz/states.hpp>

namespace exercise {

using Length = ansatz::Quantity<ansatz::unit::Length>;

class CrossingGuard {
public:
    explicit CrossingGuard(Length limit)
        : guard_(ansatz::states::crosses(ansatz::states::value("place", &Seen::place), limit)) {}

    bool update(Length now) {
        Seen seen{now};
        const ansatz::states::Question<Seen, ansatz::states::NoBehaviour> question{seen, nothing_, {}, {}};
        if (begun_) guard_.sample(memory_, question);
        else guard_.begin(memory_, question);
        begun_ = true;
        return guard_.ask(question, memory_);
    }

private:
    struct Seen {
        Length place;
    };
    using Guard = decltype(ansatz::states::crosses(ansatz::states::value("place", &Seen::place), Length{}));
    Guard guard_;
    Guard::Memory memory_{};
    bool begun_ = false;
    static constexpr ansatz::states::NoBehaviour nothing_{};
};

inline bool crossed(Length before, Length now, Length limit) {
    CrossingGuard guard(limit);
    guard.update(before);
    return guard.update(now);
}

} // namespace exercise
