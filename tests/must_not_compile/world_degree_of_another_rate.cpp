// expect: a degree of freedom whose columns do not go together
// SPDX-License-Identifier: BSL-1.0
// What changes a number by v dt has the unit of that number by time.

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

struct Speed {
    using Unit = unit::Velocity;
    static constexpr Shape shape = Shape::scalar;
    static constexpr std::string_view name = "speed";
};
struct Mine {
    using role = roles::DegreeOfFreedom;
    using position = Heat;
#ifdef ANSATZ_MISTAKE
    using velocity = Speed;
#else
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
