// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// A broadphase, or the one that tests every pair, as its parameter says: two worlds of one type, which the compiler
/// makes once, must have the same bits.

#include <ansatz/collision.hpp>

namespace fuzz {

template <class Broadphase> struct Either {
    using role = ansatz::roles::Broadphase;
    Broadphase broadphase{};
    bool every_pair = false;

    void check() const {
        if constexpr (requires { broadphase.check(); }) broadphase.check();
    }
    template <class S> class In {
    public:
        explicit In(const Either& either) : found_(either.broadphase), all_({}), every_pair_(either.every_pair) {}
        template <class F> void find(const ansatz::Boxes<S>& boxes, F&& found) {
            if (every_pair_) all_.find(boxes, found);
            else found_.find(boxes, found);
        }

    private:
        typename Broadphase::template In<S> found_;
        ansatz::BoundingBoxes::In<S> all_;
        bool every_pair_;
    };
};

} // namespace fuzz
