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
/// Guards with a Memory of your own and state classes with data say what they consist of: `fields` (archive.hpp).
/// Options are not saved: what counts or watches goes on with what the machine has that is loaded into.
// not in the umbrella: it needs nlohmann-json

#include <ansatz/states/archive.hpp>
#include <ansatz/states/machine.hpp>
#include <ansatz/states/machine_archive.hpp>
#include <ansatz/states/outline.hpp>

#include <ansatz/world/file_value.hpp>

#include <cmath>
#include <cstdint>
#include <fstream>
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
    void count(std::string_view name, std::size_t& size) override { size = std::size_t(here(name).whole(1u << 24)); }
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
            names(s.initial), contents(s.initial_content), contents(s.entry), contents(s.exit), contents(s.each);
        }
        for (const auto& t : outline.transitions) {
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

} // namespace detail

/// What `save` takes.
template <class T> inline constexpr bool is_machine = false;
/// A machine of the compile-time representations.
template <class D, class R, class... O> inline constexpr bool is_machine<StaticMachine<D, R, O...>> = true;
/// An interpreted one.
template <class D, class C, class... O> inline constexpr bool is_machine<InterpretedMachine<D, C, O...>> = true;

} // namespace states

/// Writes where a machine is and what it remembers.
/// \throws std::invalid_argument from within an action of the machine, and, for Interpreted, where a guard or a state class
///         does not say what it consists of; nothing is written
template <class Machine>
    requires states::is_machine<Machine>
void save(const Machine& machine, std::ostream& out) {
    using states::MachineArchive;
    if (MachineArchive::busy(machine))
        refuse(Refusal::invalid_argument, "save: called from an action of the machine; save between two updates");
    const states::detail::Identity identity(MachineArchive::outline(machine));
    states::detail::Json file;
    file["machine"] = MachineArchive::version;
    file["representation"] = MachineArchive::representation(machine);
    file["description"] = identity.text();
    file["states"] = identity.states;
    states::detail::JsonWriter writer(file);
    Machine copy(machine); // a copy, because fields() takes a machine that may be changed: reading and writing share it
    MachineArchive::fields(copy, writer);
    out << file.dump(1) << '\n';
}
/// Puts a machine where the one was that was saved.
/// \param name of the file, for its sentences
/// \throws std::invalid_argument for a file of another representation, version or description, or one that cannot be; the
///         machine is as it was
template <class Machine>
    requires states::is_machine<Machine>
void load(Machine& machine, std::istream& in, const std::string& name = "load") {
    using states::MachineArchive;
    using states::detail::Json;
    if (MachineArchive::busy(machine))
        refuse(Refusal::invalid_argument, "load: called from an action of the machine; load between two updates");
    const Json file = Json::parse(in, nullptr, false);
    if (file.is_discarded())
        refuse(Refusal::invalid_argument, name + ": it is no JSON; expected a machine that was saved");
    const states::detail::FileValue root{file, name, true};
    root.at("machine").is(MachineArchive::version, ", the version of the format that this library reads");
    root.at("representation")
        .is(std::string(MachineArchive::representation(machine)), ", the representation of the machine that is loaded");
    const states::detail::Identity identity(MachineArchive::outline(machine));
    const auto there = root.at("states");
    for (std::size_t s = 0; s < std::max(there.size("names"), identity.states.size()); ++s) {
        const bool here = s < identity.states.size(), saved = s < there.json.size();
        if (here && saved && there.json[s] == identity.states[s]) continue;
        refuse(Refusal::invalid_argument,
               name + ": the description of the machine has changed: state " + std::to_string(s) + " is " +
                   (here ? states::detail::shown(identity.states[s]) : "none") + ", and was " +
                   (saved ? there.json[s].dump() : "none") + " when the file was saved");
    }
    if (root.at("description").json != identity.text())
        refuse(Refusal::invalid_argument, name +
                                              ": the description of the machine has changed: its states have the same "
                                              "names, and their parts, transitions, guards or actions are others than "
                                              "when the file was saved");
    Machine next = MachineArchive::fresh(machine);
    states::detail::JsonReader reader(root);
    MachineArchive::fields(next, reader);
    machine = std::move(next);
}
/// The same into a file.
/// \throws std::invalid_argument where it cannot be written, too
template <class Machine>
    requires states::is_machine<Machine>
void save(const Machine& machine, const std::string& path) {
    std::ofstream out(path);
    if (out) save(machine, out);
    if (!out) refuse(Refusal::invalid_argument, "save: " + path + " cannot be written");
}
/// The same from a file.
/// \throws std::invalid_argument for one that cannot be opened, too
template <class Machine>
    requires states::is_machine<Machine>
void load(Machine& machine, const std::string& path) {
    std::ifstream in(path);
    if (!in) refuse(Refusal::invalid_argument, "load: " + path + " cannot be opened");
    load(machine, in, path);
}

} // namespace ansatz
