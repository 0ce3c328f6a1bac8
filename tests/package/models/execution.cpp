// SPDX-License-Identifier: BSL-1.0
// An execution runs the loops of a step: here on threads that wait for the next loop, and serve one world at a time.
#include <ansatz/world.hpp>
#include <barrier>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>
using namespace ansatz;
//! [model]
class Workers {
public:
    using Loop = std::function<void(std::size_t, std::size_t)>;
    explicit Workers(int n) : n_(std::size_t(n)), begin_(n), end_(n) {
        for (std::size_t i = 1; i < n_; ++i)
            threads_.emplace_back([this, i] {
                for (begin_.arrive_and_wait(); loop_; begin_.arrive_and_wait()) part(i);
            });
    }
    ~Workers() {
        loop_ = nullptr, begin_.arrive_and_wait();
        for (auto& thread : threads_) thread.join();
    }
    void run(std::size_t count, const Loop& loop) {
        const std::unique_lock mine(busy_, std::try_to_lock);
        if (!mine) return loop(0, count); // they serve another world
        loop_ = &loop, count_ = count, begin_.arrive_and_wait();
        part(0);
    }

private:
    void part(std::size_t i) {
        (*loop_)(count_* i / n_, count_ * (i + 1) / n_); // no law of these worlds throws
        end_.arrive_and_wait();
    }
    const Loop* loop_ = nullptr;
    std::size_t n_, count_ = 0;
    std::barrier<> begin_, end_;
    std::mutex busy_;
    std::vector<std::thread> threads_;
};
struct KeptThreads {
    using role = roles::Execution;
    std::shared_ptr<Workers> workers = std::make_shared<Workers>(3); // copies share them; moved from, none
    void execute(std::size_t count, std::size_t grain, const auto& loop) const {
        !workers || count < 2 * grain ? loop(0, count) : workers->run(count, std::cref(loop));
    }
};
//! [model]
int main() {
    auto flown = [](auto world) {
        for (int i = 0; i < 3000; ++i) world.add(velocity(metres_per_second(i, 2 * i, 0)));
        for (int i = 0; i < 100; ++i) world.step(0.01 * second);
        return world.hash();
    };
    const auto right = flown(World{RungeKutta4{}, Gravity{}, Drag{0.1 / second}});
    World kept{RungeKutta4{}, Gravity{}, Drag{0.1 / second}, KeptThreads{}};
    const auto moved = std::move(kept); // `kept` has no threads now, and goes on alone
    return flown(moved) == right && flown(kept) == right ? 0 : 1;
}
