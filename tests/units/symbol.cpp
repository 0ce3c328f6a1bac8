// SPDX-License-Identifier: BSL-1.0
// Symbols: the usual ones by name, all others by reading them back.

#include <ansatz/units/symbol.hpp>

#include "tests/catch.hpp"

#include "tests/units/spaces.hpp"

#include <boost/units/systems/si.hpp>

#include <map>
#include <string>
#include <utility>

using namespace ansatz;
namespace si = boost::units::si;

static_assert(symbol<unit::Dimensionless>().empty());
static_assert(symbol<unit::Length>() == "m" && symbol<unit::Area>() == "m^2" && symbol<unit::Volume>() == "m^3");
static_assert(symbol<unit::InverseLength>() == "1/m" && symbol<unit::Time>() == "s" &&
              symbol<unit::Frequency>() == "1/s");
static_assert(symbol<unit::FrequencySquared>() == "1/s^2" && symbol<unit::Mass>() == "kg" &&
              symbol<unit::InverseMass>() == "1/kg");
static_assert(symbol<unit::Velocity>() == "m/s" && symbol<unit::Acceleration>() == "m/s^2" &&
              symbol<unit::Force>() == "N");
static_assert(symbol<unit::Energy>() == "J" && symbol<unit::Power>() == "W" && symbol<unit::Pressure>() == "Pa");
static_assert(symbol<unit::SpecificEnergy>() == "m^2/s^2" && symbol<unit::Momentum>() == "kg m/s");
static_assert(symbol<unit::AngularMomentum>() == "kg m^2/s" && symbol<unit::Inertia>() == "kg m^2");
static_assert(symbol<unit::InverseInertia>() == "1/(kg m^2)" && symbol<unit::Density>() == "kg/m^3");
static_assert(symbol<unit::Stiffness>() == "N/m" && symbol<unit::Compliance>() == "m/N" &&
              symbol<unit::Damping>() == "kg/s");
static_assert(symbol<unit::QuadraticDrag>() == "kg/m" && symbol<unit::Viscosity>() == "Pa s");
static_assert(symbol<unit::GravitationalConstant>() == "m^3/(kg s^2)" && symbol<unit::PlaneAngle>() == "rad");
static_assert(symbol(metre_per_second) == "m/s" && symbol(newton * metre * metre) == "kg m^3/s^2");
// Units that this library has no name for.
static_assert(symbol<si::electric_charge>() == "s A" && symbol<si::temperature>() == "K" &&
              symbol<si::solid_angle>() == "sr");
static_assert(symbol<si::amount>() == "mol" && symbol<si::luminous_intensity>() == "cd" &&
              symbol<si::current>() == "A");
static_assert(symbol<si::angular_velocity>() == "rad/s" && symbol<si::torque>() == "kg m^2/(s^2 rad)");
// Rational exponents.
template <class Unit>
using Root = typename boost::units::root_typeof_helper<Unit, boost::units::static_rational<2>>::type;
static_assert(symbol<Root<unit::Length>>() == "m^(1/2)" && symbol<Root<unit::Volume>>() == "m^(3/2)");
static_assert(symbol<Root<unit::Frequency>>() == "1/s^(1/2)" && symbol<Root<unit::SpecificEnergy>>() == "m/s");
static_assert(symbol<Root<unit::Force>>() == "kg^(1/2) m^(1/2)/s");

namespace {

using Exponents = std::map<std::string, int>;

/// Reads "kg m^2/(s^3 rad)" back into exponents; knows the names of derived units.
Exponents read(std::string_view text) {
    static const std::map<std::string, Exponents> names{
        {"N", {{"kg", 1}, {"m", 1}, {"s", -2}}},
        {"J", {{"kg", 1}, {"m", 2}, {"s", -2}}},
        {"W", {{"kg", 1}, {"m", 2}, {"s", -3}}},
        {"Pa", {{"kg", 1}, {"m", -1}, {"s", -2}}},
    };
    Exponents result;
    int sign = 1;
    std::size_t i = 0;
    while (i < text.size()) {
        if (text[i] == '/') {
            sign = -1;
            ++i;
        } else if (text[i] == ' ' || text[i] == '(' || text[i] == ')' || text[i] == '1') {
            ++i;
        } else {
            std::string name;
            while (i < text.size() && std::isalpha(static_cast<unsigned char>(text[i]))) name += text[i++];
            int exponent = 1;
            if (i < text.size() && text[i] == '^') exponent = std::stoi(std::string(text.substr(++i))), ++i;
            const auto known = names.find(name);
            for (const auto& [base, power] : known == names.end() ? Exponents{{name, 1}} : known->second)
                result[base] += sign * exponent * power;
        }
    }
    std::erase_if(result, [](const auto& entry) { return entry.second == 0; });
    return result;
}

template <int Length, int Mass, int Time, int Angle> void check_one() {
    Exponents expected{{"m", Length}, {"kg", Mass}, {"s", Time}, {"rad", Angle}};
    std::erase_if(expected, [](const auto& entry) { return entry.second == 0; });
    const auto text = symbol<detail::Si<Length, Mass, Time, Angle>>();
    INFO("symbol " << text);
    CHECK(read(text) == expected);
}

// In a list, not in a fold: clang nests a fold as deep as it is long, and stops at 256.
template <int... I> void check_all(std::integer_sequence<int, I...>) {
    for (const auto check : {check_one<I % 7 - 3, I / 7 % 5 - 2, I / 35 % 7 - 3, I / 245 - 1>...}) check();
}

} // namespace

TEST_CASE("a symbol reads back as its dimension", "[units]") {
    check_all(std::make_integer_sequence<int, 7 * 5 * 7 * 3>{});
}
