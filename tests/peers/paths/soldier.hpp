// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The soldier, the domain that planners for games are usually shown on, and a straightforward planner for it: states
/// as bits, an open and a closed array, both searched from end to end, the number of unmet facts as the estimate.

#include <ansatz/paths/goap.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace peers {

struct Soldier {
    ansatz::goap::Domain<> domain;
    ansatz::goap::State<> start;
    ansatz::goap::Condition<> goal;
    Soldier() {
        auto fact = [&](const char* name) { return domain.fact(name); };
        const auto enemy = fact("enemy visible"), gun = fact("armed with gun"), loaded = fact("weapon loaded"),
                   aimed = fact("enemy lined up"), foe = fact("enemy alive"), bomb = fact("armed with bomb"),
                   near = fact("near enemy"), alive = fact("alive");
        domain.action("scout", 1).needs(gun).makes(enemy);
        domain.action("approach", 1).needs(enemy).makes(near);
        domain.action("aim", 1).needs(enemy, loaded).makes(aimed);
        domain.action("shoot", 1).needs(aimed).makes(!foe);
        domain.action("load", 1).needs(gun).makes(loaded);
        domain.action("detonate bomb", 5).needs(bomb, near).makes(!alive, !foe);
        domain.action("flee", 1).needs(enemy).makes(!near);
        start = domain.state({gun, foe, bomb, alive});
        goal = domain.condition({!foe, alive});
    }
};

class LinearPlanner {
    struct Node {
        std::uint64_t state, parent;
        int g, h, action;
        int f() const { return g + h; }
    };

public:
    struct Rule {
        std::uint64_t needs, needs_care, makes, makes_care;
        int cost;
    };
    explicit LinearPlanner(const ansatz::goap::Domain<>& domain) {
        for (const auto& r : domain.rules())
            rules_.push_back({r.needs.value.bits[0], r.needs.care.bits[0], r.makes.value.bits[0], r.makes.care.bits[0],
                              int(r.cost)});
    }
    int plan(std::uint64_t start, std::uint64_t goal, std::uint64_t care) {
        auto unmet = [&](std::uint64_t s) { return std::popcount((s ^ goal) & care); };
        open_.clear(), closed_.clear(), actions_.clear();
        open_.push_back({start, start, 0, unmet(start), -1});
        while (!open_.empty()) {
            std::size_t least = 0;
            for (std::size_t i = 1; i < open_.size(); ++i)
                if (open_[i].f() < open_[least].f()) least = i;
            const Node p = open_[least];
            open_[least] = open_.back();
            open_.pop_back();
            if ((p.state & care) == goal) {
                for (Node at = p; at.action >= 0; at = closed_[find(closed_, at.parent)])
                    actions_.insert(actions_.begin(), at.action);
                return p.g;
            }
            closed_.push_back(p);
            for (std::size_t a = 0; a < rules_.size(); ++a) {
                const Rule& r = rules_[a];
                if ((p.state & r.needs_care) != r.needs) continue;
                const Node q{(p.state & ~r.makes_care) | r.makes, p.state, p.g + r.cost, 0, int(a)};
                const std::size_t in_open = find(open_, q.state), in_closed = find(closed_, q.state);
                if (in_closed < closed_.size()) {
                    if (closed_[in_closed].g <= q.g) continue;
                    closed_[in_closed] = closed_.back();
                    closed_.pop_back();
                }
                if (in_open < open_.size()) {
                    if (open_[in_open].g <= q.g) continue;
                    open_[in_open].g = q.g, open_[in_open].parent = q.parent, open_[in_open].action = q.action;
                    continue;
                }
                open_.push_back(q);
                open_.back().h = unmet(q.state);
            }
        }
        return -1;
    }
    std::size_t expanded() const { return closed_.size(); }
    const std::vector<int>& actions() const { return actions_; }

private:
    static std::size_t find(const std::vector<Node>& nodes, std::uint64_t state) {
        std::size_t i = 0;
        while (i < nodes.size() && nodes[i].state != state) ++i;
        return i;
    }
    std::vector<Rule> rules_;
    std::vector<Node> open_, closed_;
    std::vector<int> actions_;
};

} // namespace peers
