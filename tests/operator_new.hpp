// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// operator new and delete of a whole program, all forms of them, and who is asked before each allocation. To be
/// included in one file of a program: they cannot be inline. All forms, because the address sanitizer brings its own of
/// those that are left out, whose memory must not go to `free`.

#include "tests/before_allocation.hpp"

#include <cstddef>
#include <cstdlib>
#include <new>

#if defined(__GNUC__) && !defined(__clang__)
// g++ sees free() where it has inlined the delete below and not the new: it takes them for a mismatch.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
#endif

namespace ansatz::test {

namespace memory {
inline void* take(std::size_t bytes, std::size_t alignment) noexcept {
    if (before_allocation != nullptr && !before_allocation(bytes)) return nullptr;
    if (bytes == 0) bytes = 1;
    return alignment == 0 ? std::malloc(bytes)
                          : std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
}
inline void* take_or_throw(std::size_t bytes, std::size_t alignment) {
    void* const block = take(bytes, alignment);
    if (block == nullptr) throw std::bad_alloc();
    return block;
}
} // namespace memory

} // namespace ansatz::test

void* operator new(std::size_t n) { return ansatz::test::memory::take_or_throw(n, 0); }
void* operator new[](std::size_t n) { return ansatz::test::memory::take_or_throw(n, 0); }
void* operator new(std::size_t n, std::align_val_t a) { return ansatz::test::memory::take_or_throw(n, std::size_t(a)); }
void* operator new[](std::size_t n, std::align_val_t a) {
    return ansatz::test::memory::take_or_throw(n, std::size_t(a));
}
void* operator new(std::size_t n, const std::nothrow_t&) noexcept { return ansatz::test::memory::take(n, 0); }
void* operator new[](std::size_t n, const std::nothrow_t&) noexcept { return ansatz::test::memory::take(n, 0); }
void* operator new(std::size_t n, std::align_val_t a, const std::nothrow_t&) noexcept {
    return ansatz::test::memory::take(n, std::size_t(a));
}
void* operator new[](std::size_t n, std::align_val_t a, const std::nothrow_t&) noexcept {
    return ansatz::test::memory::take(n, std::size_t(a));
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete[](void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, const std::nothrow_t&) noexcept { std::free(p); }
void operator delete[](void* p, const std::nothrow_t&) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t, const std::nothrow_t&) noexcept { std::free(p); }
void operator delete[](void* p, std::align_val_t, const std::nothrow_t&) noexcept { std::free(p); }
