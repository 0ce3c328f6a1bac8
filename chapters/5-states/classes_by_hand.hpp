// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The machine of ten states that compared_machines.hpp describes, written by hand as classes.

#include "compared_events.hpp"

namespace compared {

/// The state pattern, as one writes it: a class for each state, and a virtual call for each event.
template <bool Acts> class HandClasses {
public:
    HandClasses() = default;
    HandClasses(const HandClasses&) = delete;
    bool handle(Tally& tally, int event) {
        const State* to = now_->handle(*this, tally, event);
        if (to == nullptr) return false;
        now_ = to;
        return true;
    }
    int state() const { return now_->number(); }

private:
    struct State {
        virtual const State* handle(const HandClasses&, Tally&, int event) const = 0; ///< the next state, or none
        virtual int number() const = 0;

    protected:
        ~State() = default;
    };
    template <int S, int E> static void done(Tally& tally) {
        if constexpr (Acts) act<S, E>(tally);
    }
    struct S0 final : State {
        int number() const override { return 0; }
        const State* handle(const HandClasses& all, Tally& tally, int event) const override {
            switch (event) {
            case 0: done<0, 0>(tally); return &all.s1_;
            case 1: done<0, 1>(tally); return &all.s4_;
            case 2: done<0, 2>(tally); return &all.s7_;
            case 3: done<0, 3>(tally); return &all.s0_;
            case 4: done<0, 4>(tally); return &all.s3_;
            }
            return nullptr;
        }
    };
    struct S1 final : State {
        int number() const override { return 1; }
        const State* handle(const HandClasses& all, Tally& tally, int event) const override {
            switch (event) {
            case 0: done<1, 0>(tally); return &all.s8_;
            case 1: done<1, 1>(tally); return &all.s1_;
            case 2: done<1, 2>(tally); return &all.s4_;
            case 3: done<1, 3>(tally); return &all.s7_;
            case 4: done<1, 4>(tally); return &all.s0_;
            }
            return nullptr;
        }
    };
    struct S2 final : State {
        int number() const override { return 2; }
        const State* handle(const HandClasses& all, Tally& tally, int event) const override {
            switch (event) {
            case 0: done<2, 0>(tally); return &all.s5_;
            case 1: done<2, 1>(tally); return &all.s8_;
            case 2: done<2, 2>(tally); return &all.s1_;
            case 3: done<2, 3>(tally); return &all.s4_;
            case 4: done<2, 4>(tally); return &all.s7_;
            }
            return nullptr;
        }
    };
    struct S3 final : State {
        int number() const override { return 3; }
        const State* handle(const HandClasses& all, Tally& tally, int event) const override {
            switch (event) {
            case 0: done<3, 0>(tally); return &all.s2_;
            case 1: done<3, 1>(tally); return &all.s5_;
            case 2: done<3, 2>(tally); return &all.s8_;
            case 3: done<3, 3>(tally); return &all.s1_;
            case 4: done<3, 4>(tally); return &all.s4_;
            }
            return nullptr;
        }
    };
    struct S4 final : State {
        int number() const override { return 4; }
        const State* handle(const HandClasses& all, Tally& tally, int event) const override {
            switch (event) {
            case 0: done<4, 0>(tally); return &all.s9_;
            case 1: done<4, 1>(tally); return &all.s2_;
            case 2: done<4, 2>(tally); return &all.s5_;
            case 3: done<4, 3>(tally); return &all.s8_;
            case 4: done<4, 4>(tally); return &all.s1_;
            }
            return nullptr;
        }
    };
    struct S5 final : State {
        int number() const override { return 5; }
        const State* handle(const HandClasses& all, Tally& tally, int event) const override {
            switch (event) {
            case 0: done<5, 0>(tally); return &all.s6_;
            case 1: done<5, 1>(tally); return &all.s9_;
            case 2: done<5, 2>(tally); return &all.s2_;
            case 3: done<5, 3>(tally); return &all.s5_;
            }
            return nullptr;
        }
    };
    struct S6 final : State {
        int number() const override { return 6; }
        const State* handle(const HandClasses& all, Tally& tally, int event) const override {
            switch (event) {
            case 0: done<6, 0>(tally); return &all.s3_;
            case 1: done<6, 1>(tally); return &all.s6_;
            case 2: done<6, 2>(tally); return &all.s9_;
            case 4: done<6, 4>(tally); return &all.s5_;
            }
            return nullptr;
        }
    };
    struct S7 final : State {
        int number() const override { return 7; }
        const State* handle(const HandClasses& all, Tally& tally, int event) const override {
            switch (event) {
            case 0: done<7, 0>(tally); return &all.s0_;
            case 1: done<7, 1>(tally); return &all.s3_;
            case 3: done<7, 3>(tally); return &all.s9_;
            case 4: done<7, 4>(tally); return &all.s2_;
            }
            return nullptr;
        }
    };
    struct S8 final : State {
        int number() const override { return 8; }
        const State* handle(const HandClasses& all, Tally& tally, int event) const override {
            switch (event) {
            case 0: done<8, 0>(tally); return &all.s7_;
            case 2: done<8, 2>(tally); return &all.s3_;
            case 3: done<8, 3>(tally); return &all.s6_;
            case 4: done<8, 4>(tally); return &all.s9_;
            }
            return nullptr;
        }
    };
    struct S9 final : State {
        int number() const override { return 9; }
        const State* handle(const HandClasses& all, Tally& tally, int event) const override {
            switch (event) {
            case 1: done<9, 1>(tally); return &all.s7_;
            case 2: done<9, 2>(tally); return &all.s0_;
            case 3: done<9, 3>(tally); return &all.s3_;
            case 4: done<9, 4>(tally); return &all.s6_;
            }
            return nullptr;
        }
    };
    S0 s0_;
    S1 s1_;
    S2 s2_;
    S3 s3_;
    S4 s4_;
    S5 s5_;
    S6 s6_;
    S7 s7_;
    S8 s8_;
    S9 s9_;
    const State* now_ = &s0_;
};

} // namespace compared
