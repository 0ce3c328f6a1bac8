// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The elements of the SCXML subset, one function each: what scxml.hpp reads, with the line of everything that is
/// wrong.

// not in the umbrella: it is a part of scxml.hpp, and needs pugixml

#include <ansatz/states/chart_build.hpp>
#include <ansatz/states/check.hpp>

#include <pugixml.hpp>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <string_view>
#include <utility>

namespace ansatz::states::detail {

inline constexpr std::size_t most_text = std::size_t(16) << 20;
inline constexpr std::string_view scxml_namespace = "http://www.w3.org/2005/07/scxml",
                                  own_namespace = "urn:ansatz:states";

/// The text of a file, or a sentence.
inline std::string text_of_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) refuse(Refusal::invalid_argument, path + ": the file cannot be opened");
    std::string text(most_text + 1, '\0');
    file.read(text.data(), std::streamsize(text.size()));
    if (file.bad()) refuse(Refusal::invalid_argument, path + ": the file cannot be read");
    text.resize(std::size_t(file.gcount()));
    return text; // one byte too long is refused by the reader
}

/// Reads one text.
class ScxmlReader {
public:
    ScxmlReader(std::string_view text, std::string origin) : text_(text) { outline_.origin = std::move(origin); }

    Outline read() {
        if (text_.size() > most_text) wrong(0, "it is longer than 16 MB, the most that is read");
        if (const auto nul = text_.find('\0'); nul != std::string_view::npos)
            wrong(line_of(std::ptrdiff_t(nul)), "a byte with the value 0 is no XML of UTF-8");
        pugi::xml_document document;
        constexpr auto how = pugi::parse_default | pugi::parse_doctype | pugi::parse_declaration;
        const auto result = document.load_buffer(text_.data(), text_.size(), how, pugi::encoding_utf8);
        if (!result) wrong(line_of(result.offset), std::string("it is no well-formed XML: ") + result.description());
        pugi::xml_node root;
        for (const auto node : document.children()) {
            if (node.type() == pugi::node_doctype)
                wrong(node, "a document type (<!DOCTYPE ...>) is not accepted, and no entity of its own");
            if (node.type() == pugi::node_declaration) require_utf8(node);
            if (node.type() != pugi::node_element) continue;
            if (root) wrong(node, "a second root element, <" + std::string(node.name()) + ">");
            root = node;
        }
        if (!root) wrong(1, "there is no element in it; a machine begins with <scxml>");
        require_references();
        namespaces(root);
        if (local(root) != "scxml") wrong(root, "the root is " + tag(root) + "; a machine begins with <scxml>");
        machine(root);
        return std::move(outline_);
    }

private:
    using Node = pugi::xml_node;
    using Content = Outline::Content;

    // ------------------------------------------------------------ sentences
    [[noreturn]] void wrong(long line, const std::string& what) const {
        refuse(Refusal::invalid_argument, outline_.origin + (line > 0 ? ":" + std::to_string(line) : "") + ": " + what);
    }
    [[noreturn]] void wrong(Node node, const std::string& what) { wrong(line_of(node), what); }
    long line_of(std::ptrdiff_t offset) {
        if (lines_.empty())
            for (std::size_t i = 0; i < text_.size(); ++i)
                if (text_[i] == '\n') lines_.push_back(i);
        if (offset < 0) return 1;
        return 1 + (std::lower_bound(lines_.begin(), lines_.end(), std::size_t(offset)) - lines_.begin());
    }
    long line_of(Node node) { return line_of(node.offset_debug()); }
    static std::string tag(Node node) {
        return "<" + shown(node.name()).substr(1, std::min<std::size_t>(60, shown(node.name()).size() - 2)) + ">";
    }

    // Its names are compared byte by byte with those that the program binds.
    void require_utf8(Node declaration) {
        std::string encoding = declaration.attribute("encoding").as_string("UTF-8");
        for (char& c : encoding) c = c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c;
        if (encoding != "UTF-8" && encoding != "UTF8" && encoding != "US-ASCII" && encoding != "ASCII")
            wrong(declaration, "the encoding is " + shown(encoding) + "; save the file as UTF-8");
    }

    // Of a reference such as &#65; pugixml keeps the last 32 bits, and &#0; ends a value for it.
    void require_references() {
        for (auto at = text_.find_first_of("<&"); at != text_.npos; at = text_.find_first_of("<&", at)) {
            for (const auto& [begin, end] : {std::pair<std::string_view, std::string_view>{"<!--", "-->"},
                                             {"<![CDATA[", "]]>"},
                                             {"<?", "?>"}}) // within these it is only text
                if (text_.substr(at).starts_with(begin)) at = std::min(text_.find(end, at), text_.size() - 1);
            if (text_.substr(at).starts_with("&#")) {
                const auto reference = text_.substr(at, text_.find(';', at) - at);
                if (!names_character(reference.substr(2)))
                    wrong(line_of(std::ptrdiff_t(at)), "the reference " + shown(std::string(reference.substr(0, 20))) +
                                                           " is of no character of XML");
            }
            ++at;
        }
    }
    /// \param number "65" or "x41"
    static bool names_character(std::string_view number) {
        const bool hexadecimal = number.starts_with('x');
        if (hexadecimal) number.remove_prefix(1);
        std::uint32_t c = 0;
        const auto [end, fault] =
            std::from_chars(number.data(), number.data() + number.size(), c, hexadecimal ? 16 : 10);
        if (fault != std::errc() || end != number.data() + number.size()) return false;
        return c == 0x9 || c == 0xa || c == 0xd || (c >= 0x20 && c < 0xd800) || (c >= 0xe000 && c < 0xfffe) ||
               (c >= 0x10000 && c < 0x110000);
    }
    // pugixml does not check bytes.
    void require_characters(Node node, const std::string& what, std::string_view text) {
        const auto bad = first_bad_byte(text);
        if (bad < text.size())
            wrong(node, what + " is " + shown(text) + ", whose byte " + std::to_string(bad) +
                            " is of no character of XML; save the file as UTF-8");
    }
    // Lists of names have blanks between them.
    void require_id(Node node, const std::string& id) {
        if (id.empty()) wrong(node, tag(node) + " has no id");
        if (const auto all = words(id); all.size() != 1 || all.front() != id)
            wrong(node,
                  "the id of " + tag(node) + " is " + shown(id) + ", with a blank in it; no target could name it");
    }

    // ------------------------------------------------------------ namespaces
    void namespaces(Node root) {
        for (const auto attribute : root.attributes()) {
            const std::string_view name = attribute.name();
            if (name == "xmlns") {
                if (attribute.value() != scxml_namespace)
                    wrong(root, "the namespace is " + shown(attribute.value()) + "; that of SCXML is " +
                                    shown(scxml_namespace));
            } else if (name.starts_with("xmlns:")) prefixes_.emplace(name.substr(6), attribute.value());
        }
    }
    // The name within SCXML; "ansatz:..." for ours; empty for another's.
    std::string local_name(Node where, std::string_view name) {
        const auto colon = name.find(':');
        if (colon == std::string_view::npos) return std::string(name);
        const std::string prefix(name.substr(0, colon));
        if (prefix == "xml" || prefix == "xmlns") return {};
        const auto known = prefixes_.find(prefix);
        if (known == prefixes_.end()) wrong(where, "the prefix of " + shown(name) + " is not declared in the root");
        if (known->second == scxml_namespace) return std::string(name.substr(colon + 1));
        if (known->second == own_namespace) return "ansatz:" + std::string(name.substr(colon + 1));
        return {};
    }
    std::string local(Node node) { return local_name(node, node.name()); }
    // The attributes of an element, of which only some are possible.
    std::map<std::string, std::string> attributes(Node node, std::initializer_list<std::string_view> possible) {
        std::map<std::string, std::string> found;
        for (const auto attribute : node.attributes()) {
            const std::string_view full = attribute.name();
            if (full == "xmlns" || full.starts_with("xmlns:")) {
                if (node.parent().type() != pugi::node_document)
                    wrong(node, "namespaces are declared in the root, not in " + tag(node));
                continue;
            }
            const auto name = full.find(':') == std::string_view::npos ? std::string(full) : local_name(node, full);
            if (name.empty()) continue;
            if (std::find(possible.begin(), possible.end(), name) == possible.end())
                wrong(node, tag(node) + " has the attribute " + shown(name) + ", which means nothing here");
            require_characters(node, "the attribute " + shown(name), attribute.value());
            if (!found.emplace(name, attribute.value()).second)
                wrong(node, tag(node) + " has the attribute " + shown(name) + " twice");
        }
        return found;
    }
    // The elements in a node; refuses stray text.
    std::vector<std::pair<std::string, Node>> elements(Node node) {
        std::vector<std::pair<std::string, Node>> found;
        for (const auto child : node.children()) {
            if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata)
                wrong(child, "text stands in " + tag(node) + ": " + shown(child.value()));
            if (child.type() != pugi::node_element) continue;
            auto name = local(child);
            if (!name.empty()) found.emplace_back(std::move(name), child);
        }
        return found;
    }
    [[noreturn]] void out_of_place(Node node, const std::string& name, Node parent) {
        static constexpr std::string_view left_out[] = {"datamodel", "data",     "assign",   "param",  "if",
                                                        "elseif",    "else",     "foreach",  "send",   "cancel",
                                                        "invoke",    "finalize", "donedata", "content"};
        const bool out = std::find(std::begin(left_out), std::end(left_out), name) != std::end(left_out);
        wrong(node,
              tag(node) +
                  (out ? " is not in the subset of SCXML that is read; do it in a guard or an action of the program"
                       : " cannot stand in " + tag(parent)));
    }

    // ------------------------------------------------------------ elements
    void machine(Node root) {
        auto a = attributes(root, {"name", "initial", "version", "datamodel", "binding"});
        Outline::State state;
        state.initial = words(a["initial"]);
        state.line = line_of(root);
        outline_.name = a["name"];
        outline_.states.push_back(std::move(state));
        const auto is_state = [](std::string_view name) {
            return name == "state" || name == "parallel" || name == "final";
        };
        const auto inside = elements(root);
        for (const auto& [name, child] : inside) {
            if (name == "ansatz:transition") outline_.transitions.push_back(transition(child, 0));
            else if (!is_state(name)) out_of_place(child, name, root);
        }
        for (const auto& [name, child] : inside)
            if (is_state(name)) place(child, name, 0, 1);
    }
    void place(Node node, const std::string& what, std::size_t parent, std::size_t depth) {
        if (depth > most_depth) wrong(node, "it is nested more than 256 deep");
        if (outline_.states.size() >= 0xfff0) wrong(node, "it has more than 65519 states");
        if (what == "history") return history(node, parent);
        auto a = what == "state" ? attributes(node, {"id", "initial", "ansatz:class", "ansatz:initial"})
                                 : attributes(node, {"id", "ansatz:class"});
        const std::size_t me = outline_.states.size();
        Outline::State state;
        state.name = a["id"];
        state.kind = what == "parallel" ? Kind::parallel : what == "final" ? Kind::final : Kind::state;
        state.parent = parent;
        state.initial = words(a["initial"]);
        state.behaviour = a["ansatz:class"];
        state.childless = a["ansatz:initial"] == "none";
        state.line = line_of(node);
        if (!state.childless && !a["ansatz:initial"].empty())
            wrong(node, "ansatz:initial is " + shown(a["ansatz:initial"]) + "; it can be \"none\"");
        require_id(node, state.name);
        outline_.states.push_back(std::move(state));
        const auto inside = elements(node);
        for (const auto& [name, child] : inside) part(node, me, name, child);
        for (const auto& [name, child] : inside)
            if (name == "state" || name == "parallel" || name == "final" || name == "history")
                place(child, name, me, depth + 1);
    }
    void part(Node node, std::size_t me, const std::string& name, Node child) {
        auto add = [&](std::vector<Content>& to) {
            attributes(child, {});
            auto more = contents(child);
            to.insert(to.end(), more.begin(), more.end());
        };
        auto& state = outline_.states[me];
        const bool final = state.kind == Kind::final;
        if (name == "onentry") add(state.entry);
        else if (name == "onexit") add(state.exit);
        else if (name == "ansatz:onupdate") add(state.each);
        else if (name == "transition" && !final) outline_.transitions.push_back(transition(child, me));
        else if (name == "initial" && state.kind == Kind::state) {
            if (!state.initial.empty()) wrong(child, "the state " + shown(state.name) + " says twice where it begins");
            attributes(child, {});
            begin(child, state);
        } else if (final || (name != "state" && name != "parallel" && name != "final" && name != "history"))
            out_of_place(child, name, node);
    }
    // The one transition of an <initial> or a <history>.
    void begin(Node node, Outline::State& state) {
        const auto inside = elements(node);
        if (inside.size() != 1 || inside.front().first != "transition")
            wrong(node, tag(node) + " holds one <transition target=\"...\">");
        const auto t = transition(inside.front().second, 0);
        if (!t.events.empty() || !t.guard.empty() || t.targets.empty())
            wrong(node, "the transition of " + tag(node) + " has a target, no event and no condition");
        state.initial = t.targets;
        state.initial_content = t.content;
    }
    void history(Node node, std::size_t parent) {
        auto a = attributes(node, {"id", "type"});
        if (!a["type"].empty() && a["type"] != "shallow" && a["type"] != "deep")
            wrong(node, "a history is shallow or deep, not " + shown(a["type"]));
        Outline::State state;
        state.name = a["id"];
        state.kind = a["type"] == "deep" ? Kind::deep_history : Kind::shallow_history;
        state.parent = parent;
        state.line = line_of(node);
        require_id(node, state.name);
        begin(node, state);
        outline_.states.push_back(std::move(state));
    }
    Outline::Transition transition(Node node, std::size_t source) {
        auto a = attributes(node, {"event", "cond", "target", "type"});
        if (outline_.transitions.size() >= 0xfff0) wrong(node, "it has more than 65519 transitions");
        if (!a["type"].empty() && a["type"] != "external" && a["type"] != "internal")
            wrong(node, "a transition is external or internal, not " + shown(a["type"]));
        Outline::Transition t;
        t.source = source;
        for (const auto& word : words(a["event"])) t.events += (t.events.empty() ? "" : " ") + word;
        if (t.events.empty() && node.attribute("event")) wrong(node, "the transition has an empty event");
        t.guard = a["cond"];
        if (t.guard.empty() && node.attribute("cond")) wrong(node, "the transition has an empty condition");
        t.targets = words(a["target"]);
        if (t.targets.empty() && node.attribute("target")) wrong(node, "the transition has an empty target");
        t.internal = a["type"] == "internal";
        t.content = contents(node);
        t.line = line_of(node);
        return t;
    }
    std::vector<Content> contents(Node node) {
        std::vector<Content> found;
        for (const auto child : node.children()) {
            if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata)
                wrong(child, "text stands in " + tag(node) + ": " + shown(child.value()));
            if (child.type() != pugi::node_element) continue;
            const auto name = local(child);
            if (name.empty()) continue;
            Content content;
            content.line = line_of(child);
            if (name == "raise") {
                content.what = Content::What::raise;
                content.name = attributes(child, {"event"})["event"];
                const auto events = words(content.name);
                if (events.size() != 1) wrong(child, "<raise> names one event, not " + shown(content.name));
                content.name = events.front();
            } else if (name == "log") {
                content.what = Content::What::log;
                auto a = attributes(child, {"label", "expr"});
                content.name = a["label"].empty() ? a["expr"] : a["label"] + ": " + a["expr"];
            } else if (name == "script") {
                attributes(child, {});
                content.name = trimmed(child.child_value());
                if (content.name.empty()) wrong(child, "<script> holds the name of an action");
                require_characters(child, "the action", content.name);
                if (child.first_child() != child.last_child())
                    wrong(child, "<script> holds the name of one action and nothing else; write two of them");
            } else out_of_place(child, name, node);
            if (name != "script" && child.first_child()) wrong(child, tag(child) + " is empty");
            found.push_back(std::move(content));
        }
        return found;
    }
    static std::string trimmed(std::string_view text) {
        const auto first = text.find_first_not_of(" \t\n\r");
        if (first == std::string_view::npos) return {};
        return std::string(text.substr(first, text.find_last_not_of(" \t\n\r") - first + 1));
    }

    std::string_view text_;
    Outline outline_;
    std::map<std::string, std::string> prefixes_;
    std::vector<std::size_t> lines_;
};

} // namespace ansatz::states::detail
