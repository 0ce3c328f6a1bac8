// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Who is asked before an allocation, for tests in a program of which one file includes operator_new.hpp.

#include <cstddef>

namespace ansatz::test {

/// Asked with the number of bytes; an allocation that it answers with false fails. While it is null all are allowed.
inline bool (*before_allocation)(std::size_t bytes) noexcept = nullptr;

} // namespace ansatz::test
