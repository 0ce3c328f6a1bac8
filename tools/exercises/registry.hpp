// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// How the tests of an exercise come to its main: what test.cpp makes, and main.cpp keeps.

#include <string>
#include <vector>

namespace ansatz::workbook {

/// One test of one subject, made by TEST_CASE.
struct RegisteredTest {
    RegisteredTest(const char* subject, const char* sentence, const char* tags, void (*test)());
};
/// What one subject computes for inputs that tell the wrong answers apart: the function `probe` of test.cpp. Equal
/// numbers name the mistake that a student made.
struct RegisteredProbe {
    RegisteredProbe(const char* subject, std::vector<double> (*probe)(int task));
};

/// Ends the test, which has failed, with a text of one or more lines.
[[noreturn]] void fail(const std::string& text);

} // namespace ansatz::workbook

/// A test of an exercise: TEST_CASE("the position moves with the old velocity", "[task-1][old-velocity]") { ... }.
/// Whose it is says `tested_subject`, which is the nearest one of this name.
#define ANSATZ_TEST_NAMED(name, ...)                                                                                   \
    static void name();                                                                                                \
    static const ansatz::workbook::RegisteredTest registered_##name(tested_subject, __VA_ARGS__, &name);               \
    static void name()
#define ANSATZ_TEST_AT(line, ...) ANSATZ_TEST_NAMED(test_of_line_##line, __VA_ARGS__)
#define ANSATZ_TEST(line, ...) ANSATZ_TEST_AT(line, __VA_ARGS__)
#define TEST_CASE(...) ANSATZ_TEST(__LINE__, __VA_ARGS__)
