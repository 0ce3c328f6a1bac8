// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What can be wrong with the properties that `World::add` is given, each with its sentence. Included by door.hpp.
// not in the umbrella: it is a part of door.hpp, which includes it

#include <ansatz/world/composition.hpp>
#include <ansatz/world/held_parameters.hpp>
#include <ansatz/world/properties.hpp>
#include <ansatz/world/user_data.hpp>

#include <concepts>
#include <type_traits>

namespace ansatz::detail {

template <class T> inline constexpr bool is_given = false;
template <class C, class Q> inline constexpr bool is_given<Given<C, Q>> = true;
template <class Q> inline constexpr bool is_given<GivenMass<Q>> = true;
template <class T> inline constexpr bool is_given_datum = false;
template <class T> inline constexpr bool is_given_datum<GivenDatum<T>> = true;
template <class T>
inline constexpr bool is_kind = std::same_as<T, Fixed> || std::same_as<T, Moving> || std::same_as<T, Resting>;
template <class T>
inline constexpr bool is_property = is_given<T> || is_given_datum<T> || is_kind<T> || std::same_as<T, Shapeless> ||
                                    !std::is_void_v<typename ModuleOfProperty<T>::type>;

template <class C, class T> inline constexpr bool gives = false;
template <class C, class Q> inline constexpr bool gives<C, Given<C, Q>> = true;
template <class Q> inline constexpr bool gives<InverseMass, GivenMass<Q>> = true;

/// The datum among the properties, or a new one.
template <class DatumT, class... Property> auto given_datum([[maybe_unused]] const Property&... property) {
    if constexpr (std::is_void_v<DatumT>) return Absent{};
    else {
        DatumT datum{};
        [[maybe_unused]] auto take = [&](const auto& given) {
            if constexpr (is_given_datum<std::remove_cvref_t<decltype(given)>>) datum = given.value;
        };
        (take(property), ...);
        return datum;
    }
}

template <class C, class T> inline constexpr bool gives_column = false;
template <class C, class Q> inline constexpr bool gives_column<C, Given<C, Q>> = true;
template <class DatumT, class T> inline constexpr bool fits_datum = true;
template <class DatumT, class T>
    requires(!std::is_void_v<DatumT>)
inline constexpr bool fits_datum<DatumT, GivenDatum<T>> = std::is_convertible_v<const T&, DatumT>;

/// Whether some policy of a world puts bodies to rest.
template <class C> inline constexpr bool rests_in = requires { requires C::rests; };

/// \tparam DatumT the datum that the world keeps, or void
template <class C, class DatumT, class... Property> struct AddFacts {
    template <class Column_> static constexpr int given = (0 + ... + int(gives<Column_, Property>));
    template <class T> static constexpr bool given_twice() {
        if constexpr (is_given<T>) return given<typename T::column> > 1;
        return false;
    }

    static constexpr bool properties = (is_property<Property> && ...);
    static constexpr bool one_kind = (0 + ... + int(is_kind<Property>)) <= 1;
    static constexpr bool once = !(given_twice<Property>() || ...) && (0 + ... + int(is_given_datum<Property>)) <= 1 &&
                                 (0 + ... + int(std::same_as<Property, Shapeless>)) <= 1;
    static constexpr bool mass_by_name = !(gives_column<InverseMass, Property> || ...);
    static constexpr bool no_history = !(gives_column<PreviousPosition, Property> || ...);
    static constexpr bool own_columns =
        !((gives_column<RestTime, Property> || gives_column<DrawnPosition, Property> ||
           gives_column<AppliedForce, Property> || gives_column<CoupledForce, Property>) ||
          ...);
    static constexpr bool is_fixed = (std::same_as<Property, Fixed> || ...);
    static constexpr bool is_moving = (std::same_as<Property, Moving> || ...);
    static constexpr bool is_resting = (std::same_as<Property, Resting> || ...);
    static constexpr bool immovable = is_fixed || is_moving;
    static constexpr bool mass_wanted = given<InverseMass> == 0 || C::has_mass;
    static constexpr bool mass_there = given<InverseMass> == 1 || !C::has_mass || immovable;
    static constexpr bool infinite_mass = given<InverseMass> == 0 || !immovable;
    static constexpr bool fixed_stands = given<Velocity> == 0 || !is_fixed;
    static constexpr bool resting_stands = given<Velocity> == 0 || !is_resting;
    static constexpr bool can_rest = rests_in<C> || !is_resting;
    static constexpr bool datum_kept = !std::is_void_v<DatumT> || !(is_given_datum<Property> || ...);
    static constexpr bool datum_fits = (fits_datum<DatumT, Property> && ...);
    static constexpr bool ok = properties && one_kind && once && mass_by_name && no_history && own_columns &&
                               mass_wanted && mass_there && infinite_mass && fixed_stands && resting_stands &&
                               can_rest && datum_kept && datum_fits;
};
/// By name: clang prints the condition in front of the sentence.
template <class Facts> struct CheckAdd : Facts {
    using Facts::properties, Facts::one_kind, Facts::once, Facts::mass_by_name, Facts::no_history, Facts::own_columns,
        Facts::mass_wanted, Facts::mass_there, Facts::infinite_mass, Facts::fixed_stands, Facts::resting_stands,
        Facts::can_rest, Facts::datum_kept, Facts::datum_fits;

    static_assert(properties, "Ansatz: add takes named properties; write e.g. add(position(metres(0, 10, 0)), "
                              "velocity(metres_per_second(1, 0, 0)), mass(2.0 * kilogram))");
    static_assert(one_kind, "Ansatz: add: a body is one of fixed, moving or resting");
    static_assert(once, "Ansatz: add: a property is given twice");
    static_assert(
        mass_by_name,
        "Ansatz: add: a mass is given by mass(...), e.g. mass(2.0 * kilogram), which holds it to be positive");
    static_assert(no_history,
                  "Ansatz: add: the integrator makes the history of a body from its velocity; give velocity(...)");
    static_assert(own_columns,
                  "Ansatz: add: the world itself writes this column; a force from outside is given by apply_force");
    static_assert(
        mass_wanted,
        "Ansatz: add: this world stores no mass, because none of its policies needs it (gravity "
        "accelerates every mass alike); leave mass(...) out, or add Keep<InverseMass>{} to the world's policies");
    static_assert(
        mass_there || !mass_by_name,
        "Ansatz: add: this world's policies need the mass of a body; give it, e.g. mass(2.0 * kilogram), or say fixed");
    static_assert(infinite_mass, "Ansatz: add: a fixed or moving body has infinite mass; leave mass(...) out");
    static_assert(fixed_stands,
                  "Ansatz: add: a fixed body has no velocity; a platform that moves is added as `moving`");
    static_assert(resting_stands, "Ansatz: add: a resting body has no velocity");
    static_assert(can_rest, "Ansatz: add: this world puts no bodies to rest; add Rest{} to its policies");
    static_assert(datum_kept, "Ansatz: add: this world keeps no datum of yours; add Datum<T>{} to its policies");
    static_assert(datum_fits,
                  "Ansatz: add: the datum is not of the type that the world keeps; see Datum<T> among its policies");
};

// What the modules say of the properties that are theirs; those of a module that the world has not are its to refuse.
template <class M, class C, class... Property> constexpr bool module_takes() {
    if constexpr (requires { M::template AddFacts<C, Property...>::ok; })
        return M::template AddFacts<C, Property...>::ok;
    return true;
}
template <class M, class C, class... Property> constexpr bool read_add() {
    if constexpr (!module_takes<M, C, Property...>()) return sizeof(typename M::template CheckAdd<C, Property...>) > 0;
    return true;
}
template <class C, class... Property, class... M> constexpr bool modules_take(Types<M...>) {
    return (module_takes<M, C, Property...>() && ...);
}
template <class C, class... Property, class... M> constexpr bool read_adds(Types<M...>) {
    return (read_add<M, C, Property...>() && ...);
}
/// The modules of a world, and those that properties belong to.
template <class C, class... Property> struct ModulesAsked {
    template <class List> struct With;
    template <class... M> struct With<Types<M...>> {
        using type = distinct<M..., typename ModuleOfProperty<Property>::type...>;
    };
    using type = typename With<typename C::modules>::type;
};
template <class C, class... Property>
inline constexpr bool takes = modules_take<C, Property...>(typename ModulesAsked<C, Property...>::type{});

} // namespace ansatz::detail
