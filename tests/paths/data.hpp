// SPDX-License-Identifier: BSL-1.0
#pragma once

// Where the benchmarks' files are.

#include "tests/project.hpp"

#include <cstdlib>
#include <filesystem>
#include <string>

namespace paths_tests {

/// The folder of the benchmarks; empty where there is none.
inline std::string data_folder() {
    namespace fs = std::filesystem;
    if (const char* named = std::getenv("ANSATZ_TEST_DATA")) return fs::exists(named) ? named : "";
    const fs::path beside = fs::path(project_folder()) / "../shared/data";
    return fs::exists(beside) ? beside.lexically_normal().string() : "";
}

} // namespace paths_tests
