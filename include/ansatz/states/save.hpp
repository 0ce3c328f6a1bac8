// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Machines that last: `save(machine, out)` and `load(machine, in)` write and read where a machine is, since when, and
/// all that its histories, guards, state classes and queue remember, as JSON. A machine that was loaded goes on as the
/// one that was saved; nothing is left or entered by loading.
///
/// Everything stands under its name. The file says which representation wrote it, in which version of the format, and
/// what the machine's description was: one for another representation or another description is refused with a sentence
/// that says where they differ, and a file that cannot be, such as two active states of which one excludes the other,
/// with its place. The machine is then as it was. For a description that was changed while the game runs there is
/// `reload`.
///
/// Transitions that were added while the machine ran (additions.hpp) are in the file by their names; the machine that
/// is loaded into has them already, or `load` is given the Bindings of those names.
///
/// Guards with a Memory of your own and state classes with data say what they consist of: `fields` (archive.hpp).
/// Options are not saved: what counts or watches goes on with what the machine has that is loaded into.
// not in the umbrella: it needs nlohmann-json

#include <ansatz/states/archive.hpp>
#include <ansatz/states/machine.hpp>
#include <ansatz/states/machine_archive.hpp>
#include <ansatz/states/outline.hpp>

#include <ansatz/world/file_value.hpp>
#include <ansatz/world/whole_file.hpp>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <ios>
#include <istream>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ansatz {

namespace states {
namespace detail {

using Json = ansatz::detail::Json;
using ansatz::detail::FileValue;

/// Writes fields into JSON.
class JsonWriter final : public Archive {
public:
    explicit JsonWriter(Json& root) : at_{&root} {}
    void flag(std::string_view name, bool& x) override { here(name) = x; }
    void number(std::string_view name, double& x) override { here(name) = ansatz::detail::number_to_file(x); }
    void whole(std::string_view name, std::int64_t& x, std::int64_t, std::int64_t) override { here(name) = x; }
    void natural(std::string_view name, std::uint64_t& x) override { here(name) = x; }
    void text(std::string_view name, std::string& x) override { here(name) = x; }
    void open(std::string_view name) override {
        auto& inside = here(name) = Json::object();
        at_.push_back(&inside);
    }
    void close() override { at_.pop_back(); }
    void count(std::string_view name, std::size_t& size) override { here(name) = size; }
    bool reads() const override { return false; }
    void refuse_here(std::string_view, const std::string&) const override { std::abort(); } // nothing was read

private:
    Json& here(std::string_view name) { return (*at_.back())[std::string(name)]; }
    std::vector<Json*> at_;
};

/// Reads fields from JSON.
class JsonReader final : public Archive {
public:
    explicit JsonReader(FileValue root) : at_{std::move(root)} {}
    void flag(std::string_view name, bool& x) override { x = here(name).yes(); }
    void number(std::string_view name, double& x) override {
        const auto value = here(name);
        if (value.json == "inf") x = std::numeric_limits<double>::infinity();
        else if (value.json == "-inf") x = -std::numeric_limits<double>::infinity();
        else if (value.json == "nan") x = std::numeric_limits<double>::quiet_NaN();
        else x = value.number<double>();
    }
    void whole(std::string_view name, std::int64_t& x, std::int64_t least, std::int64_t most) override {
        const auto value = here(name);
        x = value.integer<std::int64_t>();
        if (x < least || x > most)
            value.refuse_here("a whole number from " + std::to_string(least) + " to " + std::to_string(most));
    }
    void natural(std::string_view name, std::uint64_t& x) override {
        x = here(name).whole(std::numeric_limits<std::uint64_t>::max());
    }
    void text(std::string_view name, std::string& x) override {
        const auto value = here(name);
        if (!value.json.is_string()) value.refuse_here("a text");
        x = value.json.get<std::string>();
    }
    void open(std::string_view name) override { at_.push_back(here(name)); }
    void close() override { at_.pop_back(); }
    void count(std::string_view name, std::size_t& size) override {
        const auto value = here(name);
        // Each entry stands beside the count: room for more than the file has is never made.
        size = std::size_t(value.whole(at_.back().json.size() - 1));
    }
    bool reads() const override { return true; }
    void refuse_here(std::string_view name, const std::string& expected) const override {
        here(name).refuse_here(expected);
    }

private:
    FileValue here(std::string_view name) const { return at_.back().at(std::string(name).c_str()); }
    std::vector<FileValue> at_;
};

/// A machine's description in one number, and the names of its states.
struct Identity {
    std::uint64_t number = 14695981039346656037u; // FNV-1a
    std::vector<std::string> states;

    explicit Identity(const Outline& outline) {
        const auto contents = [&](const std::vector<Outline::Content>& all) {
            add(all.size());
            for (const auto& one : all) add(std::size_t(one.what)), add(one.name);
        };
        const auto names = [&](const std::vector<std::string>& all) {
            add(all.size());
            for (const auto& one : all) add(one);
        };
        for (const auto& s : outline.states) {
            states.push_back(s.name);
            add(s.name), add(std::size_t(s.kind)), add(s.parent), add(s.behaviour);
            if (s.childless) add(std::size_t(1) << 32);
            names(s.initial), contents(s.initial_content), contents(s.entry), contents(s.exit), contents(s.each);
        }
        for (const auto& t : outline.transitions) {
            if (t.added) continue; // that is no part of the description
            add(t.source), add(t.events), add(t.guard), add(std::size_t(t.internal));
            names(t.targets), contents(t.content);
        }
    }
    std::string text() const {
        std::string digits;
        for (int i = 60; i >= 0; i -= 4) digits += "0123456789abcdef"[number >> i & 15];
        return digits;
    }

private:
    void add(std::size_t n) {
        for (int i = 0; i < 64; i += 8) number = (number ^ (std::uint64_t(n) >> i & 255)) * 1099511628211u;
    }
    void add(const std::string& text) {
        add(text.size());
        for (const char c : text) number = (number ^ std::uint64_t(static_cast<unsigned char>(c))) * 1099511628211u;
    }
};

/// What was added to a machine while it ran, as a file has it; of others nothing.
inline Json additions_to_file(const Outline& outline) {
    Json all = Json::array();
    std::size_t place = 0;
    for (std::size_t t = 0; t < outline.transitions.size(); ++t) {
        const auto& from = outline.transitions[t];
        place = t > 0 && outline.transitions[t - 1].source == from.source ? place + 1 : 0;
        if (!from.added) continue;
        Json content = Json::array();
        for (const auto& one : from.content) content.push_back({one.what, one.name});
        all.push_back({{"state", outline.states[from.source].name},
                       {"place", place},
                       {"events", from.events},
                       {"guard", from.guard},
                       {"targets", from.targets},
                       {"internal", from.internal},
                       {"content", content}});
    }
    return all;
}
inline std::vector<MachineArchive::Addition> additions_from_file(const FileValue& all, const Outline& outline) {
    const auto text = [](const FileValue& value) {
        if (!value.json.is_string()) value.refuse_here("a text");
        return value.json.get<std::string>();
    };
    std::vector<std::size_t> count(outline.states.size(), 0);
    for (const auto& t : outline.transitions) count[t.source] += t.added ? 0 : 1;
    std::vector<MachineArchive::Addition> found;
    for (std::size_t i = 0; i < all.size("transitions"); ++i) {
        const auto from = all.at(i);
        Outline::Transition to;
        const auto state = text(from.at("state"));
        while (to.source < outline.states.size() && outline.states[to.source].name != state) ++to.source;
        if (to.source == outline.states.size()) from.at("state").refuse_here("the name of a state of the machine");
        const auto place = std::size_t(from.at("place").whole(count[to.source]++));
        to.added = true;
        to.events = text(from.at("events")), to.guard = text(from.at("guard"));
        to.internal = from.at("internal").yes();
        const auto targets = from.at("targets"), content = from.at("content");
        for (std::size_t k = 0; k < targets.size("names"); ++k) to.targets.push_back(text(targets.at(k)));
        for (std::size_t k = 0; k < content.size("things that are done"); ++k) {
            content.at(k).size_is(2, "parts, what is done and its name");
            to.content.push_back(
                {Outline::Content::What(content.at(k).at(std::size_t(0)).whole(2)), text(content.at(k).at(1)), 0});
        }
        found.emplace_back(std::move(to), place);
    }
    return found;
}

/// A file as text. Texts that are no UTF-8 come from the program, and the sentence is to say from where in it.
inline std::string text_of(const Json& file, const std::vector<std::string>& states) {
    try {
        return file.dump(1) + '\n';
    } catch (const Json::type_error&) {
        using How = Json::error_handler_t;
        for (const auto& state : states) {
            const auto legible = Json(state).dump(-1, ' ', false, How::replace);
            if (legible != Json(state).dump(-1, ' ', false, How::ignore))
                refuse(Refusal::invalid_argument,
                       "save: the name of the state " + legible + " is not UTF-8, and a file holds UTF-8 text");
        }
        refuse(Refusal::invalid_argument,
               "save: a text that the machine remembers is not UTF-8, and a file holds UTF-8 text");
    }
}
inline Json parsed(std::istream& in, const std::string& name) {
    try {
        auto file = ansatz::detail::parse_file(in, false);
        if (file.is_discarded())
            refuse(Refusal::invalid_argument, name + ": it is no JSON; expected a machine that was saved");
        return file;
    } catch (const std::ios_base::failure&) { // a directory can be opened, and fails when it is read
        refuse(Refusal::invalid_argument, name + " cannot be read; is it a file?");
    }
}

} // namespace detail

/// What `save` takes.
template <class T> inline constexpr bool is_machine = false;
/// A machine of the compile-time representations.
template <class D, class R, class... O> inline constexpr bool is_machine<StaticMachine<D, R, O...>> = true;
/// An interpreted one.
template <class D, class C, class... O> inline constexpr bool is_machine<InterpretedMachine<D, C, O...>> = true;
/// Whether a machine can be added to while it runs.
template <class T> inline constexpr bool is_interpreted = false;
/// An interpreted one can.
template <class D, class C, class... O> inline constexpr bool is_interpreted<InterpretedMachine<D, C, O...>> = true;

} // namespace states

namespace states::detail {
/// All of it, so that nothing is written of a machine that is refused.
template <class Machine> std::string saved_text(const Machine& machine) {
    if (MachineArchive::busy(machine))
        refuse(Refusal::invalid_argument, "save: called from an action of the machine; save between two updates");
    const Identity identity(MachineArchive::outline(machine));
    Json file;
    file["machine"] = MachineArchive::version;
    file["representation"] = MachineArchive::representation(machine);
    file["description"] = identity.text();
    file["states"] = identity.states;
    if (auto added = additions_to_file(MachineArchive::outline(machine)); !added.empty())
        file["added"] = std::move(added);
    JsonWriter writer(file);
    Machine copy(machine); // a copy, because fields() takes a machine that may be changed: reading and writing share it
    MachineArchive::fields(copy, writer);
    return text_of(file, identity.states);
}
} // namespace states::detail

/// Writes where a machine is and what it remembers.
/// \throws std::invalid_argument from within an action of the machine, for a name or a text that is no UTF-8, and, for
///         Interpreted, where a guard or a state class does not say what it consists of; nothing is written
template <class Machine>
    requires states::is_machine<Machine>
void save(const Machine& machine, std::ostream& out) {
    out << states::detail::saved_text(machine);
}
namespace states::detail {
/// \param names  what the names of transitions stand for that were added while the machine ran; null: nothing
template <class Machine, class Names>
void load_machine(Machine& machine, std::istream& in, const std::string& name, const Names* names) {
    if (MachineArchive::busy(machine))
        refuse(Refusal::invalid_argument, "load: called from an action of the machine; load between two updates");
    const Json file = parsed(in, name);
    const FileValue root{file, name, true};
    root.at("machine").is(MachineArchive::version, ", the version of the format that this library reads");
    root.at("representation")
        .is(std::string(MachineArchive::representation(machine)), ", the representation of the machine that is loaded");
    const Outline& outline = MachineArchive::outline(machine);
    const Identity identity(outline);
    const auto there = root.at("states");
    for (std::size_t s = 0; s < std::max(there.size("names"), identity.states.size()); ++s) {
        const bool here = s < identity.states.size(), saved = s < there.json.size();
        if (here && saved && there.json[s] == identity.states[s]) continue;
        if (saved && !there.json[s].is_string()) there.at(s).refuse_here("the name of a state");
        refuse(Refusal::invalid_argument, name + ": the description of the machine has changed: state " +
                                              std::to_string(s) + " is " + (here ? shown(identity.states[s]) : "none") +
                                              ", and was " + (saved ? there.json[s].dump() : "none") +
                                              " when the file was saved");
    }
    if (root.at("description").json != identity.text())
        refuse(Refusal::invalid_argument, name +
                                              ": the description of the machine has changed: its states have the same "
                                              "names, and their parts, transitions, guards or actions are others than "
                                              "when the file was saved");
    Machine next = MachineArchive::fresh(machine);
    if constexpr (is_interpreted<Machine>) {
        std::vector<MachineArchive::Addition> added;
        if (file.contains("added")) added = additions_from_file(root.at("added"), outline);
        MachineArchive::set_additions(next, added, names, name);
    }
    JsonReader reader(root);
    MachineArchive::fields(next, reader);
    machine = std::move(next);
}
} // namespace states::detail

/// Puts a machine where the one was that was saved.
/// \param name of the file, for its sentences
/// \throws std::invalid_argument for a file of another representation, version or description, or one that cannot be; the
///         machine is as it was
template <class Machine>
    requires states::is_machine<Machine>
void load(Machine& machine, std::istream& in, const std::string& name = "load") {
    states::detail::load_machine(machine, in, name, static_cast<const Bindings<typename Machine::Context>*>(nullptr));
}
/// The same of an Interpreted machine to which transitions were added: the machine has those of the file afterwards.
/// \param names  what their guards and actions stand for, where this machine has none of that name
/// \throws std::invalid_argument for a name that nobody bound, too
template <class Machine>
    requires states::is_interpreted<Machine>
void load(Machine& machine, std::istream& in, const Bindings<typename Machine::Context>& names,
          const std::string& name = "load") {
    states::detail::load_machine(machine, in, name, &names);
}
/// The same into a file, whole or not at all: it is written beside the file, as `path`.part, which then takes its
/// place.
/// \throws std::invalid_argument where it cannot be written, too; what was there before is there as it was
template <class Machine>
    requires states::is_machine<Machine>
void save(const Machine& machine, const std::string& path) {
    ansatz::detail::write_whole_file(path, states::detail::saved_text(machine));
}
/// The same from a file.
/// \throws std::invalid_argument for one that cannot be opened or read, too
template <class Machine>
    requires states::is_machine<Machine>
void load(Machine& machine, const std::string& path) {
    std::ifstream in(path);
    if (!in) refuse(Refusal::invalid_argument, "load: " + path + " cannot be opened");
    load(machine, in, path);
}
/// The same.
template <class Machine>
    requires states::is_interpreted<Machine>
void load(Machine& machine, const std::string& path, const Bindings<typename Machine::Context>& names) {
    std::ifstream in(path);
    if (!in) refuse(Refusal::invalid_argument, "load: " + path + " cannot be opened");
    load(machine, in, names, path);
}

} // namespace ansatz
