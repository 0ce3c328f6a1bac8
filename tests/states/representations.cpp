// SPDX-License-Identifier: BSL-1.0
// The same events lead to the same trace: the interpreter against an oracle that knows nothing of how it works.
// Runs long with the sanitizers.

#include <ansatz/states/chart.hpp>
#include <ansatz/states/interpreted.hpp>

#include "tests/rounds.hpp"
#include "tests/states/oracle.hpp"

#include <random>

using namespace states_tests;

namespace {

// ---------------------------------------------------------------- random machines
Outline random_outline(std::mt19937& random) {
    auto pick = [&](std::size_t n) { return std::size_t(random() % n); };
    Outline o;
    o.origin = "random";
    o.states.emplace_back();
    const std::size_t wanted = 2 + pick(9);
    // Depth first: each new state stands in one of the states on the way from the last to the root.
    for (std::size_t s = 1; s <= wanted; ++s) {
        std::size_t parent = s - 1;
        while (parent != 0 && (pick(2) == 0 || o.states[parent].kind == Kind::final)) parent = o.states[parent].parent;
        Outline::State state;
        state.name = std::string("s") + std::to_string(s);
        state.parent = parent;
        if (pick(8) == 0) state.kind = Kind::final;
        o.states.push_back(state);
    }
    auto inside = [&](std::size_t s) {
        std::vector<std::size_t> found;
        for (std::size_t d = s + 1; d < o.states.size(); ++d)
            for (std::size_t up = d; up != 0; up = o.states[up].parent)
                if (o.states[up].parent == s) {
                    found.push_back(d);
                    break;
                }
        return found;
    };
    for (std::size_t s = 0; s <= wanted; ++s)
        if (const auto in = inside(s); !in.empty() && pick(3) == 0)
            o.states[s].initial = {o.states[in[pick(in.size())]].name};
    // A history at the end of a state.
    if (const std::size_t s = 1 + pick(wanted); !inside(s).empty()) {
        const auto in = inside(s);
        Outline::State history;
        history.name = "h";
        history.kind = pick(2) ? Kind::deep_history : Kind::shallow_history;
        history.parent = s;
        history.initial = {o.states[in[pick(in.size())]].name};
        const std::size_t at = in.back() + 1;
        for (auto& state : o.states)
            if (state.parent >= at) ++state.parent;
        o.states.insert(o.states.begin() + std::ptrdiff_t(at), history);
    }
    for (std::size_t s = 1; s < o.states.size(); ++s) {
        if (o.states[s].kind != Kind::state) continue;
        for (auto n = pick(4); n-- > 0;) {
            static const char* const events[] = {
                "a", "b", "c", "a b", "b.*", "*", "c.d", "done.state.s1", "done.state.s2"};
            Outline::Transition t;
            t.source = s;
            if (pick(4)) t.events = events[pick(9)];
            if (t.events.empty() ? pick(12) != 0 : pick(2) != 0) t.guard = std::string(1, char('A' + pick(6)));
            if (pick(8) || t.events.empty()) t.targets = {o.states[1 + pick(o.states.size() - 1)].name};
            t.internal = pick(4) == 0;
            o.transitions.push_back(t);
        }
    }
    return o;
}
Bindings<Bits> names() {
    Bindings<Bits> n;
    for (int i = 0; i < 6; ++i)
        n.guard(std::string(1, char('A' + i)), [i](const Bits& b) { return (b.bits >> i & 1) != 0; });
    return n;
}
// The same machine as one part of a parallel state, beside one that does nothing.
Outline beside(const Outline& o) {
    Outline wrapped = o;
    wrapped.states.clear();
    wrapped.states.resize(3);
    wrapped.states[1].name = "P", wrapped.states[1].kind = Kind::parallel;
    wrapped.states[2] = o.states[0], wrapped.states[2].name = "R", wrapped.states[2].parent = 1;
    for (std::size_t s = 1; s < o.states.size(); ++s) {
        wrapped.states.push_back(o.states[s]);
        wrapped.states.back().parent += 2;
    }
    wrapped.states.emplace_back();
    wrapped.states.back().name = "Q", wrapped.states.back().parent = 1;
    for (auto& t : wrapped.transitions) t.source += 2;
    return wrapped;
}

} // namespace

TEST_CASE("ten thousand random machines do what an oracle says", "[states]") {
    std::mt19937 random(2024);
    const auto bound = names();
    std::size_t transitions = 0, restored = 0;
    constexpr int machines = test::rounds(10000);
    for (int machine_number = 0; machine_number < machines; ++machine_number) {
        const auto outline = random_outline(random);
        Bits bits{unsigned(random())};
        Oracle oracle{outline, bits};
        Machine<InFile<Bits>, Interpreted, Everything> machine{make_chart(outline, bound), Everything{}};
        Machine<InFile<Bits>, Interpreted, Everything> part{make_chart(beside(outline), bound), Everything{}};
        oracle.start();
        machine.start(bits);
        part.start(bits);
        for (int i = 0; i < 12; ++i) {
            bits.bits = unsigned(random());
            if (random() % 3 == 0) {
                oracle.update();
                machine.update(bits, frame);
                part.update(bits, frame);
            } else {
                const char* event = inputs[random() % 8];
                oracle.handle(event);
                machine.handle(bits, event);
                part.handle(bits, event);
            }
        }
        const auto trace = without_numbers(text(machine));
        if (trace != oracle.trace)
            FAIL("machine " << machine_number << "\n"
                            << write_scxml(outline) << "\noracle: " << oracle.trace << "\nansatz: " << trace);
        // Beside another part: the same, but for three states entered at the start; and its own root tells when it is
        // done.
        auto beside_trace = without_numbers(text(part));
        for (const char* extra : {"+P ", "+R ", " +Q", " ?"})
            for (auto at = beside_trace.find(extra); at != std::string::npos; at = beside_trace.find(extra))
                beside_trace.erase(at, std::string(extra).size());
        auto plain = trace;
        for (auto at = plain.find(" ?"); at != std::string::npos; at = plain.find(" ?")) plain.erase(at, 2);
        if (beside_trace != plain)
            FAIL("machine " << machine_number << "\n"
                            << write_scxml(outline) << "\nalone:  " << plain << "\nbeside: " << beside_trace);
        transitions += std::size_t(std::count(trace.begin(), trace.end(), '*'));
        restored += outline.states.size() && oracle.remembered.size() ? 1 : 0;
    }
    CHECK(transitions > std::size_t(test::at_least(30000))); // they move
    CHECK(restored > std::size_t(test::at_least(200)));      // and histories remember
}
