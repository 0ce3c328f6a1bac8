// expect: ElementTable: a row needs `static void fields(auto& self, auto&& field)`
// SPDX-License-Identifier: BSL-1.0
// How a row is hashed and saved follows from its fields.

#include <ansatz/world.hpp>

using namespace ansatz;

struct Tie {
    using element = Tie;
    Handle first, second;
};
struct TieRow {
    BodyId first, second;
#ifndef ANSATZ_MISTAKE
    static void fields(auto& self, auto&& field) {
        field("first", self.first);
        field("second", self.second);
    }
#endif
    static TieRow from(const auto& asked, const Tie& tie) { return {asked.body(tie.first), asked.body(tie.second)}; }
};
struct Ties {
    using role = roles::System;
    using Element = Tie;
    static constexpr std::string_view name = "Ties";
    template <class S> using State = ElementTable<S, Tie, TieRow>;
};

int main() {
    World world{SemiImplicitEuler{}, Ties{}};
    const auto a = world.add(), b = world.add();
    const auto tie = world.add(Tie{a, b});
    world.remove(tie);
}
