// SPDX-License-Identifier: BSL-1.0
// Runs the section of the number that is the first word: sections_water 7.2.1.
#include "tools/sections.hpp"

#include <cstdio>
#include <string_view>

int main(int count, char** words) {
    const bool asked = count > 2 && std::string_view(words[1]) == "--has"; // whether it is here
    const std::string_view number = count > 1 ? words[asked ? 2 : 1] : "";
    for (const auto& section : ansatz::workbook::Section::all())
        if (section.number == number)
            return asked ? 0 : section.plain ? section.plain() : section.asked(count - 1, words + 1);
    if (asked) return 1;
    std::fprintf(stderr, "usage: %s <number of a section>; here are", words[0]);
    for (const auto& section : ansatz::workbook::Section::all()) std::fprintf(stderr, " %s", section.number.c_str());
    std::fprintf(stderr, "\n");
    return 2;
}
