// SPDX-License-Identifier: BSL-1.0
// 5.1.3 Interpreted state pattern: the machine stands in a file, and may be changed while the game runs

// "States, behaviours and transitions are read from a file and the structure is constructed at game startup." The file
// is SCXML, the W3C's format for statecharts, for which there are editors. It holds the structure and names; what a
// name does is bound by the program, so that whoever changes the file cannot break more than the machine. What is wrong
// with a file is said with its line, and nothing of it is kept. A file that was saved again is taken over between two
// updates.

#include "claims.hpp"
#include "graphviz.hpp"
#include "guard_npc.hpp"
#include "say.hpp"

#include <ansatz/states/scxml.hpp>

#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>

using namespace guard;

namespace {

const std::string folder = std::filesystem::path(__FILE__).parent_path().string(); // the file lies beside this one

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    return text.replace(text.find(what), what.size(), by);
}

} // namespace

int main() {
    workbook::Claims claim;

    //! [read]
    Bindings<Npc> names;
    names.guard("sees", GuardNpc::sight.below())
        .guard("lost", GuardNpc::sight.above())
        .guard("near", GuardNpc::distance < 1.0 * metre);
    names.guard("tired", after(3.0 * second)).guard("rested", after(2.0 * second));
    names.action("strike", strike).behaviour<Walk>("Walk").behaviour<Chase>("Chase");
    const auto chart = read_scxml(folder + "/guard_npc.scxml", names);

    Machine<InFile<Npc>, Interpreted> from_file{chart};
    //! [read]
    Machine<GuardNpc, Switch> compiled;
    Npc of_file, of_program;
    const Trace trace = evening(of_file, from_file);
    std::cout << trace.size() - 1 << " changes of state from the file\n";
    claim("the machine from the file has the trace of the compiled one", trace == evening(of_program, compiled));
    claim("and did the same", of_file.place == of_program.place && of_file.blows == of_program.blows &&
                                  of_file.shouts == of_program.shouts);

    // The library writes its machines as such files, and reads them back.
    const std::string text = write_scxml(chart->outline());
    claim("written and read again it is the same machine",
          parse_scxml(text, "guard", names)->outline() == chart->outline());

    // What can be wrong with a file, each in a sentence; the machine that runs knows nothing of it.
    //! [refused]
    for (const auto& [right, wrong] : {std::pair<std::string, std::string>{"target=\"strike\"", "target=\"strik\""},
                                       {"cond=\"sees\"", "cond=\"smells\""},
                                       {"id=\"search\"", "id=\"patrol\""},
                                       {"</scxml>", ""}}) {
        try {
            from_file.reload(of_file, parse_scxml(replaced(text, right, wrong), "guard_npc.scxml", names));
            claim("a wrong file is refused", false);
        } catch (const std::invalid_argument& error) {
            workbook::say() << error.what() << '\n';
        }
    }
    //! [refused]
    claim("after four wrong files he is still on patrol", from_file.active_name() == "patrol");

    // A new file while he walks: from now on he sleeps at his post when the bell rings.
    //! [reload]
    const std::string changed = replaced(text, "</scxml>", "<state id=\"sleep\"/></scxml>");
    const auto legs = from_file.own<Walk>(from_file.state("patrol")).legs;
    from_file.reload(
        of_file, parse_scxml(replaced(changed, "event=\"noise\" target=\"search\"", "event=\"bell\" target=\"sleep\""),
                             "guard_npc.scxml", names));
    //! [reload]
    claim("he goes on in the state of the same name, with its data",
          from_file.active_name() == "patrol" && from_file.own<Walk>(from_file.state("patrol")).legs == legs);
    claim("noise is nothing to him any more, the bell is", !from_file.handle(of_file, "noise") &&
                                                               from_file.handle(of_file, "bell") &&
                                                               from_file.active_name() == "sleep");

    // Nothing leads out of the new state. He gets a way out while he sleeps, he alone.
    //! [add]
    from_file.add(of_file, "sleep", transition(when("rested", after(8.0 * second)), to("patrol")));
    //! [add]
    try {
        from_file.add(of_file, "sleep", transition(on("bell"), to("patroll")));
        claim("a transition to nowhere is refused", false);
    } catch (const std::invalid_argument& error) {
        workbook::say() << error.what() << '\n';
    }

    // A picture of the machine as it is now.
    //! [dot]
    const std::string dot = to_dot(from_file.outline(), from_file.active_names());
    workbook::draw_graph("5.1.3", dot);
    //! [dot]
    workbook::say() << dot; // a line of it may end at any blank
    claim("the picture marks the active state", dot.find("\"sleep\" [fillcolor=\"#0072b2\"") != std::string::npos);
    for (int i = 0; i < 8 && from_file.is_in("sleep"); ++i) from_file.update(of_file, 1.0 * second);
    claim("he sleeps for 8 s, and goes on with his round", from_file.active_name() == "patrol");
    return claim.result();
}
