// SPDX-License-Identifier: BSL-1.0
// A field with a state of its own that advances with the step: heat along a rod.

#include <ansatz/world.hpp>
#include <cmath>

using namespace ansatz;

//! [model]
struct Rod {
    using role = roles::System;
    static constexpr std::string_view name = "Rod";
    template <class S> struct State {
        std::vector<typename S::Scalar> heat = std::vector<typename S::Scalar>(50);
        static void fields(auto& self, auto&& field) { field("heat", self.heat); }
    };
    template <class S> struct Conduct {
        static constexpr Phase phase = phases::fields;
        static constexpr std::string_view name = "rod: conduct";
        explicit Conduct(const Rod&) {}
        void run(auto& view, const auto& context) const {
            auto& heat = view.state().heat;
            const auto was = heat;
            const auto rate = typename S::Scalar(20) * context.dt().value();
            for (std::size_t i = 0; i + 1 < heat.size(); ++i) {
                heat[i] += rate * (was[i + 1] - was[i]);
                heat[i + 1] += rate * (was[i] - was[i + 1]);
            }
        }
    };
    template <class S> using systems = Types<Conduct<S>>;
    template <class W, class C> class Door : public TableDoor<W, Rod> {
    public:
        double heat(std::size_t i) const { return this->kept().heat.at(i); }
        void warm(std::size_t i, double by) {
            this->change("World::warm", [&](auto& rod) { rod.heat.at(i) += by; });
        }
    };
};
//! [model]

int main() {
    World world{SemiImplicitEuler{}, Rod{}};
    world.warm(0, 100);
    const auto copy = world;
    for (int i = 0; i < 20000; ++i) world.step(0.01 * second);
    double sum = 0;
    for (std::size_t i = 0; i < 50; ++i) sum += world.heat(i);
    return std::abs(sum - 100) < 1e-9 && std::abs(world.heat(49) - 2) < 0.1 && copy.heat(0) == 100 ? 0 : 1;
}
