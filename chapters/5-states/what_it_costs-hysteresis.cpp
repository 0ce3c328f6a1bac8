// SPDX-License-Identifier: BSL-1.0
// What a band of hysteresis lets through

// A value on the threshold, with normal noise. An update turns the machine when the noise is beyond the far edge of the
// band, w sigma away: n updates make n erfc(w / sqrt 2) / 2 transitions, give or take its root.

#include "what_it_costs.hpp"

#include "plot.hpp"

#include <ansatz/states.hpp>

#include <cmath>
#include <filesystem>
#include <ostream>
#include <random>
#include <vector>

using namespace ansatz;
using workbook::Axis;
using workbook::Costs;
using workbook::Outcome;
using workbook::Row;
using workbook::Rows;

namespace {

constexpr int updates = 100000;
const Axis width{.name = "hysteresis",
                 .error_norm = "|transitions - law| / sqrt(law)",
                 .work_unit = "transitions in 100000 updates",
                 .time_unit = "ns an update",
                 .has_order = false};

struct Ear {
    Quantity<unit::Length> distance = 1.0 * metre;
};
constexpr auto sigma = 0.05 * metre;
/// A band of half-width (quarters / 4) sigma.
template <int Quarters> struct Sentry {
    using Context = Ear;
    static constexpr auto edge =
        states::band(states::value("distance", &Ear::distance), 1.0 * metre, Quarters * 0.25 * sigma);
    static constexpr auto machine = [] {
        using namespace states;
        return states::machine(state("near", transition(when(edge.above()), to("far"))),
                               state("far", transition(when(edge.below()), to("near"))));
    }();
};

const std::vector<Quantity<unit::Length>>& measurements() {
    static const std::vector<Quantity<unit::Length>> all = [] {
        std::mt19937_64 random(6);
        const auto uniform = [&] { return (double(random() >> 11) + 0.5) * 0x1p-53; };
        std::vector<Quantity<unit::Length>> list;
        for (int i = 0; i < updates; ++i)
            list.push_back(1.0 * metre + std::sqrt(-2 * std::log(uniform())) * std::cos(2 * M_PI * uniform()) * sigma);
        return list;
    }();
    return all;
}
double law(double w) { return updates * 0.5 * std::erfc(w / std::sqrt(2.0)); }

template <int Quarters> int transitions() {
    Ear ear;
    Machine<Sentry<Quarters>> sentry;
    sentry.start(ear);
    int count = 0;
    for (const auto& distance : measurements()) {
        ear.distance = distance;
        count += sentry.update(ear);
    }
    return count;
}
template <int Quarters> void add_row(Costs& costs) {
    const double w = 0.25 * Quarters;
    costs.add(width, {.choice = "band(value, threshold, w sigma)",
                      .problem = "normal noise on the threshold",
                      .parameter = {"w", w},
                      .error_run =
                          [w] {
                              const int counted = transitions<Quarters>();
                              return Outcome{.error = std::abs(counted - law(w)) / std::sqrt(law(w)),
                                             .work = double(counted)};
                          },
                      .timed_run = [] { return transitions<Quarters>(); },
                      .per = double(updates)});
}

void picture_of_widths(std::ostream&, const Rows& all, const std::filesystem::path& folder) {
    std::vector<double> widths, counted, fine;
    for (const Row& row : all)
        if (row.axis == width.name && row.work && *row.work > 0)
            widths.push_back(*row.parameter.value), counted.push_back(*row.work);
    if (widths.empty()) return;
    for (double w = 0; w <= 5; w += 0.1) fine.push_back(w);
    workbook::Plot plot("", "What a band of hysteresis lets through");
    plot.x("half-width of the band, sigma").y("transitions in 100000 updates").log_y();
    plot.reference("n erfc(w / sqrt 2) / 2", fine, law).points("counted", widths, counted);
    workbook::draw(folder / "states-hysteresis-against-width.svg", plot.script());
}

} // namespace

void state_costs::add_hysteresis(Costs& costs) {
    add_row<0>(costs), add_row<2>(costs), add_row<4>(costs), add_row<6>(costs), add_row<8>(costs);
    add_row<10>(costs), add_row<12>(costs), add_row<16>(costs), add_row<20>(costs);
    costs.add_summary(picture_of_widths);
}
