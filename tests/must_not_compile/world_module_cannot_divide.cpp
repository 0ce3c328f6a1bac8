// expect: a policy of this world divides bodies, and a module of it keeps something of each body and does not say what becomes of it; it needs `static void on(hook::Divided, auto& data, std::uint32_t id, std::uint32_t part, const auto& share)`
// at most: 1 error
// SPDX-License-Identifier: BSL-1.0
// A module of one's own that takes a property at add, in a world whose sheets tear.

#include <ansatz/soft_bodies/tearing.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct Right {
    static constexpr bool ok = true;
};
struct Labels {
    template <class Policy, class S> using FactsOf = Right;
    template <class Policy, class S> struct SentencesOf {};
    template <class C, class... Property> using AddFacts = Right;
#ifndef ANSATZ_MISTAKE
    static void on(hook::Divided, auto&, std::uint32_t, std::uint32_t, const auto&) {}
#endif
};
struct Label {
    using module = Labels;
};
struct Labelled {
    using role = Label;
};

int main() {
    World world{SemiImplicitEuler{}, Springs<Breaking>{}, Tearing<Splitting>{}, Labelled{}};
    world.step(0.1 * second);
}
