// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The machine of ten states that compared_machines.hpp describes, written by hand as a switch.

#include "compared_events.hpp"

namespace compared {

/// A switch, as one writes it.
template <bool Acts> class HandSwitch {
public:
    bool handle(Tally& tally, int event) {
        switch (state_) {
        case 0:
            switch (event) {
            case 0:
                done<0, 0>(tally);
                state_ = 1;
                return true;
            case 1:
                done<0, 1>(tally);
                state_ = 4;
                return true;
            case 2:
                done<0, 2>(tally);
                state_ = 7;
                return true;
            case 3:
                done<0, 3>(tally);
                state_ = 0;
                return true;
            case 4:
                done<0, 4>(tally);
                state_ = 3;
                return true;
            }
            break;
        case 1:
            switch (event) {
            case 0:
                done<1, 0>(tally);
                state_ = 8;
                return true;
            case 1:
                done<1, 1>(tally);
                state_ = 1;
                return true;
            case 2:
                done<1, 2>(tally);
                state_ = 4;
                return true;
            case 3:
                done<1, 3>(tally);
                state_ = 7;
                return true;
            case 4:
                done<1, 4>(tally);
                state_ = 0;
                return true;
            }
            break;
        case 2:
            switch (event) {
            case 0:
                done<2, 0>(tally);
                state_ = 5;
                return true;
            case 1:
                done<2, 1>(tally);
                state_ = 8;
                return true;
            case 2:
                done<2, 2>(tally);
                state_ = 1;
                return true;
            case 3:
                done<2, 3>(tally);
                state_ = 4;
                return true;
            case 4:
                done<2, 4>(tally);
                state_ = 7;
                return true;
            }
            break;
        case 3:
            switch (event) {
            case 0:
                done<3, 0>(tally);
                state_ = 2;
                return true;
            case 1:
                done<3, 1>(tally);
                state_ = 5;
                return true;
            case 2:
                done<3, 2>(tally);
                state_ = 8;
                return true;
            case 3:
                done<3, 3>(tally);
                state_ = 1;
                return true;
            case 4:
                done<3, 4>(tally);
                state_ = 4;
                return true;
            }
            break;
        case 4:
            switch (event) {
            case 0:
                done<4, 0>(tally);
                state_ = 9;
                return true;
            case 1:
                done<4, 1>(tally);
                state_ = 2;
                return true;
            case 2:
                done<4, 2>(tally);
                state_ = 5;
                return true;
            case 3:
                done<4, 3>(tally);
                state_ = 8;
                return true;
            case 4:
                done<4, 4>(tally);
                state_ = 1;
                return true;
            }
            break;
        case 5:
            switch (event) {
            case 0:
                done<5, 0>(tally);
                state_ = 6;
                return true;
            case 1:
                done<5, 1>(tally);
                state_ = 9;
                return true;
            case 2:
                done<5, 2>(tally);
                state_ = 2;
                return true;
            case 3:
                done<5, 3>(tally);
                state_ = 5;
                return true;
            }
            break;
        case 6:
            switch (event) {
            case 0:
                done<6, 0>(tally);
                state_ = 3;
                return true;
            case 1:
                done<6, 1>(tally);
                state_ = 6;
                return true;
            case 2:
                done<6, 2>(tally);
                state_ = 9;
                return true;
            case 4:
                done<6, 4>(tally);
                state_ = 5;
                return true;
            }
            break;
        case 7:
            switch (event) {
            case 0:
                done<7, 0>(tally);
                state_ = 0;
                return true;
            case 1:
                done<7, 1>(tally);
                state_ = 3;
                return true;
            case 3:
                done<7, 3>(tally);
                state_ = 9;
                return true;
            case 4:
                done<7, 4>(tally);
                state_ = 2;
                return true;
            }
            break;
        case 8:
            switch (event) {
            case 0:
                done<8, 0>(tally);
                state_ = 7;
                return true;
            case 2:
                done<8, 2>(tally);
                state_ = 3;
                return true;
            case 3:
                done<8, 3>(tally);
                state_ = 6;
                return true;
            case 4:
                done<8, 4>(tally);
                state_ = 9;
                return true;
            }
            break;
        case 9:
            switch (event) {
            case 1:
                done<9, 1>(tally);
                state_ = 7;
                return true;
            case 2:
                done<9, 2>(tally);
                state_ = 0;
                return true;
            case 3:
                done<9, 3>(tally);
                state_ = 3;
                return true;
            case 4:
                done<9, 4>(tally);
                state_ = 6;
                return true;
            }
            break;
        }
        return false;
    }
    int state() const { return state_; }

private:
    template <int S, int E> static void done(Tally& tally) {
        if constexpr (Acts) act<S, E>(tally);
    }
    int state_ = 0;
};

} // namespace compared
