// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Lanes`: one contiguous array of raw SI scalars for each component of each column, and `for_lanes`, the one loop of
/// the library over bodies.
///
/// Use `for_lanes` when you have lanes of your own (an entity system) and want the library's laws on them: it takes
/// plain pointers. Not for containers of structs: an array of bodies vectorises four to ten times worse than lanes.
///
/// Why the loop looks as it does (measured, g++ 12 and clang 14): the lane pointers are `__restrict` *parameters*,
/// because g++ ignores restrict on locals, gives up on alias checks and runs five times slower; the kernel is copied
/// into a local, because a quantity is not trivially copyable and would be reloaded for each body; the values pass
/// through one small array, which both compilers dissolve into registers before they vectorise.

#include <ansatz/core/error.hpp>
#include <ansatz/world/row.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace ansatz {

namespace detail {

/// Lanes begin on a cache line, so that no vector load straddles two.
template <class T> struct CacheLineAllocator {
    using value_type = T;
    static constexpr std::align_val_t alignment{alignof(T) > 64 ? alignof(T) : 64};
    CacheLineAllocator() = default;
    // NOLINTNEXTLINE(google-explicit-constructor): as an allocator must
    template <class U> CacheLineAllocator(const CacheLineAllocator<U>&) {}
    T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), alignment)); }
    void deallocate(T* p, std::size_t) noexcept { ::operator delete(p, alignment); }
    template <class U> bool operator==(const CacheLineAllocator<U>&) const { return true; }
};

template <bool Write, class Scalar>
[[gnu::always_inline]] inline void store_lane(Scalar* lane, std::size_t i, const Scalar& value) {
    if constexpr (Write) lane[i] = value;
}

template <class S, class Loaded, class Written, class Locals> struct LaneLoop;

template <class S, class... L, class... W, class... T> struct LaneLoop<S, Columns<L...>, Columns<W...>, Columns<T...>> {
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
    [[gnu::always_inline]] static void one_body(std::size_t i, const Kernel& kernel, std::index_sequence<K...>,
                                                Lane*... lane) {
        Scalar raw[width + 1] = {lane[i]...};
        Row<S, Columns<L..., T...>> row;
        ((row.template get<L>() = load<L, S>(raw + offset_in<L>(Columns<L...>{}, S::dimension))), ...);
        kernel(row, i);
        (store<L, S>(row.template get<L>(), raw + offset_in<L>(Columns<L...>{}, S::dimension)), ...);
        (store_lane<written[K]>(lane, i, raw[K]), ...);
    }

    /// With everything inlined, also a policy's own functions: what a vector loop needs.
    template <class Kernel, std::size_t... K, class... Lane>
    [[gnu::flatten, gnu::noinline]] static void run_inlined(std::size_t begin, std::size_t end, const Kernel& given,
                                                            std::index_sequence<K...> lanes, Lane* __restrict... lane) {
        const Kernel kernel = given;
        for (std::size_t i = begin; i < end; ++i) one_body(i, kernel, lanes, lane...);
    }
    /// As the compiler sees fit: solvers do not vectorise, and a class scalar inlined whole takes minutes to compile.
    template <class Kernel, std::size_t... K, class... Lane>
    static void run(std::size_t begin, std::size_t end, const Kernel& given, std::index_sequence<K...> lanes,
                    Lane* __restrict... lane) {
        const Kernel kernel = given;
        for (std::size_t i = begin; i < end; ++i) one_body(i, kernel, lanes, lane...);
    }
};

} // namespace detail

/// Walks bodies `begin` to `end`: loads the columns `Loaded`, calls `kernel(row, index)`, stores those of them that are
/// in `Written`. `Locals` are further columns that live only in the row.
/// A kernel with `static constexpr bool inlines = true` is inlined whole, so that the loop vectorises.
/// \param lane pointers to the lanes of `Loaded`, in order, component by component; they must not overlap
template <class S, class Loaded, class Written, class Locals, class Kernel, std::size_t N>
void for_lanes(const std::array<typename S::Scalar*, N>& lane, std::size_t begin, std::size_t end,
               const Kernel& kernel) {
    using Loop = detail::LaneLoop<S, Loaded, Written, Locals>;
    static_assert(N == Loop::width, "Ansatz: for_lanes needs one pointer for each lane of the loaded columns");
    [&]<std::size_t... K>(std::index_sequence<K...> lanes) {
        if constexpr (std::is_floating_point_v<typename S::Scalar> && requires { requires Kernel::inlines; })
            Loop::run_inlined(begin, end, kernel, lanes, lane[K]...);
        else Loop::run(begin, end, kernel, lanes, lane[K]...);
    }(std::make_index_sequence<N>{});
}
/// The old name of `for_lanes`.
template <class S, class Loaded, class Written, class Locals, class Kernel, std::size_t N>
[[deprecated("call for_lanes")]] void sweep(const std::array<typename S::Scalar*, N>& lane, std::size_t begin,
                                            std::size_t end, const Kernel& kernel) {
    for_lanes<S, Loaded, Written, Locals>(lane, begin, end, kernel);
}

/// The storage of a world: the lanes of columns `C...`, all of one length, in one block.
///
/// The lanes of a long block start at different places of a memory page. If they all started at the same, bodies would
/// compete for few places of the cache, and a load would wait for a store of another lane whose address only looks the
/// same to the processor: 25 to 35 % of the time of a step (measured, Zen 3).
template <class S, class List> class Lanes;
/// The lanes of a list of columns.
template <class S, class... C> class Lanes<S, Columns<C...>> {
public:
    using Scalar = typename S::Scalar;
    using columns = Columns<C...>;                                                    ///< the columns that it stores
    static constexpr int dimension = S::dimension;                                    ///< components of a vector
    static constexpr std::size_t width = detail::lane_count(columns{}, S::dimension); ///< lanes in all
    static constexpr std::size_t bytes_per_body = width * sizeof(Scalar);             ///< what a body takes

    Lanes() = default;
    /// Copies the values; the room is the copy's own.
    Lanes(const Lanes& other) { *this = other; }
    /// Takes the values; the other is empty.
    Lanes(Lanes&& other) noexcept { *this = std::move(other); }
    /// Copies the bodies; allocates only where they do not fit into what is there already, and before anything is
    /// changed.
    Lanes& operator=(const Lanes& other) {
        if (this == &other) return *this;
        reserve(other.size_);
        size_ = other.size_;
        for (std::size_t k = 0; k < width; ++k) std::copy_n(other.lane_at(k), size_, lane_at(k));
        return *this;
    }
    /// Takes the values; the other is empty.
    Lanes& operator=(Lanes&& other) noexcept {
        if (this == &other) return *this;
        block_ = std::move(other.block_);
        other.block_.clear();
        stride_ = std::exchange(other.stride_, 0);
        size_ = std::exchange(other.size_, 0);
        return *this;
    }

    /// Bodies.
    std::size_t size() const { return size_; }
    /// How many bodies there is room for.
    std::size_t room() const { return stride_; }

    /// Room for so many bodies.
    [[gnu::cold]] void reserve(std::size_t n) {
        if (n <= stride_) return;
        if (n > std::numeric_limits<std::size_t>::max() / (2 * bytes_per_body + 64) - 4096)
            refuse_value("Lanes::reserve", "n", n, "so many bodies cannot be addressed");
        const std::size_t stride = stride_for(n);
        Block grown(width * stride);
        for (std::size_t k = 0; k < width; ++k) std::copy_n(lane_at(k), size_, grown.data() + k * stride);
        block_ = std::move(grown);
        stride_ = stride;
    }
    /// Adds a body whose every column is zero.
    void push_back() {
        if (size_ == stride_) reserve(size_ == 0 ? 8 : 2 * size_);
        for (std::size_t k = 0; k < width; ++k) lane_at(k)[size_] = Scalar(0);
        ++size_;
    }
    /// Removes the last body.
    void pop_back() { --size_; }
    /// Two bodies change places.
    void swap(std::size_t i, std::size_t j) {
        using std::swap;
        if (i == j) return;
        for (std::size_t k = 0; k < width; ++k) swap(lane_at(k)[i], lane_at(k)[j]);
    }
    /// Removes all.
    void clear() { size_ = 0; }

    /// A body's value in a column.
    template <class Which> [[gnu::always_inline]] value_of<Which, S> get(std::size_t i) const {
        Scalar raw[detail::room_for<Which, S>] = {};
        const auto first = offset<Which>();
        for (std::size_t k = 0; k < lanes_of<Which>(S::dimension); ++k) raw[k] = lane_at(first + k)[i];
        return detail::load<Which, S>(raw);
    }
    /// A body's values in a list of columns.
    template <class... Which> Row<S, Columns<Which...>> get(Columns<Which...>, [[maybe_unused]] std::size_t i) const {
        Row<S, Columns<Which...>> row;
        ((row.template get<Which>() = get<Which>(i)), ...);
        return row;
    }
    /// Sets a body's value in a column.
    template <class Which> [[gnu::always_inline]] void set(std::size_t i, const value_of<Which, S>& q) {
        Scalar raw[detail::room_for<Which, S>] = {};
        detail::store<Which, S>(q, raw);
        const auto first = offset<Which>();
        for (std::size_t k = 0; k < lanes_of<Which>(S::dimension); ++k) lane_at(first + k)[i] = raw[k];
    }

    /// One lane: the raw SI scalars of one component of a column.
    template <class Which> Scalar* lane(int component = 0) { return lane_at(offset<Which>() + std::size_t(component)); }
    /// The raw numbers of one component of a column.
    template <class Which> const Scalar* lane(int component = 0) const {
        return lane_at(offset<Which>() + std::size_t(component));
    }
    /// A lane by its number.
    Scalar* lane_at(std::size_t index) { return block_.data() + index * stride_; }
    /// A lane by its number.
    const Scalar* lane_at(std::size_t index) const { return block_.data() + index * stride_; }

    /// The pointers that `for_lanes` wants for the columns of a list.
    template <class... Which> auto pointers(Columns<Which...>) {
        std::array<Scalar*, detail::lane_count(Columns<Which...>{}, S::dimension)> all{};
        std::size_t next = 0;
        auto take = [&](std::size_t first, std::size_t count) {
            for (std::size_t k = 0; k < count; ++k) all[next++] = lane_at(first + k);
        };
        (take(offset<Which>(), lanes_of<Which>(S::dimension)), ...);
        return all;
    }

private:
    using Block = std::vector<Scalar, detail::CacheLineAllocator<Scalar>>;

    template <class Which> static constexpr std::size_t offset() {
        static_assert(detail::contains<Which, columns>, "Ansatz: this world does not store that column");
        return detail::offset_in<Which>(columns{}, S::dimension);
    }

    /// From one lane to the next, in scalars: room for `n`, whole cache lines, and from a page on so that the lanes'
    /// first places are spread over a page.
    static constexpr std::size_t stride_for(std::size_t n) {
        constexpr std::size_t line = 64, page = 4096;
        constexpr std::size_t apart = std::max(page / width / line, std::size_t(1)) * line;
        if constexpr (line % sizeof(Scalar) != 0) return n; // a class scalar
        else {
            std::size_t bytes = (n * sizeof(Scalar) + line - 1) / line * line;
            if (bytes >= page) bytes += (page + apart - bytes % page) % page;
            return bytes / sizeof(Scalar);
        }
    }

    Block block_;
    std::size_t stride_ = 0; // how many bodies the lanes have room for
    std::size_t size_ = 0;
};

} // namespace ansatz
