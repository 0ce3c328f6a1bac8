// expect: a State with a BodyId among its fields would name a body that is gone, since nobody tells it
// SPDX-License-Identifier: BSL-1.0
// What names bodies is kept in a table whose rows go with them.

#include <ansatz/world.hpp>

using namespace ansatz;

struct Leader {
    using role = roles::System;
    static constexpr std::string_view name = "Leader";
    template <class S> struct State {
#ifdef ANSATZ_MISTAKE
        BodyId who;
#else
        double who = 0;
#endif
        static void fields(auto& self, auto&& field) { field("who", self.who); }
    };
};

int main() {
    World world{SemiImplicitEuler{}, Leader{}};
    return int(world.hash() % 2);
}
