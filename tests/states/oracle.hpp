// SPDX-License-Identifier: BSL-1.0
#pragma once

// What a machine must do, written once more and differently: names, sets and recursion, no tables and no numbers.

#include "tests/states/support.hpp"

#include <map>
#include <sstream>

namespace states_tests {

struct Bits {
    unsigned bits = 0;
};

// ---------------------------------------------------------------- the oracle: an outline, names, sets and recursion
struct Oracle {
    const Outline& o;
    const Bits& bits;
    std::vector<std::size_t> path{}; // active states, from the root on
    std::map<std::size_t, std::vector<std::size_t>> remembered{};
    std::string trace{};
    std::vector<std::string> events{};

    std::size_t find(const std::string& name) const {
        for (std::size_t s = 1; s < o.states.size(); ++s)
            if (o.states[s].name == name) return s;
        throw std::logic_error("oracle: " + name);
    }
    std::vector<std::size_t> line(std::size_t s) const { // from the root to s
        std::vector<std::size_t> up{s};
        while (up.back() != 0) up.push_back(o.states[up.back()].parent);
        return {up.rbegin(), up.rend()};
    }
    void say(const std::string& what) { trace += (trace.empty() ? "" : " ") + what; }
    void enter(std::size_t s) {
        path.push_back(s);
        say("+" + o.states[s].name);
        if (o.states[s].kind == Kind::final && o.states[s].parent != 0)
            events.push_back("done.state." + o.states[o.states[s].parent].name);
    }
    void go(std::size_t target) { // the path is above the target already
        const auto way = line(target);
        for (std::size_t i = path.size(); i < way.size(); ++i) {
            if (is_history(o.states[way[i]].kind)) {
                const auto kept = remembered.find(way[i]);
                if (kept != remembered.end() && kept->second.empty()) return; // its parent was active alone
                go(kept == remembered.end()                      ? find(o.states[way[i]].initial.at(0))
                   : o.states[way[i]].kind == Kind::deep_history ? kept->second.back()
                                                                 : kept->second.front());
                return;
            }
            enter(way[i]);
        }
        if (o.states[target].childless) return;
        if (!o.states[target].initial.empty()) return go(find(o.states[target].initial[0]));
        for (std::size_t s = target + 1; s < o.states.size(); ++s)
            if (o.states[s].parent == target && !is_history(o.states[s].kind)) return go(s);
    }
    void start() {
        path = {0};
        go(0);
        settle();
    }
    bool guard(const Outline::Transition& t) const {
        return t.guard.empty() || (bits.bits >> (t.guard[0] - 'A') & 1) != 0;
    }
    // what: an event's name, "?" for conditions, "!" for transitions without either
    bool step(const std::string& what) {
        for (std::size_t i = path.size(); i-- > 0;)
            for (std::size_t t = 0; t < o.transitions.size(); ++t) {
                const auto& it = o.transitions[t];
                if (it.source != path[i]) continue;
                const bool meant = it.events.empty() ? what == (it.guard.empty() ? "!" : "?") : takes(it.events, what);
                if (!meant || !guard(it)) continue;
                take(it, t);
                return true;
            }
        return false;
    }
    static bool takes(const std::string& events, const std::string& what) {
        if (what == "?" || what == "!") return false;
        std::istringstream words(events);
        for (std::string one; words >> one;) {
            if (one == "*" || one == what) return true;
            if (one.size() > 2 && one.substr(one.size() - 2) == ".*") one.resize(one.size() - 2);
            if (one == what || what.rfind(one + ".", 0) == 0) return true;
        }
        return false;
    }
    void take(const Outline::Transition& it, std::size_t number) {
        if (it.targets.empty()) return say("*" + std::to_string(number));
        const auto source = line(it.source), target = line(find(it.targets[0]));
        std::size_t common = 0; // how many states of the path stay
        while (common < source.size() && common < target.size() && source[common] == target[common]) ++common;
        const bool target_inside = common == source.size() && target.size() > source.size();
        if (!(it.internal && target_inside) && common == source.size()) --common;
        if (common == target.size()) --common;
        common = std::max<std::size_t>(common, 1); // the machine itself is never left
        for (auto s = path.size(); s-- > common;)
            for (std::size_t h = 1; h < o.states.size(); ++h)
                if (is_history(o.states[h].kind) && o.states[h].parent == path[s])
                    remembered[h] = {path.begin() + std::ptrdiff_t(s) + 1, path.end()};
        while (path.size() > common) {
            say("-" + o.states[path.back()].name);
            path.pop_back();
        }
        say("*" + std::to_string(number));
        go(target.back());
    }
    void settle() {
        for (int n = 0; n < 1000; ++n) {
            if (step("!")) continue;
            if (events.empty()) return;
            const auto next = events.front();
            events.erase(events.begin());
            if (!step(next)) say("?");
        }
        events.clear();
    }
    void handle(const std::string& event) {
        if (step(event)) settle();
        else say("?");
    }
    void update() {
        if (step("?")) settle();
    }
};

inline std::string without_numbers(std::string trace) { // of events that nobody handled
    for (std::size_t at = trace.find('?'); at != std::string::npos; at = trace.find('?', at + 1))
        while (at + 1 < trace.size() && std::isdigit(static_cast<unsigned char>(trace[at + 1]))) trace.erase(at + 1, 1);
    return trace;
}

inline constexpr const char* inputs[] = {"a", "b", "c", "b.x", "c.d", "c.d.e", "z", "ab"};

} // namespace states_tests
