// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The sections of a chapter in one program (chapters/CMakeLists.txt): each in a namespace of its own, under its
/// number.

#include <string>
#include <string_view>
#include <vector>

namespace ansatz::workbook {

/// What a section's `main` may be.
struct Section {
    std::string number;                  ///< e.g. 7.2.1
    int (*plain)() = nullptr;            ///< without words of the command line
    int (*asked)(int, char**) = nullptr; ///< with them; the first is the number

    /// \param place of its source, e.g. chapters/7-water/7.2.1-courant_limit.cpp
    Section(std::string_view place, int (*run)()) : number(number_of(place)), plain(run) { all().push_back(*this); }
    /// The same, of one that takes words.
    Section(std::string_view place, int (*run)(int, char**)) : number(number_of(place)), asked(run) {
        all().push_back(*this);
    }
    /// Of this program.
    static std::vector<Section>& all() {
        static std::vector<Section> sections;
        return sections;
    }

private:
    static std::string number_of(std::string_view place) {
        place.remove_prefix(place.rfind('/') + 1);
        return std::string(place.substr(0, place.find('-')));
    }
};

} // namespace ansatz::workbook
