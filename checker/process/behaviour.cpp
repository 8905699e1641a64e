// SPDX-License-Identifier: Apache-2.0
// Divides the run of a part of a process into segments. During a segment, either a sequential component runs, or an
// operator remains while its operands move. A segment ends when the operator is resolved and an operand continues that
// had not run before.
#include "checker/process/behaviour.hpp"

#include <algorithm>
#include <cassert>
#include <optional>
#include <set>
#include <span>

#include "checker/process/derivation.hpp"
#include "checker/process/operators.hpp"

namespace robochart::process {
namespace {

constexpr std::size_t most_parts = 500;
constexpr std::size_t most_entries = 10'000'000;  // total size of all traces
constexpr int deepest_parts = 100;
constexpr int deepest_look = 50;
constexpr std::size_t shown_events = 3;
constexpr std::size_t most_looked_at = 200'000;  // total number of searched states of compressed operands

struct Step {
    std::size_t index;  ///< index in the whole run
    Transition transition;
};
using Steps = std::vector<Step>;

/// The work spent so far on one run and on the separate runs of its compressed operands.
struct Work {
    std::size_t looked_at = 0;
    std::size_t parts = 0;
};

/// Searches for a shortest run with these events. If `end` is stable, the run must end in a stable state with the same
/// offer. The search is breadth-first over pairs of a term and the number of events performed. Returns no value if it
/// reaches the work limit.
std::optional<std::vector<Transition>> run_inside(OperationalSemantics& semantics, TermId from,
                                                  const std::vector<Event>& events, const Behaviour& end, Work& work) {
    struct Node {
        TermId term;
        std::size_t done;
        std::size_t before;
        Transition step;
    };
    std::vector<Node> nodes{{from, 0, 0, {}}};
    std::set<std::pair<std::size_t, TermId>> known{{0, from}};
    const auto ends = [&](std::span<const Transition> steps) {
        EventSet offered;
        for (const Transition& transition : steps) {
            if (transition.event == tau && end.stable) return false;
            if (offered.empty() || offered.back() != transition.event) offered.push_back(transition.event);
        }
        return !end.stable || offered == end.offered;
    };
    for (std::size_t at = 0; at < nodes.size() && work.looked_at < most_looked_at; ++at) {
        ++work.looked_at;
        const Node node = nodes[at];
        const std::span<const Transition> steps = semantics.successors(node.term);
        if (node.done == events.size() && ends(steps)) {
            std::vector<Transition> run;
            for (std::size_t i = at; i != 0; i = nodes[i].before) run.push_back(nodes[i].step);
            std::ranges::reverse(run);
            return run;
        }
        for (const Transition& step : steps) {
            const bool visible = step.event != tau;
            if (visible && (node.done == events.size() || step.event != events[node.done])) continue;
            const std::size_t done = node.done + (visible ? 1 : 0);
            if (known.emplace(done, step.target).second) nodes.push_back({step.target, done, at, step});
        }
    }
    return std::nullopt;
}

class Splitter {
public:
    Splitter(OperationalSemantics& semantics, std::size_t length, Work& work, bool offers)
        : semantics_(semantics),
          terms_(semantics.terms()),
          length_(length),
          offers_(offers),
          work_(work),
          most_parts_(std::min(most_parts, most_entries / (length + 1))) {}

    Behaviour split_run(TermId initial, const Steps& steps, int depth);
    void add_moves(TermId term, const Transition& step, int depth, std::vector<Move>& result);

private:
    struct Segment {
        Behaviour behaviour;
        TermId end;
        std::size_t next;      ///< the step after the segment
        bool goes_on = false;  ///< whether another, possibly empty, segment follows
    };

    Behaviour begin(TermId initial) {
        ++work_.parts;
        Behaviour result;
        result.name = describe(terms_, initial);
        result.trace.assign(length_, no_event);
        result.revealed.assign(length_, no_event);
        result.initial = initial;
        result.reached.assign(length_, initial);
        return result;
    }
    static void record_step(Behaviour& behaviour, const Step& step) {
        assert(step.index < behaviour.trace.size());
        behaviour.trace[step.index] = step.transition.event;
        behaviour.revealed[step.index] = step.transition.revealed;
        behaviour.reached[step.index] = step.transition.target;
    }
    void end(Behaviour& behaviour, TermId last) {
        behaviour.offered.clear();
        behaviour.state = describe(terms_, last);
        if (offers_) add_offer(behaviour, last);
    }
    void add_offer(Behaviour& behaviour, TermId last) {
        for (const Transition& transition : semantics_.successors(last)) {
            if (transition.event == tau) behaviour.stable = false;
            if (transition.event != tau && (behaviour.offered.empty() || behaviour.offered.back() != transition.event))
                behaviour.offered.push_back(transition.event);
        }
    }
    TermId unfold_term(TermId term) { return terms_.unfold_calls(term, deepest_look); }
    static std::size_t running(const Term& term) { return running_operands(term.op, term.children.size()); }
    bool worth_taking_apart(TermId term, int look = 0);
    Segment component(TermId from, const Steps& steps, std::size_t next, int depth);
    Segment operation(TermId from, const Steps& steps, std::size_t next, int depth);
    Segment compression(TermId from, const Steps& steps, std::size_t next, int depth);
    std::string notation_of(const Term& term);
    std::string notation_of(SetId set);

    OperationalSemantics& semantics_;
    TermStore& terms_;
    std::size_t length_;
    bool offers_;
    Work& work_;
    std::size_t most_parts_;
};

/// Returns false for operators that are only above sequential processes (choices, sequences). They are shown as part of
/// the component.
bool Splitter::worth_taking_apart(TermId id, int look) {
    if (look > deepest_look) return false;
    const Term term = terms_[unfold_term(id)];
    switch (properties_of(term.op).group) {
        case OpGroup::parallel:
            return term.children.size() > 1;
        case OpGroup::unary:
        case OpGroup::synchronising:
            return true;
        case OpGroup::compression:
            return term.op == Op::compress;
        case OpGroup::resolving:
            return std::any_of(term.children.begin(),
                               term.children.begin() + static_cast<std::ptrdiff_t>(running(term)),
                               [&](TermId child) { return worth_taking_apart(child, look + 1); });
        case OpGroup::leaf:
        case OpGroup::prefix:
        case OpGroup::internal_choice:
            break;
    }
    return false;
}

Splitter::Segment Splitter::component(TermId from, const Steps& steps, std::size_t next, int depth) {
    Segment segment{begin(from), from, next, false};
    const bool to_the_end = depth > deepest_parts || work_.parts > most_parts_;
    while (segment.next < steps.size()) {
        record_step(segment.behaviour, steps[segment.next]);
        segment.end = steps[segment.next++].transition.target;
        const bool known = offers_ || segment.next < steps.size();
        segment.goes_on = known && !to_the_end && worth_taking_apart(segment.end);
        if (segment.goes_on) break;
    }
    return segment;
}

/// Splits the run of the machine that a compression has computed for its operand. A separate run of the operand with
/// the same events is reported, too.
Splitter::Segment Splitter::compression(TermId from, const Steps& steps, std::size_t next, int depth) {
    Segment segment{begin(from), from, next, false};
    const Term term = terms_[unfold_term(from)];
    std::vector<Event> events;
    std::vector<std::size_t> shown;
    for (; segment.next < steps.size(); ++segment.next) {
        const Step& step = steps[segment.next];
        record_step(segment.behaviour, step);
        segment.end = step.transition.target;
        if (step.transition.event != tau) events.push_back(step.transition.event);
        if (step.transition.event != tau) shown.push_back(step.index);
    }
    add_offer(segment.behaviour, segment.end);  // a machine's transitions are already known, so this takes little work
    const TermId operand = term.children.front();
    const auto inside = run_inside(semantics_, operand, events, segment.behaviour, work_);
    if (!inside) return segment;
    segment.behaviour.op = name_of(Compression{term.payload});
    Steps own;
    for (const Transition& transition : *inside) own.push_back({own.size(), transition});
    Behaviour within = Splitter(semantics_, own.size(), work_, offers_).split_run(operand, own, depth + 1);
    const std::size_t last = length_ == 0 ? 0 : length_ - 1;
    for (std::size_t i = 0, done = 0; i < inside->size(); ++i) {
        within.shown_by.push_back(done < shown.size() ? shown[done] : last);
        if ((*inside)[i].event != tau) ++done;
    }
    within.own_run = true;
    segment.behaviour.parts.push_back(std::move(within));
    return segment;
}

Splitter::Segment Splitter::operation(TermId from, const Steps& steps, std::size_t next, int depth) {
    Segment segment{begin(from), from, next, false};
    TermId now = unfold_term(from);
    const Term term = terms_[now];
    if (term.op == Op::compress) return compression(from, steps, next, depth);
    segment.behaviour.op = notation_of(term);
    std::vector<Steps> moved(term.children.size());
    std::optional<std::size_t> survivor;
    bool handed_over = false;
    while (segment.next < steps.size() && !survivor && !handed_over) {
        const Step& step = steps[segment.next];
        const std::optional<Derivation> derived = derivation(semantics_, now, step.transition);
        record_step(segment.behaviour, step);
        segment.end = now = step.transition.target;
        ++segment.next;
        if (!derived) {
            handed_over = true;
            break;
        }
        for (const auto& [operand, transition] : derived->moves) moved[operand].push_back({step.index, transition});
        handed_over = derived->starts;
        if (!derived->starts) survivor = derived->survivor;
    }
    const std::size_t resolved = segment.next == next ? 0 : steps[segment.next - 1].index + 1;
    if (survivor)
        for (; segment.next < steps.size(); ++segment.next) {
            record_step(segment.behaviour, steps[segment.next]);
            moved[*survivor].push_back(steps[segment.next]);
            segment.end = steps[segment.next].transition.target;
        }
    for (std::size_t i = 0; i < running(term); ++i) {
        Behaviour operand = split_run(term.children[i], moved[i], depth + 1);
        operand.left = handed_over || (survivor && *survivor != i);
        if (operand.left) operand.ends = resolved;
        segment.behaviour.parts.push_back(std::move(operand));
    }
    segment.goes_on = handed_over;
    return segment;
}

void Splitter::add_moves(TermId term, const Transition& step, int depth, std::vector<Move>& result) {
    const TermId now = unfold_term(term);
    const bool apart = depth <= deepest_parts && terms_[now].op != Op::compress && worth_taking_apart(now);
    const auto derived = apart ? derivation(semantics_, now, step) : std::nullopt;
    if (!derived) {
        result.push_back({term, step});
        return;
    }
    for (const auto& [operand, transition] : derived->moves)
        add_moves(Term(terms_[now]).children[operand], transition, depth + 1, result);
}

Behaviour Splitter::split_run(TermId initial, const Steps& steps, int depth) {
    std::vector<Segment> segments;
    TermId now = initial;
    std::size_t next = 0;
    for (bool more = true; more;) {
        const std::size_t begins = next == 0 ? 0 : steps[next - 1].index + 1;
        const bool apart = depth <= deepest_parts && work_.parts <= most_parts_ && worth_taking_apart(now);
        segments.push_back(apart ? operation(now, steps, next, depth) : component(now, steps, next, depth));
        now = segments.back().end;
        next = segments.back().next;
        more = segments.back().goes_on;
        end(segments.back().behaviour, now);
        segments.back().behaviour.left = more;
        segments.back().behaviour.begins = begins;
        if (more && next > 0) segments.back().behaviour.ends = steps[next - 1].index + 1;
    }
    if (segments.size() == 1) return std::move(segments.front().behaviour);
    Behaviour whole = begin(initial);
    whole.op = "then";
    for (const Step& step : steps) record_step(whole, step);
    end(whole, now);
    for (Segment& segment : segments) whole.parts.push_back(std::move(segment.behaviour));
    return whole;
}

std::string Splitter::notation_of(SetId set) {
    std::string text;
    const EventSet& events = terms_[set];
    for (std::size_t i = 0; i < events.size() && i < shown_events; ++i)
        text += (i > 0 ? ", " : "") + terms_.events().name(events[i]);
    if (events.size() > shown_events) text += ", …";
    return "{" + text + "}";
}

std::string Splitter::notation_of(const Term& term) {
    switch (term.op) {
        case Op::parallel: {
            const EventSet& set = terms_[SetId{term.payload}];
            return set.empty() ? "|||" : "[|" + notation_of(SetId{term.payload}) + "|]";
        }
        case Op::alphabetised:
            return "[…||…]";
        case Op::external_choice:
            return "[]";
        case Op::sequential:
            return ";";
        case Op::interrupt:
            return "/\\";
        case Op::sliding:
            return "[>";
        case Op::exception:
            return "[|" + notation_of(SetId{term.payload}) + "|>";
        case Op::sync_choice:
            return "[+" + notation_of(SetId{term.payload}) + "+]";
        case Op::sync_interrupt:
            return "/+" + notation_of(SetId{term.payload}) + "+\\";
        case Op::hide:
            return "\\ " + notation_of(SetId{term.payload});
        case Op::rename:
            return "[[…]]";
        case Op::prioritise:
        case Op::prioritise_order:
            return "prioritise";
        case Op::stop:
        case Op::skip:
        case Op::div:
        case Op::omega:
        case Op::run:
        case Op::chaos:
        case Op::call:
        case Op::prefix:
        case Op::internal_choice:
        case Op::chase:
        case Op::compress:
        case Op::machine:
        case Op::chaos_offer:
            break;
    }
    return "";
}

}  // namespace

Behaviour behaviour(OperationalSemantics& semantics, TermId initial, const std::vector<Transition>& run, bool offers) {
    Steps steps;
    for (const Transition& transition : run) steps.push_back({steps.size(), transition});
    Work work;
    return Splitter(semantics, run.size(), work, offers).split_run(initial, steps, 0);
}

std::vector<Move> split_transition(OperationalSemantics& semantics, TermId term, const Transition& step) {
    Work work;
    std::vector<Move> result;
    Splitter(semantics, 1, work, false).add_moves(term, step, 0, result);
    return result;
}

}  // namespace robochart::process
