// SPDX-License-Identifier: BSL-1.0
// Events that nobody handles: what the refusal says.

#include "tests/states/support.hpp"

using namespace states_tests;

namespace {

struct Nobody {};
struct Door {
    using Context = Nobody;
    static constexpr auto machine = states::machine(state("shut", transition(on("push hit.hard"), to("open"))),
                                                    state("open", transition(on("pull"), to("shut"))));
};

} // namespace

TEST_CASE("a machine that refuses names the event as it was given, also one that it has never heard of", "[states]") {
    each_representation([]<class R>() {
        Nobody nobody;
        Machine<Door, R, RefuseUnhandled> m;
        CHECK_THAT(refusal([&] { m.handle(nobody, "bogus"); }), ContainsSubstring("call start(context)"));
        m.start(nobody);
        const auto said = [&](auto event) { return refusal([&] { m.handle(nobody, event); }); };
        CHECK_THAT(said("bogus"), ContainsSubstring("nobody handles the event \"bogus\" in the state \"shut\""));
        CHECK_THAT(said("pull"), ContainsSubstring("the event \"pull\" in"));
        CHECK_THAT(said("pull.gently"),
                   ContainsSubstring("the event \"pull.gently\" in")); // read as pull, which it begins with
        CHECK_THAT(said("hit"), ContainsSubstring("the event \"hit\" in"));
        CHECK_THAT(said(""), ContainsSubstring("the event \"\" in"));
        CHECK_THAT(said("*"), ContainsSubstring("the event \"*\" in"));
        CHECK_THAT(said(m.event("pull")), ContainsSubstring("the event \"pull\" in"));
        // A number without a name: that of any other event, and one that is no event of this machine.
        CHECK_THAT(said(m.event("bogus")),
                   ContainsSubstring("an event that no transition of the machine names, in the state \"shut\""));
        CHECK_THAT(said(EventId(999)),
                   ContainsSubstring("an event that no transition of the machine names, in the state \"shut\""));
        CHECK_THAT(said(EventId::none),
                   ContainsSubstring("an event that no transition of the machine names, in the state \"shut\""));
        CHECK(m.is_in("shut")); // as it was
        CHECK(m.handle(nobody, "hit.hard.twice"));
        CHECK(m.is_in("open"));
    });
}
