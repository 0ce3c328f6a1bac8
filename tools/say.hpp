// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The sentences of a section's program, wrapped at words: no line is wider than a terminal, however long the numbers
/// are.

#include "width.hpp"

#include <cctype>
#include <cstddef>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace ansatz::workbook {

namespace detail {

/// Whether a line may end at the blank `at`: not between a number or a vector and its unit, within a vector, nor beside
/// an operator. `open` brackets are not closed yet.
inline bool may_end(std::string_view line, std::size_t at, int open) {
    const auto is_operator = [](std::string_view word) {
        return word.size() == 1 && std::string_view("=+-*/").find(word[0]) != std::string_view::npos;
    };
    const std::string_view before = line.substr(0, at), after = line.substr(at + 1);
    if (is_operator(before.substr(before.rfind(' ') + 1)) || is_operator(after.substr(0, after.find(' '))))
        return false;
    if (after.substr(0, 1) == "(") return true;
    std::size_t last = at;
    while (last > 0 && (line[last - 1] == ')' || (line[last - 1] == ',' && open > 0))) --last;
    return last == 0 || !std::isdigit(static_cast<unsigned char>(line[last - 1]));
}

/// What a line must not end within.
inline std::vector<std::string_view> pieces(std::string_view line) {
    std::vector<std::string_view> all;
    std::size_t begin = 0;
    int open = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '(') ++open;
        if (line[i] == ')') --open;
        if (line[i] != ' ' || i == begin || !may_end(line, i, open)) continue;
        all.push_back(line.substr(begin, i - begin));
        begin = i + 1;
    }
    all.push_back(line.substr(begin));
    return all;
}

/// One line, as lines of at most terminal_width.
inline std::string wrapped_line(std::string_view line, std::size_t hang) {
    const std::size_t blanks = line.find_first_not_of(' ');
    if (visible_width(line) <= terminal_width || blanks == std::string_view::npos) return std::string(line);
    const std::string indent(blanks + hang, ' ');
    std::string out(blanks, ' ');
    std::size_t width = blanks;
    for (const std::string_view piece : pieces(line.substr(blanks))) {
        if (width == blanks) {
            out += piece;
        } else if (width + 1 + visible_width(piece) <= terminal_width) {
            (out += ' ') += piece;
            ++width;
        } else {
            out.erase(out.find_last_not_of(' ') + 1);
            ((out += '\n') += indent) += piece;
            width = indent.size();
        }
        width += visible_width(piece);
    }
    return out;
}

} // namespace detail

/// A text whose lines are wrapped where they are too wide; what is left of a line is indented by `hang` more than it
/// was.
inline std::string wrapped(std::string_view text, std::size_t hang = 4) {
    std::string out;
    while (true) {
        const std::size_t end = text.find('\n');
        out += detail::wrapped_line(text.substr(0, end), hang);
        if (end == std::string_view::npos) return out;
        out += '\n';
        text.remove_prefix(end + 1);
    }
}

/// What is written to it stands on the standard output at its end, wrapped. Numbers look as they do there, and
/// manipulators hold on there.
class Paragraph : public std::ostringstream {
public:
    Paragraph() { copyfmt(std::cout); }
    ~Paragraph() override {
        std::cout << wrapped(str());
        std::cout.copyfmt(*this);
    }
};

/// say() << "A swing takes " << period << '\n'; for sentences. Tables and maps go to std::cout as they are.
inline Paragraph say() { return {}; }

} // namespace ansatz::workbook
