// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What a section's program says about the notes, line by line, and whether it turned out to be so.
///
/// A program of the course makes claims; each is printed with its outcome, and the program fails when one does not
/// hold. So every section is a test as well.

#include "say.hpp"

#include <iostream>
#include <string>
#include <string_view>

namespace ansatz::workbook {

class Claims {
public:
    /// Prints a claim and remembers whether it holds.
    void operator()(std::string_view claim, bool holds) {
        const std::string outcome = holds ? "[holds] " : "[FAILS] ";
        std::cout << wrapped("  " + outcome + std::string(claim), outcome.size()) << '\n';
        all_ = all_ && holds;
    }
    /// The program's exit code: 0 if every claim held.
    int result() const { return all_ ? 0 : 1; }

private:
    bool all_ = true;
};

} // namespace ansatz::workbook
