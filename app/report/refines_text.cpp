// SPDX-License-Identifier: Apache-2.0
// Prints assertions of scripts as text: in the format of FDR's `refines`, and in our own format.
#include <fmt/format.h>

#include <algorithm>

#include "app/command/findings.hpp"
#include "app/report/script_report.hpp"
#include "driver/claims/certificates.hpp"

namespace robochart::app {
namespace {

using process::Behaviour;
using process::Event;
using refine::ViolationKind;

/// A counterexample that is split into more parts than this is shown without its parts, unless `--split` is given.
constexpr std::size_t few_parts = 16;

class Names {
public:
    Names(const process::EventTable& events, bool reveal) : events_(events), reveal_(reveal) {}

    [[nodiscard]] std::string event_text(Event event) const { return events_.name(event); }
    [[nodiscard]] std::string event_text(Event event, Event revealed) const {
        const bool hidden =
            reveal_ && event == process::tau && revealed != process::tau && revealed != process::no_event;
        return hidden ? fmt::format("τ({})", events_.name(revealed)) : events_.name(event);
    }
    [[nodiscard]] std::string set_text(const process::EventSet& events) const {
        std::vector<std::string> names;
        for (const Event event : events) names.push_back(event_text(event));
        return fmt::format("{{{}}}", fmt::join(names, ", "));
    }
    [[nodiscard]] std::string run_text(const std::vector<refine::Step>& steps) const {
        std::vector<std::string> names;
        for (const refine::Step& step : steps) names.push_back(event_text(step.event, step.revealed));
        return fmt::format("<{}>", fmt::join(names, ", "));
    }
    [[nodiscard]] std::string run_text(const Behaviour& part) const {
        std::vector<std::string> names;
        for (std::size_t i = 0; i < part.trace.size(); ++i)
            if (part.trace[i] != process::no_event) names.push_back(event_text(part.trace[i], part.revealed[i]));
        return fmt::format("<{}>", fmt::join(names, ", "));
    }

private:
    const process::EventTable& events_;
    bool reveal_;
};

std::string sets_text(const Names& names, const std::vector<process::EventSet>& list) {
    std::vector<std::string> shown;
    for (const process::EventSet& event_set : list) shown.push_back(names.set_text(event_set));
    return fmt::format("{}", fmt::join(shown, " "));
}

std::string not_allowed(const refine::Counterexample& c, const Names& names, const std::string& event) {
    const bool ends = std::ranges::all_of(c.required, [](const auto& event_set) { return event_set.empty(); });
    if (ends) return fmt::format("where the specification allows no event, so not {}", event);
    return fmt::format("where the specification does not allow {}, only {}", event, sets_text(names, c.required));
}

/// Describes a refusal. If the specification has no stable state after the trace, it has no failures for this trace in
/// the failures model. It then allows no stable state of the implementation.
std::string refusal(const refine::Counterexample& c, const Names& names) {
    if (c.required.empty())
        return fmt::format(
            "then is stable and offers {}; the specification has no stable state after this trace (its taus never "
            "end), so it allows none",
            names.set_text(c.offered));
    return fmt::format("then offers {}; the specification requires one of: {}", names.set_text(c.offered),
                       sets_text(names, c.required));
}

/// Describes the run that refuses the event and, if it is known, the run that accepts the event.
std::string nondeterminism_text(const refine::Counterexample& c, const Names& names, const std::string& event) {
    std::string out = fmt::format("then refuses {}: the state offers {}", event, names.set_text(c.offered));
    if (c.accepting.empty()) return out + fmt::format("; after the same events it can also accept {}", event);
    const std::vector<refine::Step> before(c.accepting.begin(), c.accepting.end() - 1);
    return out + fmt::format("\n                 and accepts {} after {}", event, names.run_text(before));
}

/// Describes the offending event after the trace, with the events that the specification allows.
std::string offence_text(const refine::Counterexample& c, const Names& names) {
    const std::string event = c.event ? names.event_text(*c.event) : "";
    switch (c.kind) {
        case ViolationKind::trace:
            return not_allowed(c, names, event);
        case ViolationKind::refusal:
            return refusal(c, names);
        case ViolationKind::divergence:
            return fmt::format("then diverges by {} for ever", names.run_text(c.loop));
        case ViolationKind::deadlock:
            return "then can do nothing";
        case ViolationKind::nondeterminism:
            return nondeterminism_text(c, names, event);
        case ViolationKind::no_return:
            return "then can never again do what is asked for";
        case ViolationKind::no_trace:
            return fmt::format("then cannot perform {}", event);
    }
    return "";
}

std::size_t count_parts(const Behaviour& part) {
    std::size_t parts = 1;
    for (const Behaviour& child : part.parts) parts += count_parts(child);
    return parts;
}

void write_part(const Behaviour& part, std::size_t indent, const Names& names, std::string& out) {
    const std::string title = part.op.empty() ? part.name : part.op;
    out += fmt::format("{:{}}{}  {}", "", indent, title, names.run_text(part));
    if (part.left) {
        out += ", then left";
    } else if (part.parts.empty()) {
        out += fmt::format(", now {}{} offering {}", part.state, part.stable ? "" : " (unstable)",
                           names.set_text(part.offered));
    }
    out += '\n';
    for (const Behaviour& child : part.parts) write_part(child, indent + 2, names, out);
}

std::string split_text(const ScriptAssertion& a, std::size_t indent, const Names& names, const Options& options) {
    if (!a.behaviour || a.behaviour->parts.empty()) return "";
    const std::size_t parts = count_parts(*a.behaviour);
    if (parts > few_parts && !options.script.split)
        return fmt::format("{:{}}{} parts took part; --split shows what each did\n", "", indent, parts);
    std::string out = fmt::format("{:{}}each part did\n", "", indent);
    write_part(*a.behaviour, indent + 2, names, out);
    return out;
}

const char* violation_title(ViolationKind kind) {
    switch (kind) {
        case ViolationKind::trace:
            return "Trace";
        case ViolationKind::refusal:
            return "Failure";
        case ViolationKind::divergence:
            return "Divergence";
        case ViolationKind::deadlock:
            return "Deadlock";
        case ViolationKind::nondeterminism:
            return "Determinism";
        case ViolationKind::no_return:
            return "No return";
        case ViolationKind::no_trace:
            return "Stuck";
    }
    return "";
}

std::string visible_trace(const refine::Counterexample& c, const Names& names) {
    std::vector<std::string> trace;
    for (const refine::Step& step : c.steps)
        if (step.event != process::tau) trace.push_back(names.event_text(step.event));
    if (c.kind == ViolationKind::trace && !trace.empty()) trace.pop_back();
    return fmt::format("<{}>", fmt::join(trace, ", "));
}

std::string plain_counterexample(const ScriptAssertion& a, const Names& names, const Options& options) {
    const refine::Counterexample& c = *a.result.verdict.counterexample;
    std::string out = fmt::format("    Counterexample ({} Counterexample)\n", violation_title(c.kind));
    if (!a.specification.empty())
        out += fmt::format(
            "        Specification Debug:\n            {}:\n                Trace: {}\n                Allowed: {}\n",
            a.specification, visible_trace(c, names),
            c.required.empty() && c.kind == ViolationKind::refusal ? "no stable state" : sets_text(names, c.required));
    std::vector<refine::Step> steps = c.steps;
    if (c.kind == ViolationKind::trace && !steps.empty()) steps.pop_back();
    out += fmt::format("        Implementation Debug:\n            {}:\n                Trace: {}\n", a.process,
                       names.run_text(steps));
    if (c.kind == ViolationKind::divergence)
        out += fmt::format("                Repeating: {}\n", names.run_text(c.loop));
    if (c.event) out += fmt::format("                Error Event: {}\n", names.event_text(*c.event));
    if (!c.accepting.empty()) out += fmt::format("                Accepted: {}\n", names.run_text(c.accepting));
    const bool stops = c.kind == ViolationKind::refusal || c.kind == ViolationKind::deadlock ||
                       c.kind == ViolationKind::nondeterminism;
    if (stops) out += fmt::format("                Min Acceptance: {}\n", names.set_text(c.offered));
    return out + split_text(a, 16, names, options);
}

const char* sentence_of(driver::Answer answer) {
    if (answer == driver::Answer::holds) return "Passed";
    if (answer == driver::Answer::fails) return "Failed";
    return answer == driver::Answer::error ? "Error" : "Inconclusive";
}

}  // namespace

std::string refines_plain(const ScriptAssertion& a, const process::EventTable& events, const Options& options) {
    const Names names(events, options.script.reveal_taus);
    const refine::Statistics& s = a.result.verdict.statistics;
    std::string out;
    if (options.script.brief) {
        out = fmt::format("{}: {}\n", a.text, sentence_of(a.answer));
    } else {
        out = fmt::format(
            "{}:\n    Result: {}\n    Visited States: {}\n    Visited Transitions: {}\n    Visited Plys: {}\n", a.text,
            sentence_of(a.answer), s.states, s.transitions, s.depth);
        if (const std::string_view reason = proof_reason(s.decided_by); !reason.empty())
            out += fmt::format("    Decided By: {}\n", reason);
        if (s.decided_by == refine::DecidedBy::diagrams) out += fmt::format("    Decided By: {}\n", diagrams_text(s));
        if (a.result.verdict.counterexample) out += plain_counterexample(a, names, options);
    }
    if (a.certificate) out += fmt::format("    {}\n", driver::certificate_text(*a.certificate));
    for (const std::string& error : a.errors) out += fmt::format("    {}\n", error);
    return out;
}

std::string counterexample_text(const ScriptAssertion& a, const process::EventTable& events, const Options& options) {
    const Names names(events, options.script.reveal_taus);
    const refine::Counterexample& c = *a.result.verdict.counterexample;
    std::string out = fmt::format("                 trace {}\n", names.run_text(c.steps));
    out += fmt::format("                 {}\n", offence_text(c, names));
    if (!c.replayed_by_terms)
        out += "                 (replayed by the compiled rules alone: its terms are too many)\n";
    if (!c.shortest) out += fmt::format("                 ({})\n", driver::not_shortest);
    return out + split_text(a, 17, names, options);
}

}  // namespace robochart::app
