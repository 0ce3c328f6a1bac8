// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// A picture of a machine: `to_dot(machine.outline(), machine.active_names())` is a text for Graphviz, `dot -Tsvg`.
/// States in states are boxes in boxes, final states have two borders, an H is a history; the innermost active state is
/// dark blue, and what is around it light blue. What happens on an event is drawn through, a condition dashed; a loop
/// without an arrow is done without leaving the state.

#include <ansatz/states/outline.hpp>

#include <algorithm>
#include <array>

namespace ansatz {

namespace states::detail {

/// A text in quotes of the dot language.
inline std::string in_quotes(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (c == '\n') out += "\\n";
        else out += c;
    }
    return out + "\"";
}

/// Draws one outline.
class DotWriter {
public:
    DotWriter(const Outline& outline, const std::vector<std::string>& active)
        : outline_(outline), active_(active), children_(outline.states.size()) {
        for (std::size_t s = 1; s < outline.states.size(); ++s) children_[outline.states[s].parent].push_back(s);
    }
    std::string write() {
        text_ = "digraph " + in_quotes(outline_.name.empty() ? "machine" : outline_.name) +
                " {\n    compound=true; rankdir=LR; nodesep=0.5; ranksep=0.6; pad=0.2; bgcolor=white;\n"
                "    fontname=\"Helvetica,Arial,sans-serif\"; fontsize=12; fontcolor=\"#44566c\";\n"
                "    node [shape=box, style=\"rounded,filled\", fillcolor=white, color=\"#8393a5\", height=0.45, "
                "margin=\"0.16,0.06\",\n          fontname=\"Helvetica,Arial,sans-serif\", fontsize=13];\n"
                "    edge [color=\"#5d6b7a\", fontcolor=\"#334252\", arrowsize=0.7, "
                "fontname=\"Helvetica,Arial,sans-serif\", fontsize=11];\n";
        for (const auto child : children_[0]) state(child, 1);
        text_ +=
            "    start [shape=circle, style=filled, fillcolor=\"#222222\", color=\"#222222\", label=\"\", width=0.15, "
            "height=0.15, fixedsize=true];\n    start -> " +
            in_quotes(anchor(begin_of(0))) + head(begin_of(0)) + ";\n";
        if (std::any_of(outline_.transitions.begin(), outline_.transitions.end(),
                        [](const auto& t) { return t.source == 0; }))
            text_ += "    " + in_quotes(anchor(0)) +
                     " [label=\"anywhere\", shape=plaintext, fillcolor=\"#00000000\", "
                     "fontcolor=\"#334252\", fontsize=11];\n";
        for (const auto& t : outline_.transitions) transition(t);
        return text_ + "}\n";
    }

private:
    bool compound(std::size_t s) const { return !children_[s].empty(); }
    bool is_active(std::size_t s) const {
        return std::find(active_.begin(), active_.end(), outline_.states[s].name) != active_.end();
    }
    std::size_t find(const std::string& name) const {
        for (std::size_t s = 1; s < outline_.states.size(); ++s)
            if (outline_.states[s].name == name) return s;
        return 0;
    }
    std::size_t begin_of(std::size_t s) const {
        if (!outline_.states[s].initial.empty()) return find(outline_.states[s].initial.front());
        for (const auto child : children_[s])
            if (!is_history(outline_.states[child].kind)) return child;
        return s;
    }
    // What an arrow is tied to. A box of boxes is none of Graphviz' nodes: it has one in it that is not seen, and
    // arrows are cut at its border. Its name begins with a blank; that of the machine itself is the blank alone.
    std::string anchor(std::size_t s) const {
        return compound(s) || s == 0 ? " " + outline_.states[s].name : outline_.states[s].name;
    }
    std::string head(std::size_t s) const {
        return compound(s) ? " [lhead=" + in_quotes("cluster_" + outline_.states[s].name) + "]" : "";
    }

    void state(std::size_t s, std::size_t depth) {
        const auto& it = outline_.states[s];
        const std::string in(4 * depth, ' ');
        const bool active = is_active(s);
        if (!compound(s)) {
            std::string looks = active ? "fillcolor=\"#0072b2\", color=\"#0072b2\", fontcolor=white, " : "";
            if (is_history(it.kind))
                looks += std::string("shape=circle, width=0.35, height=0.35, fixedsize=true, label=") +
                         (it.kind == Kind::deep_history ? "\"H*\", " : "\"H\", ");
            if (it.kind == Kind::final) looks += "peripheries=2, ";
            text_ +=
                in + in_quotes(it.name) + (looks.empty() ? "" : " [" + looks.substr(0, looks.size() - 2) + "]") + ";\n";
            return;
        }
        static constexpr std::array<const char*, 4> shades{"#f5f7fa", "#eaeff4", "#dfe6ee", "#d4dde7"}; // by depth
        text_ += in + "subgraph " + in_quotes("cluster_" + it.name) + " {\n" + in + "    label=" + in_quotes(it.name) +
                 "; labeljust=l; margin=14; style=\"rounded,filled" +
                 (it.kind == Kind::parallel ? ",dashed\"; " : "\"; ");
        if (active) text_ += "fillcolor=\"#e1eff8\"; color=\"#0072b2\"; penwidth=1.5;\n";
        else
            text_ += std::string("fillcolor=\"") + shades[std::min(depth - 1, shades.size() - 1)] +
                     "\"; color=\"#b3c0ce\"; penwidth=1;\n";
        text_ += in + "    " + in_quotes(anchor(s)) + " [shape=point, style=invis, width=0.01, height=0.01];\n";
        for (const auto child : children_[s]) state(child, depth + 1);
        text_ += in + "}\n";
    }
    bool inside(std::size_t outer, std::size_t s) const {
        while (s != outer && s != 0) s = outline_.states[s].parent;
        return s == outer;
    }
    void transition(const Outline::Transition& t) {
        std::string label = t.events;
        if (!t.guard.empty()) label += (label.empty() ? "[" : "\n[") + t.guard + "]";
        for (std::size_t i = 0; i < std::max<std::size_t>(1, t.targets.size()); ++i) {
            const std::size_t target = t.targets.empty() ? t.source : find(t.targets[i]);
            text_ += "    " + in_quotes(anchor(t.source)) + " -> " + in_quotes(anchor(target)) +
                     " [label=" + in_quotes(label);
            // An arrow ends at a box of boxes that does not hold its other end.
            if (t.source != 0 && compound(t.source) && !inside(t.source, target))
                text_ += ", ltail=" + in_quotes("cluster_" + outline_.states[t.source].name);
            if (target != 0 && compound(target) && !inside(target, t.source))
                text_ += ", lhead=" + in_quotes("cluster_" + outline_.states[target].name);
            if (t.events.empty()) text_ += ", style=dashed";
            if (t.targets.empty()) text_ += ", arrowhead=none";
            text_ += "];\n";
        }
    }

    const Outline& outline_;
    const std::vector<std::string>& active_;
    std::vector<std::vector<std::size_t>> children_;
    std::string text_;
};

} // namespace states::detail

/// A picture of a machine as a text in Graphviz' language.
/// \param active  the names of the states to fill, e.g. `machine.active_names()`
inline std::string to_dot(const Outline& outline, const std::vector<std::string>& active = {}) {
    if (outline.states.empty()) return "digraph {}\n";
    return states::detail::DotWriter(outline, active).write();
}

} // namespace ansatz
