// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The one place that talks to Graphviz: a graph in its language, such as `to_dot` writes of a machine, becomes a
/// picture of a section. Without Graphviz it becomes one line that says so; the text is the program's to print.
///
/// \code
/// draw_graph("5.3", to_dot(machine.outline(), machine.active_names()));
/// \endcode

#include "gnuplot.hpp"

#include <string>
#include <string_view>

namespace ansatz::workbook {

/// Is Graphviz there? Asked once, of the shell, which knows the path.
inline bool graphviz_installed() {
    static const bool installed = std::system("command -v dot >/dev/null 2>&1") == 0;
    return installed;
}

/// Draws a graph and says in one line, on the error stream, where the picture is or why there is none. The picture
/// appears whole or not at all.
/// \param name  the picture's file, without folder and ending; it begins with the section's number
/// \param dot   in Graphviz' language
/// \param with  what draws it, for tests
inline bool draw_graph(const std::string& name, std::string_view dot, const std::string& with = "dot") {
    const auto file = picture_folder() / (name + ".svg");
    const auto skip = [&](const std::string& why) {
        std::clog << "picture skipped: " << why << '\n';
        return false;
    };
    if (with == "dot" ? !graphviz_installed() : std::system(("command -v " + with + " >/dev/null 2>&1").c_str()) != 0)
        return skip("Graphviz is not installed (its program is " + with +
                    "); what it would draw is a text, printed by " + "to_dot");
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    if (error) return skip(file.string() + ": the folder cannot be made: " + error.message());
    const std::filesystem::path part = file.string() + "." + std::to_string(::getpid()) + ".part";
    std::string quoted = "'"; // for the shell
    for (const char c : part.string()) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    const bool drawn = run_gnuplot(dot, (with + " -Tsvg -o " + quoted + "'").c_str());
    if (!drawn || !std::filesystem::exists(part) || std::filesystem::file_size(part, error) == 0) {
        std::filesystem::remove(part, error);
        return skip(file.string() + ": Graphviz could not draw it; its message stands above");
    }
    std::filesystem::rename(part, file, error);
    if (error) return skip(file.string() + ": it cannot be moved into place: " + error.message());
    std::clog << "picture: " << file.string() << '\n';
    return true;
}

} // namespace ansatz::workbook
