// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Visitor`: watches a search step by step, as the notes number its steps (6.1); `Trace` writes them down.
///
/// Derive from Visitor and write again what you want to see; what is not written again costs nothing. Every call gets
/// the vertex and its node, whose f, g, h and parent are those after the step.

#include <ansatz/core/compiler_flags.hpp>

#include <vector>

namespace ansatz::paths {

/// Sees nothing: the base of those that do.
struct Visitor {
    /// Step 1 and 2.3.4: a node that was on no list is put on the open list.
    template <class V, class Node> void opened(const V&, const Node&) {}
    /// Step 2.1: the node of the least f moves to the closed list.
    template <class V, class Node> void closed(const V&, const Node&) {}
    /// Step 2.3.1: a neighbour that cannot be traversed is skipped; `from` is the node it was seen from.
    template <class V> void skipped(const V& /*from*/, const V& /*to*/) {}
    /// Step 2.3.3 for a node on the open list: a cheaper way to it was found.
    template <class V, class Node> void improved(const V&, const Node&) {}
    /// Step 2.3.3 for a node on the closed list: it was updated, and by `Reopening` is open again.
    template <class V, class Node> void reopened(const V&, const Node&) {}
    /// Step 2.2: the goal came off the open list.
    template <class V, class Node> void reached(const V&, const Node&) {}
};

/// Writes down the vertices in the order in which they were opened and closed.
template <class Vertex> struct Trace : Visitor {
    /// Those that were opened.
    std::vector<Vertex> opened_in_order, closed_in_order; ///< those that were closed
    /// Writes it down as opened.
    template <class Node> void opened(const Vertex& v, const Node&) { opened_in_order.push_back(v); }
    /// Writes it down as closed.
    template <class Node> void closed(const Vertex& v, const Node&) { closed_in_order.push_back(v); }
};

} // namespace ansatz::paths
