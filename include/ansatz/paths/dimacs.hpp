// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Reader for road maps in the form of the ninth DIMACS challenge (`.gr`): lines `c ...` are comments, `p sp <vertices>
/// <arcs>` comes first, `a <from> <to> <weight>` is an arc; vertices are numbered from 1 there and from 0 here. What is
/// wrong is refused with file, line and what was expected.

#include <ansatz/paths/moving_ai.hpp>

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace ansatz::paths {

/// Roads as their file has them.
struct DimacsRoads {
    /// A road in one direction.
    struct Arc {
        /// The vertex it leaves, from 0.
        std::size_t from, to; ///< the vertex it leads to, from 0
        std::uint32_t weight; ///< as the file has it: a distance or a time
    };
    std::size_t vertices = 0; ///< how many
    std::vector<Arc> arcs;    ///< in the order of the file
    /// As a graph of Boost.Graph: `roads.graph<boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS,
    /// boost::no_property, boost::property<boost::edge_weight_t, std::uint32_t>>>()`.
    template <class Graph> Graph graph() const {
        Graph g(vertices);
        for (const auto& arc : arcs) add_edge(arc.from, arc.to, arc.weight, g);
        return g;
    }
};

/// \param name of the file, for its sentences
/// \throws std::invalid_argument for a file that is truncated or no such
inline DimacsRoads read_dimacs(std::istream& in, const std::string& name) {
    detail::Lines lines(in, name);
    DimacsRoads roads;
    std::size_t expected = 0;
    bool begun = false;
    while (lines.next()) {
        const std::string_view text = lines.text();
        const auto fields = detail::fields_of(text);
        if (fields.empty() || fields[0] == "c") continue;
        std::size_t a = 0, b = 0, w = 0;
        if (fields[0] == "p") {
            if (begun || fields.size() != 4 || fields[1] != "sp" || !detail::whole(fields[2], a) ||
                !detail::whole(fields[3], expected) || a < 1)
                lines.fail(lines.shown(), "one line \"p sp <vertices> <arcs>\"");
            roads.vertices = a;
            begun = true;
            continue;
        }
        if (!begun) lines.fail(lines.shown(), "\"p sp <vertices> <arcs>\" before all arcs");
        if (fields.size() != 4 || fields[0] != "a" || !detail::whole(fields[1], a) || !detail::whole(fields[2], b) ||
            !detail::whole(fields[3], w))
            lines.fail(lines.shown(), "\"a <from> <to> <weight>\", all whole numbers and none negative");
        if (a < 1 || b < 1 || a > roads.vertices || b > roads.vertices)
            lines.fail("an arc from " + std::to_string(a) + " to " + std::to_string(b),
                       "vertices from 1 to " + std::to_string(roads.vertices));
        if (w > 0xffffffffu) lines.fail("the weight " + std::to_string(w), "at most 4294967295");
        roads.arcs.push_back({a - 1, b - 1, std::uint32_t(w)});
    }
    if (!begun) lines.fail("the file ends", "\"p sp <vertices> <arcs>\"");
    if (roads.arcs.size() != expected)
        lines.fail("the file ends with " + std::to_string(roads.arcs.size()) + " arcs",
                   std::to_string(expected) + ", as line p says");
    return roads;
}

} // namespace ansatz::paths
