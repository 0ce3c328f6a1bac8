// expect: a degree of freedom names the columns that stand for position and velocity
// SPDX-License-Identifier: BSL-1.0
// It is advanced by its columns.

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
#ifndef ANSATZ_MISTAKE
    using velocity = Warming;
#endif
    template <class S> struct In {
        explicit In(const Mine&) {}
        auto acceleration(const auto&, const auto& v, const auto&) const {
            return -S::convert("rate", Quantity<unit::Frequency>(1.0 / second)) * v;
        }
    };
};

void use() { World world{SemiImplicitEuler{}, Mine{}}; }
