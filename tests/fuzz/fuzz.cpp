// SPDX-License-Identifier: BSL-1.0
// Compiled alone: it replaces operator new.
// Random scenes in the compositions of this build, for a while (docs/contributing.md, "The fuzzer of worlds").
// Runs long with the sanitizers.

#include "tests/catch.hpp"
#include "tests/fuzz/hunt.hpp"
#include "tests/operator_new.hpp"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>

namespace {

/// A number from the environment.
double asked(const char* name, double otherwise) {
    const char* const text = std::getenv(name);
    return text == nullptr || *text == 0 ? otherwise : std::strtod(text, nullptr);
}

} // namespace

TEST_CASE("random scenes keep every law in every composition", "[fuzz]") {
    const auto& all = fuzz::compositions();
    if (all.empty()) SKIP("no compositions were drawn: -DANSATZ_FUZZ_COMPOSITIONS=24");
    const double seconds = asked("ANSATZ_FUZZ_SECONDS", 60) / double(all.size());
    const auto seed = std::uint64_t(asked("ANSATZ_FUZZ_SEED", 1));
    const int only = int(asked("ANSATZ_FUZZ_COMPOSITION", -1));
    for (const auto& [number, subject] : all) {
        if (only >= 0 && number != only) continue;
        const auto hunt = fuzz::hunt(*subject, seed, seconds);
        std::cout << "fuzz: composition " << number << ", seed " << seed << ": " << hunt.scenes << " scenes in World{"
                  << subject->facts().text << "}\n";
        CHECK(hunt.scenes > 0);
        if (hunt.found)
            FAIL_CHECK(hunt.found->law << ". Again: ANSATZ_FUZZ_COMPOSITION=" << number
                                       << " ANSATZ_FUZZ_SEED=" << hunt.found->seed << "; as a test:\n\n"
                                       << "#include \"tests/fuzz/pasted.hpp\"\n\n"
                                       << hunt.found->program);
    }
    const auto& j = fuzz::judged;
    std::cout << "fuzz: judged " << j.steps << " steps, " << j.refusals << " refusals, " << j.copies << " copies, "
              << j.loads << " files, " << j.taken_back << " steps taken back, " << j.contacts << " pairs, "
              << j.sleepers << " sleepers, " << j.momentum << " times the momentum, " << j.energy
              << " times the energy, " << j.without_memory << " verbs that found no memory\n";
    // A law that was never asked has held nothing.
    const auto some = [&](auto can) {
        return std::any_of(all.begin(), all.end(), [&](const auto& one) { return can(one.second->facts()); });
    };
    if (only >= 0) return;
    for (const auto count : {j.steps, j.refusals, j.copies, j.loads, j.taken_back, j.without_memory}) CHECK(count > 0);
    CHECK((j.contacts > 0) == some([](const fuzz::Facts& f) { return f.collides && f.stays; }));
    CHECK((j.sleepers > 0) == some([](const fuzz::Facts& f) { return f.settles && f.rests; }));
    CHECK((j.momentum > 0) == some([](const fuzz::Facts& f) { return f.closed; }));
    CHECK((j.energy > 0) == some([](const fuzz::Facts& f) { return f.keeps_energy; }));
}
