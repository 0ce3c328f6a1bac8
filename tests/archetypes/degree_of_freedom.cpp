// SPDX-License-Identifier: BSL-1.0
// DegreeOfFreedomIn: an archetype, two models, near misses.

#include "tests/archetypes/archetype.hpp"

namespace ansatz::archetypes {

using S = Space<>;

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
using A = S::ScalarOf<unit::FrequencySquared>;

struct OneDegree : NothingMore {
    using NothingMore::NothingMore;
    using role = roles::DegreeOfFreedom;
    using position = Heat;
    using velocity = Warming;
    template <class> struct In : NothingMore {
        explicit In(const OneDegree&) : NothingMore(1) {}
        A acceleration(const value_of<Heat, S>&, const value_of<Warming, S>&, const Context<S, false>&) const {
            return {};
        }
    };
};
static_assert(DegreeOfFreedomIn<OneDegree, S>);
auto of_one_degree() { return use(World{SemiImplicitEuler{}, OneDegree(1)}); }

/// A model: of a vector, which reads a column and the time.
struct Wind {
    using Unit = unit::Length;
    static constexpr Shape shape = Shape::vector;
    static constexpr std::string_view name = "wind";
};
struct WindSpeed {
    using Unit = unit::Velocity;
    static constexpr Shape shape = Shape::vector;
    static constexpr std::string_view name = "wind speed";
};
struct Vectors {
    using role = roles::DegreeOfFreedom;
    using position = Wind;
    using velocity = WindSpeed;
    using reads = Columns<Position, Clock>;
    template <class S_> struct In {
        explicit In(const Vectors&) {}
        auto acceleration(const auto&, const auto&, const auto& x, const auto& context) const {
            const auto t = S_::Time::from_value(typename S_::Scalar(1 + context.time().value()));
            return x / (t * t);
        }
    };
};
static_assert(DegreeOfFreedomIn<Vectors, S> && DegreeOfFreedomIn<Vectors, Space<float, 2>>);
auto of_vectors() { return use(World{RungeKutta4{}, Vectors{}, OneDegree(1)}); }

// Near misses: no velocity, a law that asks for more than it reads, a rate of another unit.
struct WithoutVelocity {
    using role = roles::DegreeOfFreedom;
    using position = Heat;
    template <class> struct In : OneDegree::In<S> {
        explicit In(const WithoutVelocity&) : OneDegree::In<S>(OneDegree(1)) {}
    };
};
struct AsksForMore {
    using role = roles::DegreeOfFreedom;
    using position = Heat;
    using velocity = Warming;
    template <class> struct In {
        explicit In(const AsksForMore&) {}
        A acceleration(const auto&, const auto&, const auto&, const auto&) const { return {}; }
    };
};
struct AnotherRate {
    using role = roles::DegreeOfFreedom;
    using position = Wind;
    using velocity = Warming;
    template <class> struct In {
        explicit In(const AnotherRate&) {}
        A acceleration(const auto&, const auto&, const auto&) const { return {}; }
    };
};
static_assert(!DegreeOfFreedomIn<WithoutVelocity, S> && !DegreeOfFreedomIn<AsksForMore, S> &&
              !DegreeOfFreedomIn<AnotherRate, S>);

} // namespace ansatz::archetypes
