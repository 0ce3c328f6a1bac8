// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Runners that remember what failed, and their files.

#include <ansatz/paths/goap.hpp>
#include <ansatz/paths/goap/memory.hpp>
#include <ansatz/paths/goap/save.hpp>

#include <sstream>
#include <string>

namespace lasting_plans_tests {

using namespace ansatz;

using Domain = goap::Domain<>;
using Planner = goap::Planner<Domain>;
using Runner = goap::Runner<Planner, goap::Remembers>;

struct Nobody {
    void begin(goap::Action) {}
    goap::Progress tick(goap::Action) { return goap::Progress::failed; }
};
template <class R> std::string saved(const R& runner, const goap::Performance& performance = {}) {
    std::ostringstream out;
    goap::save(runner, performance, out);
    return out.str();
}
template <class R> void load_text(R& runner, const std::string& text) {
    std::istringstream in(text);
    goap::Performance performance;
    Nobody nobody;
    goap::load(runner, performance, nobody, in, "plan.json");
}

} // namespace lasting_plans_tests
