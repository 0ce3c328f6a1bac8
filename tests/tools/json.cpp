// SPDX-License-Identifier: BSL-1.0

// The JSON of a cost table: its keys are a contract, null stands where a field has no meaning.

#include "tests/catch.hpp"
#include "tests/scratch.hpp"

#include "tools/costs/json.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <string>

using namespace ansatz::workbook;

namespace {

std::set<std::string> keys(const Json& object) {
    std::set<std::string> names;
    for (const auto& item : object.items()) names.insert(item.key());
    return names;
}

// A folder of this process, which is gone afterwards.
struct Folder {
    std::filesystem::path path = ansatz::test::scratch_path("json");
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() { std::filesystem::remove_all(path); }
};

} // namespace

TEST_CASE("a row has exactly the promised keys, whether they have a value or not", "[costs][json]") {
    const std::set<std::string> promised{"axis",      "choice",     "problem", "parameter",   "n",
                                         "error",     "error_norm", "work",    "work_unit",   "time",
                                         "time_unit", "spread",     "order",   "known_order", "diverged"};
    Row empty;
    const Json json = to_json(this_machine(), {empty});
    REQUIRE(keys(json) == std::set<std::string>{"machine", "rows"});
    REQUIRE(json["rows"].size() == 1);
    CHECK(keys(json["rows"][0]) == promised);
    for (const char* key : {"problem", "parameter", "n", "error", "error_norm", "work", "work_unit", "time",
                            "time_unit", "spread", "order", "known_order"})
        CHECK(json["rows"][0][key].is_null());
    CHECK(json["rows"][0]["diverged"] == false);
}

TEST_CASE("the machine line tells what the times were taken on", "[costs][json]") {
    const Json machine = to_json(this_machine(), {})["machine"];
    for (const char* key : {"cpu", "cores", "compiler", "flags", "date"}) CHECK(machine.contains(key));
    CHECK(machine["cores"].get<int>() > 0);
    CHECK_FALSE(machine["compiler"].get<std::string>().empty());
    CHECK(machine["date"].get<std::string>().size() == std::string{"2000-01-01T00:00:00Z"}.size());
}

TEST_CASE("values keep their meaning: whole counts, parameters with their unit, no NaN", "[costs][json]") {
    Row r;
    r.axis = "integrator";
    r.choice = "RungeKutta4";
    r.parameter.name = "dt";
    r.parameter.value = 0.01;
    r.parameter.unit = "s";
    r.n = 1000;
    r.work = 12800.0;
    r.error = std::numeric_limits<double>::quiet_NaN();
    r.time = std::numeric_limits<double>::infinity();
    r.spread = 0.25;
    const Json json = to_json(this_machine(), {r})["rows"][0];
    CHECK(json["parameter"] == "dt = 0.01 s");
    CHECK(json["n"].is_number_integer());
    CHECK(json["work"] == 12800);
    CHECK(json["error"].is_null());
    CHECK(json["time"].is_null());
    CHECK(json["spread"] == 0.25);
}

TEST_CASE("a diverged row is kept, with null for its error", "[costs][json]") {
    Row stable, diverged;
    stable.error = 1e-3;
    diverged.diverged = true;
    diverged.time = 5.0;
    const Json rows = to_json(this_machine(), {diverged, stable})["rows"];
    REQUIRE(rows.size() == 2);
    CHECK(rows[0]["diverged"] == true);
    CHECK(rows[0]["error"].is_null());
    CHECK(rows[0]["time"] == 5.0);
    CHECK(rows[1]["diverged"] == false);
}

TEST_CASE("the file reads back, appears whole, and replaces an older one", "[costs][json]") {
    Folder folder;
    const auto file = folder.path / "deeper" / "motion.json";
    Row r;
    r.axis = "a \"quoted\" axis, \\ and é";
    r.error = 1.0 / 3.0;
    write_json(file, this_machine(), {r});
    write_json(file, this_machine(), {r, r});
    std::ifstream in{file};
    const Json read = Json::parse(in);
    REQUIRE(read["rows"].size() == 2);
    CHECK(read["rows"][0]["axis"] == r.axis);
    CHECK(read["rows"][0]["error"].get<double>() == 1.0 / 3.0); // every bit
    CHECK(std::distance(std::filesystem::directory_iterator{file.parent_path()}, {}) == 1);
}
