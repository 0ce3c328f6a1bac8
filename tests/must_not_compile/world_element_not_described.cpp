// expect: World::get: the rows of these elements cannot be described; give the row `describe(const auto& handle_of) const`
// SPDX-License-Identifier: BSL-1.0
// What world.get answers is the description that the row makes.

#include <ansatz/world.hpp>

using namespace ansatz;

struct Tie {
    using element = Tie;
    Handle first, second;
};
struct TieRow {
    BodyId first, second;
    static void fields(auto& self, auto&& field) {
        field("first", self.first);
        field("second", self.second);
    }
    static TieRow from(const auto& asked, const Tie& tie) { return {asked.body(tie.first), asked.body(tie.second)}; }
#ifndef ANSATZ_MISTAKE
    Tie describe(const auto& handle_of) const { return {handle_of(first), handle_of(second)}; }
#endif
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
    return world.get(tie).first == a ? 0 : 1;
}
