// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Readers for the grid maps and scenarios of the MovingAI benchmarks: what path finders are compared on.
///
/// '.' and 'G' are ground, 'S' is swamp, 'W' is water; '@', 'O' and 'T' are never passable. Which ground is passable is
/// a policy of `MovingAiMap::grid`: `LandOnly`, by which water is a wall, or `GroundByKind`, by which one wades into it
/// from a swamp. Files do not say which of both their lengths were made by; the maps of most games hold neither swamp
/// nor water. A step is one of eight and passes a corner where both straight neighbours are free: `Grid<>`. What is
/// wrong in a file is refused with its name, line and what was expected.
///
/// \see N. R. Sturtevant, "Benchmarks for Grid-Based Pathfinding", IEEE Trans. Comput. Intell. AI Games 4 (2012).

#include <ansatz/core/error.hpp>
#include <ansatz/paths/grid/grid.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <istream>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ansatz::paths {

/// Which ground is passable: '.', 'G' and 'S', from each to each.
struct LandOnly {
    /// Whether one may stand on this tile.
    static bool passable(char tile) { return tile == '.' || tile == 'G' || tile == 'S'; }
};

/// Which ground is passable from which, by the kinds of the format: from ground to ground and swamp, from swamp to
/// everything, from water to water and swamp. A diagonal step is possible where the four straight ones round it are.
///
/// Where the map has water beside ground some edges are blocked, which `JumpPoints` refuse.
struct GroundByKind {
    /// Whether one may stand on this tile.
    static bool passable(char tile) { return LandOnly::passable(tile) || tile == 'W'; }
    /// Whether one may step from one such tile to another beside it: not from dry ground into water, nor out again.
    static bool passable(char from, char to) { return from == 'S' || to == 'S' || (from == 'W') == (to == 'W'); }
};

/// A map as its file has it.
struct MovingAiMap {
    std::string name; ///< of the file, without its folders
    /// Columns.
    std::size_t width = 0, height = 0; ///< rows
    std::string tiles;                 ///< the letters, row by row
    /// Whether a letter is free ground: '.', 'G' or 'S'.
    static bool passable(char tile) { return LandOnly::passable(tile); }
    /// As a grid: `map.grid()`, or `map.grid<Grid<Four>>(0.5 * metre)`.
    /// \tparam Rule `LandOnly`, `GroundByKind`, or one of yours: whether a tile is passable and, if it says so, from
    /// which
    template <class Map = Grid<>, class Rule = LandOnly> Map grid(Quantity<unit::Length> tile = 1.0 * metre) const {
        Map map(width, height, tile);
        std::vector<std::uint8_t> free;
        free.reserve(tiles.size());
        for (const char t : tiles) free.push_back(Rule::passable(t));
        map.set_passable(free);
        if constexpr (requires { Rule::passable('.', '.'); })
            for (std::size_t i = 0; i < tiles.size(); ++i)
                for (int d = 0; d < Map::neighbours::directions; ++d) part<Rule>(map, i, d);
        return map;
    }

private:
    char at(int x, int y) const { return tiles[std::size_t(y) * width + std::size_t(x)]; }
    /// Blocks a step that the rule does not allow between tiles that are both free.
    template <class Rule, class Map> void part(Map& map, std::size_t i, int d) const {
        const int x = int(i % width), y = int(i / width);
        const int u = x + detail::direction_x[d], v = y + detail::direction_y[d];
        const Cell from{std::uint16_t(x), std::uint16_t(y)}, to{std::uint16_t(u), std::uint16_t(v)};
        if (u < 0 || v < 0 || u >= int(width) || v >= int(height) || !map.passable(from, to)) return;
        const auto step = [&](int a, int b, int p, int q) { return Rule::passable(at(a, b), at(p, q)); };
        bool allowed = step(x, y, u, v);
        if (d >= 4) // of the tiles at the corner only those count that are free: whether they must be the grid says
            for (const auto& [p, q] : {std::pair(u, y), std::pair(x, v)})
                if (map.passable(Cell{std::uint16_t(p), std::uint16_t(q)}))
                    allowed = allowed && step(x, y, p, q) && step(p, q, u, v);
        if (!allowed) map.set_passable(from, to, false);
    }
};

/// One query of a scenario file.
struct Scenario {
    std::size_t bucket = 0; ///< the group of queries of about this length, as the file counts them
    std::string map;        ///< as the file names it, perhaps with folders
    /// Columns of its map.
    std::size_t width = 0, height = 0; ///< rows of its map
    /// From here.
    Cell start, goal;     ///< to here
    double length = 0;    ///< of the shortest path, in tiles
    double tolerance = 0; ///< half a unit of the last digit that was printed
    std::size_t line = 0; ///< where it stands
};

namespace detail {

/// A text file line by line, which refuses with its place.
class Lines {
public:
    Lines(std::istream& in, std::string name) : in_(in), name_(std::move(name)) {}
    bool next() {
        if (!std::getline(in_, text_)) return false;
        ++number_;
        if (!text_.empty() && text_.back() == '\r') text_.pop_back();
        return true;
    }
    const std::string& text() const { return text_; }
    std::size_t number() const { return number_; }
    [[noreturn, gnu::cold]] void fail(std::string found, const std::string& expected) const {
        for (char& c : found) // a sentence that is read as a C string ends at a zero, and terminals act on the others
            if (static_cast<unsigned char>(c) < 32 || c == 127) c = '?';
        refuse(Refusal::invalid_argument,
               name_ + ":" + std::to_string(number_) + ": " + found + "; expected " + expected);
    }
    /// The next line, which must begin with this word and a space.
    std::size_t count_after(const std::string& word) {
        if (!next()) fail("the file ends", "a line \"" + word + " <number>\"");
        std::size_t value = 0;
        const std::string start = word + " ";
        const char* const end = text_.data() + text_.size();
        if (text_.rfind(start, 0) != 0) fail(shown(), "\"" + word + " <number>\"");
        const auto read = std::from_chars(text_.data() + start.size(), end, value);
        if (read.ec != std::errc{} || read.ptr != end || value < 1 || value > 65535)
            fail(shown(), word + " from 1 to 65535");
        return value;
    }
    std::string shown() const { return "\"" + (text_.size() > 40 ? text_.substr(0, 37) + "..." : text_) + "\""; }

private:
    std::istream& in_;
    std::string name_, text_;
    std::size_t number_ = 0;
};

/// What stands between spaces and tabs.
inline std::vector<std::string_view> fields_of(std::string_view text) {
    std::vector<std::string_view> fields;
    for (std::size_t at = 0; at < text.size();) {
        const auto begin = text.find_first_not_of(" \t", at);
        if (begin == std::string_view::npos) break;
        const auto end = std::min(text.find_first_of(" \t", begin), text.size());
        fields.push_back(text.substr(begin, end - begin));
        at = end;
    }
    return fields;
}
inline std::string without_folders(const std::string& path) { return path.substr(path.find_last_of("/\\") + 1); }
template <class Number> bool whole(std::string_view text, Number& number) {
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
    return read.ec == std::errc{} && read.ptr == text.data() + text.size();
}
/// A printed length. By a stream, because libc++ 19 has no from_chars for double; and in the classic locale, because
/// the decimal point of a file is no matter of where it is read.
inline bool number(std::string_view text, double& value) {
    std::istringstream in{std::string(text)};
    in.imbue(std::locale::classic());
    return in >> value && in.peek() == std::char_traits<char>::eof();
}
/// Half a unit of the last digit of a printed length. A default stream prints six significant digits and drops zeros at
/// the end; whoever prints more, or with a fixed number of decimals, shows it by his digits. Besides, those who made
/// the files took a root of 2 of seven decimals: a length that lies just above a half is rounded down in them.
inline double half_unit(std::string_view text, double value, bool fixed) {
    const auto point = text.find('.');
    const int decimals = point == std::string_view::npos ? 0 : int(text.size() - point - 1);
    const std::size_t digits = text.size() - (point == std::string_view::npos ? 0 : 1);
    const double root = 1e-7 * value;
    if (fixed || digits > 6) return 0.5 * std::pow(10.0, -decimals) + root;
    const int before = value < 1 ? 1 : int(std::floor(std::log10(value))) + 1;
    return 0.5 * std::pow(10.0, before - 6) + root;
}

} // namespace detail

/// \param name of the file, for its sentences
/// \throws std::invalid_argument for a file that is truncated, too large, not rectangular, or has other letters
inline MovingAiMap read_moving_ai_map(std::istream& in, const std::string& name) {
    detail::Lines lines(in, name);
    MovingAiMap map;
    map.name = detail::without_folders(name);
    if (!lines.next()) lines.fail("the file is empty", "\"type octile\"");
    if (lines.text() != "type octile") lines.fail(lines.shown(), "\"type octile\"");
    map.height = lines.count_after("height");
    map.width = lines.count_after("width");
    if (!lines.next()) lines.fail("the file ends", "\"map\"");
    if (lines.text() != "map") lines.fail(lines.shown(), "\"map\"");
    for (std::size_t y = 0; y < map.height; ++y) {
        if (!lines.next())
            lines.fail("the file ends after " + std::to_string(y) + " rows",
                       std::to_string(map.height) + " rows, the height");
        if (lines.text().size() != map.width)
            lines.fail("row " + std::to_string(y) + " has " + std::to_string(lines.text().size()) + " tiles",
                       std::to_string(map.width) + ", the width");
        const auto odd = lines.text().find_first_not_of(".GS@OTW");
        if (odd != std::string::npos)
            lines.fail("column " + std::to_string(odd + 1) + " is '" + lines.text()[odd] + "'", "one of . G S @ O T W");
        map.tiles += lines.text();
    }
    while (lines.next())
        if (!lines.text().empty()) lines.fail("there are more rows", std::to_string(map.height) + ", the height");
    return map;
}
/// \throws std::invalid_argument for a file that cannot be opened, and as above
inline MovingAiMap read_moving_ai_map(const std::string& path) {
    std::ifstream in(path);
    if (!in) refuse(Refusal::invalid_argument, path + ": cannot be opened; expected a map of MovingAI");
    return read_moving_ai_map(in, path);
}

/// Scenarios of version 1 (tabs) and 1.0 (spaces).
/// \throws std::invalid_argument for a file that is no such, with line and field
inline std::vector<Scenario> read_moving_ai_scenarios(std::istream& in, const std::string& name) {
    detail::Lines lines(in, name);
    if (!lines.next()) lines.fail("the file is empty", "\"version 1\" or \"version 1.0\"");
    if (lines.text() != "version 1" && lines.text() != "version 1.0")
        lines.fail(lines.shown(), "\"version 1\" or \"version 1.0\"");
    const bool fixed = lines.text() == "version 1.0";
    std::vector<Scenario> scenarios;
    while (lines.next()) {
        if (lines.text().find_first_not_of(" \t") == std::string::npos) continue;
        const auto fields = detail::fields_of(lines.text());
        if (fields.size() != 9)
            lines.fail("a line of " + std::to_string(fields.size()) + " fields",
                       "9: bucket, map, width, height, start's column and row, goal's column and row, length");
        Scenario s;
        s.line = lines.number();
        s.map = std::string(fields[1]);
        const char* const names[] = {"the bucket",         "",
                                     "the width",          "the height",
                                     "the start's column", "the start's row",
                                     "the goal's column",  "the goal's row"};
        std::size_t numbers[8]{};
        for (std::size_t i = 0; i < 8; ++i)
            if (i != 1 && (!detail::whole(fields[i], numbers[i]) || (i > 1 && numbers[i] > 65535)))
                lines.fail(std::string(names[i]) + " is \"" + std::string(fields[i]) + "\"",
                           "a whole number from 0 to 65535");
        s.bucket = numbers[0], s.width = numbers[2], s.height = numbers[3];
        if (numbers[4] >= s.width || numbers[6] >= s.width || numbers[5] >= s.height || numbers[7] >= s.height)
            lines.fail("the start or the goal lies outside the map",
                       "tiles of a map of " + std::to_string(s.width) + " x " + std::to_string(s.height));
        s.start = {std::uint16_t(numbers[4]), std::uint16_t(numbers[5])};
        s.goal = {std::uint16_t(numbers[6]), std::uint16_t(numbers[7])};
        if (!detail::number(fields[8], s.length) || !std::isfinite(s.length) || s.length < 0)
            lines.fail("the length is \"" + std::string(fields[8]) + "\"", "a number that is finite and not negative");
        s.tolerance = detail::half_unit(fields[8], s.length, fixed);
        scenarios.push_back(std::move(s));
    }
    return scenarios;
}
/// The same from a file.
/// \throws std::invalid_argument for one that cannot be opened, too
inline std::vector<Scenario> read_moving_ai_scenarios(const std::string& path) {
    std::ifstream in(path);
    if (!in) refuse(Refusal::invalid_argument, path + ": cannot be opened; expected scenarios of MovingAI");
    return read_moving_ai_scenarios(in, path);
}

/// \throws std::invalid_argument for a scenario that was made for another map: another file or another size
inline void require_map(const Scenario& s, const MovingAiMap& map) {
    const std::string where = "the scenario in line " + std::to_string(s.line);
    if (detail::without_folders(s.map) != map.name)
        refuse(Refusal::invalid_argument, where + " is for the map " + s.map + "; this is " + map.name);
    if (s.width != map.width || s.height != map.height)
        refuse(Refusal::invalid_argument, where + " is for a map of " + std::to_string(s.width) + " x " +
                                              std::to_string(s.height) + " tiles; " + map.name + " has " +
                                              std::to_string(map.width) + " x " + std::to_string(map.height));
}

} // namespace ansatz::paths
