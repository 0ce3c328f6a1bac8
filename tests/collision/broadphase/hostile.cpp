// SPDX-License-Identifier: BSL-1.0
// G9: boxes that are not finite, or inside out, are refused before anything is sorted by them; and bytes of any kind.
// Runs long with the sanitizers.

#include "tests/collision/broadphase/fuzz.hpp"

#ifdef ANSATZ_LIBFUZZER

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (!broadphase_tests::fuzz(data, size).empty()) std::abort();
    return 0;
}

#else

#include "tests/catch.hpp"
#include "tests/refusal.hpp"

#include <limits>

using namespace broadphase_tests;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();

/// Boxes by the bytes of their numbers: near each other, far, equal, denormal, one bit apart, and (`hostile`) none at
/// all.
template <class Scalar> std::vector<std::uint8_t> bytes(std::uint64_t seed, bool hostile) {
    Random random(seed);
    const auto inf = std::numeric_limits<Scalar>::infinity();
    const std::array<Scalar, 8> special{std::numeric_limits<Scalar>::quiet_NaN(),
                                        inf,
                                        -inf,
                                        std::numeric_limits<Scalar>::max(),
                                        std::numeric_limits<Scalar>::lowest(),
                                        std::numeric_limits<Scalar>::denorm_min(),
                                        Scalar(-0.0),
                                        Scalar(1)};
    std::vector<Scalar> numbers(6 * (random.below(64) + 1));
    const double scale = std::pow(10.0, random.uniform(-30, 30));
    for (Scalar& number : numbers) {
        switch (random.below(4)) {
        case 0: number = Scalar(random.uniform(-1, 1) * scale); break;
        case 1: number = Scalar(random.uniform(-1, 1)); break;
        case 2: number = Scalar(std::floor(random.uniform(-4, 4))); break;
        default: number = special[3 + random.below(5)]; break;
        }
        if (hostile && random.below(50) == 0) number = special[random.below(3)];
    }
    if (!hostile || random.below(4) != 0)
        for (std::size_t n = 0; n + 1 < numbers.size(); n += 2)
            if (numbers[n] > numbers[n + 1]) std::swap(numbers[n], numbers[n + 1]);
    std::vector<std::uint8_t> all(1 + numbers.size() * sizeof(Scalar));
    all[0] = std::uint8_t(random.bits());
    std::memcpy(all.data() + 1, numbers.data(), numbers.size() * sizeof(Scalar));
    return all;
}

} // namespace

TEST_CASE("G9: a box that is not finite or inside out is refused by a sentence", "[broadphase][hard]") {
    struct Case {
        double low, high;
        const char* said;
    };
    const std::array<Case, 5> cases{{{none, 1, "nan m to 1 m"},
                                     {0, none, "0 m to nan m"},
                                     {-infinite, 1, "-inf m to 1 m"},
                                     {0, infinite, "0 m to inf m"},
                                     {1, 0, "1 m to 0 m"}}};
    for (const Case& c : cases) {
        Boxes<Space<>> boxes;
        for (int i = 0; i < 20; ++i) boxes.push_back(metres(0, i, 0), metres(1, i + 1.5, 1));
        boxes.push_back(metres(0, c.low, 0), metres(1, c.high, 1));
        boxes.set_active(21);
        each_policy([&](const char*, const auto& policy) {
            CHECK(ansatz::test::refusal([&] { find_pairs(policy, boxes); }) ==
                  std::string("find_pairs: box 20 on axis 1 is ") + c.said +
                      "; both ends are finite, and the lower is not above the upper");
        });
    }
}

TEST_CASE("boxes of any floats: the same pairs from all, or refused", "[broadphase][fuzz]") {
    for (std::uint64_t seed = 0; seed < 400; ++seed)
        for (const bool hostile : {false, true}) {
            INFO("seed " << seed << (hostile ? ", hostile" : ""));
            CHECK(fuzz_in<Space<double, 3>>(bytes<double>(seed, hostile).data(), bytes<double>(seed, hostile).size()) ==
                  "");
            CHECK(fuzz_in<Space<float, 2>>(bytes<float>(seed, hostile).data(), bytes<float>(seed, hostile).size()) ==
                  "");
        }
}

TEST_CASE("bytes of any kind", "[broadphase][fuzz]") {
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        Random random(seed + 1000);
        std::vector<std::uint8_t> all(random.below(800));
        for (auto& byte : all) byte = std::uint8_t(random.bits());
        INFO("seed " << seed);
        CHECK(fuzz(all.data(), all.size()) == "");
    }
}

#endif
