// SPDX-License-Identifier: BSL-1.0
#pragma once

// What the tests of states share: a watcher that keeps everything, and the trace as text.

#include <ansatz/states.hpp>

#include "tests/catch.hpp"
#include "tests/refusal.hpp"

#include <string>
#include <vector>

namespace states_tests {

using namespace ansatz;
using namespace ansatz::states;
using ansatz::test::refusal;
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;

/// Keeps everything that happens.
struct Everything {
    std::vector<Happening> all;
    [[gnu::noinline]] void operator()(const Happening& h) { all.push_back(h); }
};

/// "-a -b *3 +c": left a and b, took transition 3, entered c; "?2" is an event that nobody handled.
inline std::string text(const auto& machine) {
    std::string out;
    using What = Happening::What;
    for (const auto& h : machine.template get<Everything>().all) {
        if (!out.empty()) out += ' ';
        switch (h.what) {
        case What::exited: out += "-" + std::string(machine.name(h.state)); break;
        case What::entered: out += "+" + std::string(machine.name(h.state)); break;
        case What::took: out += "*" + std::to_string(index(h.transition)); break;
        case What::unhandled: out += "?" + std::to_string(index(h.event)); break;
        }
    }
    return out;
}
inline std::string text_since(auto& machine) {
    auto out = text(machine);
    machine.template get<Everything>().all.clear();
    return out;
}

/// Calls f with each representation.
template <class F> void each_representation(F&& f) {
    f.template operator()<Switch>();
    f.template operator()<StatePattern>();
    f.template operator()<Table>();
    f.template operator()<Interpreted>();
}

constexpr auto frame = 1.0 / 60 * second;

} // namespace states_tests
