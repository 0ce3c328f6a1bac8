// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Lanes`: one contiguous array of raw SI scalars for each component of each column, and `sweep`, the one loop of the
/// library that walks bodies.
///
/// Use `sweep` when you have lanes of your own (an entity system) and want the library's laws on them: it takes plain
/// pointers. Not for containers of structs: an array of bodies vectorises four to ten times worse than lanes.
///
/// Why the loop looks as it does (measured, g++ 12 and clang 14): the lane pointers are `__restrict` *parameters*,
/// because g++ ignores restrict on locals, gives up on alias checks and runs five times slower; the kernel is copied
/// into a local, because a quantity is not trivially copyable and would be reloaded for each body; the values pass
/// through one small array, which both compilers dissolve into registers before they vectorise.

#include <ansatz/world/row.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace ansatz {

namespace detail {

/// Lanes begin on a cache line, so that no vector load straddles two.
template <class T> struct CacheLineAllocator {
    using value_type = T;
    static constexpr std::align_val_t alignment{alignof(T) > 64 ? alignof(T) : 64};
    CacheLineAllocator() = default;
    template <class U> CacheLineAllocator(const CacheLineAllocator<U>&) {}
    T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), alignment)); }
    void deallocate(T* p, std::size_t) noexcept { ::operator delete(p, alignment); }
    template <class U> bool operator==(const CacheLineAllocator<U>&) const { return true; }
};

template <bool Write, class Scalar>
[[gnu::always_inline]] inline void store_lane(Scalar* lane, std::size_t i, const Scalar& value) {
    if constexpr (Write) lane[i] = value;
}

template <class S, class Loaded, class Written, class Locals> struct Sweep;

template <class S, class... L, class... W, class... T> struct Sweep<S, Columns<L...>, Columns<W...>, Columns<T...>> {
    using Scalar = typename S::Scalar;
    static constexpr std::size_t width = lane_count(Columns<L...>{}, S::dimension);

    static constexpr std::array<bool, width + 1> written = [] {
        std::array<bool, width + 1> flags{};
        std::size_t lane = 0;
        auto mark = [&](bool write, std::size_t lanes) {
            while (lanes-- > 0) flags[lane++] = write;
        };
        (mark(contains<L, Columns<W...>>, lanes_of<L>(S::dimension)), ...);
        return flags;
    }();

    template <class Kernel, std::size_t... K, class... Lane>
    [[gnu::flatten]] static void run(std::size_t begin, std::size_t end, const Kernel& given, std::index_sequence<K...>,
                                     Lane* __restrict... lane) {
        const Kernel kernel = given;
        for (std::size_t i = begin; i < end; ++i) {
            Scalar raw[width + 1] = {lane[i]...};
            Row<S, Columns<L..., T...>> row;
            ((row.template get<L>() = load<L, S>(raw + offset_in<L>(Columns<L...>{}, S::dimension))), ...);
            kernel(row, i);
            (store<L, S>(row.template get<L>(), raw + offset_in<L>(Columns<L...>{}, S::dimension)), ...);
            (store_lane<written[K]>(lane, i, raw[K]), ...);
        }
    }
};

} // namespace detail

/// Walks bodies `begin` to `end`: loads the columns `Loaded`, calls `kernel(row, index)`, stores those of them that are
/// in `Written`. `Locals` are further columns that live only in the row.
/// \param lane pointers to the lanes of `Loaded`, in order, component by component; they must not overlap
template <class S, class Loaded, class Written, class Locals, class Kernel, std::size_t N>
void sweep(const std::array<typename S::Scalar*, N>& lane, std::size_t begin, std::size_t end, const Kernel& kernel) {
    using Loop = detail::Sweep<S, Loaded, Written, Locals>;
    static_assert(N == Loop::width, "Ansatz: sweep needs one pointer for each lane of the loaded columns");
    [&]<std::size_t... K>(std::index_sequence<K...> lanes) {
        Loop::run(begin, end, kernel, lanes, lane[K]...);
    }(std::make_index_sequence<N>{});
}

/// The storage of a world: the lanes of columns `C...`, all of one length.
template <class S, class List> class Lanes;
template <class S, class... C> class Lanes<S, Columns<C...>> {
public:
    using Scalar = typename S::Scalar;
    using columns = Columns<C...>;
    static constexpr std::size_t width = detail::lane_count(columns{}, S::dimension);
    static constexpr std::size_t bytes_per_body = width * sizeof(Scalar);

    std::size_t size() const { return size_; }

    void reserve(std::size_t n) {
        for (auto& lane : lanes_) lane.reserve(n);
    }
    /// Adds a body whose every column is zero.
    void push_back() {
        for (auto& lane : lanes_) lane.push_back(Scalar(0));
        ++size_;
    }
    void pop_back() {
        for (auto& lane : lanes_) lane.pop_back();
        --size_;
    }
    void swap(std::size_t i, std::size_t j) {
        if (i == j) return;
        for (auto& lane : lanes_) std::swap(lane[i], lane[j]);
    }
    void clear() {
        for (auto& lane : lanes_) lane.clear();
        size_ = 0;
    }

    template <class Which> value_of<Which, S> get(std::size_t i) const {
        Scalar raw[3] = {};
        const auto first = offset<Which>();
        for (std::size_t k = 0; k < lanes_of<Which>(S::dimension); ++k) raw[k] = lanes_[first + k][i];
        return detail::load<Which, S>(raw);
    }
    template <class Which> void set(std::size_t i, const value_of<Which, S>& q) {
        Scalar raw[3] = {};
        detail::store<Which, S>(q, raw);
        const auto first = offset<Which>();
        for (std::size_t k = 0; k < lanes_of<Which>(S::dimension); ++k) lanes_[first + k][i] = raw[k];
    }

    /// One lane: the raw SI scalars of one component of a column.
    template <class Which> Scalar* lane(int component = 0) {
        return lanes_[offset<Which>() + std::size_t(component)].data();
    }
    template <class Which> const Scalar* lane(int component = 0) const {
        return lanes_[offset<Which>() + std::size_t(component)].data();
    }
    Scalar* lane_at(std::size_t index) { return lanes_[index].data(); }
    const Scalar* lane_at(std::size_t index) const { return lanes_[index].data(); }

    /// The pointers that `sweep` wants for the columns of a list.
    template <class... Which> auto pointers(Columns<Which...>) {
        std::array<Scalar*, detail::lane_count(Columns<Which...>{}, S::dimension)> all{};
        std::size_t next = 0;
        auto take = [&](std::size_t first, std::size_t count) {
            for (std::size_t k = 0; k < count; ++k) all[next++] = lanes_[first + k].data();
        };
        (take(offset<Which>(), lanes_of<Which>(S::dimension)), ...);
        return all;
    }

private:
    template <class Which> static constexpr std::size_t offset() {
        static_assert(detail::contains<Which, columns>, "Ansatz: this world does not store that column");
        return detail::offset_in<Which>(columns{}, S::dimension);
    }

    std::array<std::vector<Scalar, detail::CacheLineAllocator<Scalar>>, width> lanes_;
    std::size_t size_ = 0;
};

} // namespace ansatz
