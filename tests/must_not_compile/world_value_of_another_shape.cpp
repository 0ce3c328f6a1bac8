// expect: a value of another type belongs into this column
// SPDX-License-Identifier: BSL-1.0
// A column of a shape of one's own takes its value, or what that is made from.

#include <ansatz/world.hpp>

using namespace ansatz;

template <class Scalar> struct Pair {
    Scalar first{}, second{};
    static Pair from_lanes(const Scalar* raw) { return {raw[0], raw[1]}; }
    void to_lanes(Scalar* raw) const { raw[0] = first, raw[1] = second; }
};
struct OfTwo {
    template <class S, class> using Value = Pair<typename S::Scalar>;
    static constexpr std::size_t lanes(int) { return 2; }
};
struct Two {
    using Unit = unit::Dimensionless;
    static constexpr OfTwo shape{};
    static constexpr std::string_view name = "two";
};
struct Uses {
    using role = roles::Observer;
    using reads = Columns<Two>;
};

void use() {
    World world{SemiImplicitEuler{}, Uses{}};
#ifdef ANSATZ_MISTAKE
    world.add(with<Two>(1.0 * metre));
#else
    world.add(with<Two>(Pair<double>{1, 2}));
#endif
}
