// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// A* for one purpose, written by hand: eight neighbours, whole-number costs, a heap of four children or a ring of
/// buckets. No graph concept, no policy, nothing that could be chosen; the flags of the steps are made beforehand. It
/// is what Ansatz is held against: 1.1 times its time is wanted, and what is reached stands on the page about paths.

#include <ansatz/paths/grid/grid.hpp>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace peers {

class Hand {
public:
    static constexpr std::uint32_t straight = 33461, diagonal = 47321;
    explicit Hand(const ansatz::paths::Grid<>& map) : width_(int(map.width())), nodes_(map.size()) {
        steps_.assign(map.open_directions(), map.open_directions() + map.size());
        const int dx[] = {1, 0, -1, 0, 1, -1, -1, 1}, dy[] = {0, 1, 0, -1, 1, 1, -1, -1};
        for (int d = 0; d < 8; ++d) dx_[d] = dx[d], dy_[d] = dy[d], offset_[d] = dy[d] * width_ + dx[d];
    }
    double tiles() const { return straights_ + diagonals_ * 1.4142135623730950488; }
    std::size_t expanded() const { return expanded_; }

protected:
    struct Record {
        std::uint32_t g, h, parent, stamp;
    };
    std::uint32_t estimate(int x, int y) const {
        const std::uint32_t dx = std::uint32_t(std::abs(x - goal_x_)), dy = std::uint32_t(std::abs(y - goal_y_));
        return dx > dy ? diagonal * dy + straight * (dx - dy) : diagonal * dx + straight * (dy - dx);
    }
    void trace(std::uint32_t goal, std::uint32_t start) {
        path_.clear();
        straights_ = diagonals_ = 0;
        for (std::uint32_t at = goal;; at = nodes_[at].parent) {
            path_.push_back(at);
            if (at == start) break;
            const int step = std::abs(int(at) - int(nodes_[at].parent));
            (step == 1 || step == width_ ? straights_ : diagonals_) += 1;
        }
        std::reverse(path_.begin(), path_.end());
    }
    int width_, goal_x_ = 0, goal_y_ = 0;
    int dx_[8]{}, dy_[8]{}, offset_[8]{};
    std::vector<std::uint8_t> steps_;
    std::vector<Record> nodes_;
    std::vector<std::uint32_t> path_;
    std::uint32_t stamp_ = 0;
    double straights_ = 0, diagonals_ = 0;
    std::size_t expanded_ = 0;
};

class HandHeap : Hand {
public:
    using Hand::expanded;
    using Hand::Hand;
    using Hand::tiles;
    bool find(ansatz::paths::Cell from, ansatz::paths::Cell to) {
        const std::uint32_t start = std::uint32_t(from.y * width_ + from.x), goal = std::uint32_t(to.y * width_ + to.x);
        goal_x_ = to.x, goal_y_ = to.y;
        stamp_ += 2;
        expanded_ = 0;
        heap_.clear();
        const std::uint32_t h = estimate(from.x, from.y);
        nodes_[start] = {0, h, start, stamp_};
        push({h, h, start});
        while (!heap_.empty()) {
            const std::uint32_t p = pop();
            Record& node = nodes_[p];
            if (node.stamp != stamp_) continue;
            node.stamp = stamp_ + 1;
            if (p == goal) return trace(goal, start), true;
            ++expanded_;
            const int x = int(p) % width_, y = int(p) / width_;
            for (unsigned open = steps_[p]; open != 0; open &= open - 1) {
                const int d = std::countr_zero(open);
                const std::uint32_t q = std::uint32_t(int(p) + offset_[d]), g = node.g + (d < 4 ? straight : diagonal);
                Record& next = nodes_[q];
                if (next.stamp < stamp_) next.h = estimate(x + dx_[d], y + dy_[d]);
                else if (g >= next.g) continue;
                next.g = g, next.parent = p, next.stamp = stamp_;
                push({g + next.h, next.h, q});
            }
        }
        return false;
    }

private:
    struct Entry {
        std::uint32_t f, h, at;
        bool operator<(const Entry& o) const { return f < o.f || (f == o.f && h < o.h); }
    };
    void push(Entry e) {
        std::size_t i = heap_.size();
        heap_.push_back(e);
        for (; i > 0 && e < heap_[(i - 1) / 4]; i = (i - 1) / 4) heap_[i] = heap_[(i - 1) / 4];
        heap_[i] = e;
    }
    std::uint32_t pop() {
        const std::uint32_t least = heap_.front().at;
        const Entry last = heap_.back();
        heap_.pop_back();
        const std::size_t n = heap_.size();
        if (n == 0) return least;
        std::size_t i = 0;
        for (;;) {
            const std::size_t first = 4 * i + 1;
            if (first >= n) break;
            std::size_t child = first;
            for (std::size_t k = first + 1; k < std::min(first + 4, n); ++k)
                if (heap_[k] < heap_[child]) child = k;
            if (!(heap_[child] < last)) break;
            heap_[i] = heap_[child];
            i = child;
        }
        heap_[i] = last;
        return least;
    }
    std::vector<Entry> heap_;
};

class HandBuckets : Hand {
public:
    using Hand::expanded;
    using Hand::tiles;
    explicit HandBuckets(const ansatz::paths::Grid<>& map) : Hand(map), ring_(64) {}
    bool find(ansatz::paths::Cell from, ansatz::paths::Cell to) {
        const std::uint32_t start = std::uint32_t(from.y * width_ + from.x), goal = std::uint32_t(to.y * width_ + to.x);
        goal_x_ = to.x, goal_y_ = to.y;
        stamp_ += 2;
        expanded_ = 0;
        for (; occupied_ != 0; occupied_ &= occupied_ - 1) ring_[std::size_t(std::countr_zero(occupied_))].clear();
        const std::uint32_t h = estimate(from.x, from.y);
        std::uint32_t base = h >> shift, best = ~0u;
        nodes_[start] = {0, h, start, stamp_};
        push(h, start);
        while (occupied_ != 0) {
            base += std::uint32_t(std::countr_zero(std::rotr(occupied_, int(base & 63))));
            if (base << shift >= best) break;
            auto& bucket = ring_[base & 63];
            const std::uint32_t p = bucket.back();
            bucket.pop_back();
            if (bucket.empty()) occupied_ &= ~(std::uint64_t(1) << (base & 63));
            Record& node = nodes_[p];
            if (node.stamp != stamp_ || node.g + node.h >= best) continue;
            node.stamp = stamp_ + 1;
            if (p == goal) {
                best = node.g;
                continue;
            }
            ++expanded_;
            const int x = int(p) % width_, y = int(p) / width_;
            for (unsigned open = steps_[p]; open != 0; open &= open - 1) {
                const int d = std::countr_zero(open);
                const std::uint32_t q = std::uint32_t(int(p) + offset_[d]), g = node.g + (d < 4 ? straight : diagonal);
                Record& next = nodes_[q];
                if (next.stamp < stamp_) next.h = estimate(x + dx_[d], y + dy_[d]);
                else if (g >= next.g) continue;
                next.g = g, next.parent = p, next.stamp = stamp_;
                push(g + next.h, q);
            }
        }
        if (best == ~0u) return false;
        trace(goal, start);
        return true;
    }

private:
    static constexpr int shift = 12;
    void push(std::uint32_t f, std::uint32_t at) {
        const std::uint32_t b = (f >> shift) & 63;
        ring_[b].push_back(at);
        occupied_ |= std::uint64_t(1) << b;
    }
    std::vector<std::vector<std::uint32_t>> ring_;
    std::uint64_t occupied_ = 0;
};

} // namespace peers
