#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
# Looks at every compiler that is here.
#
# The same worlds come to the same state, to the last bit, in every build (hard case I20): g++ and clang++, each with -O0,
# -O2, -O3 and -O3 -march=native, all with -ffp-contract=off as the library's exported target asks. What is compared is
# World::hash after 300 steps, of one world for every integrator, with every force and effect of the library in some of
# them. Nothing on that path may call what two C libraries or compilers compute differently: there is sqrt, which IEEE 754
# defines, and for damping the library's own exponential (motion/decay.hpp), but no sin, cos, exp, pow or hypot.
#
# And the same build twice gives the same bits: compiled again, run again, for each compiler.
#
# usage: build_matrix.sh <folder of the project>       with CXX and ANSATZ_SCRATCH in the environment, as ctest sets them
set -euo pipefail
export LC_ALL=C
project=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
source "$project/tests/performance/common.bash"
scratch=${ANSATZ_SCRATCH:-$(mktemp -d)}
mkdir -p "$scratch"
cd "$scratch"

cat > worlds.cpp <<'END'
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
            if constexpr (W::S::dimension == 2)
                return Eigen::Vector2d(x, y + 0 * z) * unit;
            else
                return Eigen::Vector3d(x, y, z) * unit;
        };
        const auto x = vector(metre, 10);
        const auto v = vector(metre_per_second, 5);
        const auto m = (0.5 + n.next()) * kilogram;
        if constexpr (W::composition::collides) { // spheres and boxes that fall on a heap
            using V = Vector<double, W::S::dimension>;
            const double half = 0.3 + 0.5 * n.next();
            const auto place = position(V(0.2 * x.value() + 3 * V::Unit(1)) * metre);
            if (i % 3 == 0)
                bodies.push_back(world.add(Box{V(V::Constant(half)) * metre}, place, velocity(v), mass(m)));
            else
                bodies.push_back(world.add(Sphere{half * metre}, place, velocity(v), mass(m)));
        } else if constexpr (W::composition::has_mass)
            bodies.push_back(world.add(position(x), velocity(v), mass(m)));
        else
            bodies.push_back(world.add(position(x), velocity(v)));
    }
    if constexpr (W::composition::keepers::size > 0 && !W::composition::collides) { // a closed chain of springs, each of another stiffness
        using Element = typename detail::FirstOf<typename W::composition::keepers>::type::Element;
        for (std::size_t i = 0; i < bodies.size(); ++i)
            world.add(Element{bodies[i], bodies[(i + 1) % bodies.size()], (20 + 30 * n.next()) * newton_per_metre, 0.5 * newton_second_per_metre, 2.0 * metre});
    }
    for (int i = 0; i < 300; ++i) world.step((1 + i % 3) * 0.005 * second); // the step varies
    std::printf("%-68s %016llx%s\n", name, static_cast<unsigned long long>(world.hash()), world.status().ok() ? "" : "  NOT FINITE");
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
    SHOW(RungeKutta4{}, Gravity{}, BinarySplit{}, Shapes{}, Penalty{});
}
END

options=("-O0" "-O2" "-O3" "-O3 -march=native")
file_of() { printf '%s%s' "${1##*/}" "${2// /}"; }
build() {    # compiler, options, what to add to the file's name
    local options
    read -ra options <<< "$2"
    compile "$1" worlds.cpp "$(file_of "$1" "$2")$3" "${options[@]}"
    "./$(file_of "$1" "$2")$3" > "$(file_of "$1" "$2")$3.txt"
}
mapfile -t compilers < <(found_compilers)
for compiler in "${compilers[@]}"; do
    for option in "${options[@]}"; do start build "$compiler" "$option" ""; done
    start build "$compiler" "-O3" "-again"
done
all_done

reference=$(file_of "${compilers[0]}" "${options[0]}")
cat "$reference.txt"
[ "$(sort -u -k1 "$reference.txt" | wc -l)" -eq 15 ] || { echo "fifteen worlds should have fifteen lines"; exit 1; }
[ "$(awk '{ print $NF }' "$reference.txt" | sort -u | wc -l)" -eq 15 ] || { echo "fifteen worlds should have fifteen hashes"; exit 1; }
echo
faults=0
same() {    # what is compared, and two files
    local different
    different=$(diff "$2" "$3" | grep -c '^>' || true)
    if [ "$different" -eq 0 ]; then
        printf '%-28s the same bits\n' "$1"
    else
        printf '%-28s DIFFERENT in %d worlds:\n' "$1" "$different"
        diff "$2" "$3" | grep '^>' || true
        faults=$((faults + 1))
    fi
}
for compiler in "${compilers[@]}"; do
    for option in "${options[@]}"; do same "${compiler##*/} $option" "$reference.txt" "$(file_of "$compiler" "$option").txt"; done
    "./$(file_of "$compiler" -O3)" > rerun.txt
    same "${compiler##*/} -O3, run again" "$(file_of "$compiler" -O3).txt" rerun.txt
    same "${compiler##*/} -O3, compiled again" "$(file_of "$compiler" -O3).txt" "$(file_of "$compiler" -O3)-again.txt"
done
# The pile, pinned: whoever changes what it comes to does so on purpose, and puts the new number here.
pinned=e5e462111e68ed8d
if grep -q "UniformGrid.*SoftSubsteps<Friction>.* $pinned\$" "$reference.txt"; then
    printf '%-28s as pinned\n' "the pile"
else
    echo "the pile is not what it was, $pinned"
    faults=$((faults + 1))
fi
[ $faults -eq 0 ]
