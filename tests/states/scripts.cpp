// SPDX-License-Identifier: BSL-1.0
// The conformance scripts of the SCION framework that need no parallel states, in every representation. Each machine is
// described here, is compared with the file that it stands for, and runs the script beside it; what a script logs is
// left out. Compiled without optimisation: ninety machines, and none of them is measured.

#include <ansatz/states/scxml.hpp>

#include "tests/project.hpp"
#include "tests/states/support.hpp"

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>

using namespace states_tests;

namespace {

struct Nothing {};
struct Script {
    using Context = Nothing;
};
struct actionSend_send2 : Script {
    static constexpr auto machine =
        states::machine(initial("a"), state("a", on_exit(raise("s")), transition(on("t"), to("b"))),
                        state("b", transition(on("s"), to("c"))), state("c"));
};
struct actionSend_send3 : Script {
    static constexpr auto machine =
        states::machine(initial("a"), state("a", transition(on("t"), to("b"))),
                        state("b", on_entry(raise("s")), transition(on("s"), to("c"))), state("c"));
};
struct actionSend_send4 : Script {
    static constexpr auto machine = states::machine(
        initial("a"), state("a", transition(on("t"), to("b"))),
        state("b", on_entry(raise("s")), transition(on("s"), to("c")), transition(to("f1"))),
        state("c", transition(on("s"), to("f2")), transition(to("d"))), state("f1"), state("d"), state("f2"));
};
struct actionSend_send7 : Script {
    static constexpr auto machine =
        states::machine(initial("a"), state("a", transition(on("t"), then(raise("s")), to("b"))),
                        state("b", initial("b1"), state("b1", transition(on("s"), to("b2")), transition(to("b3"))),
                              state("b2"), state("b3")));
};
struct actionSend_send7b : Script {
    static constexpr auto machine = states::machine(
        initial("a"), state("a", transition(on("t"), then(raise("s")), to("b"))),
        state("b", initial("b1"), state("b1", transition(on("s"), to("b2"))), state("b2"), state("b3")));
};
struct actionSend_send8 : Script {
    static constexpr auto machine =
        states::machine(initial("a"), state("a", transition(on("t"), then(raise("s")), to("b1"))),
                        state("b", initial("b1"), state("b1", transition(on("s"), to("b2")), transition(to("b3"))),
                              state("b2"), state("b3")));
};
struct actionSend_send8b : Script {
    static constexpr auto machine = states::machine(
        initial("a"), state("a", transition(on("t"), then(raise("s")), to("b1"))),
        state("b", initial("b1"), state("b1", transition(on("s"), to("b2"))), state("b2"), state("b3")));
};
struct actionSend_send9 : Script {
    static constexpr auto machine =
        states::machine(initial("a"), state("a", transition(on("t"), then(raise("s")), to("b"))),
                        state("b", initial("b1"), state("b1", transition(on("s"), to("b2")), transition(to("b3"))),
                              state("b2"), state("b3")));
};
struct atom3_basic_tests_m0 : Script {
    static constexpr auto machine =
        states::machine(state("A", transition(on("e1"), to("B"))), state("B", transition(on("e2"), to("A"))));
};
struct atom3_basic_tests_m1 : Script {
    static constexpr auto machine =
        states::machine(state("A", transition(on("e1"), to("B"))), state("B", transition(on("e2"), to("A"))));
};
struct atom3_basic_tests_m2 : Script {
    static constexpr auto machine = states::machine(state("AB", initial("A"), state("A", transition(on("e1"), to("B"))),
                                                          state("B", transition(on("e2"), to("A")))));
};
struct default_initial_state_initial2 : Script {
    static constexpr auto machine = states::machine(initial("a"), state("a", transition(on("t"), to("b"))), state("b"));
};
struct hierarchy_documentOrder_test0 : Script {
    static constexpr auto machine =
        states::machine(state("a", transition(on("t"), to("b")),
                              state("a1", transition(on("t"), to("a2")), transition(on("t"), to("c"))), state("a2")),
                        state("b"), state("c"));
};
struct hierarchy_documentOrder_test1 : Script {
    static constexpr auto machine =
        states::machine(state("a", transition(on("t"), to("a2")),
                              state("a1", transition(on("t"), to("b")), transition(on("t"), to("c"))), state("a2")),
                        state("b"), state("c"));
};
struct hierarchy_hier0 : Script {
    static constexpr auto machine =
        states::machine(state("a", state("a1", transition(on("t"), to("a2"))), state("a2")));
};
struct hierarchy_hier2 : Script {
    static constexpr auto machine = states::machine(
        state("a", transition(on("t"), to("a2")), state("a1", transition(on("t"), to("b"))), state("a2")), state("b"));
};
struct history_history1 : Script {
    static constexpr auto machine = states::machine(
        initial("a"), state("a", transition(on("t1"), to("h"))),
        state("b", initial("b1"), deep_history("h", to("b1.2")),
              state("b1", initial("b1.1"), state("b1.1"), state("b1.2", transition(on("t2"), to("b1.3"))),
                    state("b1.3", transition(on("t3"), to("a"))))));
};
struct history_history2 : Script {
    static constexpr auto machine = states::machine(
        initial("a"), state("a", transition(on("t1"), to("h"))),
        state("b", initial("b1"), shallow_history("h", to("b1.2")),
              state("b1", initial("b1.1"), state("b1.1"), state("b1.2", transition(on("t2"), to("b1.3"))),
                    state("b1.3", transition(on("t3"), to("a"))))));
};
struct multiple_events_per_transition_test1 : Script {
    static constexpr auto machine = states::machine(state("a", transition(on("foo bar bat"), to("b"))),
                                                    state("b", transition(on("foo bar bat"), to("c"))),
                                                    state("c", transition(on("foo bar bat"), to("d"))), state("d"));
};
struct scxml_prefix_event_name_matching_star0 : Script {
    static constexpr auto machine = states::machine(
        state("a", transition(on("*"), to("b")), transition(on("foo"), to("fail"))), state("b"), state("fail"));
};
struct scxml_prefix_event_name_matching_test0 : Script {
    static constexpr auto machine = states::machine(
        state("a", transition(on("foo"), to("b"))), state("b", transition(on("foo.bar"), to("c"))),
        state("c", transition(on("foo.bar.bat"), to("d"))), state("d", transition(on("foo"), to("e"))),
        state("e", transition(on("foo.bar"), to("f"))), state("f", transition(on("foo.bar.bat"), to("g"))), state("g"));
};
struct scxml_prefix_event_name_matching_test1 : Script {
    static constexpr auto machine =
        states::machine(state("a", transition(on("foo"), to("b"))), state("b", transition(on("foo.bar"), to("c"))),
                        state("c", transition(on("foo.bar.bat"), to("d"))),
                        state("d", transition(on("foo.*"), to("e")), transition(on("foo"), to("fail"))),
                        state("e", transition(on("foo.bar.*"), to("f")), transition(on("foo.bar"), to("fail"))),
                        state("f", transition(on("foo.bar.bat.*"), to("g")), transition(on("foo.bar.bat"), to("fail"))),
                        state("g"), state("fail"));
};

std::filesystem::path data() {
    if (const char* set = std::getenv("ANSATZ_DATA")) return std::filesystem::path(set) / "scxml";
    return std::filesystem::path(project_folder()) / "../shared/data/scxml";
}

// The structure alone: what is logged, and where a machine begins if that is not said.
Outline bare(Outline o) {
    auto clean = [](std::vector<Outline::Content>& contents) {
        std::erase_if(contents, [](const auto& c) { return c.what == Outline::Content::What::log; });
    };
    for (auto& s : o.states) clean(s.entry), clean(s.exit), clean(s.initial_content);
    for (auto& t : o.transitions) clean(t.content);
    o.name.clear();
    return o;
}

template <class D> void runs(const std::string& file) {
    INFO(file);
    CHECK(bare(parse_outline(states::detail::text_of_file((data() / (file + ".scxml")).string()), file)) ==
          outline_of<D>());
    const auto script = nlohmann::json::parse(std::ifstream(data() / (file + ".json")));
    each_representation([&]<class R>() {
        Nothing nothing;
        Machine<D, R> machine;
        machine.start(nothing);
        auto expected = [](const auto& list) { return list.at(0).template get<std::string>(); };
        CHECK(machine.active_name() == expected(script.at("initialConfiguration")));
        for (const auto& step : script.at("events")) {
            machine.handle(nothing, step.at("event").at("name").template get<std::string>());
            CHECK(machine.active_name() == expected(step.at("nextConfiguration")));
        }
    });
}

} // namespace

TEST_CASE("the conformance scripts without parallel states run in every representation", "[states]") {
    if (!std::filesystem::exists(data())) SKIP("no data: the scripts are not in this checkout");
    runs<actionSend_send2>("actionSend/send2");
    runs<actionSend_send3>("actionSend/send3");
    runs<actionSend_send4>("actionSend/send4");
    runs<actionSend_send7>("actionSend/send7");
    runs<actionSend_send7b>("actionSend/send7b");
    runs<actionSend_send8>("actionSend/send8");
    runs<actionSend_send8b>("actionSend/send8b");
    runs<actionSend_send9>("actionSend/send9");
    runs<atom3_basic_tests_m0>("atom3-basic-tests/m0");
    runs<atom3_basic_tests_m1>("atom3-basic-tests/m1");
    runs<atom3_basic_tests_m2>("atom3-basic-tests/m2");
    runs<default_initial_state_initial2>("default-initial-state/initial2");
    runs<hierarchy_documentOrder_test0>("hierarchy+documentOrder/test0");
    runs<hierarchy_documentOrder_test1>("hierarchy+documentOrder/test1");
    runs<hierarchy_hier0>("hierarchy/hier0");
    runs<hierarchy_hier2>("hierarchy/hier2");
    runs<history_history1>("history/history1");
    runs<history_history2>("history/history2");
    runs<multiple_events_per_transition_test1>("multiple-events-per-transition/test1");
    runs<scxml_prefix_event_name_matching_star0>("scxml-prefix-event-name-matching/star0");
    runs<scxml_prefix_event_name_matching_test0>("scxml-prefix-event-name-matching/test0");
    runs<scxml_prefix_event_name_matching_test1>("scxml-prefix-event-name-matching/test1");
}
