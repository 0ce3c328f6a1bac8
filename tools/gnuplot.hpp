// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The one place that talks to gnuplot: the house's style, and a script piped to a gnuplot process.
/// `plot.hpp` (pictures of the sections) and `costs/picture.hpp` (what accuracy costs) describe what
/// is to be seen; gnuplot draws it. Without gnuplot every picture becomes one line that says so.

#include "width.hpp"

#include <stdio.h> // popen and pclose are POSIX: <cstdio> need not declare them
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>

namespace ansatz::workbook {

/// Eight colours that people with any of the usual colour vision deficiencies tell apart on white
/// (after Okabe and Ito; their yellow is left out, because nobody sees it on white).
inline constexpr std::array<std::string_view, 8> palette{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                         "#e69f00", "#56b4e9", "#6a3d9a", "#222222"};

/// gnuplot's point types in the order of the palette: filled circle, square, triangle, diamond, ...
/// so that a curve is known by its shape, too, where its colour is not seen.
inline constexpr std::array<int, 8> point_shapes{7, 5, 9, 13, 11, 15, 6, 4};

/// The colour and the shape of the curve number `i`; they repeat after eight.
inline std::string colour(std::size_t i) { return std::string{palette[i % palette.size()]}; }
inline int point_shape(std::size_t i) { return point_shapes[i % point_shapes.size()]; }

/// A gnuplot string literal. Single quotes keep backslashes; a quote is doubled; a line end would
/// end the command, so it becomes a space.
inline std::string in_quotes(std::string_view text) {
    std::string literal{"'"};
    for (char c : text) {
        if (c == '\'') literal += "''";
        else literal += (c == '\n' || c == '\r') ? ' ' : c;
    }
    return literal + "'";
}

/// A number as gnuplot reads it; what is not finite becomes a gap.
inline std::string number(double value) {
    if (!std::isfinite(value)) return "NaN";
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.9g", value);
    return text.data();
}

/// Where pictures go: the environment variable ANSATZ_PICTURES, or `pictures` beside where one is.
inline std::filesystem::path picture_folder() {
    const char* folder = std::getenv("ANSATZ_PICTURES");
    return folder != nullptr && *folder != '\0' ? folder : "pictures";
}

/// The lines that every picture begins with: SVG on white, thin grey axes, a light grid.
inline std::string house_style(int width, int height) {
    std::ostringstream s;
    s << "set encoding utf8\n"
      << "set terminal svg enhanced size " << width << ',' << height
      << " dynamic rounded font 'DejaVu Sans,Verdana,Helvetica,Arial,sans-serif,14' background '#ffffff'\n"
      << "set minussign\n"
      << "set border 3 lc rgb '#999999' lw 1\n"
      << "set tics nomirror out scale 0.6,0.3 textcolor rgb '#555555'\n"
      << "set grid xtics ytics lt 1 lc rgb '#e8e8e8' lw 1\n"
      << "set key off\n";
    return s.str();
}

/// Is gnuplot there? Asked once, of the shell, which knows the path.
inline bool gnuplot_installed() {
    static const bool installed = std::system("command -v gnuplot >/dev/null 2>&1") == 0;
    return installed;
}

/// Runs gnuplot (or a pipe of the shell that begins with it) on a script and waits. True when it ended well.
inline bool run_gnuplot(std::string_view script, const char* command = "gnuplot") {
    std::cout.flush(); // gnuplot may print to the same terminal: keep the order
    FILE* gnuplot = popen(command, "w");
    if (gnuplot == nullptr) return false;
    // A gnuplot that stops early closes the pipe; that must be a `false` here, not a killed program.
    auto* before = std::signal(SIGPIPE, SIG_IGN);
    const bool written = std::fwrite(script.data(), 1, script.size(), gnuplot) == script.size();
    const int status = pclose(gnuplot);
    std::signal(SIGPIPE, before);
    return written && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// Draws a script into `file` and says in one line (on the error stream, so that a section's recorded
/// output does not depend on where pictures go) where the picture is, or why there is none.
/// The picture appears whole or not at all: gnuplot writes beside it, and the result is renamed.
inline bool draw(const std::filesystem::path& file, std::string_view script) {
    if (!gnuplot_installed()) {
        std::clog << "picture skipped: gnuplot is not installed\n";
        return false;
    }
    const auto fail = [&](const std::string& why) {
        std::clog << "picture skipped: " << file.string() << ": " << why << '\n';
        return false;
    };
    std::error_code error;
    if (!file.parent_path().empty()) std::filesystem::create_directories(file.parent_path(), error);
    if (error) return fail("the folder cannot be made: " + error.message());

    const std::filesystem::path part = file.string() + "." + std::to_string(::getpid()) + ".part";
    // gnuplot writes some files even when it fails; what it prints explains the failure.
    const bool drawn =
        run_gnuplot("set output " + in_quotes(part.string()) + "\n" + std::string{script} + "\nset output\n");
    if (!drawn || !std::filesystem::exists(part) || std::filesystem::file_size(part, error) == 0) {
        std::filesystem::remove(part, error);
        return fail("gnuplot could not draw it; its message stands above");
    }
    std::filesystem::rename(part, file, error);
    if (error) return fail("it cannot be moved into place: " + error.message());
    std::clog << "picture: " << file.string() << '\n';
    return true;
}

} // namespace ansatz::workbook
