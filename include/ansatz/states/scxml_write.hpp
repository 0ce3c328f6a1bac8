// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Writes a machine as SCXML; what is written can be read back by scxml.hpp to the same outline. Needs no XML library.
///
/// What a file has no place for is refused: a final state with a transition, a history that does something, a state
/// whose name has a blank, since files list names with blanks between them, an action whose name begins or ends with
/// one, and text that is no UTF-8 or that no XML may hold.

#include <ansatz/core/error.hpp>
#include <ansatz/states/names.hpp>
#include <ansatz/states/outline.hpp>

namespace ansatz {

namespace states::detail {

/// A text as the value of an attribute, or between elements.
inline std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
        case '&': out += "&amp;"; break;
        case '<': out += "&lt;"; break;
        case '>': out += "&gt;"; break;
        case '"': out += "&quot;"; break;
        case '\n': out += "&#10;"; break;
        case '\r': out += "&#13;"; break;
        case '\t': out += "&#9;"; break;
        default: out += c;
        }
    }
    return out;
}

/// Refuses an outline that would not be read back as it is.
class ScxmlWritable {
public:
    explicit ScxmlWritable(const Outline& outline) : outline_(outline) {
        text("the name of the machine", outline.name);
        const auto& machine = outline.states[0];
        if (!machine.entry.empty() || !machine.exit.empty() || !machine.each.empty() || !machine.behaviour.empty() ||
            !machine.initial_content.empty())
            wrong(
                "the machine itself does something, or has a class, which a file has no place for; let a state around "
                "all others do it");
        if (machine.kind != Kind::state || machine.childless)
            wrong("the machine itself is parallel, final or a history, or begins in no state, which a file has no "
                  "place for; let a state around all others be it");
        for (std::size_t s = 1; s < outline.states.size(); ++s) shape(outline.states[s]), state(outline.states[s]);
        for (const auto& t : outline.transitions) transition(t);
    }

private:
    [[noreturn, gnu::cold]] static void wrong(const std::string& what) {
        refuse(Refusal::invalid_argument, "write_scxml: " + what);
    }
    static void text(const std::string& what, const std::string& value) {
        const auto bad = first_bad_byte(value);
        if (bad < value.size())
            wrong(what + " is " + shown(value) + ", whose byte " + std::to_string(bad) + ", of the value " +
                  std::to_string(unsigned(std::uint8_t(value[bad]))) + ", no XML of UTF-8 can hold");
    }
    /// What is listed with blanks between.
    static void word(const std::string& what, const std::string& name) {
        text(what, name);
        if (const auto all = words(name); all.size() == 1 && all.front() == name) return;
        std::string better = name.empty() ? std::string("wait_here") : name;
        for (char& c : better)
            if (std::string_view(" \t\n\r").find(c) != std::string_view::npos) c = '_';
        wrong(what + " is " + (name.empty() ? "empty" : shown(name) + ", with a blank in it") +
              "; a file lists names with blanks between them: write e.g. " + shown(better));
    }
    void state(const Outline::State& s) const {
        word("the name of a state", s.name);
        const std::string of = " of the state " + shown(s.name);
        for (const auto& name : s.initial) word("an initial state" + of, name);
        text("the class" + of, s.behaviour);
        for (const auto* all : {&s.initial_content, &s.entry, &s.exit, &s.each}) contents(of, *all);
    }
    /// What the reader takes of a state of this kind.
    void shape(const Outline::State& s) const {
        const bool history = is_history(s.kind), one_inside = s.kind == Kind::state;
        const auto refused = [&](const std::string& what) { wrong("the state " + shown(s.name) + " " + what); };
        const Kind around = outline_.states[s.parent].kind;
        if (around == Kind::final || is_history(around))
            refused("is in " + shown(outline_.states[s.parent].name) +
                    ", a final state or a history; no file has "
                    "states in one");
        if (history && s.initial.empty()) refused("is a history that goes nowhere the first time; name its initial");
        if (history && !(s.entry.empty() && s.exit.empty() && s.each.empty() && s.behaviour.empty()))
            refused("is a history that does something, or has a class; let the state around it do that");
        if (!history && !one_inside && !(s.initial.empty() && s.initial_content.empty()))
            refused("is parallel or final, and has an initial state; leave it out");
        if (!one_inside && s.childless) refused("is no state that can be alone, without any of the states in it");
        if (!s.initial_content.empty() && s.initial.empty())
            refused("does something before its initial state, which has no name; name it in its initial");
    }
    void transition(const Outline::Transition& t) const {
        const auto& source = outline_.states[t.source].name;
        if (const Kind kind = outline_.states[t.source].kind; kind == Kind::final || is_history(kind))
            wrong("a transition begins in " + shown(source) + ", a final state or a history, from which none leads");
        const std::string of = " of a transition of " + (source.empty() ? "the machine" : shown(source));
        text("the event" + of, t.events);
        if (!t.events.empty() && words(t.events).empty()) wrong("the event" + of + " is blank; give it a name");
        text("the guard" + of, t.guard);
        for (const auto& name : t.targets) word("a target" + of, name);
        contents(of, t.content);
    }
    static void contents(const std::string& of, const std::vector<Outline::Content>& all) {
        using What = Outline::Content::What;
        for (const auto& content : all) {
            if (content.what == What::raise) word("an event that is raised by an action" + of, content.name);
            text((content.what == What::log ? "the text of a log" : "the name of an action") + of, content.name);
            if (content.what != What::action) continue;
            const auto blank = [](char c) { return std::string_view(" \t\n\r").find(c) != std::string_view::npos; };
            if (content.name.empty() || blank(content.name.front()) || blank(content.name.back()))
                wrong("the name of an action" + of + " is " + shown(content.name) +
                      "; it is the text of an element, which begins and ends with something else than a blank");
        }
    }
    const Outline& outline_;
};

/// Writes one outline.
class ScxmlWriter {
public:
    explicit ScxmlWriter(const Outline& outline)
        : outline_(outline), children_(outline.states.size()), transitions_(outline.states.size()) {
        for (std::size_t s = 1; s < outline.states.size(); ++s) children_[outline.states[s].parent].push_back(s);
        for (std::size_t t = 0; t < outline.transitions.size(); ++t)
            transitions_[outline.transitions[t].source].push_back(t);
    }
    std::string write() {
        bool own = !transitions_[0].empty();
        for (const auto& s : outline_.states) own = own || !s.each.empty() || !s.behaviour.empty() || s.childless;
        text_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<scxml xmlns=\"http://www.w3.org/2005/07/scxml\"";
        if (own) text_ += " xmlns:ansatz=\"urn:ansatz:states\"";
        text_ += " version=\"1.0\"";
        attribute("name", outline_.name);
        attribute("initial", joined(outline_.states[0].initial));
        text_ += ">\n";
        for (const auto t : transitions_[0]) transition(outline_.transitions[t], 1, "ansatz:transition");
        for (const auto child : children_[0]) state(child, 1);
        return text_ + "</scxml>\n";
    }

private:
    void indent(std::size_t depth) { text_.append(4 * depth, ' '); }
    void attribute(const char* name, const std::string& value) {
        if (!value.empty()) text_ += std::string(" ") + name + "=\"" + escaped(value) + "\"";
    }
    static std::string joined(const std::vector<std::string>& names) {
        std::string text;
        for (const auto& name : names) text += (text.empty() ? "" : " ") + name;
        return text;
    }
    void contents(const std::vector<Outline::Content>& contents, std::size_t depth) {
        using What = Outline::Content::What;
        for (const auto& content : contents) {
            indent(depth);
            const auto name = escaped(content.name);
            text_ += content.what == What::raise ? "<raise event=\"" + name + "\"/>\n"
                     : content.what == What::log ? "<log expr=\"" + name + "\"/>\n"
                                                 : "<script>" + name + "</script>\n";
        }
    }
    void block(const char* tag, const std::vector<Outline::Content>& what, std::size_t depth) {
        if (what.empty()) return;
        indent(depth);
        text_ += std::string("<") + tag + ">\n";
        contents(what, depth + 1);
        indent(depth);
        text_ += std::string("</") + tag + ">\n";
    }
    void transition(const Outline::Transition& t, std::size_t depth, const std::string& tag = "transition") {
        indent(depth);
        text_ += "<" + tag;
        attribute("event", joined(words(t.events)));
        attribute("cond", t.guard);
        attribute("target", joined(t.targets));
        if (t.internal) attribute("type", "internal");
        if (t.content.empty()) {
            text_ += "/>\n";
            return;
        }
        text_ += ">\n";
        contents(t.content, depth + 1);
        indent(depth);
        text_ += "</" + tag + ">\n";
    }
    void begin(const Outline::State& s, std::size_t depth) {
        Outline::Transition t;
        t.targets = s.initial;
        t.content = s.initial_content;
        transition(t, depth);
    }
    void state(std::size_t id, std::size_t depth) {
        const auto& s = outline_.states[id];
        const char* tag = is_history(s.kind)         ? "history"
                          : s.kind == Kind::parallel ? "parallel"
                          : s.kind == Kind::final    ? "final"
                                                     : "state";
        indent(depth);
        text_ += std::string("<") + tag;
        attribute("id", s.name);
        if (is_history(s.kind)) attribute("type", s.kind == Kind::deep_history ? "deep" : "shallow");
        const bool element = !s.initial_content.empty();
        if (!is_history(s.kind) && !element) attribute("initial", joined(s.initial));
        if (s.childless) attribute("ansatz:initial", "none");
        attribute("ansatz:class", s.behaviour);
        text_ += ">\n";
        if (is_history(s.kind)) begin(s, depth + 1);
        else if (element) {
            indent(depth + 1);
            text_ += "<initial>\n";
            begin(s, depth + 2);
            indent(depth + 1);
            text_ += "</initial>\n";
        }
        block("onentry", s.entry, depth + 1);
        block("onexit", s.exit, depth + 1);
        block("ansatz:onupdate", s.each, depth + 1);
        for (const auto t : transitions_[id]) transition(outline_.transitions[t], depth + 1);
        for (const auto child : children_[id]) state(child, depth + 1);
        indent(depth);
        text_ += std::string("</") + tag + ">\n";
    }

    const Outline& outline_;
    std::vector<std::vector<std::size_t>> children_, transitions_;
    std::string text_;
};

} // namespace states::detail

/// A machine as SCXML.
/// \throws std::invalid_argument with the name for what would not be read back as it is
inline std::string write_scxml(const Outline& outline) {
    if (outline.states.empty()) return {};
    states::detail::ScxmlWritable{outline};
    return states::detail::ScxmlWriter(outline).write();
}

} // namespace ansatz
