// SPDX-License-Identifier: BSL-1.0
// The main of every subject of an exercise: one test at a time, each in a process of its own, so that a crash or an
// endless loop is an answer like any other. tools/exercises/judge.sh calls it and says it to people.
//
//   <program> list <file>                 each test:  task<TAB>name<TAB>sentence; the last line is "end"
//   <program> run <name> <file>           runs one; the file says in its first line how it was, in the others why
//   <program> probe <tasks> <file>        what it computes, a line for each task
//   <program> mistake <its probes> <the solution's> <a wrong answer's>...   the wrong answers that compute the same
//
// What counts stands in a file of its own, for an answer may print what it likes and end the program with any code.
#define CATCH_CONFIG_RUNNER
#include "tests/catch.hpp"
#include "tools/exercises/main.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace ansatz::workbook {
std::vector<double> probe(int task);
}

namespace {

using namespace ansatz::workbook;

enum Outcome { passed, failed, not_done_yet, threw, unfinished };
constexpr const char* words[] = {"passed", "failed", "todo", "threw", "unfinished"};
constexpr int not_written = 20; // what the program ends with where its file cannot be written

/// The first failure of the test, in the words that a person reads.
struct Verdict {
    Outcome outcome = passed;
    std::string text;
};
Verdict verdict;
std::string verdict_file;
int tests_run_to_their_end = 0;

Outcome outcome_of_exception(const std::string& what) {
    return what.rfind("not done yet: task ", 0) == 0 ? not_done_yet : threw;
}

struct Listener : ListenerBase {
    using ListenerBase::ListenerBase;
    bool assertion(const Catch::AssertionStats& stats) {
        const auto& result = stats.assertionResult;
        if (result.isOk() || verdict.outcome != passed) return true;
        verdict.outcome = failed;
        if (result.getResultType() == Catch::ResultWas::ThrewException) verdict.outcome = outcome_of_exception(text_of(result.getMessage()));
        verdict.text = text_of(result.getMessage());
        if (verdict.text.empty() || (result.hasExpression() && verdict.outcome == failed))
            verdict.text = result.getExpression() + "\n    yours  " + result.getExpandedExpression();
        for (const auto& info : stats.infoMessages)
            if (info.type == Catch::ResultWas::Info) verdict.text += "\n" + info.message;
        return true;
    }
    void testCaseEnded(const Catch::TestCaseStats&) override { ++tests_run_to_their_end; }
#ifdef ANSATZ_CATCH_3
    void assertionEnded(const Catch::AssertionStats& stats) override { assertion(stats); }
#else
    bool assertionEnded(const Catch::AssertionStats& stats) override { return assertion(stats); }
#endif
};
CATCH_REGISTER_LISTENER(Listener)

bool write_verdict() {
    std::ofstream out(verdict_file);
    out << words[verdict.outcome] << '\n' << verdict.text << '\n';
    out.close();
    return bool(out);
}

/// An exception that left a noexcept function, or a destructor.
[[noreturn]] void terminated() {
    verdict = {threw, "std::terminate was called"};
    try {
        if (std::current_exception()) std::rethrow_exception(std::current_exception());
    } catch (const std::exception& error) {
        verdict = {outcome_of_exception(error.what()), error.what()};
    } catch (...) {
        verdict.text = "something that is no std::exception";
    }
    std::_Exit(write_verdict() ? 0 : not_written);
}

int list(const std::string& file) {
    std::ofstream out(file);
    for (const auto& test : all_tests()) {
        std::string task, name;
        for (const std::string& tag : test.tags)
            if (tag.rfind("task-", 0) == 0)
                task = tag.substr(5);
            else
                name = tag;
        out << task << '\t' << name << '\t' << test.sentence << '\n';
    }
    out << "end\n";
    out.close();
    return out ? 0 : not_written;
}

int run(const std::string& name, const std::string& file) {
    verdict_file = file;
    std::set_terminate(terminated);
    const std::string tag = "[" + name + "]";
    const char* arguments[] = {"subject", tag.c_str(), "--out", "/dev/null", "--abort"};
    verdict.outcome = unfinished; // what the file says should the process end before the test
    if (!write_verdict()) return not_written;
    verdict = {};
    const int failures = Catch::Session().run(5, arguments);
    if (verdict.outcome == passed && tests_run_to_their_end != 1) verdict = {failed, "there is not one test of this name"};
    if (verdict.outcome == passed && failures != 0) verdict = {failed, "a check failed"};
    return write_verdict() ? 0 : not_written;
}

int write_probes(int tasks, const std::string& file) {
    std::FILE* out = std::fopen(file.c_str(), "w");
    if (out == nullptr) return 2;
    for (int task = 1; task <= tasks; ++task) {
        std::string line = std::to_string(task);
        try {
            char number[40];
            for (const double x : probe(task)) {
                std::snprintf(number, sizeof number, " %a", x);
                line += number;
            }
        } catch (...) {
            line = std::to_string(task) + " threw";
        }
        std::fprintf(out, "%s\n", line.c_str());
        std::fflush(out); // should the next task crash, this one's numbers are there
    }
    std::fclose(out);
    return 0;
}

int mistake(const std::vector<std::string>& files) {
    const Probes mine = read_probes(files[0]), solution = read_probes(files[1]);
    for (std::size_t i = 2; i < files.size(); ++i)
        if (same_mistake(mine, solution, read_probes(files[i]))) std::cout << files[i] << '\n';
    return 0;
}

} // namespace

int main(int argc, char* argv[]) {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    const std::size_t n = arguments.size();
    if (n == 2 && arguments[0] == "list") return list(arguments[1]);
    if (n == 3 && arguments[0] == "run") return run(arguments[1], arguments[2]);
    if (n == 3 && arguments[0] == "probe") return write_probes(std::atoi(arguments[1].c_str()), arguments[2]);
    if (n >= 3 && arguments[0] == "mistake") return mistake({arguments.begin() + 1, arguments.end()});
    std::cerr << "usage: list <file> | run <test> <file> | probe <tasks> <file> | mistake <probes> <solution's> <wrong answer's>...\n";
    return 2;
}
