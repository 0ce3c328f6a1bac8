// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The line without which a table of times says nothing: what they were taken on.

#include <sys/utsname.h>

#include <ctime>
#include <fstream>
#include <string>
#include <thread>

namespace ansatz::workbook {

struct Machine {
    std::string cpu, system, compiler, flags, date;
    unsigned cores = 0;
    int repeats = 0;
};

/// What the compiler tells about the flags of the file that includes this. CMake hands over the real
/// ones in ANSATZ_FLAGS; without it, those that matter most for time are recognised by their marks.
inline std::string compile_flags() {
#if defined(ANSATZ_FLAGS)
    return ANSATZ_FLAGS;
#else
    std::string flags;
#if defined(__OPTIMIZE__)
    flags += "optimised";
#else
    flags += "NOT optimised";
#endif
#if defined(__AVX512F__)
    flags += ", AVX-512";
#elif defined(__AVX2__)
    flags += ", AVX2";
#elif defined(__AVX__)
    flags += ", AVX";
#elif defined(__SSE2__)
    flags += ", SSE2";
#endif
#if defined(__FAST_MATH__)
    flags += ", fast math";
#endif
#if !defined(NDEBUG)
    flags += ", assertions on";
#endif
    return flags;
#endif
}

inline std::string compiler_name() {
#if defined(__clang__)
    return "clang++ " __clang_version__;
#elif defined(__GNUC__)
    return "g++ " __VERSION__;
#else
    return "unknown";
#endif
}

inline Machine this_machine() {
    Machine machine;
    machine.cpu = "unknown";
    std::ifstream cpuinfo{"/proc/cpuinfo"};
    for (std::string line; std::getline(cpuinfo, line);) {
        if (line.rfind("model name", 0) != 0) continue;
        const auto colon = line.find(": ");
        if (colon != std::string::npos) machine.cpu = line.substr(colon + 2);
        break;
    }
    machine.cores = std::thread::hardware_concurrency();
    if (utsname names{}; uname(&names) == 0)
        machine.system = std::string{names.sysname} + " " + names.release + " " + names.machine;
    machine.compiler = compiler_name();
    machine.flags = compile_flags();
    const std::time_t now = std::time(nullptr);
    char text[32] = "";
    if (std::tm utc{}; gmtime_r(&now, &utc) != nullptr) std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
    machine.date = text;
    return machine;
}

} // namespace ansatz::workbook
