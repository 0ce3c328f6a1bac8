// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `isolated`: a measure in a process of its own. An engine that ends its program, or never comes to an end, is an
/// outcome of the row and not the end of the table; and what an engine keeps in globals is new each time.

#include "tests/peers/cases/engine.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <exception>
#include <functional>
#include <string>

namespace peers {

/// A number, or why there is none.
struct Outcome {
    bool measured = false, cannot = false;
    double value = 0;
    std::string why;
};

inline Outcome isolated(const std::function<double()>& measure, unsigned seconds = 300) {
    struct Message {
        int kind = 0; // 0 measured, 1 cannot, 2 an exception
        double value = 0;
        char why[200] = {};
    };
    int ends[2];
    if (pipe(ends) != 0) return {false, false, 0, "no pipe"};
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        const rlimit time{seconds, seconds + 1}, none{0, 0};
        setrlimit(RLIMIT_CPU, &time);
        setrlimit(RLIMIT_CORE, &none);
        Message said;
        try {
            said.value = measure();
        } catch (const Cannot& reason) {
            said.kind = 1;
            std::strncpy(said.why, reason.what(), sizeof said.why - 1);
        } catch (const std::exception& error) {
            said.kind = 2;
            std::strncpy(said.why, error.what(), sizeof said.why - 1);
        }
        const bool told = write(ends[1], &said, sizeof said) == ssize_t(sizeof said);
        _exit(told ? 0 : 1);
    }
    close(ends[1]);
    Message said;
    const bool told = child > 0 && read(ends[0], &said, sizeof said) == ssize_t(sizeof said);
    close(ends[0]);
    int status = 0;
    if (child > 0) waitpid(child, &status, 0);
    if (told) return {said.kind == 0, said.kind == 1, said.value, said.why};
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
        return {false, false, 0, "not ready after " + std::to_string(seconds) + " s"};
    return {false, false, 0, "it ended the program"};
}

} // namespace peers
