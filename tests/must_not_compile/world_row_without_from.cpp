// expect: an element is kept as a row, and nothing makes one of its description; give the row `static Row from
// SPDX-License-Identifier: BSL-1.0
// A row of an element of one's own that is not made from its description.

#include <ansatz/world.hpp>

using namespace ansatz;

struct Buoy {
    using element = Buoy;
    double height = 1;
};
template <class S> struct BuoyRow {
    double height = 0;
#ifndef ANSATZ_MISTAKE
    static BuoyRow from(const auto&, const Buoy& buoy) { return {buoy.height}; }
#endif
    static void fields(auto& self, auto&& field) { field("height", self.height); }
};
struct Buoys {
    using role = roles::System;
    using Element = Buoy;
    static constexpr std::string_view name = "Buoys";
    template <class S> using State = ElementTable<S, Buoy, BuoyRow<S>>;
};

int main() {
    World world{SemiImplicitEuler{}, Buoys{}};
    world.add(Buoy{});
}
