// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Bindings`: what the names in a file stand for. A file holds the structure of a machine and names; the functions are
/// the program's, bound once. A name that a file uses and that is not bound is refused when the file is read, not when
/// it is needed.

#include <ansatz/states/archive.hpp>
#include <ansatz/states/outline.hpp>

#include <functional>
#include <map>
#include <memory>

namespace ansatz {

namespace states::detail {

/// An address for each type, to tell types apart at run time.
template <class T> struct TypeTag {
    static constexpr char here = 0;
};
template <class T> constexpr const void* tag_of() { return &TypeTag<T>::here; }

/// What the state of an interpreted machine holds of a class.
template <class Context> struct Own {
    virtual ~Own() = default;
    virtual std::unique_ptr<Own> copy() const = 0;
    virtual void enter(Context&, EventQueue&) = 0;
    virtual void exit(Context&, EventQueue&) = 0;
    virtual void update(Context&, Quantity<unit::Time>, EventQueue&) = 0;
    virtual const void* data() const = 0;
    virtual const void* tag() const = 0;
    virtual bool archive(Archive&, std::string_view name) = 0; // false: it does not say what it consists of
};
template <class Context, class B> struct OwnOf final : Own<Context> {
    B own{};
    std::unique_ptr<Own<Context>> copy() const override { return std::make_unique<OwnOf>(*this); }
    void enter(Context& c, EventQueue& q) override { behave_enter(own, c, q); }
    void exit(Context& c, EventQueue& q) override { behave_exit(own, c, q); }
    void update(Context& c, Quantity<unit::Time> dt, EventQueue& q) override { behave_update(own, c, dt, q); }
    const void* data() const override { return &own; }
    const void* tag() const override { return tag_of<B>(); }
    bool archive([[maybe_unused]] Archive& a, [[maybe_unused]] std::string_view name) override {
        if constexpr (SaysFields<B>) archive_field(a, name, own);
        return is_archived<B>;
    }
};

/// A guard without its type. Called through plain pointers: no heap, one indirect call.
template <class Context> struct BoundGuard {
    struct Asked {
        Context& context;
        const void* own;
        Quantity<unit::Time> in_state, dt;
    };
    bool (*ask)(const void* guard, const Asked&, const void* memory) = nullptr;
    void (*begin)(const void* guard, const Asked&, void* memory) = nullptr; // null: it remembers nothing
    void (*sample)(const void* guard, const Asked&, void* memory) = nullptr;
    void (*archive)(void* memory, Archive&, std::string_view name) = nullptr; // null: it does not say its fields
    std::shared_ptr<const void> guard;
    std::size_t memory = 0;    // bytes
    const void* own = nullptr; // tag of the class that it reads, or null
    bool needs_time = false, equality = false;
    std::uint16_t in = 0xffff; // In('x'): the machine is asked whether it is in x
    bool not_in = false;       // !In('x')
};

/// Whether a guard reads the class of its state: it cannot be asked with the context alone.
template <class G, class Context, class Own> BoundGuard<Context> bind_guard(const G& g) {
    using Bound = BoundGuard<Context>;
    static_assert(alignof(typename G::Memory) <= alignof(std::max_align_t));
    Bound bound;
    bound.guard = std::make_shared<const G>(g);
    bound.needs_time = G::needs_time;
    bound.equality = g.is_equality();
    static constexpr auto question = [](const typename Bound::Asked& a) {
        if constexpr (std::is_same_v<Own, NoBehaviour>) {
            static constexpr NoBehaviour nothing{};
            return Question<Context, Own>{a.context, nothing, a.in_state, a.dt};
        } else // the chart has made sure that the state that asks has this class
            return Question<Context, Own>{a.context, *static_cast<const Own*>(a.own), a.in_state, a.dt};
    };
    using Memory = typename G::Memory;
    bound.ask = [](const void* guard, const typename Bound::Asked& a, const void* memory) {
        if constexpr (std::is_same_v<Memory, NoMemory>)
            return static_cast<const G*>(guard)->ask(question(a), NoMemory{});
        else return static_cast<const G*>(guard)->ask(question(a), *static_cast<const Memory*>(memory));
    };
    if constexpr (!std::is_same_v<Memory, NoMemory>) {
        bound.memory = sizeof(Memory);
        bound.begin = [](const void* guard, const typename Bound::Asked& a, void* memory) {
            static_cast<const G*>(guard)->begin(*new (memory) Memory{}, question(a));
        };
        bound.sample = [](const void* guard, const typename Bound::Asked& a, void* memory) {
            static_cast<const G*>(guard)->sample(*static_cast<Memory*>(memory), question(a));
        };
    }
    if constexpr (SaysFields<Memory>)
        bound.archive = [](void* memory, Archive& a, std::string_view name) {
            archive_field(a, name, *static_cast<Memory*>(memory));
        };
    if constexpr (!std::is_same_v<Own, NoBehaviour>) bound.own = tag_of<Own>();
    return bound;
}

/// An action without its type.
template <class Context> struct BoundAction {
    void (*run)(const void* action, Context&, Quantity<unit::Time>, EventQueue&) = nullptr;
    std::shared_ptr<const void> action;
};
struct NoEvents {
    static constexpr std::uint16_t find_event(std::string_view) { return index(EventId::none); }
};
template <class F, class Context> BoundAction<Context> bind_action(const F& f) {
    return {[](const void* action, Context& c, Quantity<unit::Time> dt, EventQueue& q) {
                act<NoEvents>(*static_cast<const F*>(action), c, dt, q);
            },
            std::make_shared<const F>(f)};
}

} // namespace states::detail

/// The names that the files of a program may use.
/// \tparam Context  the user's
template <class Context> class Bindings {
public:
    using Guard = states::detail::BoundGuard<Context>;                 ///< a guard without its type
    using Action = states::detail::BoundAction<Context>;               ///< an action without its type
    using Maker = std::unique_ptr<states::detail::Own<Context>> (*)(); ///< makes an object of a state class

    /// A guard: a function of the context, or one of the library's.
    /// \throws std::invalid_argument for an empty name or one that is bound already
    template <class F> Bindings& guard(std::string name, F f) {
        check("guard", name, guards_.count(name) > 0);
        if constexpr (std::derived_from<F, states::GuardBase>)
            guards_.emplace(std::move(name), states::detail::bind_guard<F, Context, states::NoBehaviour>(f));
        else
            guards_.emplace(std::move(name), states::detail::bind_guard<states::Asked<F>, Context, states::NoBehaviour>(
                                                 states::Asked<F>{{}, f}));
        return *this;
    }
    /// An action: a function of the context, or of it and an EventQueue&.
    template <class F> Bindings& action(std::string name, F f) {
        check("action", name, actions_.count(name) > 0);
        actions_.emplace(std::move(name), states::detail::bind_action<F, Context>(f));
        return *this;
    }
    /// A state class.
    template <class B> Bindings& behaviour(std::string name) {
        check("behaviour", name, behaviours_.count(name) > 0);
        behaviours_.emplace(
            std::move(name), +[]() -> std::unique_ptr<states::detail::Own<Context>> {
                return std::make_unique<states::detail::OwnOf<Context, B>>();
            });
        return *this;
    }
    /// Where the text of `<log>` goes; nowhere without it.
    Bindings& log(std::function<void(Context&, std::string_view)> f) {
        log_ = std::make_shared<const std::function<void(Context&, std::string_view)>>(std::move(f));
        return *this;
    }
    /// A guard that was bound elsewhere; a name that is bound already keeps its function.
    Bindings& adopt(const std::string& name, Guard guard) {
        guards_.emplace(name, std::move(guard));
        return *this;
    }
    /// An action.
    Bindings& adopt(const std::string& name, Action action) {
        actions_.emplace(name, std::move(action));
        return *this;
    }
    /// A state class.
    Bindings& adopt(const std::string& name, Maker maker) {
        behaviours_.emplace(name, maker);
        return *this;
    }

    /// Where the text of `<log>` goes, of other bindings.
    Bindings& adopt_log(std::shared_ptr<const std::function<void(Context&, std::string_view)>> f) {
        log_ = std::move(f);
        return *this;
    }

    const Guard* find_guard(const std::string& name) const { return find(guards_, name); }    ///< null: not bound
    const Action* find_action(const std::string& name) const { return find(actions_, name); } ///< null: not bound
    /// Null: not bound.
    const Maker* find_behaviour(const std::string& name) const { return find(behaviours_, name); }
    const auto& log_function() const { return log_; } ///< null: none
    /// The names of its guards, for a sentence.
    std::string guard_names() const { return names(guards_); }
    std::string action_names() const { return names(actions_); } ///< of its actions

private:
    static const auto* find(const auto& map, const std::string& name) {
        const auto at = map.find(name);
        return at == map.end() ? nullptr : &at->second;
    }
    static std::string names(const auto& map) {
        std::string text;
        for (const auto& [name, bound] : map) {
            if (text.size() > 200) return text + ", ...";
            text += (text.empty() ? "" : ", ") + name;
        }
        return text.empty() ? "none is bound" : text;
    }
    static void check(const char* what, const std::string& name, bool known) {
        if (name.empty()) refuse(Refusal::invalid_argument, std::string("Bindings::") + what + ": the name is empty");
        if (known)
            refuse(Refusal::invalid_argument, std::string("Bindings::") + what + ": \"" + name + "\" is bound already");
    }
    std::map<std::string, Guard> guards_;
    std::map<std::string, Action> actions_;
    std::map<std::string, Maker> behaviours_;
    std::shared_ptr<const std::function<void(Context&, std::string_view)>> log_;
};

namespace states::detail {

template <class D> Bindings<typename D::Context> bindings_named(auto namer) {
    using M = states::Model<D>;
    using P = states::Parts<M>;
    using Context = typename D::Context;
    namespace d = states::detail;
    Bindings<Context> names;
    auto actions = [&]<int Part>(const auto& node, std::string_view where, const char* what, std::size_t& number) {
        d::each_part<Part>(node, [&](const auto& part) {
            ++number;
            if constexpr (!std::is_same_v<decltype(part.action), states::Raised>)
                names.adopt(namer(part.called, where, what, number),
                            d::bind_action<std::remove_cvref_t<decltype(part.action)>, Context>(part.action));
        });
    };
    [&]<std::size_t... S>(std::index_sequence<S...>) {
        (
            [&] {
                const auto& node = *std::get<S>(M::state_nodes);
                using Own = typename P::template Behaviour<S>;
                std::size_t entry = 0, exit = 0, each = 0, guard = 0, then = 0;
                actions.template operator()<d::part_entry>(node, node.name, "entry", entry);
                actions.template operator()<d::part_exit>(node, node.name, "exit", exit);
                actions.template operator()<d::part_each>(node, node.name, "update", each);
                d::each_part<d::part_behaves>(node, [&](const auto& b) {
                    names.adopt(namer(b.called, node.name, "class", 1),
                                typename Bindings<Context>::Maker(+[]() -> std::unique_ptr<d::Own<Context>> {
                                    return std::make_unique<d::OwnOf<Context, Own>>();
                                }));
                });
                d::each_part<d::part_transition>(node, [&](const auto& t) {
                    d::each_part<d::part_when>(t, [&](const auto& when) {
                        using GuardType = std::remove_cvref_t<decltype(when.guard)>;
                        names.adopt(d::guard_name(when, node.name, ++guard, namer),
                                    d::bind_guard<GuardType, Context, Own>(when.guard));
                    });
                    actions.template operator()<d::part_then>(t, node.name, "action", then);
                });
            }(),
            ...);
    }(std::make_index_sequence<M::state_count>{});
    return names;
}

} // namespace states::detail

/// The names of a description, bound to its functions: what reads back a file that was written of it. Of two different
/// functions under one name the first is taken.
template <class D> Bindings<typename D::Context> bindings_of() {
    return states::detail::bindings_named<D>(states::detail::Called{});
}

} // namespace ansatz
