// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Reads machines from files: a subset of SCXML, the W3C's format for statecharts, which editors know (notes 5.1).
///
// not in the umbrella: it is the only header that needs pugixml
///
/// | element                    | attributes                                     |
/// |----------------------------|------------------------------------------------|
/// | `<scxml>`                  | `name`, `initial`; `version`, `datamodel` and `binding` are read over |
/// | `<state>`, `<parallel>`, `<final>` | `id`, `initial` (of a state)           |
/// | `<initial>`, `<history>`   | with one `<transition>`; a history's `id` and `type` (shallow or deep) |
/// | `<transition>`             | `event`, `cond`: the name of a guard, `target`, `type` (external or internal) |
/// | `<onentry>`, `<onexit>`    | hold what is done                              |
/// | `<raise>`, `<log>`, `<script>` | `event`; `label`, `expr`; the name of an action as text |
///
/// Four things more stand in a namespace of their own, `xmlns:ansatz="urn:ansatz:states"`: the attribute
/// `ansatz:class` of a state, the name of its class; `ansatz:initial="none"`, it is entered without any of the states
/// in it; the element `<ansatz:onupdate>`, what is done at every update; and in the root `<ansatz:transition>`, which
/// is taken in whatever state the machine is. Elements and attributes of other
/// namespaces (an editor's layout) are read over. Left out is what computes inside the file
/// (`datamodel`, `if`, `foreach`, `assign`, `param`, expressions) and what talks to the world outside (`send`,
/// `cancel`, `invoke`, `donedata`): the program does that. What is left out is refused by name; so is a document type,
/// so that no entity is ever expanded. A file has at most 16 MB and 256 levels. Nothing of a refused file is kept.

#include <ansatz/states/scxml_elements.hpp>

#include <fstream>

namespace ansatz {

/// How strict a file is read.
struct ReadOptions {
    bool refuse_unreachable = false; ///< a state that no transition leads to is refused too
};

/// The outline of a machine in a text.
/// \param origin  what sentences call it: the path of its file
/// \throws std::invalid_argument with origin, line and name for whatever is wrong
inline Outline parse_outline(std::string_view text, std::string origin) {
    return states::detail::ScxmlReader(text, std::move(origin)).read();
}

/// A machine in a text.
/// \param names  what its guards, actions and classes stand for
/// \throws std::invalid_argument with origin, line and name for whatever is wrong
template <class Context>
SharedChart<Context> parse_scxml(std::string_view text, std::string origin, const Bindings<Context>& names,
                                 ReadOptions options = {}) {
    auto chart = make_chart(parse_outline(text, std::move(origin)), names);
    if (options.refuse_unreachable) refuse_unreachable(chart->outline());
    return chart;
}

/// A machine in a file.
/// \throws std::invalid_argument with path, line and name for whatever is wrong, also for a file that cannot be read
template <class Context>
SharedChart<Context> read_scxml(const std::string& path, const Bindings<Context>& names, ReadOptions options = {}) {
    return parse_scxml(states::detail::text_of_file(path), path, names, options);
}

} // namespace ansatz
