// SPDX-License-Identifier: BSL-1.0
// A world for every integrator, with every force and effect in some of them, and what they come to: build_matrix.sh.
#include <ansatz/collision.hpp>
#include <ansatz/motion/integrators/cholesky.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <cstdint>
#include <cstdio>
#include <vector>

using namespace ansatz;

/// Numbers between 0 and 1 that are the same everywhere: whole numbers, and a division by a power of two.
struct Numbers {
    std::uint32_t state = 1;
    double next() {
        state = state * 1664525u + 1013904223u;
        return (state >> 8) / 16777216.0;
    }
    double around_zero() { return 2 * next() - 1; }
};

template <class W> void show(const char* name, W world) {
    Numbers n;
    std::vector<Handle> bodies;
    if constexpr (W::composition::collides) world.add(Plane::ground(), fixed);
    for (int i = 0; i < 20; ++i) {
        auto vector = [&](auto unit, double size) {
            const double x = size * n.around_zero(), y = size * n.around_zero(), z = size * n.around_zero();
            if constexpr (W::S::dimension == 2) return Eigen::Vector2d(x, y + 0 * z) * unit;
            else return Eigen::Vector3d(x, y, z) * unit;
        };
        const auto x = vector(metre, 10);
        const auto v = vector(metre_per_second, 5);
        const auto m = (0.5 + n.next()) * kilogram;
        if constexpr (W::composition::collides) { // spheres and boxes that fall on a heap
            using V = Vector<double, W::S::dimension>;
            const double half = 0.3 + 0.5 * n.next();
            const auto place = position(V(0.2 * x.value() + 3 * V::Unit(1)) * metre);
            if (i % 3 == 0) bodies.push_back(world.add(Box{V(V::Constant(half)) * metre}, place, velocity(v), mass(m)));
            else bodies.push_back(world.add(Sphere{half * metre}, place, velocity(v), mass(m)));
        } else if constexpr (W::composition::has_mass) bodies.push_back(world.add(position(x), velocity(v), mass(m)));
        else bodies.push_back(world.add(position(x), velocity(v)));
    }
    if constexpr (W::composition::keepers::size > 0 &&
                  !W::composition::collides) { // a closed chain of springs, each of another stiffness
        using Element = typename detail::FirstIn<typename W::composition::keepers>::type::Element;
        for (std::size_t i = 0; i < bodies.size(); ++i)
            world.add(Element{bodies[i], bodies[(i + 1) % bodies.size()], (20 + 30 * n.next()) * newton_per_metre,
                              0.5 * newton_second_per_metre, 2.0 * metre});
    }
    for (int i = 0; i < 300; ++i) world.step((1 + i % 3) * 0.005 * second); // the step varies
    std::printf("%-68s %016llx%s\n", name, static_cast<unsigned long long>(world.hash()),
                world.status().ok() ? "" : "  NOT FINITE");
}
#define SHOW(...) show(#__VA_ARGS__, World{__VA_ARGS__})

int main() {
    const Attraction strong{10.0 * cubic_metre / (kilogram * second * second), 0.1 * metre};
    using Flat = Space<float, 2>;
    using Solid = Space<float, 3>;
    using Shapes = Narrowphase<Sphere, Plane, Box>;
    SHOW(ExplicitEuler{}, Gravity{}, FrameDrag{}, StopBelow{});
    SHOW(SemiImplicitEuler{}, Gravity{}, Drag{0.7 / second}, Interpolation{});
    SHOW(Flat{}, SemiImplicitEuler{}, Drag{2.0 / second}, Rest{});
    SHOW(Verlet{}, Gravity{}, QuadraticDrag{});
    SHOW(VelocityVerlet{}, strong);
    SHOW(Solid{}, RungeKutta4{}, Gravity{}, QuadraticDrag{});
    SHOW(ImplicitEuler{}, Gravity{}, QuadraticDrag{});
    SHOW(Solid{}, VelocityVerlet{}, Gravity{}, Springs{});
    SHOW(Flat{}, SemiImplicitEuler{}, Ropes{}, StepLimit<Divide>{});
    SHOW(ImplicitEuler{}, Gravity{}, Springs{});
    SHOW(ImplicitEulerBy<Cholesky>{}, Gravity{}, Springs{});
    SHOW(SemiImplicitEuler{}, Gravity{}, UniformGrid{}, Shapes{}, SoftSubsteps<Friction>{}, Rest{});
    SHOW(Solid{}, Verlet{}, Gravity{}, Octree{}, Shapes{}, Impulse{}, Projection{});
    SHOW(Flat{}, VelocityVerlet{}, Gravity{}, SortAndSweep{}, Shapes{}, SoftSubsteps{});
    SHOW(Solid{}, SemiImplicitEuler{}, Gravity{}, UniformGrid{}, Shapes{}, SoftSubsteps<Coloured, Friction>{});
    SHOW(RungeKutta4{}, Gravity{}, BinarySplit{}, Shapes{}, Penalty{});
}
