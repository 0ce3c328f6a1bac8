// SPDX-License-Identifier: BSL-1.0
// `./workbook peers cases`: the hard cases in other engines. The same scene, the same measure, each with the settings
// that its documentation recommends; table.cpp is the list of rows. Nothing here depends on time, so that a second run
// says the same; the number of repeats that other areas take is not used.
//
// The table goes to <folder>/cases.json; tools/workshop/peer_cases.py keeps it and writes docs/hard_cases.md from it.

#include "tests/peers/cases/isolated.hpp"
#include "tests/peers/cases/rows.hpp"
#include "tests/peers/contest.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <set>
#include <string>
#include <vector>

using namespace peers;
using ansatz::workbook::Json;

namespace {

std::vector<Contestant> contestants() {
    std::vector<Contestant> all{ansatz_double(), ansatz_float()};
#ifdef ANSATZ_PEER_BULLET_CASES
    all.push_back(bullet());
#else
    Contest::left_out("Bullet", "libbullet-dev");
#endif
#ifdef ANSATZ_PEER_ODE_CASES
    all.push_back(ode());
#else
    Contest::left_out("ODE", "libode-dev");
#endif
#ifdef ANSATZ_PEER_BOX2D_CASES
    all.push_back(box2d());
#else
    Contest::left_out("Box2D", "libbox2d-dev");
#endif
    return all;
}

double bound_of(const Played& row, const Contestant& who) {
    return (who.scalar == "float" ? row.bound_float : row.bound) + (row.slop ? who.slop : 0);
}
std::string verdict_of(const Played& row, const Contestant& who, const Outcome& outcome) {
    if (outcome.cannot) return "cannot";
    if (!outcome.measured) return "failed";
    return outcome.value <= bound_of(row, who) ? "passed" : "failed"; // a NaN is not
}
/// In a few letters, with a mark.
std::string told(const Played& row, const Contestant& who, const Outcome& outcome) {
    const std::string verdict = verdict_of(row, who, outcome);
    if (verdict == "cannot") return "-";
    if (!outcome.measured) return "none FAILS";
    if (!std::isfinite(outcome.value)) return "lost FAILS";
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", outcome.value);
    return text + std::string(verdict == "passed" ? " ok" : " FAILS");
}
Json json_of(const Played& row, const Contestant& who, const Outcome& outcome) {
    Json json{{"engine", who.name}, {"value", nullptr}, {"bound", bound_of(row, who)}};
    if (outcome.measured && std::isfinite(outcome.value)) json["value"] = outcome.value;
    json["verdict"] = verdict_of(row, who, outcome);
    if (outcome.measured && !std::isfinite(outcome.value)) json["why"] = "what is measured is no number, or never came";
    if (!outcome.measured) json["why"] = outcome.why;
    return json;
}
Json describe(const Contestant& who) {
    return {{"name", who.name}, {"version", who.version},   {"scalar", who.scalar},      {"flat", who.flat},
            {"slop", who.slop}, {"settings", who.settings}, {"does_more", who.does_more}};
}
Json play(const std::vector<Contestant>& all, const std::set<std::string>& wished) {
    Json json = Json::array();
    std::printf("%-4s %-84s %9s", "row", "what is measured: less is better", "bound");
    for (const Contestant& who : all) std::printf(" %15s", who.name.c_str());
    std::puts("");
    for (const Played& row : rows()) {
        if (!wished.empty() && !wished.count(row.id)) continue;
        Json results = Json::array();
        std::printf("%-4s %-84s %9.2g", row.id.c_str(), (row.what + (row.unit.empty() ? "" : ", " + row.unit)).c_str(),
                    row.bound);
        for (const Contestant& who : all) {
            const Outcome outcome = isolated([&] { return row.measure(who); });
            std::printf(" %15s", told(row, who, outcome).c_str());
            std::fflush(stdout);
            results.push_back(json_of(row, who, outcome));
        }
        std::puts("");
        json.push_back({{"row", row.id},
                        {"what", row.what},
                        {"unit", row.unit},
                        {"bound", row.bound},
                        {"bound_float", row.bound_float},
                        {"slop_added", row.slop},
                        {"results", results}});
    }
    return json;
}

} // namespace

/// usage: peers_cases <folder for cases.json> [repeats, which are not used [rows, which are only shown]]
int main(int argc, char** argv) {
    const std::string folder = argc > 1 ? argv[1] : ".";
    const std::vector<Contestant> all = contestants();
    Json json;
    const auto machine = ansatz::workbook::this_machine();
    json["machine"] = {{"cpu", machine.cpu},
                       {"system", machine.system},
                       {"compiler", machine.compiler},
                       {"flags", machine.flags},
                       {"date", machine.date}};
    json["engines"] = Json::array();
    for (const Contestant& who : all) {
        json["engines"].push_back(describe(who));
        std::printf("%s %s, %s%s\n", who.name.c_str(), who.version.c_str(), who.scalar.c_str(),
                    who.flat ? ", two dimensions" : "");
        for (const std::string& setting : who.settings) std::printf("    %s\n", setting.c_str());
    }
    std::puts("");
    const std::set<std::string> wished(argv + std::min(argc, 3), argv + argc);
    json["rows"] = play(all, wished);
    if (!wished.empty()) return 0;
    json["left_out"] = Json::array();
    std::puts("\nnot played:");
    for (const LeftOut& one : left_out()) {
        json["left_out"].push_back({{"rows", one.rows}, {"why", one.why}});
        std::printf("    %s: %s\n", one.rows.c_str(), one.why.c_str());
    }
    const std::string file = folder + "/cases.json";
    ansatz::workbook::write_whole(file, json.dump(2) + "\n");
    std::cout << "\nwritten: " << file << '\n';
    return 0;
}
