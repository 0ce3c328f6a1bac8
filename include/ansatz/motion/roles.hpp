// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The roles of motion: what advances bodies, what pulls at them, and what acts on them beside that.

#include <ansatz/world/roles.hpp>

namespace ansatz {

namespace modules {
struct Motion; // motion/module.hpp
}

namespace roles {
/// Advances one body by its stages; exactly one.
struct Integrator {
    using module = modules::Motion; ///< it comes with
};
/// A law of one body, or couples bodies; any number.
struct Force {
    using module = modules::Motion; ///< it comes with
};
/// Something of a body beside its place that has a rate and is accelerated: an orientation; any number.
struct DegreeOfFreedom {
    using module = modules::Motion; ///< it comes with
};
/// Takes part in the step by systems of its own (motion/policy_systems.hpp), and may keep a state; any number. So may a
/// policy of any other role.
struct System {
    using module = modules::Motion; ///< it comes with
};
/// Acts on declared columns at a named place of the step; any number.
struct Effect {
    using module = modules::Motion; ///< it comes with
};
} // namespace roles

} // namespace ansatz
