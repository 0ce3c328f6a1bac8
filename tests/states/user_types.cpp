// SPDX-License-Identifier: BSL-1.0
// What a user brings into a machine, in every representation: classes of states of any type, members as guards and
// actions.

#include <ansatz/states/describe.hpp>
#include <ansatz/states/machine.hpp>

#include "tests/states/support.hpp"

#include <map>
#include <string>

using namespace states_tests;

namespace {

struct Reader {
    bool armed = true;
};
/// A class that is no literal type and lies on the heap.
struct Diary {
    std::map<std::string, int> days{};
    std::string title = "longer than what a string keeps inside itself";
    int exit = 0; // no function
    void update(Reader&) { ++days["day " + std::to_string(days.size())]; }
};
struct Writes {
    using Context = Reader;
    static constexpr auto machine = states::machine(
        state("write", behaves<Diary>("Diary"),
              transition(on("stop"), when([](const Reader& l) { return l.armed; }), to("read")),
              transition(when([](const Reader&, const Diary& d) { return d.days.size() == 2; }), to("read"))),
        state("read"));
};
struct Oven {
    bool warm = false;
    int rung = 0;
    bool ready() const { return warm; }
    void ring() { ++rung; }
};
struct Bakes {
    using Context = Oven;
    static constexpr auto machine = states::machine(
        state("wait", transition(when(&Oven::ready), to("bake"))),
        state("bake", on_entry(&Oven::ring), transition(when(&Oven::warm), then(&Oven::ring), to("wait"))));
};

} // namespace

TEST_CASE("a state's class may be of any type, and guards and actions may be members of the context", "[states]") {
    each_representation([]<class R>() {
        Reader reader;
        Machine<Writes, R> m;
        m.start(reader);
        CHECK_FALSE(m.update(reader, frame));
        CHECK_FALSE(m.update(reader, frame));
        CHECK(m.template own<Diary>(m.state("write")).days.size() == 2);
        CHECK(m.update(reader, frame));
        CHECK(m.is_in("read"));

        Oven oven;
        Machine<Bakes, R> bakes;
        bakes.start(oven);
        CHECK_FALSE(bakes.update(oven, frame));
        oven.warm = true;
        CHECK(bakes.update(oven, frame));
        CHECK(bakes.update(oven, frame));
        CHECK(oven.rung == 2);
        CHECK(bakes.is_in("wait"));
    });
}
