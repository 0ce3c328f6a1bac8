// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// A picture of a machine: `to_dot(machine.outline(), names)` is a text for Graphviz, `dot -Tsvg`. States in states are
/// boxes in boxes; the active states are filled; conditions are drawn dashed.

#include <ansatz/states/outline.hpp>

#include <algorithm>

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
                " {\n    compound=true; rankdir=LR;\n    node [shape=box, style=rounded, fontname=sans];\n    edge "
                "[fontname=sans, fontsize=10];\n";
        for (const auto child : children_[0]) state(child, 1);
        text_ += "    start [shape=point, width=0.15];\n    start -> " + in_quotes(anchor(begin_of(0))) +
                 head(begin_of(0)) + ";\n";
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
    // The node that an arrow is tied to: a box of boxes has none of its own.
    std::string anchor(std::size_t s) const {
        while (compound(s)) s = children_[s].front();
        return outline_.states[s].name;
    }
    std::string head(std::size_t s) const {
        return compound(s) ? " [lhead=" + in_quotes("cluster_" + outline_.states[s].name) + "]" : "";
    }

    void state(std::size_t s, std::size_t depth) {
        const auto& it = outline_.states[s];
        const std::string in(4 * depth, ' ');
        const char* fill = is_active(s) ? "style=\"rounded,filled\", fillcolor=gold" : "style=rounded";
        if (!compound(s)) {
            text_ += in + in_quotes(it.name) + " [" + fill;
            if (is_history(it.kind))
                text_ += std::string(", shape=circle, label=") + (it.kind == Kind::deep_history ? "\"H*\"" : "\"H\"");
            if (it.kind == Kind::final) text_ += ", peripheries=2";
            text_ += "];\n";
            return;
        }
        text_ +=
            in + "subgraph " + in_quotes("cluster_" + it.name) + " {\n" + in + "    label=" + in_quotes(it.name) + "; ";
        text_ += is_active(s)                ? "style=\"rounded,filled\"; fillcolor=lightyellow;"
                 : it.kind == Kind::parallel ? "style=\"rounded,dashed\";"
                                             : "style=rounded;";
        text_ += "\n";
        for (const auto child : children_[s]) state(child, depth + 1);
        text_ += in + "}\n";
    }
    void transition(const Outline::Transition& t) {
        std::string label = t.events;
        if (!t.guard.empty()) label += (label.empty() ? "[" : " [") + t.guard + "]";
        for (std::size_t i = 0; i < std::max<std::size_t>(1, t.targets.size()); ++i) {
            const std::size_t target = t.targets.empty() ? t.source : find(t.targets[i]);
            text_ += "    " + in_quotes(anchor(t.source)) + " -> " + in_quotes(anchor(target)) +
                     " [label=" + in_quotes(label);
            if (compound(t.source)) text_ += ", ltail=" + in_quotes("cluster_" + outline_.states[t.source].name);
            if (compound(target)) text_ += ", lhead=" + in_quotes("cluster_" + outline_.states[target].name);
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
