// SPDX-License-Identifier: BSL-1.0
// Where a test may write.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

namespace ansatz::test {

/// A path in the machine's folder for temporary files that no other test has: tests run beside each other, each in a
/// process of its own, and one process may ask more than once.
inline std::filesystem::path scratch_path(const std::string& name) {
    static int asked = 0;
    return std::filesystem::temp_directory_path() /
           ("ansatz-" + name + "-" + std::to_string(::getpid()) + "-" + std::to_string(++asked));
}

} // namespace ansatz::test
