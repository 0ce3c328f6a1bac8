// SPDX-License-Identifier: BSL-1.0
// The main of the programs of an exercise: one test of one subject at a time, each in a process of its own, so that a
// crash or an endless loop is an answer like any other. tools/exercises/judge.sh calls it and says it to people.
//
//   <program> list <subject> <file>           each test:  task<TAB>name<TAB>sentence; the last line is "end"
//   <program> run <subject> <name> <file>     runs one; the file says in its first line how it was, in the others why
//   <program> probe <subject> <tasks> <file>  what it computes, a line for each task
//   <program> mistake <its probes> <the solution's> <a wrong answer's>...   the wrong answers that compute the same
//
// What counts stands in a file of its own, for an answer may print what it likes and end the program with any code. It
// may write that file too, from a global object or at exit: so "passed" and "end" count only with the word after them
// which the judge has given on the standard input. It is read before any global object of an answer is made.
#include "tools/exercises/main.hpp"

#include "tools/exercises/registry.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fcntl.h>
#include <fstream>
#include <iostream>
#include <string>
#include <unistd.h>
#include <vector>

namespace {

using namespace ansatz::workbook;

enum Outcome { passed, failed, not_done_yet, threw, unfinished };
constexpr const char* words[] = {"passed", "failed", "todo", "threw", "unfinished"};
constexpr int not_written = 20; // what the program ends with where its file cannot be written

// No constructors: it is filled before any other global object is made.
char judges_word[64];
__attribute__((constructor(101))) void take_judges_word() {
    const auto length = read(STDIN_FILENO, judges_word, sizeof judges_word - 1);
    if (length > 0 && judges_word[length - 1] == '\n') judges_word[length - 1] = '\0';
    const int nothing = open("/dev/null", O_RDONLY); // who opens the input again finds nothing in it
    if (nothing < 0) std::_Exit(not_written);
    dup2(nothing, STDIN_FILENO);
    close(nothing);
}

/// A test as it was registered, and what belongs to one subject.
struct Test {
    std::string task, name, sentence;
    void (*run)();
};
struct Subject {
    std::string name;
    std::vector<Test> tests;
    std::vector<double> (*probe)(int task) = nullptr;
};
std::vector<Subject>& subjects() {
    static std::vector<Subject> all;
    return all;
}
Subject& subject_named(const std::string& name) {
    for (Subject& subject : subjects())
        if (subject.name == name) return subject;
    subjects().push_back({name, {}, nullptr});
    return subjects().back();
}

/// How the test came out, with its first failure in the words that a person reads.
struct Verdict {
    Outcome outcome = passed;
    std::string text;
};
Verdict verdict;
struct TestEnds {};

Outcome outcome_of_exception(const std::string& what) {
    return what.rfind("not done yet: task ", 0) == 0 ? not_done_yet : threw;
}

// The end of the program, before anything that an answer has left behind for it can act.
[[noreturn]] void end(bool written) {
    std::fflush(nullptr);
    std::cout.flush();
    std::_Exit(written ? 0 : not_written);
}
bool write_verdict(const std::string& file) {
    std::ofstream out(file);
    out << words[verdict.outcome];
    if (verdict.outcome == passed) out << ' ' << judges_word;
    out << '\n' << verdict.text << '\n';
    out.close();
    return bool(out);
}

std::string verdict_file;
/// An exception that left a noexcept function, or a destructor.
[[noreturn]] void terminated() {
    if (verdict.outcome != failed) {
        verdict = {threw, "std::terminate was called"};
        try {
            if (std::current_exception()) std::rethrow_exception(std::current_exception());
        } catch (const std::exception& error) {
            verdict = {outcome_of_exception(error.what()), error.what()};
        } catch (...) {
            verdict.text = "something that is no std::exception";
        }
    }
    end(write_verdict(verdict_file));
}

int list(const Subject& subject, const std::string& file) {
    std::ofstream out(file);
    for (const Test& test : subject.tests) out << test.task << '\t' << test.name << '\t' << test.sentence << '\n';
    out << "end " << judges_word << '\n';
    out.close();
    end(bool(out));
}

int run(const Subject& subject, const std::string& name, const std::string& file) {
    verdict_file = file;
    std::set_terminate(terminated);
    const Test* the_one = nullptr;
    int of_this_name = 0;
    for (const Test& test : subject.tests)
        if (test.name == name) the_one = &test, ++of_this_name;
    verdict.outcome = unfinished; // what the file says should the process end before the test
    if (!write_verdict(file)) return not_written;
    verdict = {};
    if (of_this_name != 1) {
        verdict = {failed, "there is not one test of this name"};
    } else {
        try {
            the_one->run();
        } catch (const TestEnds&) {
        } catch (const std::exception& error) {
            if (verdict.outcome == passed) verdict = {outcome_of_exception(error.what()), error.what()};
        } catch (...) {
            if (verdict.outcome == passed) verdict = {threw, "something that is no std::exception"};
        }
    }
    end(write_verdict(file));
}

int write_probes(const Subject& subject, int tasks, const std::string& file) {
    std::FILE* out = std::fopen(file.c_str(), "w");
    if (out == nullptr || subject.probe == nullptr) return 2;
    for (int task = 1; task <= tasks; ++task) {
        std::string line = std::to_string(task);
        try {
            char number[40];
            for (const double x : subject.probe(task)) {
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
    end(true);
}

int mistake(const std::vector<std::string>& files) {
    const Probes mine = read_probes(files[0]), solution = read_probes(files[1]);
    for (std::size_t i = 2; i < files.size(); ++i)
        if (same_mistake(mine, solution, read_probes(files[i]))) std::cout << files[i] << '\n';
    return 0;
}

} // namespace

namespace ansatz::workbook {

RegisteredTest::RegisteredTest(const char* subject, const char* sentence, const char* tags, void (*run)()) {
    Test test{"", "", sentence, run};
    const std::string all(tags);
    for (std::size_t i = 0, close; i < all.size() && (close = all.find(']', i)) != std::string::npos; i = close + 1) {
        const std::string tag = all.substr(i + 1, close - i - 1);
        if (tag.rfind("task-", 0) == 0) test.task = tag.substr(5);
        else test.name = tag;
    }
    subject_named(subject).tests.push_back(test);
}

RegisteredProbe::RegisteredProbe(const char* subject, std::vector<double> (*probe)(int task)) {
    subject_named(subject).probe = probe;
}

void fail(const std::string& text) {
    if (verdict.outcome == passed) verdict = {failed, text};
    throw TestEnds();
}

} // namespace ansatz::workbook

int main(int argc, char* argv[]) {
    // The judge waits no longer than this.
    if (const char* seconds = std::getenv("ANSATZ_SECONDS")) alarm(static_cast<unsigned>(std::atoi(seconds)));
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    const std::size_t n = arguments.size();
    if (n >= 3 && arguments[0] == "mistake") return mistake({arguments.begin() + 1, arguments.end()});
    if (n >= 2) {
        const Subject& subject = subject_named(arguments[1]);
        if (n == 3 && arguments[0] == "list") return list(subject, arguments[2]);
        if (n == 4 && arguments[0] == "run") return run(subject, arguments[2], arguments[3]);
        if (n == 4 && arguments[0] == "probe")
            return write_probes(subject, std::atoi(arguments[2].c_str()), arguments[3]);
    }
    std::cerr << "usage: list <subject> <file> | run <subject> <test> <file> | probe <subject> <tasks> <file> |\n"
                 "       mistake <probes> <solution's> <wrong answer's>...\n";
    return 2;
}
