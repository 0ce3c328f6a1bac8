// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on hysteresis (notes 5.2).

#include "tools/exercises/expect.hpp"

#include <cmath>
#include <random>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

constexpr auto threshold = 2.0 * metre;
constexpr auto half_width = 0.25 * metre;

void expect_after(bool above, double value, bool right, const std::string& why) {
    const bool yours = exercise::above_after(above, value * metre, threshold, half_width);
    const auto said = [](bool is_above) { return is_above ? "above" : "below"; };
    std::ostringstream text;
    text << "was " << said(above) << ", and the value is " << value
         << " m; threshold 2 m, half-width 0.25 m\n    yours  " << said(yours) << "\n    right  " << said(right) << '\n'
         << why;
    expect(yours == right, text.str());
}

/// Turns in n updates of normal noise around the threshold, with a band of half-width w times its deviation.
int turns_in_noise(double w, int n) {
    std::mt19937_64 random(11);
    const auto uniform = [&] { return (double(random() >> 11) + 0.5) * 0x1p-53; };
    bool above = false;
    int turns = 0;
    for (int i = 0; i < n; ++i) {
        const double normal = std::sqrt(-2 * std::log(uniform())) * std::cos(2 * M_PI * uniform());
        const bool now = exercise::above_after(above, threshold + 0.1 * normal * metre, threshold, 0.1 * w * metre);
        turns += now != above;
        above = now;
    }
    return turns;
}

/// At which updates of a row of wishes a state turns.
std::vector<int> turns(const std::vector<bool>& wishes, Quantity<unit::Time> dwell, Quantity<unit::Time> dt) {
    exercise::Dwelling dwelling(dwell);
    std::vector<int> at;
    for (std::size_t i = 0; i < wishes.size(); ++i)
        if (dwelling.update(wishes[i], dt)) at.push_back(int(i) + 1);
    return at;
}
void expect_turns(const std::string& what, const std::vector<bool>& wishes, const std::vector<int>& right,
                  const std::string& why, double dt = 0.25) {
    const auto yours = turns(wishes, 1.0 * second, dt * second);
    const auto said = [](const std::vector<int>& at) {
        std::string text;
        for (const int i : at) text += (text.empty() ? "" : ", ") + std::to_string(i);
        return text.empty() ? std::string("never") : "at update " + text;
    };
    std::ostringstream text;
    text << what << ", with a dwell time of 1 s and updates of " << dt << " s\n    yours  turns " << said(yours)
         << "\n    right  turns " << said(right) << '\n'
         << why;
    expect(yours == right, text.str());
}
std::vector<bool> wishes(const std::string& signs) {
    std::vector<bool> all;
    for (const char sign : signs) all.push_back(sign == '+');
    return all;
}

} // namespace

TEST_CASE("beyond the band it follows the value", "[task-1][beyond]") {
    for (const bool above : {false, true}) {
        for (const double value : {2.26, 2.4, 9.0})
            expect_after(above, value, true, "The value is above the whole band.");
        for (const double value : {1.74, 1.6, -3.0})
            expect_after(above, value, false, "The value is below the whole band.");
    }
}

TEST_CASE("within the band it stays what it is", "[task-1][within]") {
    for (const bool above : {false, true})
        for (const double value : {1.76, 1.9, 2.0, 2.1, 2.24})
            expect_after(above, value, above, "Within the band the value says nothing: the state is the memory.");
}

TEST_CASE("in noise it turns as often as the law says", "[task-1][noise]") {
    const int n = 20000;
    for (const double w : {0.0, 1.0, 2.0, 3.0}) {
        const double law = n * 0.5 * std::erfc(w / std::sqrt(2.0));
        std::ostringstream text;
        text << "turns in " << n << " updates of normal noise on the threshold, half-width " << w
             << " sigma\n    yours  " << turns_in_noise(w, n) << "\n    right  " << law << ", give or take "
             << 5 * std::sqrt(law)
             << "\nAn update turns it when the noise is beyond the far edge: with the probability erfc(w / sqrt 2) / "
                "2. Five standard deviations of that count are allowed.";
        expect(std::abs(turns_in_noise(w, n) - law) <= 5 * std::sqrt(law), text.str());
    }
}

TEST_CASE("it turns when it has dwelt and wants to", "[task-2][dwells]") {
    expect_turns("wanting to from the first update on", wishes("+++++++++++++"), {4, 8, 12},
                 "After 1 s, which is four updates, and then anew.");
    expect_turns("wanting to only after 1.5 s", wishes("-----+---+"), {6, 10},
                 "By then it has been in its state for long enough: it turns at once.");
    expect_turns("wanting to twice, too early", wishes("-+-+"), {4},
                 "The first wish comes after 0.5 s, the second after 1 s.");
    expect_turns("wanting to from the first update on", wishes("++++"), {3},
                 "Three updates are 1.125 s and two are only 0.75 s: the third turns it, since the time that it takes "
                 "counts too.",
                 0.375);
}

TEST_CASE("after a turn the time begins at nothing", "[task-2][anew]") {
    expect_turns("wanting to only after 2 s, and from then on", wishes("-------++++++"), {8, 12},
                 "It turns after 2 s, when the dwell time has long been over. The second that it has waited since then "
                 "is no time in the new state.");
    expect_turns("wanting to from the first update on", wishes("++++++++++"), {3, 6, 9},
                 "Each turn comes after 1.125 s, three updates. What is more than a second belongs to the old state.",
                 0.375);
}

TEST_CASE("what counts is the time in the state, not that of the wish", "[task-2][wish]") {
    expect_turns("with a wish that comes and goes", wishes("+-+-+-+-+-+-"), {5, 9},
                 "A noisy wish is still a wish. Who begins to wait anew whenever it goes may wait for ever.");
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1) {
        for (const bool above : {false, true})
            for (const double value : {1.4, 1.7, 1.8, 1.95, 2.05, 2.2, 2.3, 2.6})
                numbers.push_back(exercise::above_after(above, value * metre, threshold, half_width));
    } else {
        for (const char* signs : {"+++++++++", "-----+---+", "+-+-+-+-+-", "-+-+++"})
            for (const int at : turns(wishes(signs), 1.0 * second, 0.25 * second)) numbers.push_back(at);
        for (const char* signs : {"+++++++++", "------++++++"})
            for (const int at : turns(wishes(signs), 1.0 * second, 0.375 * second)) numbers.push_back(at);
    }
    return numbers;
}
