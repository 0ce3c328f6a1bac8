// expect: keeps a State of which the world does not know what it consists of
// SPDX-License-Identifier: BSL-1.0
// How a state is hashed and saved follows from its fields.

#include <ansatz/world.hpp>

using namespace ansatz;

struct Weather {
    using role = roles::System;
    static constexpr std::string_view name = "Weather";
    template <class S> struct State {
        double wind = 0;
#ifndef ANSATZ_MISTAKE
        static void fields(auto& self, auto&& field) { field("wind", self.wind); }
#endif
    };
};

int main() {
    World world{SemiImplicitEuler{}, Weather{}};
    return int(world.hash() % 2);
}
