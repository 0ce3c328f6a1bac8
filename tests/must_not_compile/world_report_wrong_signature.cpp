// expect: a policy that has something to say in status(), with a wrong signature; it needs `std::string report(const auto& world, const Quantity<unit::Time>& dt) const`
// SPDX-License-Identifier: BSL-1.0
// What an observer has to say would be passed over in silence.

#include <ansatz/world.hpp>

#include <string>

using namespace ansatz;

struct Speaker {
    using role = roles::Observer;
#ifdef ANSATZ_MISTAKE
    static std::string report(int world) { return world > 0 ? "" : "empty"; }
#else
    static std::string report(const auto& world, const Quantity<unit::Time>&) {
        return world.size() > 0 ? "" : "empty";
    }
#endif
};

int main() {
    World world{SemiImplicitEuler{}, Speaker{}};
    return world.status().ok() ? 0 : 1;
}
