// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Interpreted`: the interpreted state pattern of the notes (5.1). States, behaviours and transitions come from a
/// file, and the structure is built when the program starts, or again while it runs.
///
/// `Machine<InFile<Npc>, Interpreted> m{chart}` runs a chart that was read; `Machine<GuardNpc, Interpreted>` interprets
/// a description, for comparison. It alone has parallel states. Several machines share one chart. Taking an event does
/// not allocate. What it costs: a load where the switch has a jump, an indirect call for each guard and action.

#include <ansatz/states/additions.hpp>
#include <ansatz/states/chart_build.hpp>
#include <ansatz/states/lasting.hpp>
#include <ansatz/states/regions.hpp>

namespace ansatz {

/// Representation of a Machine: a chart, read at run time.
struct Interpreted {};

/// The description of a machine whose states stand in a file.
/// \tparam C  the user's context
template <class C> struct InFile {
    using Context = C; ///< the user's
};

/// What `reload` did.
enum class Reloaded : std::uint8_t {
    same_states, ///< every active state is in the new chart: the machine goes on in them, nothing was left or entered
    other_states ///< some are not: the machine went to what is left of them, and entered the initial states there
};

/// \tparam D  InFile<Context> or a description
template <class D, class Context_, class... O>
class InterpretedMachine
    : public states::Lasting<InterpretedMachine<D, Context_, O...>, Context_>
    , public states::Additions<InterpretedMachine<D, Context_, O...>, Context_> {
public:
    using states::Additions<InterpretedMachine, Context_>::add;
    using states::Lasting<InterpretedMachine, Context_>::start;
    using Context = Context_;                                             ///< the user's
    using Opts = states::Options<O...>;                                   ///< all its options together
    static constexpr bool from_file = std::is_same_v<D, InFile<Context>>; ///< whether it needs a chart to begin with
    static constexpr bool keeps_time = true;                              ///< knows its time()

    InterpretedMachine()
        requires(!from_file)
    {
        adopt(chart_of<D>());
    }
    /// \param options  those that have a value to begin with; all of them, in the order of the type
    explicit InterpretedMachine(O... options)
        requires(!from_file && sizeof...(O) > 0)
        : options_(options...) {
        adopt(chart_of<D>());
    }
    /// \param chart  from read_scxml or make_chart
    /// \throws std::invalid_argument for none
    explicit InterpretedMachine(SharedChart<Context> chart, O... options)
        requires(from_file)
        : options_(make_options(options...)) {
        adopt(std::move(chart));
    }

    InterpretedMachine(const InterpretedMachine& other) { *this = other; } ///< a snapshot
    /// The chart is shared; states, data, memories, queue and time are copied.
    InterpretedMachine& operator=(const InterpretedMachine& other) {
        if (this == &other) return *this;
        chart_ = other.chart_, leaf_ = other.leaf_, regions_ = other.regions_, busy_ = false, stopped_ = other.stopped_,
        quick_ = other.quick_, history_ = other.history_;
        entered_ = other.entered_, memory_ = other.memory_, queue_ = other.queue_, now_ = other.now_, dt_ = other.dt_,
        options_ = other.options_;
        owns_.clear();
        for (const auto& own : other.owns_) owns_.push_back(own->copy());
        return *this;
    }
    InterpretedMachine(InterpretedMachine&&) = default;            ///< takes everything over
    InterpretedMachine& operator=(InterpretedMachine&&) = default; ///< takes everything over

    // ------------------------------------------------------------ driving it; as Machine of the other representations
    /// Enters the initial states, from the outside inwards; refused within an action. What waits, and stuck(), is
    /// forgotten.
    void start(Context& context) {
        begin(context, [&] {
            if (chart_->parallel_) regions_.start(*this, context);
            else enter_initial(context, 0);
        });
    }
    /// An event. Within an action of this machine it waits until the present transition is complete.
    bool handle(Context& context, EventId event) {
        return handle_as(context, event,
                         [&] { return index(event) + 1 < event_count() ? std::optional(name(event)) : std::nullopt; });
    }
    /// The same by name.
    bool handle(Context& context, std::string_view name) {
        return handle_as(context, event(name), [name] { return std::optional(name); });
    }
    /// One update of the fixed clock.
    /// \param dt  s
    bool update(Context& context, Parameter<unit::Time> dt) {
        if (!(dt.value() >= 0 && dt.value() <= std::numeric_limits<double>::max())) states::refuse_dt(dt);
        if (!started()) states::refuse_not_started();
        if (busy_)
            refuse(Refusal::invalid_argument,
                   "Machine::update: called from an action of the same machine; raise an event instead");
        const states::detail::Busy busy(busy_);
        const auto& c = *chart_;
        now_ += dt;
        dt_ = dt;
        if (c.memory_ > 0) for_memories(context, false);
        const bool took = choose(context, c.columns_ - 2);
        if (took) finish(context);
        if (c.acts_) {
            behave(context, dt);
            finish(context);
        }
        return took;
    }
    /// The same where time is not counted.
    bool update(Context& context) { return update(context, Quantity<unit::Time>{}); }

    using states::Lasting<InterpretedMachine, Context_>::update;

    /// Another chart, between two updates. The machine stays in the states of the same names, with what they hold;
    /// where an active state is gone, it goes to what is left around it and enters the initial states there. Histories
    /// and times stay with their states; what guards remember begins anew.
    /// \throws std::invalid_argument for none, or from within an action; the machine is as it was
    Reloaded reload(Context& context, SharedChart<Context> chart);

    // ------------------------------------------------------------ what can be asked
    const Chart<Context>& chart() const { return *chart_; }                              ///< what it runs
    const Outline& outline() const { return chart_->outline_; }                          ///< its structure and names
    bool started() const { return chart_->parallel_ ? regions_.started() : leaf_ != 0; } ///< start was called
    /// The innermost active state; of parallel ones the first.
    StateId active() const { return StateId(chart_->parallel_ ? regions_.first_leaf(*chart_) : leaf_); }
    std::string_view active_name() const { return chart_->name(active()); } ///< of the innermost active state
    /// It is active.
    bool is_in(StateId id) const {
        return started() && index(id) < chart_->state_count() &&
               (chart_->parallel_ ? regions_.has(index(id))
                                  : index(id) <= leaf_ && leaf_ < chart_->states_[index(id)].end);
    }
    bool is_in(std::string_view name) const { return is_in(state(name)); } ///< by name
    /// The innermost active states: one, or one of each region.
    std::vector<StateId> leaves() const {
        std::vector<StateId> found;
        if (!chart_->parallel_ && started()) found.push_back(active());
        for (const auto s : regions_.leaves()) found.push_back(StateId(s));
        return found;
    }
    /// In a final state of the machine itself.
    bool done() const {
        for (std::size_t s = 1; s < chart_->state_count(); s = chart_->states_[s].end)
            if (chart_->states_[s].kind == states::Kind::final && is_in(StateId(s))) return true;
        return false;
    }
    Quantity<unit::Time> time() const { return now_; } ///< since start
    bool stuck() const { return stopped_; }            ///< one call raised events without end and was stopped
    std::uint32_t dropped_events() const { return queue_.dropped(); }      ///< raised, and no room for them
    template <class Option> const Option& get() const { return options_; } ///< one of its options
    template <class Option> Option& get() { return options_; }             ///< one of its options
    /// The data of a state that has a class.
    template <class B> const B& own(StateId id) const {
        const auto at = index(id) < chart_->state_count() ? chart_->states_[index(id)].behaviour : states::nowhere;
        if (at == states::nowhere || owns_[at]->tag() != states::detail::tag_of<B>())
            refuse(Refusal::invalid_argument, "Machine::own: this state has no data of this class");
        return *static_cast<const B*>(owns_[at]->data());
    }
    std::size_t state_count() const { return chart_->state_count(); }          ///< with the root
    std::size_t event_count() const { return chart_->event_count(); }          ///< names, and one for all others
    std::string_view name(StateId id) const { return chart_->name(id); }       ///< of a state
    std::string_view name(EventId id) const { return chart_->name(id); }       ///< of an event
    EventId event(std::string_view name) const { return chart_->event(name); } ///< of a name
    /// The state of a name.
    /// \throws std::invalid_argument for a name that no state has
    StateId state(std::string_view name) const {
        const StateId found = chart_->find(name);
        if (found == StateId::none)
            refuse(Refusal::invalid_argument, "Machine::state: there is no state " + states::detail::shown(name));
        return found;
    }

private:
    template <class> friend class states::detail::Regions;
    friend struct states::MachineArchive;
    template <class, class> friend class states::Lasting;
    template <class, class> friend class states::Additions;
    states::Kind kind_of(StateId s) const { return chart_->states_[index(s)].kind; }
    Quantity<unit::Time> entered_at(std::size_t s) const { return entered_[s]; }
    void start_in(Context& context, std::size_t s) {
        begin(context, [&] {
            const std::vector<std::uint16_t> there{std::uint16_t(s)};
            if (chart_->parallel_) regions_.go_to(*this, context, there, [](std::size_t) { return false; });
            else enter_target(context, 0, s);
        });
    }
    void begin(Context& context, auto&& enter) {
        if (busy_)
            refuse(Refusal::invalid_argument,
                   "Machine::start: called from an action of the same machine; raise an event instead");
        const states::detail::Busy busy(busy_);
        now_ = dt_ = {}, queue_ = {}, stopped_ = false;
        forget();
        for_memories(context, true);
        try {
            enter();
        } catch (...) { // half entered is not started
            forget();
            throw;
        }
        finish(context);
    }
    static Opts make_options([[maybe_unused]] O... options) {
        if constexpr (sizeof...(O) > 0) return Opts(options...);
        else return {};
    }

    void adopt(SharedChart<Context> chart) {
        if (chart == nullptr) refuse(Refusal::invalid_argument, "Machine: there is no chart");
        if (chart->childless() && !Opts::childless) states::refuse_childless(chart->outline());
        fit_chart(std::move(chart));
        const auto& c = *chart_;
        leaf_ = 0;
        regions_.fit(c);
        entered_.assign(c.state_count(), {});
        owns_.clear();
        for (const auto maker : c.behaviours_) owns_.push_back(maker());
        forget();
    }
    void fit_chart(SharedChart<Context> chart) {
        chart_ = std::move(chart);
        const auto& c = *chart_;
        memory_.assign((c.memory_ + sizeof(std::max_align_t) - 1) / sizeof(std::max_align_t), std::max_align_t{});
        // Without options that see, and where nothing asks for the time, an event that changes only the state is one
        // load.
        quick_ = !Opts::watched && !c.automatic_ && !c.raises_;
        for (const auto& guard : c.guards_) quick_ = quick_ && !guard.needs_time;
    }
    void forget() {
        leaf_ = 0;
        history_.assign(chart_->state_count(), states::nowhere);
        regions_.forget();
    }

    // ------------------------------------------------------------ one step
    // An event, and how it is called if it must be refused.
    [[gnu::always_inline]] bool handle_as(Context& context, EventId event, auto&& called) {
        if (busy_) [[unlikely]]
            return queue_.raise(event);
        const auto& c = *chart_;
        if (!c.parallel_ && index(event) < c.columns_ - 2 &&
            quick_) { // nothing can be raised, watched or timed: one load
            const std::uint32_t at = c.cells_[leaf_ * c.columns_ + index(event)];
            if (at != states::detail::no_candidate) {
                const auto& t = c.transitions_[c.candidates_[at]];
                if (t.plain) {
                    leaf_ = t.lands;
                    return true;
                }
            }
        }
        const states::detail::Busy busy(busy_);
        if (!column(context, event)) {
            unhandled(event, called);
            return false;
        }
        finish(context);
        return true;
    }
    bool column(Context& context, EventId event) {
        const auto& c = *chart_;
        return choose(context, std::min<std::size_t>(index(event), c.columns_ - 3));
    }
    bool choose(Context& context, std::size_t column) {
        const auto& c = *chart_;
        if (c.parallel_) return regions_.choose(*this, context, column);
        std::uint32_t at = c.cells_[leaf_ * c.columns_ + column];
        if (at == states::detail::no_candidate) return false;
        for (; c.candidates_[at] != states::nowhere; ++at)
            if (holds(context, c.candidates_[at])) {
                take(context, c.candidates_[at]);
                return true;
            }
        return false;
    }
    typename Chart<Context>::Guard::Asked asked(Context& context, std::size_t source) const {
        const auto own = chart_->states_[source].behaviour;
        return {context, own == states::nowhere ? nullptr : owns_[own]->data(), now_ - entered_[source], dt_};
    }
    bool holds(Context& context, std::size_t t) const {
        const auto& row = chart_->transitions_[t];
        if (row.guard == states::nowhere) return true;
        const auto& guard = chart_->guards_[row.guard];
        if (guard.in != states::nowhere) return is_in(StateId(guard.in)) != guard.not_in;
        return guard.ask(guard.guard.get(), asked(context, row.source), memory_at(row.guard));
    }
    const void* memory_at(std::size_t guard) const {
        return reinterpret_cast<const std::byte*>(memory_.data()) + chart_->memory_at_[guard];
    }
    void for_memories(Context& context, bool begin) {
        for (std::size_t t = 0; t < chart_->transitions_.size(); ++t) for_memory(context, t, begin);
    }
    void for_memory(Context& context, std::size_t t, bool begin) {
        const auto& row = chart_->transitions_[t];
        if (row.guard == states::nowhere || chart_->guards_[row.guard].memory == 0) return;
        const auto& guard = chart_->guards_[row.guard];
        (begin ? guard.begin : guard.sample)(guard.guard.get(), asked(context, row.source),
                                             const_cast<void*>(memory_at(row.guard)));
    }
    void perform(Context& context, states::detail::Range steps, Quantity<unit::Time> dt = {}) {
        using What = Outline::Content::What;
        const auto& c = *chart_;
        for (std::size_t i = 0; i < steps.count; ++i) {
            const auto step = c.steps_[steps.first + i];
            if (step.what == What::action)
                c.actions_[step.number].run(c.actions_[step.number].action.get(), context, dt, queue_);
            else if (step.what == What::raise) queue_.raise(EventId(step.number));
            else if (c.log_ != nullptr) (*c.log_)(context, c.texts_[step.number]);
        }
    }
    void took(Context& context, std::size_t t) {
        const auto& row = chart_->transitions_[t];
        tell(Happening::What::took, row.source, t);
        perform(context, row.content);
    }
    void enter(Context& context, std::size_t s) {
        const auto& state = chart_->states_[s];
        entered_[s] = now_;
        if (state.acts) {
            perform(context, state.entry);
            if (state.behaviour != states::nowhere) owns_[state.behaviour]->enter(context, queue_);
        }
        tell(Happening::What::entered, s);
    }
    void exit(Context& context, std::size_t s) {
        const auto& state = chart_->states_[s];
        if (state.acts) {
            if (state.behaviour != states::nowhere) owns_[state.behaviour]->exit(context, queue_);
            perform(context, state.exit);
        }
        tell(Happening::What::exited, s);
    }
    void take(Context& context, std::size_t t);
    // A final state tells that its parent is done.
    void enter_one(Context& context, std::size_t s) {
        enter(context, s);
        if (chart_->states_[s].kind == states::Kind::final && chart_->states_[s].parent != 0)
            queue_.raise(EventId(chart_->states_[chart_->states_[s].parent].done));
    }
    void restore(Context& context, std::size_t h);
    // From below `domain` to a target, and on to where that begins.
    void enter_target(Context& context, std::size_t domain, std::size_t target);
    void enter_initial(Context& context, std::size_t s);
    void behave(Context& context, Quantity<unit::Time> dt) {
        const auto& c = *chart_;
        for (std::size_t s = 1; s < c.state_count(); ++s) { // outer states first
            if (!c.states_[s].acts || !is_in(StateId(s))) continue;
            perform(context, c.states_[s].each, dt);
            if (c.states_[s].behaviour != states::nowhere) owns_[c.states_[s].behaviour]->update(context, dt, queue_);
        }
    }
    void finish(Context& context) {
        const auto& c = *chart_;
        if (!c.automatic_ && queue_.empty()) [[likely]]
            return;
        for (std::uint32_t n = 0; n < states::detail::most_steps; ++n) {
            if (c.automatic_ && choose(context, c.columns_ - 1)) continue;
            if (queue_.empty()) return;
            const EventId next = queue_.take();
            if (!column(context, next)) tell(Happening::What::unhandled, index(active()), 0xffff, next);
        }
        stopped_ = true;
        while (!queue_.empty()) queue_.take();
    }
    void unhandled(EventId event, [[maybe_unused]] auto&& called) {
        if (!started()) states::refuse_not_started();
        if constexpr (Opts::refuses) states::refuse_event(called(), active_name());
        tell(Happening::What::unhandled, index(active()), 0xffff, event);
    }
    void tell(Happening::What what, std::size_t state, std::size_t transition = 0xffff, EventId event = EventId::none) {
        if constexpr (Opts::watched) options_.tell({what, StateId(state), TransitionId(transition), event, now_});
    }
    Reloaded take_over(const InterpretedMachine& before, Context& context);
    void keep_history(const InterpretedMachine& before, std::size_t was, std::size_t now);

    SharedChart<Context> chart_;
    std::uint16_t leaf_ = 0;
    bool busy_ = false, stopped_ = false, quick_ = false;
    states::detail::Regions<Context> regions_;
    std::vector<std::uint16_t> history_;
    std::vector<Quantity<unit::Time>> entered_;
    std::vector<std::max_align_t> memory_;
    std::vector<std::unique_ptr<states::detail::Own<Context>>> owns_;
    EventQueue queue_;
    Quantity<unit::Time> now_{}, dt_{};
    [[no_unique_address]] Opts options_;
};

} // namespace ansatz
