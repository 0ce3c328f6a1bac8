// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What a machine remembers, field by field, to write it down and read it back (save.hpp). Guards with a Memory
/// and state classes with data say what they consist of, once:
///
///     struct Patrol {
///         int corner = 0;
///         Quantity<unit::Time> waited{};
///         static void fields(auto& self, auto&& field) {
///             field("corner", self.corner);
///             field("waited", self.waited);
///         }
///     };
///
/// A field is a number, a bool, an enumeration, a quantity of one number, a text, a std::vector or std::array of these,
/// or something with fields of its own.

#include <ansatz/states/guards.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>

namespace ansatz::states {

/// Takes fields one after the other: writes what it is shown, or replaces it by what it has read.
class Archive {
public:
    virtual ~Archive() = default;
    virtual void flag(std::string_view name, bool& x) = 0;     ///< yes or no
    virtual void number(std::string_view name, double& x) = 0; ///< any number
    /// A whole number within bounds.
    virtual void whole(std::string_view name, std::int64_t& x, std::int64_t least, std::int64_t most) = 0;
    virtual void natural(std::string_view name, std::uint64_t& x) = 0; ///< a whole number of 64 bits without a sign
    virtual void text(std::string_view name, std::string& x) = 0;      ///< a text
    virtual void open(std::string_view name) = 0;                      ///< what follows is inside this
    virtual void close() = 0;                                          ///< and that was all of it
    virtual void count(std::string_view name, std::size_t& size) = 0;  ///< how many are in a list
    virtual bool reads() const = 0;                                    ///< whether it replaces what it is shown
    /// Refuses what was read last. \param expected what would have been right
    [[noreturn]] virtual void refuse_here(std::string_view name, const std::string& expected) const = 0;
};

namespace detail {
struct AnyFieldOfState {
    void operator()(std::string_view, auto&) const {}
};
/// Whether something says what it consists of.
template <class T>
concept SaysFields = requires(T& x) { T::fields(x, AnyFieldOfState{}); };
template <class T>
inline constexpr bool is_quantity_of_one_number = requires(const T& q) {
    { q.value() } -> std::convertible_to<double>;
    T::from_value(q.value());
};
template <class T>
inline constexpr bool is_list_of_fields = requires(T& list) {
    list[0];
    list.size();
    typename T::value_type;
} && !std::is_same_v<T, std::string>;

/// Whether a class can be written down.
template <class T> inline constexpr bool is_archived = SaysFields<T> || std::is_empty_v<T>;

template <class T> void archive_field(Archive& a, std::string_view name, T& x) {
    if constexpr (std::is_same_v<T, bool>) a.flag(name, x);
    else if constexpr (std::is_floating_point_v<T>) {
        double number = double(x);
        a.number(name, number);
        x = T(number);
    } else if constexpr (std::is_enum_v<T>) {
        auto number = static_cast<std::underlying_type_t<T>>(x);
        archive_field(a, name, number);
        x = T(number);
    } else if constexpr (std::is_unsigned_v<T> && sizeof(T) >= sizeof(std::uint64_t)) {
        std::uint64_t number = x; // the upper half of its numbers is no int64_t
        a.natural(name, number);
        x = T(number);
    } else if constexpr (std::is_integral_v<T>) {
        auto number = std::int64_t(x);
        a.whole(name, number, std::int64_t(std::numeric_limits<T>::min()), std::int64_t(std::numeric_limits<T>::max()));
        x = T(number);
    } else if constexpr (std::is_same_v<T, std::string>) a.text(name, x);
    else if constexpr (SaysFields<T>) {
        a.open(name);
        T::fields(x, [&](std::string_view inner, auto& field) { archive_field(a, inner, field); });
        a.close();
    } else if constexpr (is_quantity_of_one_number<T>) {
        auto number = double(x.value());
        a.number(name, number);
        x = T::from_value(static_cast<std::remove_cvref_t<decltype(x.value())>>(number));
    } else if constexpr (is_list_of_fields<T>) {
        a.open(name);
        std::size_t size = x.size();
        a.count("count", size);
        if constexpr (requires { x.resize(size); }) x.resize(size);
        else if (size != x.size()) a.refuse_here("count", std::to_string(x.size()));
        for (std::size_t i = 0; i < size; ++i) {
            if constexpr (std::is_same_v<decltype(x[i]), typename T::value_type&>)
                archive_field(a, std::to_string(i), x[i]);
            else { // of a std::vector<bool>, which holds bits
                typename T::value_type one = x[i];
                archive_field(a, std::to_string(i), one);
                x[i] = one;
            }
        }
        a.close();
    } else
        static_assert(std::is_empty_v<T>,
                      "Ansatz: a machine cannot be saved whose guard or state class holds something of which it is not "
                      "known what it consists of; give it `static void fields(auto& self, auto&& field)`, which calls "
                      "field(\"name\", self.name) for each of its members");
}
} // namespace detail

} // namespace ansatz::states
