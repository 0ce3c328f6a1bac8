// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Plans that last: `save(runner, performance, out)` and `load(runner, performance, performer, in)` write and read a
/// plan that is being performed, as JSON: the goal, the actions, how far they are done, which one is begun, and what
/// failed. A runner that was loaded goes on as the one that was saved: it does not plan anew, and begins nothing twice.
///
/// ```
/// goap::save(runner, performance, plan);      save(machine, body);      // whoever performs is saved by its own means
/// goap::load(runner, performance, crew, plan); load(machine, body);
/// ```
/// Facts and actions stand under their names, and the file says what each action needed, made and cost: a plan of
/// another domain is refused with a sentence that says where they differ, and so is a file that cannot be, such as a
/// plan that does not lead to its goal. The runner is then as it was. The planner, its policies and the runner's
/// `attempts` or `Remembers` are not in the file; they are the program's.
// not in the umbrella: it needs nlohmann-json

#include <ansatz/paths/goap/perform.hpp>
#include <ansatz/world/file_value.hpp>
#include <ansatz/world/whole_file.hpp>

#include <array>
#include <fstream>
#include <ios>
#include <istream>
#include <ostream>

namespace ansatz::goap {

namespace detail {

using Json = ansatz::detail::Json;
using ansatz::detail::FileValue;

/// Facts by their names, held or not.
template <std::size_t W> Json to_file(const Domain<W>& domain, const Condition<W>& c) {
    Json facts = Json::object();
    for (std::size_t f = 0; f < domain.facts(); ++f)
        if (c.care.has(f)) facts[domain.name_of(Fact{f})] = c.value.has(f);
    return facts;
}
template <std::size_t W> Json to_file(const Domain<W>& domain, const State<W>& s) {
    Json facts = Json::array();
    for (std::size_t f = 0; f < domain.facts(); ++f)
        if (s.has(f)) facts.push_back(domain.name_of(Fact{f}));
    return facts;
}
template <std::size_t W> Json to_file(const Domain<W>& domain) {
    Json file, facts = Json::array(), actions = Json::array();
    for (std::size_t f = 0; f < domain.facts(); ++f) facts.push_back(domain.name_of(Fact{f}));
    for (Action a = 0; a < domain.actions(); ++a) {
        const auto& rule = domain.rules()[a];
        actions.push_back({{"name", domain.name_of(a)},
                           {"needs", to_file(domain, rule.needs)},
                           {"makes", to_file(domain, rule.makes)},
                           {"cost", rule.cost}});
    }
    file["facts"] = facts, file["actions"] = actions;
    return file;
}

/// A file as text. Names that are no UTF-8 come from the program, and the sentence is to say which.
template <std::size_t W> std::string text_of(const Json& file, const Domain<W>& domain) {
    try {
        return file.dump(1) + '\n';
    } catch (const Json::type_error&) {
        using How = Json::error_handler_t;
        const auto require = [](const char* what, const std::string& name) {
            const auto legible = Json(name).dump(-1, ' ', false, How::replace);
            if (legible != Json(name).dump(-1, ' ', false, How::ignore))
                refuse(Refusal::invalid_argument, "goap::save: the name of the " + std::string(what) + " " + legible +
                                                      " is not UTF-8, and a file holds UTF-8 text");
        };
        for (std::size_t f = 0; f < domain.facts(); ++f) require("fact", domain.name_of(Fact{f}));
        for (Action a = 0; a < domain.actions(); ++a) require("action", domain.name_of(a));
        throw; // there is no other text in it
    }
}
inline Json parsed(std::istream& in, const std::string& name) {
    try {
        auto file = ansatz::detail::parse_file(in, false);
        if (file.is_discarded())
            refuse(Refusal::invalid_argument, name + ": it is no JSON; expected a plan that was saved");
        return file;
    } catch (const std::ios_base::failure&) { // a directory can be opened, and fails when it is read
        refuse(Refusal::invalid_argument, name + " cannot be read; is it a file?");
    }
}

/// Reads names of a domain from a file.
template <std::size_t W> struct NamesFromFile {
    const Domain<W>& domain;

    std::size_t fact(const FileValue& value, const std::string& name) const {
        for (std::size_t f = 0; f < domain.facts(); ++f)
            if (domain.name_of(Fact{f}) == name) return f;
        value.refuse_here("names of facts of the domain; \"" + name + "\" is none");
    }
    Action action(const FileValue& value) const {
        for (Action a = 0; a < domain.actions(); ++a)
            if (value.json == domain.name_of(a)) return a;
        value.refuse_here("the name of an action of the domain");
    }
    Condition<W> condition(const FileValue& value) const {
        if (!value.json.is_object()) value.refuse_here("facts that are true or false");
        Condition<W> c;
        for (const auto& [name, holds] : value.json.items()) {
            const std::size_t f = fact(value, name);
            c.care.set(f, true), c.value.set(f, value.at(name.c_str()).yes());
        }
        return c;
    }
    State<W> state(const FileValue& value) const {
        State<W> s;
        for (std::size_t i = 0; i < value.size("names of facts"); ++i) {
            const auto name = value.at(i);
            if (!name.json.is_string()) name.refuse_here("the name of a fact");
            s.set(fact(name, name.json.get<std::string>()), true);
        }
        return s;
    }
    /// Refuses a file whose domain was another, and says where.
    void same(const FileValue& root) const {
        const Json here = to_file(domain);
        const auto there = root.at("domain");
        // What nests deeply is named, not shown: a file of a hundred thousand brackets must not be followed down. The
        // program's own names may be no UTF-8.
        const auto legible = [](const Json& value) {
            if (FileValue::deeper_than(value, 4)) return std::string(value.is_array() ? "a list" : "an object");
            return value.dump(-1, ' ', false, Json::error_handler_t::replace);
        };
        const auto differs = [&](const std::string& what, const Json& now, const Json& was) {
            refuse(Refusal::invalid_argument, root.place + ": the domain has changed: " + what + " is " + legible(now) +
                                                  ", and was " + legible(was) + " when the plan was saved");
        };
        const auto facts = there.at("facts"), actions = there.at("actions");
        const auto number = [](std::size_t i) { return std::to_string(i); };
        for (std::size_t f = 0; f < std::max(facts.size("names of facts"), here["facts"].size()); ++f) {
            const Json none = "none";
            const Json& now = f < domain.facts() ? here["facts"][f] : none;
            const Json& was = f < facts.json.size() ? facts.json[f] : none; // no copy, which would follow it down
            if (now != was) differs("fact " + number(f), now, was);
        }
        for (std::size_t a = 0; a < std::max(actions.size("actions"), here["actions"].size()); ++a) {
            const Json now = a < domain.actions() ? here["actions"][a] : Json{{"name", "none"}};
            if (a >= actions.json.size()) differs("action " + number(a), now["name"], "none");
            const auto was = actions.at(a);
            if (now["name"] != was.at("name").json) differs("action " + number(a), now["name"], was.at("name").json);
            for (const char* part : {"needs", "makes", "cost"})
                if (now[part] != was.at(part).json)
                    differs("what \"" + domain.name_of(a) + "\" " + (part == std::string("cost") ? "costs" : part),
                            now[part], was.at(part).json);
        }
    }
};

template <std::size_t W> NamesFromFile(const Domain<W>&) -> NamesFromFile<W>;

} // namespace detail

/// What a runner consists of, for `save` and `load`; a friend of it.
struct RunnerArchive {
    static constexpr std::uint64_t version = 1; ///< of the format
    /// How a planning can have ended.
    static constexpr std::array outcomes{Outcome::not_begun, Outcome::found,   Outcome::no_path,   Outcome::gave_up,
                                         Outcome::blocked,   Outcome::too_far, Outcome::bad_weight};

    /// All of it.
    template <class P, class M> static detail::Json to_file(const Runner<P, M>& r, const Performance& performance) {
        const auto& domain = r.planner_->domain();
        const auto names = [&](std::span<const Action> actions) {
            auto all = detail::Json::array();
            for (const Action a : actions) all.push_back(domain.name_of(a));
            return all;
        };
        detail::Json file;
        file["plan"] = version;
        file["domain"] = detail::to_file(domain);
        file["goal"] = detail::to_file(domain, r.goal_);
        file["from"] = detail::to_file(domain, r.from_);
        file["actions"] = names(r.actions_);
        file["done"] = r.at_;
        file["outcome"] = paths::name_of(r.outcome_);
        file["answer"] = paths::name_of(r.answer_);
        file["answered"] = r.is_answered(r.from_);
        file["plans"] = r.plans_, file["searches"] = r.searches_, file["failures"] = r.failures_;
        file["begun"] = performance.begun ? detail::Json(domain.name_of(*performance.begun)) : detail::Json(nullptr);
        if constexpr (Runner<P, M>::remembers) {
            auto all = detail::Json::array();
            const auto& records = r.memory_.records();
            for (Action a = 0; a < records.size(); ++a)
                if (records[a] != detail::Failures::Record{})
                    all.push_back({{"action", domain.name_of(a)},
                                   {"failures", records[a].failures},
                                   {"pause", ansatz::detail::number_to_file(records[a].pause.value())},
                                   {"until", ansatz::detail::number_to_file(records[a].until.value())},
                                   {"out", records[a].out}});
            file["memory"] = {{"time", r.memory_.now().value()}, {"failed", all}};
        }
        return file;
    }
    /// The same as text.
    template <class P, class M> static std::string text(const Runner<P, M>& r, const Performance& performance) {
        return detail::text_of(to_file(r, performance), r.planner_->domain());
    }
    /// Reads all of it into a copy.
    template <class P, class M>
    static void from_file(Runner<P, M>& r, Performance& performance, const detail::FileValue& root) {
        root.at("plan").is(version, ", the version of the format that this library reads");
        const auto& domain = r.planner_->domain();
        const detail::NamesFromFile names{domain};
        names.same(root);
        r.goal_ = names.condition(root.at("goal")), r.from_ = names.state(root.at("from"));
        r.actions_.clear();
        const auto actions = root.at("actions");
        for (std::size_t i = 0; i < actions.size("names of actions"); ++i)
            r.actions_.push_back(names.action(actions.at(i)));
        r.at_ = std::size_t(root.at("done").whole(r.actions_.size()));
        r.outcome_ = outcome(root.at("outcome")), r.answer_ = outcome(root.at("answer"));
        constexpr std::uint64_t most = std::numeric_limits<std::size_t>::max();
        r.plans_ = root.at("plans").whole(most), r.searches_ = root.at("searches").whole(most);
        r.failures_ = root.at("failures").whole(most);
        const auto begun = root.at("begun");
        performance.begun = begun.json.is_null() ? std::nullopt : std::optional(names.action(begun));
        memory(r, names, root);
        const bool answered = root.at("answered").yes();
        r.version_ = answered ? domain.version() : std::numeric_limits<std::size_t>::max();
        r.left_out_version_ = r.memory_version();
        possible(r, root, answered);
    }

private:
    static Outcome outcome(const detail::FileValue& value) {
        std::string all;
        for (const auto one : outcomes) {
            if (value.json == paths::name_of(one)) return one;
            all += (all.empty() ? "\"" : ", \"") + std::string(paths::name_of(one)) + "\"";
        }
        value.refuse_here("one of " + all);
    }
    static Quantity<unit::Time> time(const detail::FileValue& value) {
        const double s = value.json == "inf" ? std::numeric_limits<double>::infinity() : value.number<double>();
        if (s < 0) value.refuse_here("a time that is not negative, s");
        return Quantity<unit::Time>::from_value(s);
    }
    template <class P, class M> static void memory(Runner<P, M>& r, const auto& names, const detail::FileValue& root) {
        if constexpr (Runner<P, M>::remembers) {
            const auto kept = root.at("memory"), failed = kept.at("failed");
            std::vector<detail::Failures::Record> records;
            for (std::size_t i = 0; i < failed.size("actions that failed"); ++i) {
                const auto one = failed.at(i);
                const Action a = names.action(one.at("action"));
                if (records.size() <= a) records.resize(a + 1);
                records[a] = {one.at("failures").whole(std::numeric_limits<std::uint64_t>::max()),
                              time(one.at("pause")), time(one.at("until")), one.at("out").yes()};
            }
            r.memory_.set(std::move(records), time(kept.at("time")));
        } else if (root.json.contains("memory"))
            refuse(Refusal::invalid_argument,
                   root.place + ": the plan was saved of a runner that remembers what failed; load it into one, "
                                "goap::Runner{planner, goap::Remembers{}}");
    }
    // What is left of a plan that was found leads from where it was planned to the goal, unless the domain is another.
    template <class P, class M>
    static void possible(const Runner<P, M>& r, const detail::FileValue& root, bool answered) {
        if (r.outcome_ == Outcome::found && r.answer_ != Outcome::found && r.at_ < r.actions_.size())
            root.at("answer").refuse_here("\"found\", since there is a plan");
        if (r.outcome_ != Outcome::found && r.at_ < r.actions_.size())
            root.at("done").refuse_here(std::to_string(r.actions_.size()) +
                                        ", the number of actions: nothing is to be done");
        if (!answered || r.answer_ != Outcome::found) return;
        auto s = r.from_;
        for (const Action a : r.actions_) {
            const auto& rule = r.planner_->domain().rules()[a];
            if (!rule.needs.holds_in(s))
                root.at("actions").refuse_here("actions that can be done one after the other; \"" +
                                               r.planner_->domain().name_of(a) + "\" cannot");
            s = rule.after(s);
        }
        if (!r.goal_.holds_in(s)) root.at("actions").refuse_here("actions that lead to the goal");
    }
};

/// Writes a plan that is being performed.
/// \throws std::invalid_argument for a name of the domain that is no UTF-8; nothing is written
template <class Planner, class Memory>
void save(const Runner<Planner, Memory>& runner, const Performance& performance, std::ostream& out) {
    out << RunnerArchive::text(runner, performance);
}
/// The same into a file, whole or not at all: it is written beside the file, as `path`.part, which then takes its
/// place.
/// \throws std::invalid_argument where it cannot be written, too; what was there before is there as it was
template <class Planner, class Memory>
void save(const Runner<Planner, Memory>& runner, const Performance& performance, const std::string& path) {
    ansatz::detail::write_whole_file(path, RunnerArchive::text(runner, performance));
}
/// Puts a runner where the one was that was saved.
/// \param performer what goes on with the action that is begun; one with `resume(action)`, such as ByMachine, is told
/// \param name      of the file, for its sentences
/// \throws std::invalid_argument for a file of another version, of another domain or of a runner with a memory where
///         this one has none, or the other way about, and for one that cannot be; everything is as it was
template <class Planner, class Memory, Performer P>
void load(Runner<Planner, Memory>& runner, Performance& performance, P& performer, std::istream& in,
          const std::string& name = "goap::load") {
    const auto file = detail::parsed(in, name);
    auto next = runner;
    Performance going;
    RunnerArchive::from_file(next, going, detail::FileValue{file, name, true});
    if constexpr (requires { performer.resume(Action{}); })
        if (going.begun) performer.resume(*going.begun);
    runner = std::move(next);
    performance = going;
}
/// The same from a file.
/// \throws std::invalid_argument for one that cannot be opened or read, too
template <class Planner, class Memory, Performer P>
void load(Runner<Planner, Memory>& runner, Performance& performance, P& performer, const std::string& path) {
    std::ifstream in(path);
    if (!in) refuse(Refusal::invalid_argument, "goap::load: " + path + " cannot be opened");
    load(runner, performance, performer, in, path);
}

} // namespace ansatz::goap
