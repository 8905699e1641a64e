// SPDX-License-Identifier: Apache-2.0
// Describes the steps by the components that move. If the reference semantics had no time to replay the run, its states
// are not terms. The steps are then described by the names of the whole process.
#include "counterexample/interpreter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "counterexample/copies.hpp"
#include "counterexample/text.hpp"
#include "counterexample/timeline.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::runs {
namespace {

using process::TermId;
using refine::ViolationKind;

constexpr std::size_t most_offers = 40;       // listed alternatives for each step
constexpr std::size_t most_looked_at = 5000;  // alternatives examined for all steps together

class Interpreter {
public:
    Interpreter(const Context& context, const csp_emit::Obligation& obligation,
                const refine::Counterexample& counterexample)
        : context_(context),
          obligation_(obligation),
          counterexample_(counterexample),
          reader_(context),
          copies_(context.provenance.copies) {}

    Run run();

private:
    void read_raw();
    void read_steps();
    bool read_apart();
    void read_whole();
    void add_step(std::size_t raw, bool shown, Event event, std::vector<Event> with, std::vector<Machine> machines);
    [[nodiscard]] bool belongs_to_last(std::size_t raw, const std::string& name, const Event& event) const;
    void complete_last(bool shown, std::vector<Machine> machines);
    [[nodiscard]] const Machine* last_known(const std::string& component, std::size_t steps) const;
    void add_times();
    void fold_tocks();
    void add_offers();
    void read_end();
    void name_watched();

    [[nodiscard]] const refine::Step& raw_step(std::size_t raw) const {
        return raw < counterexample_.steps.size() ? counterexample_.steps[raw]
                                                  : counterexample_.loop[raw - counterexample_.steps.size()];
    }
    [[nodiscard]] TermId term_before(std::size_t raw) const {
        return raw < counterexample_.steps.size() ? counterexample_.terms[raw]
                                                  : counterexample_.loop_terms[raw - counterexample_.steps.size()];
    }
    [[nodiscard]] const std::string& name(process::Event event) const { return reader_.name(event); }
    void tell_copies_apart(const Timeline& line);
    [[nodiscard]] Happening happening_at(const Moment& moment, const std::vector<ComponentStep>& moves);
    [[nodiscard]] Happening said_of_copy(Happening happening, const std::string& whole) const;
    [[nodiscard]] Event event_of_offer(TermId term, const process::Transition& step);
    std::vector<ComponentStep> moves_of(const Moment& moment, const std::vector<std::optional<TermId>>& before);
    std::vector<Machine> machines_at(const std::vector<std::optional<TermId>>& leaves);
    std::vector<Machine> machines_described(const std::string& state);
    [[nodiscard]] std::vector<Change> collect_changes(std::size_t steps, const std::vector<Machine>& after) const;
    std::vector<Event> offers_at(TermId term);
    void add_offers(std::size_t raw, Step& step);

    [[nodiscard]] EndKind end_kind() const;
    [[nodiscard]] bool time_passes_in_loop() const;
    [[nodiscard]] std::vector<process::Transition> transitions_at(TermId term) const;
    [[nodiscard]] std::vector<Event> events_of_set(const process::EventSet& set) const;
    [[nodiscard]] bool writes_are_urgent() const;
    [[nodiscard]] std::vector<Cause> collect_causes() const;
    [[nodiscard]] std::string accepting_run() const;
    [[nodiscard]] std::string explain_end() const;
    [[nodiscard]] std::vector<Event> missing_events() const;
    [[nodiscard]] const std::vector<Machine>& last_machines() const;
    std::vector<Event> offered_at_the_end();

    const Context& context_;
    const csp_emit::Obligation& obligation_;
    const refine::Counterexample& counterexample_;
    StepReader reader_;
    Copies copies_;
    std::size_t described_ = 0;     ///< the maximal number of definitions in the text of a state
    std::size_t before_first_ = 0;  ///< number of raw events before the first step; the first step includes them
    Run run_;
    std::map<TermId, std::vector<std::pair<process::Transition, Event>>> offers_;
    std::size_t looked_at_ = 0;
};

// ---------------------------------------------------------------- steps

/// Returns the machines of a state. The machines of each copy are read separately, because each copy has its own
/// memories.
std::vector<Machine> Interpreter::machines_at(const std::vector<std::optional<TermId>>& leaves) {
    std::map<std::optional<std::uint32_t>, std::vector<std::vector<Call>>> calls;
    for (Leaf leaf = 0; leaf < leaves.size(); ++leaf)
        if (leaves[leaf]) calls[copies_.of_leaf(leaf)].push_back(reader_.calls_of(*leaves[leaf]));
    std::vector<Machine> result;
    for (const auto& [copy, own] : calls)
        for (Machine& machine : reader_.machines_of(own)) {
            machine.component = copies_.name_with_copy(machine.component, copy);
            result.push_back(std::move(machine));
        }
    return result;
}

/// Assigns the leaves to copies. The assignment is dropped if only leaves of other copies perform an event of one copy.
void Interpreter::tell_copies_apart(const Timeline& line) {
    std::vector<bool> of_model(line.initial.size());
    const auto look = [&](const std::vector<std::optional<TermId>>& leaves) {
        for (Leaf leaf = 0; leaf < leaves.size(); ++leaf)
            if (leaves[leaf] && !of_model[leaf]) of_model[leaf] = !reader_.calls_of(*leaves[leaf]).empty();
    };
    look(line.initial);
    for (const Moment& moment : line.moments) look(moment.leaves);
    copies_.number_leaves(of_model);
    for (const Moment& moment : line.moments) {
        if (!moment.shown) continue;
        const refine::Step& raw = raw_step(moment.raw);
        const std::string& name = reader_.name_of(raw.event, raw.revealed);
        const auto copy = copies_.of_event(name);
        if (!copy) continue;
        const bool of_it =
            std::ranges::any_of(moment.movers, [&](const Mover& mover) { return copies_.of_leaf(mover.leaf) == copy; });
        const bool of_none = std::ranges::none_of(
            moment.movers, [&](const Mover& mover) { return copies_.of_leaf(mover.leaf).has_value(); });
        if (!of_it && !of_none) return copies_.forget_leaves();
    }
}

/// Describes the actions in a moment, separately for each copy that takes part. The copy to which the event belongs
/// comes first.
Happening Interpreter::happening_at(const Moment& moment, const std::vector<ComponentStep>& moves) {
    const refine::Step& raw = raw_step(moment.raw);
    const std::string& whole = moment.shown ? reader_.name_of(raw.event, raw.revealed) : name(process::tau);
    std::map<std::optional<std::uint32_t>, std::vector<ComponentStep>> apart;
    for (std::size_t i = 0; i < moves.size(); ++i) apart[copies_.of_leaf(moment.movers[i].leaf)].push_back(moves[i]);
    apart.erase(std::nullopt);
    Happening all = reader_.happening_of(moves, whole);
    if (all.event.kind == Kind::tock) return all;
    if (apart.empty()) return said_of_copy(std::move(all), whole);
    const auto actor = copies_.of_event(whole);
    const auto first = actor && apart.contains(actor) ? apart.find(actor) : apart.begin();
    Happening result = reader_.happening_of(first->second, whole);
    const auto name_all = [&](Happening& happening, std::optional<std::uint32_t> copy) {
        happening.event.component = copies_.name_with_copy(happening.event.component, copy);
        for (Event& other : happening.with) other.component = copies_.name_with_copy(other.component, copy);
    };
    name_all(result, first->first);
    for (const auto& [copy, own] : apart) {
        if (copy == first->first) continue;
        Happening other = reader_.happening_of(own, whole);
        name_all(other, copy);
        result.with.push_back(std::move(other.event));
        result.with.insert(result.with.end(), other.with.begin(), other.with.end());
    }
    return result;
}

/// Describes an event in which no machine of the model takes part.
Happening Interpreter::said_of_copy(Happening happening, const std::string& whole) const {
    const auto words = copies_.words_for(whole);
    if (!words) return happening;
    happening.event.kind = words->empty() ? Kind::internal : Kind::event;
    if (!words->empty()) happening.event.text = *words;
    happening.event.component = copies_.name_with_copy("", copies_.of_event(whole));
    return happening;
}

/// Returns the machine after this number of steps, or its last known state before that. Between an event and the
/// following update of a memory, the state of a machine is unknown.
const Machine* Interpreter::last_known(const std::string& component, std::size_t steps) const {
    for (std::size_t i = steps + 1; i-- > 0;) {
        const std::vector<Machine>& machines = i == 0 ? run_.initial : run_.steps[i - 1].machines;
        const auto found =
            std::ranges::find_if(machines, [&](const Machine& machine) { return machine.component == component; });
        if (found != machines.end()) return &*found;
    }
    return nullptr;
}

/// Returns the changes of variables since this number of steps. Clocks and countdowns change with time, and temporary
/// values are not variables of the model. Both are ignored.
std::vector<Change> Interpreter::collect_changes(std::size_t steps, const std::vector<Machine>& after) const {
    std::vector<Change> result;
    for (const Machine& now : after) {
        const Machine* was = last_known(now.component, steps);
        if (was == nullptr) continue;
        for (const Variable& variable : now.variables) {
            if (variable.kind != VariableKind::variable || !variable.value) continue;
            const auto old = std::ranges::find_if(
                was->variables, [&](const Variable& candidate) { return candidate.name == variable.name; });
            const auto value = old == was->variables.end() ? std::nullopt : old->value;
            if (value != variable.value) result.push_back({now.component, variable.name, value, *variable.value});
        }
    }
    return result;
}

std::vector<ComponentStep> Interpreter::moves_of(const Moment& moment,
                                                 const std::vector<std::optional<TermId>>& before) {
    std::vector<ComponentStep> moves;
    for (const Mover& mover : moment.movers) {
        ComponentStep move{name(mover.event), {}, {}};
        if (before[mover.leaf]) move.before = reader_.calls_of(*before[mover.leaf]);
        if (moment.leaves[mover.leaf]) move.after = reader_.calls_of(*moment.leaves[mover.leaf]);
        moves.push_back(std::move(move));
    }
    return moves;
}

void Interpreter::add_step(std::size_t raw, bool shown, Event event, std::vector<Event> with,
                           std::vector<Machine> machines) {
    Step step;
    step.raw = raw;
    step.count = shown ? 1 : 0;
    if (shown) {
        step.raw -= before_first_;
        step.count += std::exchange(before_first_, 0);
    }
    step.hidden = !shown || raw_step(raw).event == process::tau;
    step.units = event.kind == Kind::tock ? 1 : 0;
    step.event = std::move(event);
    step.with = std::move(with);
    step.changes = collect_changes(run_.steps.size(), machines);
    step.machines = std::move(machines);
    if (raw >= counterexample_.steps.size() && !run_.loop_start) run_.loop_start = run_.steps.size();
    run_.steps.push_back(std::move(step));
}

/// Returns true if the event belongs to the step before it. This is true if a machine reads or writes a memory as a
/// consequence of that step, and for events of a watch, which belong to no component.
bool Interpreter::belongs_to_last(std::size_t raw, const std::string& name, const Event& event) const {
    if (!reader_.meanings().is_memory(name)) return false;
    const bool loop_begins = raw >= counterexample_.steps.size() && !run_.loop_start;
    if (loop_begins) return false;
    return event.component.empty() || run_.steps.empty() || run_.steps.back().event.component == event.component;
}

void Interpreter::complete_last(bool shown, std::vector<Machine> machines) {
    if (run_.steps.empty()) {
        if (shown) ++before_first_;
        run_.initial = std::move(machines);
        return;
    }
    Step& last = run_.steps.back();
    if (shown) ++last.count;
    last.changes = collect_changes(run_.steps.size() - 1, machines);
    last.machines = std::move(machines);
}

/// Reads the run from the components that move. Returns false if the states of the run are not terms.
bool Interpreter::read_apart() {
    const auto behaviour = context_.session.behaviour(counterexample_, false);
    if (!behaviour) return false;
    const Timeline line = timeline_of(*behaviour, counterexample_.steps.size() + counterexample_.loop.size());
    tell_copies_apart(line);
    run_.initial = machines_at(line.initial);
    const std::vector<std::optional<TermId>>* before = &line.initial;
    for (const Moment& moment : line.moments) {
        const bool none = counterexample_.steps.empty() && counterexample_.loop.empty();
        if (none) break;
        const std::vector<ComponentStep> moves = moves_of(moment, *before);
        auto [event, with] = happening_at(moment, moves);
        if (!moves.empty() && belongs_to_last(moment.raw, moves.front().name, event))
            complete_last(moment.shown, machines_at(moment.leaves));
        else
            add_step(moment.raw, moment.shown, std::move(event), std::move(with), machines_at(moment.leaves));
        before = &moment.leaves;
    }
    return true;
}

/// Returns the machines of a state, which are read from its text. If the state has as many definitions as any state of
/// the run, they are in the order of the copies. Otherwise some copy has no definition, and the definitions cannot be
/// assigned to copies.
std::vector<Machine> Interpreter::machines_described(const std::string& state) {
    const std::vector<Call> calls = reader_.meanings().calls_in(state);
    const std::uint32_t copies = context_.provenance.copies ? context_.provenance.copies->count : 1;
    if (copies == 1 || calls.size() != described_ || calls.size() % copies != 0) return reader_.machines_of({calls});
    std::vector<Machine> result;
    const auto calls_per_copy = static_cast<std::ptrdiff_t>(calls.size() / copies);
    for (std::uint32_t copy = 0; copy < copies; ++copy) {
        const auto begin = calls.begin() + copy * calls_per_copy;
        for (Machine& machine : reader_.machines_of({std::vector<Call>(begin, begin + calls_per_copy)})) {
            machine.component = copies_.name_with_copy(machine.component, copy);
            result.push_back(std::move(machine));
        }
    }
    return result;
}

void Interpreter::read_whole() {
    for (const std::vector<refine::Step>* steps : {&counterexample_.steps, &counterexample_.loop})
        for (const refine::Step& step : *steps)
            described_ = std::max(described_, reader_.meanings().calls_in(step.state).size());
    run_.initial = machines_described(counterexample_.initial);
    for (std::size_t raw = 0; raw < counterexample_.steps.size() + counterexample_.loop.size(); ++raw) {
        const refine::Step& step = raw_step(raw);
        const std::string& name = reader_.name_of(step.event, step.revealed);
        Event event = said_of_copy({reader_.meanings().event_of(name), {}}, name).event;
        std::vector<Machine> machines = machines_described(step.state);
        if (belongs_to_last(raw, name, event))
            complete_last(true, std::move(machines));
        else
            add_step(raw, true, std::move(event), {}, std::move(machines));
    }
}

void Interpreter::add_times() {
    if (!run_.timed) return;
    std::int64_t time = 0;
    for (std::size_t i = 0; i < run_.steps.size(); ++i) {
        if (run_.loop_start == i) run_.time = time;
        run_.steps[i].time = time;
        time += run_.steps[i].units;
    }
    if (!run_.loop_start) run_.time = time;
}

/// Merges consecutive tocks into one step. Tocks of the loop are not merged with tocks before the loop.
void Interpreter::fold_tocks() {
    std::vector<Step> folded;
    std::optional<std::size_t> loop_start;
    for (std::size_t i = 0; i < run_.steps.size(); ++i) {
        Step& step = run_.steps[i];
        const bool loop_begins = run_.loop_start == i;
        if (loop_begins) loop_start = folded.size();
        Step* const last = folded.empty() ? nullptr : &folded.back();
        const bool goes_on = !loop_begins && last != nullptr && last->event.kind == Kind::tock &&
                             step.event.kind == Kind::tock && last->raw + last->count == step.raw &&
                             last->hidden == step.hidden && last->changes.empty();
        if (!goes_on) {
            folded.push_back(std::move(step));
            continue;
        }
        last->units += step.units;
        last->count += step.count;
        last->machines = std::move(step.machines);
        last->changes = std::move(step.changes);
        for (Event& offered : step.offered)
            if (!is_among(last->offered, offered)) last->offered.push_back(std::move(offered));
        last->more_offered = std::max(last->more_offered, step.more_offered);
    }
    for (Step& step : folded)
        if (step.event.kind == Kind::tock)
            step.event.text = step.units == 1 ? "1 time unit passes" : fmt::format("{} time units pass", step.units);
    run_.steps = std::move(folded);
    run_.loop_start = loop_start;
}

// ---------------------------------------------------------------- offers

/// Returns the transitions of a term, or an empty list if definitions cannot be evaluated. An evaluation error is
/// ignored here, because alternatives are not part of the verdict.
std::vector<process::Transition> Interpreter::transitions_at(TermId term) const {
    try {
        return context_.session.transitions(term);
    } catch (const cspm::EvaluationError&) {
    }
    return {};
}

/// Returns the event of a step that was not taken.
Event Interpreter::event_of_offer(TermId term, const process::Transition& step) {
    const std::string& whole = reader_.name_of(step.event, step.revealed);
    Happening result = reader_.happening_of(term, step);
    const auto copy = copies_.of_event(whole);
    if (!copy) return result.event;
    if (result.event.component.empty()) return said_of_copy(std::move(result), whole).event;
    result.event.component = copies_.name_with_copy(result.event.component, copy);
    return result.event;
}

/// Adds the other steps that were possible before this step. They are computed only once for each state.
void Interpreter::add_offers(std::size_t raw, Step& step) {
    const TermId term = term_before(raw);
    const auto [found, added] = offers_.try_emplace(term);
    if (added)
        for (const process::Transition& transition : transitions_at(term)) {
            if (++looked_at_ > most_looked_at) break;
            if (reader_.meanings().is_memory(reader_.name_of(transition.event, transition.revealed))) continue;
            found->second.emplace_back(transition, event_of_offer(term, transition));
        }
    const refine::Step& taken = raw_step(raw);
    for (const auto& [transition, event] : found->second) {
        const bool this_one = transition.event == taken.event && transition.revealed == taken.revealed;
        if (this_one || same_event(event, step.event) || is_among(step.offered, event)) continue;
        if (step.offered.size() < most_offers)
            step.offered.push_back(event);
        else
            ++step.more_offered;
    }
}

void Interpreter::add_offers() {
    if (counterexample_.terms.empty()) return;
    for (Step& step : run_.steps)
        if (step.count > 0) add_offers(step.raw, step);
}

std::vector<Event> Interpreter::events_of_set(const process::EventSet& set) const {
    std::vector<Event> result;
    for (const process::Event event : set) result.push_back(reader_.meanings().event_of(name(event)));
    return result;
}

std::vector<Event> Interpreter::offered_at_the_end() {
    // The state after a forbidden event was not explored.
    if (counterexample_.terms.empty() || counterexample_.kind == ViolationKind::trace || run_.loop_start)
        return events_of_set(counterexample_.offered);
    std::vector<Event> result;
    for (const process::Transition& transition : transitions_at(counterexample_.terms.back())) {
        if (transition.event == process::tau || ++looked_at_ > most_looked_at) continue;
        Event event = event_of_offer(counterexample_.terms.back(), transition);
        if (!is_among(result, event)) result.push_back(std::move(event));
    }
    return result;
}

// ---------------------------------------------------------------- the end

const std::vector<Machine>& Interpreter::last_machines() const {
    const std::size_t end = run_.loop_start.value_or(run_.steps.size());
    return end == 0 ? run_.initial : run_.steps[end - 1].machines;
}

/// Returns true if time passes in the loop. Only the check for timed deadlocks finds such loops.
bool Interpreter::time_passes_in_loop() const {
    return run_.loop_start &&
           std::any_of(run_.steps.begin() + static_cast<std::ptrdiff_t>(*run_.loop_start), run_.steps.end(),
                       [](const Step& step) { return step.event.kind == Kind::tock; });
}

EndKind Interpreter::end_kind() const {
    switch (obligation_.kind) {
        case ir::PropertyKind::reachable:
            return EndKind::reached;
        case ir::PropertyKind::deadlock_free:
            if (time_passes_in_loop()) return EndKind::deadlock;
            break;
        case ir::PropertyKind::timelock_free:
            return EndKind::timelock;
        case ir::PropertyKind::terminates:
            if (obligation_.negated) return EndKind::terminated;
            break;
        case ir::PropertyKind::clock_initialised:
            return obligation_.one_suffices ? EndKind::clock_initialised : EndKind::clock_not_initialised;
        case ir::PropertyKind::event_missed:
            return EndKind::missed;
        case ir::PropertyKind::divergence_free:
        case ir::PropertyKind::deterministic:
        case ir::PropertyKind::refines:
        case ir::PropertyKind::equals:
        case ir::PropertyKind::conforms:
        case ir::PropertyKind::schedulable:
            break;
    }
    switch (counterexample_.kind) {
        case ViolationKind::trace:
            return EndKind::forbidden;
        case ViolationKind::refusal:
            return EndKind::refusal;
        case ViolationKind::divergence:
            return EndKind::divergence;
        case ViolationKind::deadlock:
            return EndKind::deadlock;
        case ViolationKind::nondeterminism:
            return EndKind::nondeterminism;
        case ViolationKind::no_return:
            return EndKind::no_return;
        case ViolationKind::no_trace:
            break;
    }
    return EndKind::no_trace;
}

/// Returns true if a composition makes writes visible, and false for a separate machine (semantics 3.10).
bool Interpreter::writes_are_urgent() const {
    const std::vector<Machine>& machines = last_machines();
    return std::ranges::any_of(counterexample_.offered, [&](process::Event offered) {
        const Event event = reader_.meanings().event_of(name(offered));
        return event.kind == Kind::assignment && std::ranges::none_of(machines, [&](const Machine& machine) {
                   return machine.component == event.component;
               });
    });
}

std::vector<Cause> Interpreter::collect_causes() const {
    std::vector<Cause> result;
    for (const Machine& machine : last_machines())
        for (const Variable& variable : machine.variables)
            if (!variable.deadline.empty() && variable.value &&
                (*variable.value == "0" || variable.value->starts_with("-")))
                result.push_back({fmt::format("the deadline of {} has run out", variable.deadline), machine.component,
                                  variable.place});
    for (const Event& offered : run_.end.offered)
        if (offered.kind == Kind::call || (offered.kind == Kind::assignment && writes_are_urgent()))
            result.push_back({fmt::format("{} waits for the environment, which may refuse it", offered.text),
                              offered.component, offered.place});
    const bool ended = std::ranges::find(counterexample_.offered, process::tick) != counterexample_.offered.end();
    if (result.empty() && ended) result.push_back({"it has terminated", "", std::nullopt});
    return result;
}

std::string list_events(const std::vector<Event>& events) {
    constexpr std::size_t shown = 12;
    std::vector<std::string> texts;
    for (const Event& event : events) {
        if (texts.size() == shown) break;
        texts.push_back(event.kind == Kind::tock ? "that time passes" : event.text);
    }
    if (events.size() > shown) texts.push_back(fmt::format("{} more", events.size() - shown));
    return texts.empty() ? "nothing" : fmt::format("{}", fmt::join(texts, ", "));
}

/// Returns the text of the other run, up to the event that this run refuses. Returns "" if that run is not known in
/// terms of the model.
std::string Interpreter::accepting_run() const {
    if (counterexample_.accepting_terms.empty()) return "";
    refine::Counterexample other;
    other.kind = refine::ViolationKind::no_trace;
    other.steps = counterexample_.accepting;
    other.initial = counterexample_.accepting_initial;
    other.terms = counterexample_.accepting_terms;
    const Run run = Interpreter(context_, obligation_, other).run();
    constexpr std::size_t shown = 20;
    std::vector<std::string> steps;
    for (const Step& step : run.steps) {
        if (step.event.kind == Kind::tock)
            steps.push_back(fmt::format("{} time unit{}", step.units, step.units == 1 ? "" : "s"));
        else if (is_news(step))
            steps.push_back(text_of(step.event, step.with));
    }
    const std::size_t more = steps.size() > shown ? steps.size() - shown : 0;
    steps.erase(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(more));
    return fmt::format("; it is accepted in the run {}{}", more > 0 ? "..., " : "", fmt::join(steps, ", "));
}

std::string Interpreter::explain_end() const {
    const End& end = run_.end;
    switch (end.kind) {
        case EndKind::forbidden:
            if (context_.provenance.copies && !obligation_.reason.empty()) return obligation_.reason;
            if (end.event && end.event->kind == Kind::tock)
                return fmt::format("the last time unit is not allowed to pass; allowed: {}", list_events(end.allowed));
            return fmt::format("{} is not allowed here; allowed: {}", end.event ? end.event->text : "the last step",
                               list_events(end.allowed));
        case EndKind::timelock:
        case EndKind::refusal: {
            std::vector<std::string> reasons;
            for (const Cause& cause : end.causes)
                reasons.push_back(cause.place
                                      ? fmt::format("{} ({}:{})", cause.text, cause.place->file, cause.place->line)
                                      : cause.text);
            if (!reasons.empty()) return fmt::format("time cannot pass: {}", fmt::join(reasons, ", and "));
            if (end.required.empty())
                return fmt::format(
                    "it comes to rest, offering {}; the specification has no stable state after these events, since "
                    "its "
                    "internal steps never end, and so allows none",
                    list_events(end.offered));
            std::vector<std::string> alternatives;
            for (const auto& required : end.required) {
                std::string events = list_events(required);
                if (required.size() == 2) events = fmt::format("both of {}", events);
                if (required.size() > 2) events = fmt::format("all of {}", events);
                alternatives.push_back(std::move(events));
            }
            return fmt::format("it offers {}, and must offer at least {}", list_events(end.offered),
                               fmt::join(alternatives, ", or "));
        }
        case EndKind::divergence:
            return "it can go on internally for ever without offering anything";
        case EndKind::deadlock:
            return run_.loop_start ? "nothing is possible any more but that time passes"
                                   : "nothing is possible any more";
        case EndKind::nondeterminism:
            return fmt::format("{} may be accepted and may be refused after the same events; here it is refused{}",
                               end.event ? end.event->text : "an event", accepting_run());
        case EndKind::reached:
            return "the state has been reached";
        case EndKind::terminated:
            return "it has terminated";
        case EndKind::clock_not_initialised:
            return "the clock is read before its first reset";
        case EndKind::clock_initialised:
        case EndKind::missed:
            return obligation_.reason;
        case EndKind::no_return:
            return obligation_.reason;
        case EndKind::no_trace:
            return "the trace cannot go on";
        case EndKind::undefined:
            break;  // find_failing_run() sets this end
    }
    return "";
}

/// Returns the events that some alternative requires but that are not offered.
std::vector<Event> Interpreter::missing_events() const {
    std::vector<Event> result;
    for (const process::EventSet& set : counterexample_.required)
        for (const process::Event event : set) {
            if (std::ranges::find(counterexample_.offered, event) != counterexample_.offered.end()) continue;
            Event missing = reader_.meanings().event_of(name(event));
            if (!is_among(result, missing)) result.push_back(std::move(missing));
        }
    return result;
}

void Interpreter::read_end() {
    End& end = run_.end;
    end.kind = end_kind();
    end.offered = offered_at_the_end();
    // Steps inside a compressed process after the last event do not cause the violation, so they are skipped.
    const auto last =
        std::find_if(run_.steps.rbegin(), run_.steps.rend(), [](const Step& step) { return step.count > 0; });
    if (counterexample_.kind == ViolationKind::trace && last != run_.steps.rend()) end.event = last->event;
    if (counterexample_.kind == ViolationKind::nondeterminism && counterexample_.event)
        end.event = reader_.meanings().event_of(name(*counterexample_.event));
    if (counterexample_.kind == ViolationKind::trace && !counterexample_.required.empty())
        end.allowed = events_of_set(counterexample_.required.front());
    if (counterexample_.kind == ViolationKind::refusal) {
        for (const process::EventSet& set : counterexample_.required) end.required.push_back(events_of_set(set));
        end.refused = missing_events();
    }
    if (end.kind == EndKind::timelock) end.causes = collect_causes();
    end.why = explain_end();
}

void Interpreter::read_raw() {
    run_.raw_loop = counterexample_.loop.size();
    for (std::size_t raw = 0; raw < counterexample_.steps.size() + counterexample_.loop.size(); ++raw) {
        const refine::Step& step = raw_step(raw);
        const bool hidden = step.event == process::tau && step.revealed != process::tau;
        run_.raw.push_back(hidden ? fmt::format("τ({})", name(step.revealed)) : name(step.event));
    }
}

Run Interpreter::run() {
    run_.timed = obligation_.time == csp_emit::Time::timed;
    run_.unit = context_.unit;
    read_raw();
    if (!read_apart()) read_whole();
    add_offers();
    add_times();
    fold_tocks();
    read_end();
    name_watched();
    return std::move(run_);
}

/// Reports a run of a watched copy of a machine as a run of the machine.
void Interpreter::name_watched() {
    const bool watches =
        obligation_.kind == ir::PropertyKind::event_missed || obligation_.kind == ir::PropertyKind::clock_initialised;
    if (!watches || run_.initial.empty()) return;
    const std::string copy = run_.initial.front().component;
    const std::string& title = obligation_.component;  // "state machine P::S"
    const std::string watched = obligation_.property == ir::no_id
                                    ? title.substr(title.rfind(' ') + 1)
                                    : ir::qualified_name(context_.system.properties[obligation_.property].subject);
    const auto rename = [&](std::string& component) {
        if (component == copy || component.starts_with(copy + "::")) component.replace(0, copy.size(), watched);
    };
    for (Machine& machine : run_.initial) rename(machine.component);
    for (Step& step : run_.steps) {
        rename(step.event.component);
        for (Event& event : step.with) rename(event.component);
        for (Event& event : step.offered) rename(event.component);
        for (Change& change : step.changes) rename(change.component);
        for (Machine& machine : step.machines) rename(machine.component);
    }
    for (Event& event : run_.end.offered) rename(event.component);
    for (Cause& cause : run_.end.causes) rename(cause.component);
    if (run_.end.event) rename(run_.end.event->component);
}

}  // namespace

Run interpret_counterexample(const Context& context, const csp_emit::Obligation& obligation,
                             const refine::Counterexample& counterexample) {
    return Interpreter(context, obligation, counterexample).run();
}

}  // namespace robochart::runs
