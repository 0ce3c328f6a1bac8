// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise: its guards `band` and `after`.
#include <ansatz/states.hpp>

namespace exercise {

using Length = ansatz::Quantity<ansatz::unit::Length>;
using Time = ansatz::Quantity<ansatz::unit::Time>;

struct Seen {
    Length value;
};
inline bool above_after(bool above, Length value, Length threshold, Length half_width) {
    Seen seen{value};
    const ansatz::states::Question<Seen, ansatz::states::NoBehaviour> question{seen, {}, {}, {}};
    const auto band = ansatz::states::band(ansatz::states::value("value", &Seen::value), threshold, half_width);
    return above ? !band.below().ask(question, {}) : band.above().ask(question, {});
}

class Dwelling {
public:
    explicit Dwelling(Time dwell) : guard_(ansatz::states::after(dwell)) {}

    bool update(bool wants_to_turn, Time dt) {
        in_state_ += dt;
        struct Nothing {
        } nothing;
        const ansatz::states::NoBehaviour own;
        const bool turned =
            wants_to_turn &&
            guard_.ask(ansatz::states::Question<Nothing, ansatz::states::NoBehaviour>{nothing, own, in_state_, dt}, {});
        if (turned) in_state_ = {}; // as a machine does when it enters a state
        return turned;
    }

private:
    ansatz::states::After guard_;
    Time in_state_{};
};

} // namespace exercise
