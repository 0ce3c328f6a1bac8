// expect: a policy gives rows of joints, and nothing in this world solves them
// SPDX-License-Identifier: BSL-1.0
// Rows are solved with the contacts of SoftSubsteps; Impulse has no substeps in which they would hold.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct Mine {
    using role = roles::System;
    template <class S> struct Rows {
        explicit Rows(const Mine&) {}
        void rows(auto&, auto&&) const {}
    };
};

#ifdef ANSATZ_MISTAKE
using Response = Impulse<>;
#else
using Response = SoftSubsteps<>;
#endif

void use() { World world{SemiImplicitEuler{}, SortAndSweep{}, Narrowphase<Sphere>{}, Response{}, Mine{}}; }
