// expect: this integrator advances translation alone
// SPDX-License-Identifier: BSL-1.0
// Verlet keeps where a body was; of another degree of freedom it would have to keep what it was, and nobody says so.

#include <ansatz/world.hpp>

using namespace ansatz;

struct Heat {
    using Unit = unit::Dimensionless;
    static constexpr Shape shape = Shape::scalar;
    static constexpr std::string_view name = "heat";
};
struct Warming {
    using Unit = unit::Frequency;
    static constexpr Shape shape = Shape::scalar;
    static constexpr std::string_view name = "warming";
};

struct Mine {
    using role = roles::DegreeOfFreedom;
    using position = Heat;
    using velocity = Warming;
    template <class S> struct In {
        explicit In(const Mine&) {}
        auto acceleration(const auto&, const auto& v, const auto&) const {
            return -S::convert("rate", Quantity<unit::Frequency>(1.0 / second)) * v;
        }
    };
};

#ifdef ANSATZ_MISTAKE
using Integrator = Verlet;
#else
using Integrator = RungeKutta4;
#endif

void use() { World world{Integrator{}, Mine{}}; }
