// SPDX-License-Identifier: BSL-1.0
// A policy outside the library, against the public frame only: a field of columns of water with a state of its own,
// that bodies press and that carries them. What a body displaces rises in the columns around it, so that volume is
// kept.

#include <ansatz/world.hpp>
#include <ansatz/world/save.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <numeric>
#include <sstream>
#include <vector>

using namespace ansatz;

namespace {

//! [field]
/// How tall a floating block is, and how much area it has seen from above.
struct Tall {
    using Unit = unit::Length;
    static constexpr Shape shape = Shape::scalar;
    static constexpr std::string_view name = "tall";
};

struct Pool {
    using role = roles::Force; // it carries bodies, and has systems beside
    static constexpr bool couples_bodies = true;
    using reads = Columns<Position, Velocity, Tall>;
    static constexpr std::string_view name = "Pool";
    double columns = 32, cell = 0.5, depth = 2, area = 0.25, density = 1000, gravity = 9.81, drag = 800;
    static void parameters(auto&, auto&&) {}

    template <class S> struct State {
        std::vector<typename S::Scalar> volume, flow, displaced; // of each column; a flow through each right wall
        static void fields(auto& self, auto&& field) {
            field("volume", self.volume);
            field("flow", self.flow);
            field("displaced", self.displaced);
        }
    };
    std::size_t column_of(double x) const { return std::size_t(std::min(columns - 2, std::max(1.0, x / cell))); }
    template <class StateT> double level(const StateT& kept, std::size_t i) const { // read beside what lies in it
        return 0.5 * (kept.volume[i - 1] + kept.volume[i + 1]) / (cell * cell);
    }
    double under_water(double y, double tall, double surface) const {
        return area * std::min(tall, std::max(0.0, surface - (y - tall / 2)));
    }
    template <class S> struct In {
        const Pool& pool;
        explicit In(const Pool& p) : pool(p) {}
        void couple(auto& view, const auto&) const { // Archimedes, and a drag
            for (std::size_t slot = 0; slot < view.end(Motion::awake); ++slot) {
                const auto x = view.template get<Position>(slot).value();
                const auto sunk = pool.under_water(x[1], view.template get<Tall>(slot).value(),
                                                   pool.level(view.state(), pool.column_of(x[0])));
                const double v = view.template get<Velocity>(slot).value()[1];
                view.add_force(slot,
                               newtons(0, pool.density * pool.gravity * sunk - (sunk > 0 ? pool.drag * v : 0), 0));
            }
        }
    };
    template <class S> struct Waves {
        static constexpr Phase phase = phases::fields;
        static constexpr std::string_view name = "pool: waves";
        using reads = Columns<Position, Tall>;
        const Pool& pool;
        explicit Waves(const Pool& p) : pool(p) {}
        void run(auto& view, const auto& context) const {
            auto& kept = view.state();
            const double dt = context.dt().value();
            std::vector<typename S::Scalar> now(kept.volume.size());
            view.for_each([&](std::size_t slot) {
                const auto x = view.template get<Position>(slot).value();
                const auto i = pool.column_of(x[0]);
                now[i] += pool.under_water(x[1], view.template get<Tall>(slot).value(), pool.level(kept, i));
            });
            for (std::size_t i = 1; i + 1 < now.size(); ++i) { // pressed out to both sides, or sucked in
                const double more = now[i] - kept.displaced[i];
                kept.volume[i - 1] += more / 2;
                kept.volume[i + 1] += more / 2;
            }
            kept.displaced = now;
            for (std::size_t i = 0; i + 1 < now.size(); ++i) // pipes between the columns
                kept.flow[i] = 0.99 * kept.flow[i] +
                               dt * pool.gravity * pool.depth * (kept.volume[i] - kept.volume[i + 1]) / pool.cell;
            for (std::size_t i = 0; i + 1 < now.size(); ++i) {
                kept.volume[i] -= dt * kept.flow[i] / pool.cell;
                kept.volume[i + 1] += dt * kept.flow[i] / pool.cell;
            }
        }
    };
    template <class S> using systems = Types<Waves<S>>;

    template <class W, class C> class Door : public TableDoor<W, Pool> {
    public:
        void fill() {
            this->change("World::fill", [&](auto& kept) {
                const auto n = std::size_t(this->policy().columns);
                kept.volume.assign(n, this->policy().depth * this->policy().cell * this->policy().cell);
                kept.flow.assign(n, 0);
                kept.displaced.assign(n, 0);
            });
        }
        double water() const { // what is there, without what bodies have pressed up
            const auto& kept = this->kept();
            return std::accumulate(kept.volume.begin(), kept.volume.end(), 0.0) -
                   std::accumulate(kept.displaced.begin(), kept.displaced.end(), 0.0);
        }
        double level_at(double x) const { return this->policy().level(this->kept(), this->policy().column_of(x)); }
    };
};
//! [field]

template <class I> auto pool_with_blocks() {
    World world{I{}, Gravity{}, Pool{}};
    world.fill();
    world.add(position(metres(4, 2.4, 0)), mass(50.0 * kilogram), with<Tall>(0.4 * metre));
    const auto block = world.add(position(metres(11, 3, 0)), mass(60.0 * kilogram), with<Tall>(0.4 * metre));
    return std::pair(world, block);
}

} // namespace

TEMPLATE_TEST_CASE("A field of a user's own carries bodies, is pressed by them and keeps its volume", "[systems]",
                   SemiImplicitEuler, VelocityVerlet, Verlet, RungeKutta4) {
    auto [world, block] = pool_with_blocks<TestType>();
    const double at_first = world.water();
    double farthest = 0;
    for (int i = 0; i < 3000; ++i) {
        world.step(0.005 * second);
        farthest = std::max(farthest, std::abs(world.water() - at_first));
    }
    CHECK(world.status().ok());
    CHECK(farthest / at_first < 1e-12);
    // Archimedes: 60 kg under 0.25 m^2 of water sink 0.24 m below the level around them, which both have raised.
    CHECK(world.level_at(11) - (world.position(block).value()[1] - 0.2) == Approx(0.24).margin(0.005));
    CHECK(world.level_at(11) > 2.001);
}
TEST_CASE("A world with such a field is a value", "[systems]") {
    auto [world, block] = pool_with_blocks<VelocityVerlet>();
    for (int i = 0; i < 50; ++i) world.step(0.005 * second);
    auto copy = world;
    std::stringstream file;
    save(world, file);
    auto [loaded, ignored] = pool_with_blocks<VelocityVerlet>();
    CHECK(loaded.hash() != world.hash());
    load(loaded, file);
    for (auto* one : {&world, &copy, &loaded})
        for (int i = 0; i < 50; ++i) one->step(0.005 * second);
    CHECK(copy.hash() == world.hash());
    CHECK(loaded.hash() == world.hash());
    // A number of the field that is another is another hash, or is refused.
    std::string text = file.str();
    const auto flow = text.find("\"flow\"");
    REQUIRE(flow != std::string::npos);
    const auto digit = text.find_first_of("123456789", flow);
    text[digit] = text[digit] == '1' ? '2' : '1';
    std::stringstream changed(text);
    auto [other, ignored_too] = pool_with_blocks<VelocityVerlet>();
    load(other, changed);
    std::stringstream whole(file.str());
    auto [same, ignored_again] = pool_with_blocks<VelocityVerlet>();
    load(same, whole);
    CHECK(other.hash() != same.hash());
}
