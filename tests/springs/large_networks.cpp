// SPDX-License-Identifier: BSL-1.0
// Networks of hundreds of bodies that come, go, sleep and are fixed, solved with groups that move as wholes, beside the
// direct solver.

#include <ansatz/motion/integrators/matrix_free.hpp>
#include <ansatz/world/save.hpp>

#include "tests/dice.hpp"
#include "tests/springs/support.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

using namespace spring_tests;

namespace {

using Quick = ImplicitEulerBy<MatrixFree>;

template <class S, class I> auto network_by(const I& integrator) {
    return World{integrator, S{}, Gravity{}, Springs<Breaking>{}, Ropes<>{}, Rest{}};
}

/// The same verbs upon two worlds.
template <class S> struct Two {
    using T = typename S::Scalar;
    decltype(network_by<S>(Quick{})) quick =
        network_by<S>(Quick{.tolerance = std::is_same_v<T, float> ? 1e-5 : 1e-11, .most_iterations = 100});
    decltype(network_by<S>(ImplicitEulerDirect{})) direct = network_by<S>(ImplicitEulerDirect{});
    std::vector<Handle> bodies;
    test::Dice dice;

    explicit Two(std::uint64_t seed) : dice(seed) {}
    void both(const auto& f) { f(quick), f(direct); }
    auto somewhere(double wide) {
        return vector_in<S, unit::Length>(dice.number(0, wide), dice.number(0, wide), dice.number(0, wide));
    }
    void add_body(double wide) {
        const auto place = somewhere(wide);
        const double m = dice.number(0.02, 0.5);
        const int kind = dice.below(20);
        Handle body;
        both([&](auto& world) {
            body = kind == 0   ? world.add(position(place), fixed)
                   : kind == 1 ? world.add(position(place), mass(m * kilogram), resting)
                               : world.add(position(place), mass(m * kilogram));
        });
        bodies.push_back(body);
    }
    /// Stretched, so that its matrix is the whole of its Jacobian; a rope may become slack.
    void add_link() {
        const Handle a = bodies[dice.below(bodies.size())], b = bodies[dice.below(bodies.size())];
        const double length = double(norm(quick.position(a) - quick.position(b)).value());
        if (length < 0.05 || (quick.motion(a) == Motion::fixed && quick.motion(b) == Motion::fixed)) return;
        const double k = dice.number(1, 100) * (dice.one_in(10) ? 10 : 1), c = dice.number(0, 0.1);
        const bool rope = dice.one_in(5), anchored = dice.one_in(10);
        const auto anchor = somewhere(1);
        both([&](auto& world) {
            if (rope) world.add(Rope{a, b, k * N_per_m, c * N_s_per_m, 0.8 * length * metre});
            else if (anchored) world.add(Spring{a, anchor, k * N_per_m, c * N_s_per_m, 0.0 * metre});
            else world.add(Spring{a, b, k * N_per_m, c * N_s_per_m, 0.9 * length * metre});
        });
    }
    void remove_body() {
        const auto which = dice.below(bodies.size());
        both([&](auto& world) { world.remove(bodies[which]); });
        bodies.erase(bodies.begin() + std::ptrdiff_t(which));
    }
    /// \return how far they are apart at most, m; then the one is where the other is
    double compare() {
        double most = 0;
        for (const Handle body : bodies) {
            REQUIRE(quick.motion(body) == direct.motion(body));
            most = std::max(most, double(norm(quick.position(body) - direct.position(body)).value()));
            if (quick.motion(body) != Motion::awake) continue;
            quick.set_position(body, direct.position(body));
            quick.set_velocity(body, direct.velocity(body));
        }
        return most;
    }
};

} // namespace

TEMPLATE_TEST_CASE("large networks end where the direct solver takes them, whatever comes, goes and sleeps",
                   "[springs][implicit]", Space<double>, (Space<float>), (Space<double, 2>)) {
    using S = TestType;
    const double close = std::is_same_v<typename S::Scalar, float> ? 2e-4 : 1e-8;
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        Two<S> two(seed);
        for (int n = 0; n < 120 + 100 * int(seed); ++n) two.add_body(2);
        for (std::size_t n = 0; n < 3 * two.bodies.size(); ++n) two.add_link();
        for (int step = 0; step < 12; ++step) {
            CAPTURE(seed, step);
            if (step % 3 == 1) two.remove_body();
            if (step % 3 == 2) two.add_body(2), two.add_link();
            auto copy = two.quick;
            std::stringstream file;
            save(two.quick, file);
            auto loaded = network_by<S>(Quick{});
            load(loaded, file);
            two.both([](auto& world) { world.step(1.0 / 240 * second); });
            REQUIRE(two.quick.status().unsolved == 0);
            copy.step(1.0 / 240 * second);
            loaded.step(1.0 / 240 * second);
            REQUIRE(copy.hash() == two.quick.hash());
            REQUIRE(loaded.hash() == two.quick.hash());
            REQUIRE(two.compare() <= close);
        }
    }
}
