// SPDX-License-Identifier: BSL-1.0
// The unit types against Boost's own, the constants, and making scalar quantities with them.

#include <ansatz/units/unit.hpp>

#include "tests/catch.hpp"

#include "tests/units/spaces.hpp"

#include <boost/units/systems/si.hpp>

using namespace ansatz;
using namespace ansatz::test;
namespace si = boost::units::si;

// The lists written down in unit.hpp are the ones that Boost computes.
static_assert(same<unit::Dimensionless, si::dimensionless> && same<unit::Length, si::length>);
static_assert(same<unit::Area, si::area> && same<unit::Volume, si::volume> &&
              same<unit::InverseLength, si::wavenumber>);
static_assert(same<unit::Time, si::time> && same<unit::Frequency, si::frequency> && same<unit::Mass, si::mass>);
static_assert(same<unit::Velocity, si::velocity> && same<unit::Acceleration, si::acceleration>);
static_assert(same<unit::Force, si::force> && same<unit::Energy, si::energy> && same<unit::Power, si::power>);
static_assert(same<unit::Momentum, si::momentum> && same<unit::Impulse, si::momentum>);
static_assert(same<unit::Pressure, si::pressure> && same<unit::Density, si::mass_density>);
static_assert(same<unit::AreaDensity, si::surface_density> && same<unit::Stiffness, si::surface_tension>);
static_assert(same<unit::Viscosity, si::dynamic_viscosity> && same<unit::Diffusivity, si::kinematic_viscosity>);
static_assert(same<unit::SpecificEnergy, si::absorbed_dose> && same<unit::PlaneAngle, si::plane_angle>);

// What physics says about the rest.
template <class A, class B> using Product = typename boost::units::multiply_typeof_helper<A, B>::type;
template <class A, class B> using Quotient = typename boost::units::divide_typeof_helper<A, B>::type;
static_assert(same<Product<unit::Mass, unit::Acceleration>, unit::Force>);
static_assert(same<Product<unit::Force, unit::Length>, unit::Torque>);
static_assert(same<Product<unit::Force, unit::Time>, unit::Impulse>);
static_assert(same<Product<unit::Stiffness, unit::Length>, unit::Force>);
static_assert(same<Product<unit::Stiffness, unit::Compliance>, unit::Dimensionless>);
static_assert(same<Product<unit::Damping, unit::Velocity>, unit::Force>);
static_assert(same<Product<unit::QuadraticDrag, unit::SpecificEnergy>, unit::Force>);
static_assert(same<Product<unit::Mass, unit::InverseMass>, unit::Dimensionless>);
static_assert(same<Product<unit::Inertia, unit::InverseInertia>, unit::Dimensionless>);
static_assert(same<Product<unit::Inertia, unit::FrequencySquared>, unit::Torque>);
static_assert(same<Product<unit::Inertia, unit::Frequency>, unit::AngularMomentum>);
static_assert(same<Product<unit::Length, unit::Momentum>, unit::AngularMomentum>);
static_assert(same<Product<unit::Frequency, unit::Length>, unit::Velocity>);
static_assert(same<Product<unit::Jerk, unit::Time>, unit::Acceleration>);
static_assert(same<Product<unit::LineDensity, unit::Length>, unit::Mass>);
static_assert(same<Product<unit::Time, unit::Time>, unit::TimeSquared>);
static_assert(same<Product<unit::Area, unit::InverseArea>, unit::Dimensionless>);
static_assert(same<Product<unit::Area, unit::Velocity>, unit::VolumeFlow>);
static_assert(
    same<Quotient<Product<Product<unit::GravitationalConstant, unit::Mass>, unit::Mass>, unit::Area>, unit::Force>);

// Each constant has the unit that its name says.
template <class A, auto& Constant>
inline constexpr bool is_of = same<A, std::remove_const_t<std::remove_reference_t<decltype(Constant)>>>;
static_assert(is_of<decltype(newton * metre), joule> && is_of<decltype(newton * metre), newton_metre>);
static_assert(is_of<decltype(joule / second), watt> && is_of<decltype(newton / square_metre), pascal>);
static_assert(is_of<decltype(kilogram * metre_per_second_squared), newton>);
static_assert(is_of<decltype(metre * metre), square_metre> && is_of<decltype(square_metre * metre), cubic_metre>);
static_assert(is_of<decltype(metre / second), metre_per_second> && is_of<unit::Frequency, hertz>);
static_assert(is_of<unit::PlaneAngle, radian> && is_of<decltype(metre_per_second / second), metre_per_second_squared>);
static_assert(same<decltype(newton * second), decltype(kilogram * metre_per_second)>);
static_assert(is_of<decltype(newton * second), newton_second> &&
              is_of<decltype(newton * second), kilogram_metre_per_second>);
static_assert(is_of<decltype(newton * second / metre), newton_second_per_metre>);
static_assert(is_of<decltype(newton / metre), newton_per_metre>);
static_assert(is_of<decltype(kilogram / cubic_metre), kilogram_per_cubic_metre>);
static_assert(is_of<decltype(kilogram / metre), kilogram_per_metre>);
static_assert(is_of<decltype(pascal * second), pascal_second>);
static_assert(is_of<decltype(kilogram * square_metre), kilogram_square_metre>);
static_assert(is_of<decltype(kilogram / second), kilogram_per_second>);

// Numbers and constants.
static_assert(same<decltype(0.5 * metre), Quantity<unit::Length>>);
static_assert(same<decltype(metre * 0.5), Quantity<unit::Length>>);
static_assert(same<decltype(0.05 / second), Quantity<unit::Frequency>>);
static_assert(same<decltype(2 * kilogram), Quantity<unit::Mass>>);
static_assert(same<decltype(kilogram * 2), Quantity<unit::Mass>>);
static_assert(same<decltype(2u / second), Quantity<unit::Frequency>>);
static_assert(same<decltype(2L * metre), Quantity<unit::Length>>);
static_assert(std::is_base_of_v<Quantity<unit::Time>,
                                decltype(2L * second)>); // which the doors that take a time tell from 2.0 * second
static_assert(same<decltype(0.5f * metre), Quantity<unit::Length, float>>);
static_assert(same<decltype(Precise(2) * metre), Quantity<unit::Length, Precise>>);
static_assert(same<decltype(9.81 * metre / second / second), Quantity<unit::Acceleration>>);
static_assert(same<decltype(3 * metre * metre), Quantity<unit::Area>>);

TEST_CASE("a number times a unit is a quantity", "[units]") {
    CHECK((0.5 * metre).value() == 0.5);
    CHECK((metre * 0.5).value() == 0.5);
    CHECK((0.05 / second).value() == 0.05);
    CHECK((1.0 / 60 * second).value() == 1.0 / 60);
    CHECK((2 * kilogram).value() == 2.0);
    CHECK((4 / second).value() == 4.0);
    CHECK((3 * metre * metre / second).value() == 3.0);
}

TEST_CASE("whole numbers never divide as whole numbers", "[units]") {
    CHECK((1 * metre / 2).value() == 0.5);
    CHECK((metre / 2).value() == 0.5);
    CHECK((metre / 2.0).value() == 0.5);
    CHECK((1 / (2 * second)).value() == 0.5);
    CHECK((1 * metre / (2 * second)).value() == 0.5);
    CHECK((1 * newton / 3).value() == 1.0 / 3);
}
