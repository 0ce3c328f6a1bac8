// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Worlds as the text of a file, for the tests.

#include <ansatz/world/save.hpp>

#include <sstream>
#include <string>

namespace ansatz::test {

template <class W> std::string text_of(const W& world) {
    std::ostringstream out;
    save(world, out);
    return out.str();
}
template <class W> void load_text(W& world, const std::string& text) {
    std::istringstream in(text);
    load(world, in);
}

} // namespace ansatz::test
