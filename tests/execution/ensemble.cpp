// SPDX-License-Identifier: BSL-1.0
// ensemble: results in the order of the parameters, whatever runs them; what ends early goes on from its file.

#include <ansatz/execution/ensemble.hpp>
#include <ansatz/execution/kept_results.hpp>
#include <ansatz/execution/on_threads.hpp>

#include "tests/catch.hpp"
#include "tests/refusal.hpp"
#include "tests/scratch.hpp"

#include <oneapi/tbb/global_control.h>

#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numeric>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

using namespace ansatz;
using ansatz::test::refusal;
namespace fs = std::filesystem;

namespace {

/// Runs of very different length, whose results tell their parameters.
double slow_sine(double x) {
    double sum = x;
    for (int i = 0; i < int(1000 * x) % 20000; ++i) sum = std::sin(sum) + x;
    return sum;
}
std::vector<double> numbers(int n) {
    std::vector<double> all(std::size_t(n), 0.);
    for (int i = 0; i < n; ++i) all[std::size_t(i)] = 0.37 * i * i;
    return all;
}
/// A file that is gone at the end.
struct Scratch {
    fs::path path = ansatz::test::scratch_path("ensemble");
    Scratch() { fs::remove(path); }
    ~Scratch() { fs::remove(path); }
    std::string text() const {
        std::ifstream in(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    void write(const std::string& bytes) const { std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes; }
};
template <class F> std::string failure(F&& f) {
    try {
        f();
    } catch (const std::runtime_error& e) {
        return e.what();
    }
    return "nothing was thrown";
}

} // namespace

TEST_CASE("The results stand in the order of the parameters, to the bit on any number of threads", "[execution]") {
    const oneapi::tbb::global_control more(oneapi::tbb::global_control::max_allowed_parallelism, 4);
    for (const int n : {0, 1, 2, 57}) {
        const auto parameters = numbers(n);
        std::vector<double> expected;
        for (const double x : parameters) expected.push_back(slow_sine(x));
        CHECK(ensemble(slow_sine, parameters) == expected);
        for (const int threads : {1, 2, 4}) CHECK(ensemble(slow_sine, parameters, OnThreads{threads}) == expected);
    }
    // Any number of threads may be asked for; there are no more than runs.
    CHECK(ensemble(slow_sine, numbers(5), OnThreads{std::numeric_limits<int>::max()}) ==
          ensemble(slow_sine, numbers(5)));
    CHECK(refusal([] { OnThreads{0}; }) == "OnThreads: threads is 0; it is 1 or more; OnThreads{} takes every core");
}

TEST_CASE("A run that throws is told with its number, its words and what was kept", "[execution]") {
    const auto run = [](int i) {
        if (i == 3) throw std::domain_error("no such sea");
        return i;
    };
    std::vector<int> parameters(10);
    std::iota(parameters.begin(), parameters.end(), 0);
    CHECK(
        failure([&] { ensemble(run, parameters); }) ==
        "ensemble: run 3 of 10 failed: no such sea; 3 results are lost (EnsembleOptions::kept names a file for them)");
    CHECK(failure([&] {
              ensemble([](int) -> int { throw 7; }, parameters);
          }).find("it threw what is no std::exception") != std::string::npos);
    for (int repeat = 0; repeat < 20; ++repeat)
        CHECK(failure([&] {
                  ensemble(run, parameters, OnThreads{2});
              }).find("ensemble: run 3 of 10 failed: no such sea") == 0);
}

TEST_CASE("What ended early goes on from its file, and runs nothing twice", "[execution]") {
    const Scratch file;
    const auto parameters = numbers(20);
    const auto expected = ensemble(slow_sine, parameters);
    std::atomic<int> runs = 0;
    bool broken = true;
    const auto run = [&](double x) {
        ++runs;
        if (broken && x == parameters[12]) throw std::runtime_error("the lamp went out");
        return slow_sine(x);
    };
    const EnsembleOptions kept{.kept = file.path, .name = "sines", .progress = {}};
    CHECK(failure([&] { ensemble(run, parameters, OneByOne{}, kept); }) ==
          "ensemble: run 12 of 20 failed: the lamp went out; 12 results are kept in " + file.path.string() +
              ": the same call goes on from there");
    CHECK(runs == 13);
    broken = false;
    CHECK(ensemble(run, parameters, OnThreads{2}, kept) == expected);
    CHECK(runs == 13 + 8);
    CHECK(ensemble(run, parameters, OneByOne{}, kept) == expected); // all of it from the file
    CHECK(runs == 13 + 8);

    // Wherever the file is torn, what is whole is used, and what is torn is run again.
    const std::string whole = file.text();
    for (std::size_t size = 0; size < whole.size(); size += 11) {
        file.write(whole.substr(0, size));
        runs = 0;
        CHECK(ensemble(run, parameters, OneByOne{}, kept) == expected);
        CHECK(runs > 0);
        CHECK(file.text().size() == whole.size());
    }
    // A bit that has turned is found by the checksum; what stands behind it is not trusted.
    for (std::size_t at = whole.find('\n') + 1; at < whole.size(); at += 37) {
        std::string turned = whole;
        turned[at] = char(turned[at] ^ 4);
        file.write(turned);
        CHECK(ensemble(run, parameters, OneByOne{}, kept) == expected);
    }
}

TEST_CASE("The file of another ensemble is refused, and left as it is", "[execution]") {
    const Scratch file;
    const auto parameters = numbers(5);
    ensemble(slow_sine, parameters, OneByOne{}, {.kept = file.path, .name = "sines", .progress = {}});
    const std::string before = file.text();
    int runs = 0;
    const auto refused = [&](const std::vector<double>& other, const char* name) {
        return refusal([&] {
            ensemble(
                [&](double x) {
                    ++runs;
                    return x;
                },
                other, OneByOne{}, {.kept = file.path, .name = name, .progress = {}});
        });
    };
    const std::string begins =
        "ensemble: " + file.path.string() + " keeps the results of another ensemble, 'ansatz-ensemble 1";
    CHECK(refused(parameters, "cosines").find(begins) == 0);
    CHECK(refused(numbers(6), "sines").find(begins) == 0);
    CHECK(refused({0, 0.37, 1.48, 3.33, 5}, "sines").find(begins) == 0);
    CHECK(file.text() == before);
    file.write("a letter to my mother\n");
    CHECK(refused(parameters, "sines").find("is no file of results; it begins 'a letter to my mother'") !=
          std::string::npos);
    CHECK(file.text() == "a letter to my mother\n");
    CHECK(runs == 0);
    // Results of another type: the same line, other sizes.
    fs::remove(file.path);
    const EnsembleOptions kept{.kept = file.path, .name = {}, .progress = {}};
    ensemble([](double x) { return float(x); }, parameters, OneByOne{}, kept);
    CHECK(refusal([&] { ensemble(slow_sine, parameters, OneByOne{}, kept); }) ==
          "ensemble: the size of a result is 4 bytes; a result has 8; the run gave back another type once");
    CHECK(refusal([&] {
              ensemble(slow_sine, parameters, OneByOne{}, {.kept = "/nowhere/at/all", .name = {}, .progress = {}});
          }).find("ensemble: /nowhere/at/all cannot be written: No such file or directory") == 0);
}

TEST_CASE("What cannot be a file of results is refused as such, whatever stands at the path", "[execution]") {
    const auto refused = [](const fs::path& path) {
        return refusal(
            [&] { ensemble(slow_sine, numbers(3), OneByOne{}, {.kept = path, .name = "sines", .progress = {}}); });
    };
    const std::string long_name(400, 'a');
    CHECK(refused(long_name) == "ensemble: " + long_name + " cannot be written: File name too long");
    const Scratch file;
    fs::create_symlink(file.path.filename(), file.path);
    CHECK(refused(file.path) ==
          "ensemble: " + file.path.string() + " cannot be written: Too many levels of symbolic links");
    const auto folder = fs::temp_directory_path().string();
    CHECK(refused(folder) == "ensemble: " + folder + " cannot be written: Is a directory");
    CHECK(refused("/dev/null").find("ensemble: /dev/null cannot be read: ") == 0);
    // Bytes that no terminal shows; a sentence would end at a zero.
    fs::remove(file.path);
    file.write(std::string("PNG\0\1\2", 6) + std::string(200, '\0'));
    CHECK(refused(file.path).find(" is no file of results; it begins 'PNG'; this one is 'ansatz-ensemble 1") !=
          std::string::npos);
}

TEST_CASE("Vectors, text and small structs are kept; what cannot be kept is a sentence", "[execution]") {
    struct Point {
        double x, y;
        bool operator==(const Point&) const = default;
    };
    const std::vector<int> parameters{3, 1, 4, 1, 5};
    const auto twice_is_once = [&](auto run) {
        const Scratch file;
        const EnsembleOptions kept{.kept = file.path, .name = {}, .progress = {}};
        const auto first = ensemble(run, parameters, OneByOne{}, kept);
        using Result = typename decltype(first)::value_type;
        CHECK(ensemble([](int) -> Result { throw std::runtime_error("it was kept"); }, parameters, OneByOne{}, kept) ==
              first);
        CHECK(first == ensemble(run, parameters));
    };
    twice_is_once([](int i) { return Point{1. / i, double(i)}; });
    twice_is_once([](int i) { return std::vector<float>(std::size_t(i), 0.1f); });
    twice_is_once([](int i) { return std::string(std::size_t(i), '\0') + "\n"; });
    const auto maps = [](int i) { return std::vector<std::string>(std::size_t(i)); };
    CHECK(ensemble(maps, parameters).size() == 5);
    const Scratch file;
    CHECK(refusal([&] {
              ensemble(maps, parameters, OneByOne{}, {.kept = file.path, .name = {}, .progress = {}});
          }).find("ensemble: results of this type cannot be kept in a file; give back numbers") == 0);
    CHECK_FALSE(fs::exists(file.path));
    // A view is where a text is, which is nothing that a file could keep.
    static_assert(!detail::BytesOf<std::string_view>::known && !detail::BytesOf<std::span<const double>>::known);
    static_assert(!detail::BytesOf<std::vector<std::string_view>>::known && !detail::BytesOf<const char*>::known);
    static_assert(detail::BytesOf<std::array<double, 3>>::known && detail::BytesOf<long double>::known);
}

/// Leaves a byte all over the stack, on which a long double then has bytes that are no part of it.
[[gnu::noinline]] void litter(int byte) {
    volatile char all[4096];
    for (auto& one : all) one = char(byte);
}
[[gnu::noinline]] std::uint64_t fingerprint_of(const std::vector<long double>& parameters) {
    return detail::fingerprint(parameters);
}
TEST_CASE("Parameters are told apart by their numbers, not by what lies beside them in memory", "[execution]") {
    const std::vector<long double> thirds{0, 1 / 3.L, 2 / 3.L};
    litter(0);
    const auto once = fingerprint_of(thirds);
    litter(0x5a);
    CHECK(fingerprint_of(thirds) == once);
    const std::vector<long double> others{0, 1 / 3.L, std::nextafter(2 / 3.L, 1.L)};
    CHECK(fingerprint_of(others) != once);
}

TEST_CASE("A run may be anything that can be called with a parameter", "[execution]") {
    const std::vector<std::string> words{"rigid", "body"};
    CHECK(ensemble(&std::string::size, words) == std::vector<std::size_t>{5, 4});
}

TEST_CASE("Progress is told after each run", "[execution]") {
    std::vector<std::size_t> told;
    ensemble(slow_sine, numbers(4), OnThreads{2},
             {.kept = {}, .name = {}, .progress = [&](std::size_t done, std::size_t all) {
                  CHECK(all == 4);
                  told.push_back(done);
              }});
    CHECK(told == std::vector<std::size_t>{1, 2, 3, 4});
    std::ostringstream line;
    ensemble(slow_sine, numbers(2), OneByOne{}, {.kept = {}, .name = {}, .progress = ProgressLine{line}});
    CHECK(line.str() == "\r1 of 2 runs\r2 of 2 runs\n");
    // What it throws ends the ensemble as what a run throws does.
    for (const bool sentence : {false, true}) {
        const auto told_of = failure([&] {
            ensemble(slow_sine, numbers(2), OnThreads{2}, {.kept = {}, .name = {}, .progress = [&](auto, auto) {
                                                               if (sentence) throw std::runtime_error("no terminal");
                                                               throw 7;
                                                           }});
        });
        CHECK(told_of.find(sentence ? "ensemble: no terminal; "
                                    : "ensemble: EnsembleOptions::progress threw what is no std::exception; ") == 0);
    }
}
