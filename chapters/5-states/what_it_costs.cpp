// SPDX-License-Identifier: BSL-1.0
// What a machine costs: an event in every representation, the compiler's time for it, and what a band of hysteresis
// lets through

// Three axes:
//
// - representation: nanoseconds an event against the number of states, beside the same machine by hand and in
//   Boost.Statechart. In the place of the error stands after how many of 4096 events the machine was in a wrong state:
//   none. Events are random, so that the processor cannot learn the way through the machine; a game's are kinder.
//   Actions differ from transition to transition, so that a compiler cannot make one of all. Without actions it turns a
//   switch by hand into a table of numbers: that is what Switch and Table are measured against.
// - compile time: what the compiler takes for so many states, and how large its code is. No program can measure how it
//   was compiled: this one writes a source a row and calls its own compiler on it once. CPU time with -O2, and in the
//   place of the work the bytes of code, as the command `size` tells them.
// - hysteresis: what_it_costs-hysteresis.cpp

#include "what_it_costs.hpp"

#include "compared_machines.hpp"
#include "plot.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iomanip>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

using namespace ansatz;
using namespace compared;
using workbook::Axis;
using workbook::Costs;
using workbook::Outcome;
using workbook::Row;
using workbook::Rows;

namespace {

// ---------------------------------------------------------------- an event
constexpr int sample = 4096;
const Axis an_event{.name = "representation",
                    .error_norm = "events after which the state is wrong",
                    .work_unit = "transitions",
                    .time_unit = "ns an event",
                    .has_order = false};
const std::string moves = "changes of state alone", acts = "with an action on every transition";

const std::vector<int>& random_events() {
    static const std::vector<int> all = [] {
        std::mt19937 random(2026);
        std::vector<int> list;
        for (int i = 0; i < sample; ++i) list.push_back(int(random() % events));
        return list;
    }();
    return all;
}

/// The machine beside the formula that it was made from.
template <class M> Outcome check(int n) {
    const auto machine = std::make_unique<M>();
    Tally tally;
    int state = 0, wrong = 0, taken = 0;
    for (const int event : random_events()) {
        const bool handled = machine->handle(tally, event), should = answers(state, event);
        if (should) state = next(state, event, n), ++taken;
        wrong += handled != should || machine->state() != state;
    }
    return {.error = double(wrong), .work = double(taken)};
}

template <class M> void add_row(Costs& costs, const std::string& problem, const char* choice, int n) {
    costs.add(an_event, {.choice = choice,
                         .problem = problem,
                         .parameter = {"states", double(n)},
                         .n = n,
                         .error_run = [n] { return check<M>(n); },
                         .timed_run =
                             [machine = std::make_shared<M>(), tally = std::make_shared<Tally>()] {
                                 for (const int event : random_events()) machine->handle(*tally, event);
                                 return tally->sum + std::uint32_t(machine->state());
                             },
                         .per = double(sample)});
}
template <int N, bool Acts> void add_rows(Costs& costs, const std::string& problem) {
    if constexpr (N == 10) add_row<HandSwitch<Acts>>(costs, problem, "switch by hand", N);
    add_row<Library<N, Acts, Switch>>(costs, problem, "Switch", N);
    add_row<Library<N, Acts, Table>>(costs, problem, "Table", N);
    if constexpr (Acts) { // for the others an action makes little difference
        if constexpr (N == 10) add_row<HandClasses<Acts>>(costs, problem, "virtual calls by hand", N);
        add_row<Library<N, Acts, StatePattern>>(costs, problem, "StatePattern", N);
        add_row<Library<N, Acts, Interpreted>>(costs, problem, "Interpreted", N);
        add_row<Statechart<N, Acts>>(costs, problem, "Boost.Statechart", N);
    }
}

/// How many times the hand-written machine each takes, with ten states; and the picture against their number.
void summarise(std::ostream& out, const Rows& all, const std::filesystem::path& folder) {
    std::map<std::string, std::map<std::string, double>> time; // of ten states: problem, choice
    for (const Row& row : all)
        if (row.axis == an_event.name && row.time && *row.n == 10) time[row.problem][row.choice] = *row.time;
    if (time.empty()) return;
    out << "\nTen states, 45 transitions: how many times the machine by hand each takes\n";
    const std::vector<std::pair<std::string, std::string>> pairs{{"Switch", "switch by hand"},
                                                                 {"Table", "switch by hand"},
                                                                 {"Interpreted", "switch by hand"},
                                                                 {"StatePattern", "virtual calls by hand"}};
    for (auto& [problem, of] : time) {
        out << "  " << problem << '\n';
        for (const auto& [choice, by_hand] : pairs)
            if (of.count(choice) && of.count(by_hand))
                out << "    " << std::left << std::setw(14) << choice << std::right << std::fixed
                    << std::setprecision(2) << std::setw(7) << of[choice] / of[by_hand] << " times the " << by_hand
                    << '\n';
    }
    out << std::defaultfloat << std::setprecision(6);

    const Rows rows = workbook::where(all, &Row::problem, acts);
    workbook::Plot plot("", "An event with an action in each representation, against the number of states");
    plot.x("states").y("ns an event").log_y();
    for (const auto& choice : workbook::different(rows, &Row::choice)) {
        std::vector<double> n, ns;
        for (const Row& row : workbook::where(rows, &Row::choice, choice))
            if (row.time) n.push_back(*row.n), ns.push_back(*row.time);
        if (n.size() > 1) plot.linked_points(choice, n, ns);
        else if (n.size() == 1) plot.points(choice, n, ns);
    }
    workbook::draw(folder / "states-event-against-states.svg", plot.script());
}
void add_events(Costs& costs) {
    add_rows<10, false>(costs, moves);
    add_rows<5, true>(costs, acts);
    add_rows<10, true>(costs, acts);
    add_rows<20, true>(costs, acts);
    costs.add_summary(summarise);
}

// ---------------------------------------------------------------- the compiler
const Axis compile_time{.name = "compile time",
                        .error_norm = "CPU seconds of the compiler",
                        .work_unit = "bytes of code",
                        .has_order = false};

std::string number(int i) { return std::to_string(i); }
/// What is written for each transition: state, event, next state; and what stands around the transitions of a state.
std::string each(int n, const std::function<std::string(int)>& before,
                 const std::function<std::string(int, int, int, bool)>& transition, const std::string& after) {
    std::string text;
    for (int s = 0; s < n; ++s) {
        text += before(s);
        bool first = true;
        for (int e = 0; e < events; ++e)
            if (answers(s, e)) text += transition(s, e, next(s, e, n), first), first = false;
        text += after;
    }
    return text;
}
const std::string context = "struct Tally { unsigned sum = 0; };\ntemplate <int S, int E> inline void act(Tally& t) { "
                            "t.sum = 3 * t.sum + S * 5 + E; }\n";

std::string by_switch(int n) {
    return context + "int handle(Tally& t, int state, int event) {\n    switch (state) {\n" +
           each(
               n, [](int s) { return "        case " + number(s) + ": switch (event) {\n"; },
               [](int s, int e, int to, bool) {
                   return "            case " + number(e) + ": act<" + number(s) + ", " + number(e) + ">(t); return " +
                          number(to) + ";\n";
               },
               "        } break;\n") +
           "    }\n    return state;\n}\nint main(int argc, char**) { Tally t; return handle(t, argc, argc) + "
           "int(t.sum); }\n";
}
std::string by_classes(int n) {
    return context + "struct State { virtual int handle(Tally&, int) const = 0; };\n" +
           each(
               n,
               [](int s) {
                   return "struct S" + number(s) +
                          " final : State { int handle(Tally& t, int event) const override { switch (event) {\n";
               },
               [](int s, int e, int to, bool) {
                   return "    case " + number(e) + ": act<" + number(s) + ", " + number(e) + ">(t); return " +
                          number(to) + ";\n";
               },
               "    } return -1; } };\n") +
           "int main(int argc, char**) {\n    Tally t;\n" +
           each(
               n, [](int s) { return "    static const S" + number(s) + " s" + number(s) + ";\n"; },
               [](int, int, int, bool) { return std::string(); }, "") +
           "    const State* all[] = {" +
           each(
               n, [](int s) { return "&s" + number(s) + ", "; }, [](int, int, int, bool) { return std::string(); },
               "") +
           "};\n    return all[argc]->handle(t, argc) + int(t.sum);\n}\n";
}
std::string by_library(int n, const std::string& representation) {
    return "#include <ansatz/states.hpp>\n" + context +
           "using namespace ansatz::states;\nstruct Described {\n    using Context = Tally;\n    static constexpr auto "
           "machine = ansatz::states::machine(\n" +
           each(
               n, [](int s) { return std::string(s == 0 ? "" : ",\n") + "        state(\"s" + number(s) + "\""; },
               [](int s, int e, int to, bool) {
                   return ",\n            transition(on(\"e" + number(e) + "\"), then(act<" + number(s) + ", " +
                          number(e) + ">), ansatz::states::to(\"s" + number(to) + "\"))";
               },
               ")") +
           ");\n};\nint main(int argc, char**) {\n    Tally t;\n    ansatz::Machine<Described, ansatz::" +
           representation +
           "> machine;\n    machine.start(t);\n    machine.handle(t, ansatz::EventId(argc));\n    return "
           "int(t.sum);\n}\n";
}
const std::string headers_of_statechart =
    "#include <boost/mpl/list.hpp>\n#include <boost/statechart/simple_state.hpp>\n#include "
    "<boost/statechart/state_machine.hpp>\n#include <boost/statechart/transition.hpp>\n";
std::string by_statechart(int n) {
    std::string text = headers_of_statechart + context +
                       "namespace sc = boost::statechart;\ntemplate <int E> struct Event : sc::event<Event<E>> {};\n";
    text += each(
        n, [](int s) { return "struct S" + number(s) + ";\n"; }, [](int, int, int, bool) { return std::string(); }, "");
    text += "struct Machine : sc::state_machine<Machine, S0> {\n    Tally t;\n    template <int S, int E> void "
            "took(const Event<E>&) { act<S, E>(t); }\n};\n";
    text += each(
        n,
        [](int s) {
            return "struct S" + number(s) + " : sc::simple_state<S" + number(s) +
                   ", Machine> {\n    using reactions = boost::mpl::list<";
        },
        [](int s, int e, int to, bool first) {
            return std::string(first ? "" : ", ") + "sc::transition<Event<" + number(e) + ">, S" + number(to) +
                   ", Machine, &Machine::took<" + number(s) + ", " + number(e) + ">>";
        },
        ">;\n};\n");
    return text + "int main() {\n    Machine machine;\n    machine.initiate();\n    "
                  "machine.process_event(Event<0>());\n    return int(machine.t.sum);\n}\n";
}

double seconds_of_children() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    return double(usage.ru_utime.tv_sec) + 1e-6 * double(usage.ru_utime.tv_usec);
}
/// Bytes of code in an object, if there is a command that tells.
workbook::Number code_of(const std::string& object) {
    workbook::Number bytes;
    if (FILE* out = popen(("size " + object + " 2> /dev/null").c_str(), "r")) {
        char line[200];
        double text = 0;
        if (std::fgets(line, sizeof line, out) && std::fgets(line, sizeof line, out) &&
            std::sscanf(line, "%lf", &text) == 1)
            bytes = text;
        pclose(out);
    }
    return bytes;
}
/// Compiles a source.
Outcome compile(const std::string& source) {
    const auto folder = std::filesystem::temp_directory_path() /
                        ("ansatz-compile-" + std::to_string(::getpid())); // others may measure beside this program
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "machine.cpp") << source;
    const std::string object = (folder / "machine.o").string();
    const double before = seconds_of_children();
    const bool compiled = std::system((std::string(ANSATZ_COMPILE) + " -O2 -c " + (folder / "machine.cpp").string() +
                                       " -o " + object + " 2> " + (folder / "said").string())
                                          .c_str()) == 0;
    const double seconds = seconds_of_children() - before;
    Outcome outcome{.error = seconds, .diverged = !compiled}; // what does not compile is shown as such, never left out
    if (compiled) outcome.work = code_of(object);
    std::filesystem::remove_all(folder);
    return outcome;
}

void picture_of_compiling(std::ostream&, const Rows& all, const std::filesystem::path& folder) {
    const Rows rows = workbook::where(all, &Row::axis, compile_time.name);
    if (rows.empty()) return;
    workbook::Plot plot("", "What the compiler takes for a machine, with its headers");
    plot.x("states").y("CPU seconds of the compiler");
    for (const auto& choice : workbook::different(rows, &Row::choice)) {
        std::vector<double> n, seconds;
        for (const Row& row : workbook::where(rows, &Row::choice, choice))
            if (row.error) n.push_back(*row.n), seconds.push_back(*row.error);
        if (n.size() > 1) plot.linked_points(choice, n, seconds);
    }
    workbook::draw(folder / "states-compile-time-against-states.svg", plot.script());
}
void add_compile_time(Costs& costs) {
    const auto add = [&](const std::string& choice, int n, const std::string& source) {
        costs.add(compile_time, {.choice = choice,
                                 .problem = "an action on every transition",
                                 .parameter = {"states", double(n)},
                                 .n = n,
                                 .error_run = [source] { return compile(source); }});
    };
    add("the headers of Ansatz", 0, "#include <ansatz/states.hpp>\nint main() {}\n");
    add("the headers of Boost.Statechart", 0, headers_of_statechart + "int main() {}\n");
    const int sizes[] = {10, 20, 40};
    for (const int n : sizes) add("switch by hand", n, by_switch(n));
    for (const int n : sizes) add("virtual calls by hand", n, by_classes(n));
    for (const char* representation : {"Switch", "StatePattern", "Table", "Interpreted"})
        for (const int n : sizes) add(representation, n, by_library(n, representation));
    for (const int n : sizes) add("Boost.Statechart", n, by_statechart(n));
    costs.add_summary(picture_of_compiling);
}

} // namespace

int main(int argc, char** argv) {
    Costs costs("states", argc, argv);
    add_events(costs);
    add_compile_time(costs);
    state_costs::add_hysteresis(costs);
    return costs.run();
}
