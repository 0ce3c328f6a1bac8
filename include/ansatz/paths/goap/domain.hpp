// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Domain`: what there is to know and to do: facts by name, actions with preconditions, effects and costs (notes 6.2).
///
/// ```
/// goap::Domain<> tea;
/// const auto water = tea.fact("has water"), hot = tea.fact("water is hot"), cup = tea.fact("has tea");
/// tea.action("fetch water", 2).makes(water, !hot);
/// tea.action("boil", 3).needs(water).makes(hot);
/// tea.action("brew", 1).needs(hot).makes(cup, !water, !hot);
/// ```
/// An action is an edge from every state in which all that it needs holds, to the same state with what it makes.

#include <ansatz/core/error.hpp>
#include <ansatz/paths/goap/state.hpp>
#include <ansatz/units/describe.hpp>

#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace ansatz::goap {

/// A fact, or with `!` that it does not hold.
struct Fact {
    std::size_t number = 0; ///< in its domain, from 0
    bool holds = true;      ///< or, turned round by `!`, that it does not
    /// The opposite.
    friend constexpr Fact operator!(Fact f) { return {f.number, !f.holds}; }
    friend constexpr bool operator==(Fact a, Fact b) { return a.number == b.number && a.holds == b.holds; }
};

/// An action's number in its domain, from 0 in the order in which they were added.
using Action = std::size_t;

/// Facts and actions.
/// \tparam Words how many times 64 facts there may be
template <std::size_t Words = 1> class Domain {
public:
    static constexpr std::size_t most_facts = 64 * Words; ///< how many facts there may be
    using State = goap::State<Words>;                     ///< which facts hold
    using Condition = goap::Condition<Words>;             ///< which facts should

    /// What an action does to the states.
    struct Rule {
        Condition needs; ///< holds before
        Condition makes; ///< holds after
        double cost = 1; ///< of doing it, not negative
        /// What a state becomes by it.
        State after(const State& s) const { return (s & ~makes.care) | makes.value; }
    };

    /// Adds conditions to an action: `domain.action("boil", 3).needs(water, !full).makes(hot)`.
    class Building {
    public:
        /// To add to this action.
        Building(Domain& domain, Action action) : domain_(&domain), action_(action) {}
        /// \throws std::invalid_argument, and adds none of them, for a fact of another domain, and for one that is
        ///         needed both ways
        template <class... Facts> Building& needs(Facts... facts) {
            domain_->put(action_, "needs", domain_->rules_[action_].needs, {facts...});
            return *this;
        }
        /// \throws std::invalid_argument, and adds none of them, for a fact of another domain, and for one that is made
        ///         both ways
        template <class... Facts> Building& makes(Facts... facts) {
            domain_->put(action_, "makes", domain_->rules_[action_].makes, {facts...});
            return *this;
        }
        /// The action itself.
        // NOLINTNEXTLINE(google-explicit-constructor): the sentence ends in an action
        operator Action() const { return action_; }

    private:
        Domain* domain_;
        Action action_;
    };

    /// The fact of this name; a name that is new makes a new fact.
    /// \throws std::invalid_argument for an empty name, and when there are no more bits
    Fact fact(std::string_view name) {
        if (name.empty()) refuse_value("goap::Domain::fact", "the name", "empty", "a fact has a name");
        for (std::size_t i = 0; i < facts_.size(); ++i)
            if (facts_[i] == name) return {i, true};
        if (facts_.size() == most_facts)
            refuse_value("goap::Domain::fact", "\"" + std::string(name) + "\"", "one fact too many",
                         "there is room for " + std::to_string(most_facts) + "; take Domain<" +
                             std::to_string(Words + 1) + ">");
        facts_.emplace_back(name);
        return {facts_.size() - 1, true};
    }
    /// A new action, which needs nothing and makes nothing yet.
    /// \param cost finite and not negative
    /// \throws std::invalid_argument for another cost, and for a name that there is already
    Building action(std::string_view name, double cost = 1) {
        if (!std::isfinite(cost) || cost < 0)
            refuse_value("goap::Domain::action", "the cost of \"" + std::string(name) + "\"", cost,
                         "it must be finite and not negative");
        for (const auto& other : names_)
            if (other == name)
                refuse_value("goap::Domain::action", "\"" + std::string(name) + "\"", "there already",
                             "an action has a name of its own");
        names_.emplace_back(name);
        rules_.push_back({{}, {}, cost});
        ++version_;
        return {*this, rules_.size() - 1};
    }
    /// \throws std::invalid_argument, and changes nothing, unless the cost is finite and not negative
    void set_cost(Action a, double cost) {
        require(a);
        if (!std::isfinite(cost) || cost < 0)
            refuse_value("goap::Domain::set_cost", "the cost of \"" + names_[a] + "\"", cost,
                         "it must be finite and not negative");
        rules_[a].cost = cost;
        ++version_;
    }

    /// The state in which these facts hold and no others.
    State state(std::initializer_list<Fact> facts) const {
        State s;
        for (const Fact f : facts) {
            require(f);
            s.set(f.number, f.holds);
        }
        return s;
    }
    /// What is wanted: these facts, held or not as they are given; the others do not matter.
    /// \throws std::invalid_argument for a fact that is wanted both ways
    Condition condition(std::initializer_list<Fact> facts) const {
        Condition c;
        for (const Fact f : facts) {
            require(f);
            if (!add(c, f))
                refuse_value("goap::Domain::condition", "\"" + facts_[f.number] + "\"", "wanted both ways",
                             "leave one out");
        }
        return c;
    }

    const std::vector<Rule>& rules() const { return rules_; } ///< one for each action
    std::size_t facts() const { return facts_.size(); }       ///< how many
    std::size_t actions() const { return rules_.size(); }     ///< how many
    std::size_t version() const { return version_; }          ///< grows with every change of an action
    /// The name of an action.
    const std::string& name_of(Action a) const { return names_[a]; }
    /// The name of a fact, the same for its opposite.
    const std::string& name_of(Fact f) const { return facts_[f.number]; }
    std::string words(const State& s) const { ///< the facts that hold, "{has water, has tea}"
        std::string text = "{";
        for (std::size_t i = 0; i < facts_.size(); ++i)
            if (s.has(i)) text += (text.size() > 1 ? ", " : "") + facts_[i];
        return text + "}";
    }

private:
    static bool add(Condition& c, Fact f) {
        if (c.care.has(f.number) && c.value.has(f.number) != f.holds) return false;
        c.care.set(f.number, true);
        c.value.set(f.number, f.holds);
        return true;
    }
    void put(Action a, const char* verb, Condition& c, std::initializer_list<Fact> facts) {
        Condition more = c; // all of them or none
        for (const Fact f : facts) {
            require(f);
            if (!add(more, f))
                refuse_value("goap::Domain::action", "\"" + facts_[f.number] + "\"", "given both ways",
                             "\"" + names_[a] + "\" " + verb + " it or its opposite, not both");
        }
        c = more;
        version_ += facts.size();
    }
    void require(Fact f) const {
        if (f.number >= facts_.size())
            refuse_value("goap::Domain", "the fact", std::to_string(f.number),
                         "this domain has " + std::to_string(facts_.size()) + ", made by fact(name)");
    }
    void require(Action a) const {
        if (a >= rules_.size())
            refuse_value("goap::Domain", "the action", std::to_string(a),
                         "this domain has " + std::to_string(rules_.size()) + ", made by action(name, cost)");
    }
    std::vector<std::string> facts_, names_;
    std::vector<Rule> rules_;
    std::size_t version_ = 0;
};

} // namespace ansatz::goap
