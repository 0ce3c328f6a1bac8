// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Overlapping guards, found by asking: `overlapping<GuardNpc>(contexts)` (notes 5.2).
///
/// Two guards of one state that hold in the same context leave the choice to the order of the description, which is
/// sometimes meant and often not. A condition from a to b and one from b to a that hold in the same context turn the
/// machine at every update, without any noise. Guards that remember or count time are left out: a context alone does
/// not decide them.

#include <ansatz/states/check.hpp>

#include <string>

namespace ansatz {

namespace states::detail {

/// What every guard of a description says in one context; of those that remember, count time or read a state's class,
/// nothing.
template <class D> struct Answers {
    using M = Model<D>;
    using P = Parts<M>;
    static constexpr std::size_t count = M::transition_count;

    template <std::size_t T> static constexpr bool asks() {
        using G = typename P::template GuardType<T>;
        if constexpr (std::is_void_v<G>) return false;
        else
            return !P::template remembers<T> && !G::needs_time &&
                   std::is_same_v<typename P::template Behaviour<M::rows.transitions[T].source>, NoBehaviour>;
    }
    static std::array<bool, count + 1> in(typename D::Context& context) {
        std::array<bool, count + 1> holds{};
        [&]<std::size_t... T>(std::index_sequence<T...>) {
            (
                [&] {
                    if constexpr (asks<T>())
                        each_part<part_when>(*std::get<T>(M::transition_nodes), [&](const auto& when) {
                            static constexpr NoBehaviour nothing{};
                            holds[T] = when.guard.ask(
                                Question<typename D::Context, NoBehaviour>{context, nothing, {}, {}}, NoMemory{});
                        });
                }(),
                ...);
        }(std::make_index_sequence<count>{});
        return holds;
    }
};

} // namespace states::detail

/// The pairs of guards that hold together in one of the contexts; each pair once.
/// \tparam D        a description
/// \param contexts  a range of contexts, e.g. a grid over what the guards read
template <class D> std::vector<Finding> overlapping(auto&& contexts) {
    using M = states::Model<D>;
    constexpr std::size_t n = M::transition_count;
    std::vector<char> together(n * n, 0);
    for (auto context : contexts) {
        const auto holds = states::detail::Answers<D>::in(context);
        for (std::size_t a = 0; a < n; ++a)
            for (std::size_t b = a + 1; holds[a] && b < n; ++b)
                together[a * n + b] = char(together[a * n + b] | char(holds[b]));
    }
    const auto outline = outline_of<D>();
    std::vector<Finding> found;
    for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = a + 1; b < n; ++b) {
            if (!together[a * n + b]) continue;
            const auto& ra = M::rows.transitions[a];
            const auto& rb = M::rows.transitions[b];
            const auto& ga = outline.transitions[a].guard;
            const auto& gb = outline.transitions[b].guard;
            const std::string from(M::rows.states[ra.source].name);
            bool same_event = ra.events.empty() && rb.events.empty();
            for (std::size_t e = 0; e < M::event_count; ++e)
                same_event = same_event || (states::matches(ra.events, M::event_name(e)) &&
                                            states::matches(rb.events, M::event_name(e)));
            if (ra.source == rb.source && same_event)
                found.push_back({Finding::What::overlap, from, 0,
                                 "the guards \"" + ga + "\" and \"" + gb + "\" of \"" + from +
                                     "\" hold together: the one that stands first is taken"});
            if (ra.events.empty() && rb.events.empty() && ra.target == rb.source && rb.target == ra.source)
                found.push_back({Finding::What::back_and_forth, from, 0,
                                 "\"" + ga + "\" leads from \"" + from + "\" to \"" +
                                     std::string(M::rows.states[rb.source].name) + "\" and \"" + gb +
                                     "\" leads back, and both hold together: the machine turns at every update"});
        }
    return found;
}

} // namespace ansatz
