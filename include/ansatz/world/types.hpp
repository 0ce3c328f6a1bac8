// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Types`: a compile-time list of types, and the few operations on such lists that a composition is made with.

#include <ansatz/core/compiler_flags.hpp>

#include <concepts>
#include <type_traits>

namespace ansatz {

/// A compile-time list of types.
template <class... T> struct Types {
    /// How many there are.
    static constexpr int size = int(sizeof...(T));
};

namespace detail {

template <class Done, template <class> class Keep, class... T> struct Filtered {
    using type = Done;
};
template <class... Done, template <class> class Keep, class First, class... Rest>
struct Filtered<Types<Done...>, Keep, First, Rest...> {
    using type = typename Filtered<std::conditional_t<Keep<First>::value, Types<Done..., First>, Types<Done...>>, Keep,
                                   Rest...>::type;
};
/// Those for which `Keep<T>::value`, in the order of the list.
template <template <class> class Keep, class... T> using filter = typename Filtered<Types<>, Keep, T...>::type;

template <class List> struct FirstIn {
    using type = void;
};
template <class First, class... Rest> struct FirstIn<Types<First, Rest...>> {
    using type = First;
};

template <class Done, class... Lists> struct JoinedTypes {
    using type = Done;
};
template <class... Done, class... T, class... Lists> struct JoinedTypes<Types<Done...>, Types<T...>, Lists...> {
    using type = typename JoinedTypes<Types<Done..., T...>, Lists...>::type;
};
/// One list of several.
template <class... Lists> using joined_types = typename JoinedTypes<Types<>, Lists...>::type;

template <class Done, class... T> struct Distinct {
    using type = Done;
};
template <class... Done, class First, class... Rest> struct Distinct<Types<Done...>, First, Rest...> {
    using type = typename Distinct<std::conditional_t<std::is_void_v<First> || (std::same_as<First, Done> || ...),
                                                      Types<Done...>, Types<Done..., First>>,
                                   Rest...>::type;
};
/// Each once, without `void`, in the order of first mention.
template <class... T> using distinct = typename Distinct<Types<>, T...>::type;

/// Whether a type stands in a list.
template <class T, class List> inline constexpr bool stands_in = false;
template <class T, class... In> inline constexpr bool stands_in<T, Types<In...>> = (std::same_as<T, In> || ...);

} // namespace detail
} // namespace ansatz
