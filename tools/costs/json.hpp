// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// A cost table as JSON: `{"machine": {...}, "rows": [{...}]}`, null where a field has no meaning.

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "machine.hpp"
#include "row.hpp"

namespace ansatz::workbook {

using Json = nlohmann::ordered_json; // keys stay in the order in which a reader expects them

/// The whole table. The keys of a row are a contract with everything that reads these files.
inline Json to_json(const Machine& machine, const Rows& rows) {
    const auto value = [](const Number& number) { return number ? Json(*number) : Json(nullptr); };
    const auto count = [](const Number& number) {
        if (!number) return Json(nullptr);
        // Counts are whole: 12800, not 12800.0.
        const auto whole = static_cast<long long>(*number);
        return static_cast<double>(whole) == *number ? Json(whole) : Json(*number);
    };
    const auto text = [](const std::string& string) { return string.empty() ? Json(nullptr) : Json(string); };

    Json json;
    json["machine"] = {{"cpu", machine.cpu},
                       {"cores", machine.cores},
                       {"system", machine.system},
                       {"compiler", machine.compiler},
                       {"flags", machine.flags},
                       {"date", machine.date},
                       {"clock", "thread CPU time, one thread"},
                       {"repeats", machine.repeats}};
    json["rows"] = Json::array();
    for (const Row& row : rows)
        json["rows"].push_back({{"axis", row.axis},
                                {"choice", row.choice},
                                {"problem", text(row.problem)},
                                {"parameter", text(row.parameter.text())},
                                {"n", count(row.n)},
                                {"error", value(row.error)},
                                {"error_norm", text(row.error_norm)},
                                {"work", count(row.work)},
                                {"work_unit", text(row.work_unit)},
                                {"time", value(row.time)},
                                {"time_unit", text(row.time_unit)},
                                {"spread", value(row.spread)},
                                {"order", value(row.order)},
                                {"known_order", value(row.known_order)},
                                {"diverged", row.diverged}});
    return json;
}

/// Writes a whole text or nothing: into a neighbour first, which then takes the file's place.
inline void write_whole(const std::filesystem::path& file, const std::string& text) {
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
    const std::filesystem::path part = file.string() + ".part";
    {
        std::ofstream out{part};
        out << text;
        if (!out.flush()) throw std::runtime_error(part.string() + " cannot be written");
    }
    std::filesystem::rename(part, file);
}

/// Writes the table and reads it back: a file that does not parse to what was meant must not stay
/// unnoticed until somebody's page is built from it.
inline void write_json(const std::filesystem::path& file, const Machine& machine, const Rows& rows) {
    const Json json = to_json(machine, rows);
    write_whole(file, json.dump(2) + "\n");
    std::ifstream in{file};
    if (Json::parse(in) != json) throw std::runtime_error(file.string() + " does not read back as it was written");
}

} // namespace ansatz::workbook
