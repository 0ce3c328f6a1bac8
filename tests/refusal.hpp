// SPDX-License-Identifier: BSL-1.0
#pragma once

// What a call says when it refuses.

#include <exception>
#include <stdexcept>
#include <string>

namespace ansatz::test {

/// What a call throws, as text; "nothing" if it does not.
template <class Exception, class F> std::string sentence(F&& f) {
    try {
        f();
    } catch (const Exception& e) {
        return e.what();
    } catch (const std::exception& e) {
        return std::string("another exception: ") + e.what();
    }
    return "nothing";
}
/// The same of a bad value.
template <class F> std::string refusal(F&& f) { return sentence<std::invalid_argument>(f); }

} // namespace ansatz::test
