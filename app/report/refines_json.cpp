// SPDX-License-Identifier: Apache-2.0
// Writes the fields of FDR's `refines --format json`. In this format, event 0 means "no event", 1 is tau and 2 is tick,
// so our event numbers are increased by one. The field names are those of FDR 4.2.7's output. A child's trace has an
// entry for every step of its parent's trace.
#include <algorithm>
#include <array>
#include <optional>

#include "app/report/script_report.hpp"
#include "base/diagnostics/json_values.hpp"

namespace robochart::app {
namespace {

using diagnostics::Json;
using diagnostics::json_array;
using process::Event;
using refine::ViolationKind;

/// Assigns FDR's numbers to events, and remembers which events are shown.
class EventMap {
public:
    std::uint64_t event_number(Event event) {
        if (event == process::no_event) return 0;
        used_.push_back(event);
        return std::uint64_t{event} + 1;
    }
    template <class Events>
    Json event_numbers(const Events& events) {
        return json_array(events, [&](Event event) { return event_number(event); });
    }
    [[nodiscard]] const std::vector<Event>& used_events() const { return used_; }

private:
    std::vector<Event> used_;
};

Json event_map(const std::vector<ScriptAssertion>& assertions) {
    std::map<Event, std::string> names;
    for (const ScriptAssertion& assertion : assertions) names.insert(assertion.events.begin(), assertion.events.end());
    Json map{{"0", "0"}, {"1", "τ"}, {"2", "✓"}};
    for (const auto& [event, name] : names) map[std::to_string(std::uint64_t{event} + 1)] = name;
    return map;
}

const char* counterexample_type(ViolationKind kind) {
    switch (kind) {
        case ViolationKind::trace:
            return "trace";
        case ViolationKind::refusal:
            return "failure";
        case ViolationKind::divergence:
            return "divergence";
        case ViolationKind::deadlock:
            return "deadlock";
        case ViolationKind::nondeterminism:
            return "determinism";
        case ViolationKind::no_return:
            return "no_return";
        case ViolationKind::no_trace:
            return "stuck";
    }
    return "";
}

/// Writes the behaviour of each part at the end of the run. The offending event is separate from the trace; a loop and
/// an acceptance are added to the trace.
class Behaviours {
public:
    Behaviours(const refine::Counterexample& counterexample, EventMap& events, const Options& options)
        : counterexample_(counterexample), events_(events), options_(options) {}

    Json implementation_json(const std::string& name) {
        Json json{{"machine_name", name}, {"type", behaviour_type()}};
        std::vector<Event> trace;
        std::vector<Event> revealed;
        Json states = Json::array({counterexample_.initial});
        const auto append = [&](const std::vector<refine::Step>& steps) {
            for (const refine::Step& step : steps) {
                trace.push_back(step.event);
                revealed.push_back(step.revealed);
                states.push_back(step.state);
            }
        };
        append(counterexample_.steps);
        append(counterexample_.loop);
        if (offence_of_whole()) states.erase(states.size() - 1);
        add_trace(json, trace, revealed, counterexample_.offered, offence_of_whole());
        json["states"] = std::move(states);
        return json;
    }
    /// Writes the run that accepts the event that the counterexample refuses. This event is the last step of the run.
    Json accepting_json(const std::string& name) {
        Json json{{"machine_name", name}, {"type", "trace"}};
        std::vector<Event> trace;
        Json states = Json::array({counterexample_.accepting_initial});
        for (const refine::Step& step : counterexample_.accepting) {
            trace.push_back(step.event);
            states.push_back(step.state);
        }
        json["trace"] = events_.event_numbers(trace);
        json["states"] = std::move(states);
        return json;
    }
    void add_parts(Json& json, const process::Behaviour& whole) { add_children(json, whole, offence_of_whole()); }
    Json specification_json(const std::string& name) {
        std::vector<Event> trace;
        for (const refine::Step& step : counterexample_.steps)
            if (step.event != process::tau) trace.push_back(step.event);
        if (counterexample_.kind == ViolationKind::trace && !trace.empty()) trace.pop_back();
        const auto event_set = [&](const process::EventSet& set) { return events_.event_numbers(set); };
        return {{"machine_name", name},
                {"type", "trace"},
                {"error_event", 0},
                {"trace", events_.event_numbers(trace)},
                {"states", Json::array({name})},
                {"allowed", json_array(counterexample_.required, event_set)}};
    }

private:
    /// The index of the offending event in a trace, if there is one.
    using Offence = std::optional<std::size_t>;

    [[nodiscard]] Offence offence_of_whole() const {
        if (counterexample_.kind != ViolationKind::trace || counterexample_.steps.empty()) return std::nullopt;
        return counterexample_.steps.size() - 1;
    }
    /// Finds the offending event in the trace of a part. A part has an entry for every step of its parent, but a
    /// compressed part has a separate run.
    static Offence offence_of(const process::Behaviour& part, const process::Behaviour& above, Offence offence) {
        if (!part.own_run || !offence) return offence;
        if (*offence >= above.trace.size() || above.trace[*offence] == process::no_event) return std::nullopt;
        const auto visible = [](Event event) { return event != process::tau && event != process::no_event; };
        const auto last = std::find_if(part.trace.rbegin(), part.trace.rend(), visible);
        if (last == part.trace.rend()) return std::nullopt;
        return static_cast<std::size_t>(part.trace.rend() - last) - 1;
    }
    Json part_json(const process::Behaviour& behaviour, Offence offence) {
        Json json{{"machine_name", behaviour.name}, {"type", behaviour_type()}};
        add_trace(json, behaviour.trace, behaviour.revealed, behaviour.offered, offence);
        if (!behaviour.op.empty()) json["operator"] = behaviour.op;
        json["states"] = Json::array({behaviour.name, behaviour.state});
        add_children(json, behaviour, offence);
        return json;
    }
    void add_children(Json& json, const process::Behaviour& behaviour, Offence offence) {
        if (behaviour.parts.empty()) return;
        json["child_behaviours"] = json_array(behaviour.parts, [&](const process::Behaviour& part) {
            return part_json(part, offence_of(part, behaviour, offence));
        });
    }
    [[nodiscard]] const char* behaviour_type() const {
        switch (counterexample_.kind) {
            case ViolationKind::trace:
            case ViolationKind::no_trace:
                return "trace";
            case ViolationKind::divergence:
                return "loop";
            case ViolationKind::refusal:
            case ViolationKind::deadlock:
            case ViolationKind::nondeterminism:
            case ViolationKind::no_return:
                break;
        }
        return "min_acceptance";
    }
    /// Returns the least acceptance. A state that can terminate may always do so, so its least acceptance is {✓}.
    static process::EventSet least_acceptance(const process::EventSet& offered) {
        const bool terminates = !offered.empty() && offered.front() == process::tick;
        return terminates ? process::EventSet{process::tick} : offered;
    }
    void add_trace(Json& json, std::vector<Event> trace, std::vector<Event> revealed, const process::EventSet& offered,
                   Offence offence) {
        if (counterexample_.kind == ViolationKind::trace) {
            const bool has_it = offence && *offence < trace.size();
            json["error_event"] = has_it ? events_.event_number(trace[*offence]) : 0;
            if (has_it) trace.resize(*offence);
            if (has_it) revealed.resize(*offence);
        } else if (counterexample_.kind == ViolationKind::no_trace) {
            json["error_event"] = counterexample_.event ? events_.event_number(*counterexample_.event) : 0;
        } else if (counterexample_.kind == ViolationKind::divergence) {
            json["loop_start"] = std::min(counterexample_.steps.size(), trace.size());
        } else {
            json["acceptance"] = events_.event_numbers(least_acceptance(offered));
        }
        json["trace"] = events_.event_numbers(trace);
        if (options_.script.reveal_taus) json["revealed_trace"] = events_.event_numbers(revealed);
    }

    const refine::Counterexample& counterexample_;
    EventMap& events_;
    const Options& options_;
};

Json script_counterexample_json(const ScriptAssertion& assertion, EventMap& events, const Options& options) {
    const refine::Counterexample& counterexample = *assertion.result.verdict.counterexample;
    Behaviours behaviours(counterexample, events, options);
    Json json{{"type", counterexample_type(counterexample.kind)}};
    if (!assertion.specification.empty())
        json["specification_behaviour"] = behaviours.specification_json(assertion.specification);
    json["implementation_behaviour"] = behaviours.implementation_json(assertion.process);
    if (assertion.behaviour) behaviours.add_parts(json["implementation_behaviour"], *assertion.behaviour);
    if (counterexample.kind == ViolationKind::nondeterminism && counterexample.event) {
        json["event"] = events.event_number(*counterexample.event);
        if (!counterexample.accepting.empty())
            json["accepting_behaviour"] = behaviours.accepting_json(assertion.process);
    }
    json["replayed_by"] = counterexample.replayed_by_terms ? "terms" : "compiled rules";
    json["shortest"] = counterexample.shortest;
    return json;
}

/// Returns 1, 0 or null, as in FDR's output.
Json result_number(driver::Answer answer) {
    if (answer == driver::Answer::holds) return 1;
    if (answer == driver::Answer::fails) return 0;
    return nullptr;
}

Json script_result_json(const ScriptAssertion& a, EventMap& events, const Options& options) {
    constexpr std::array<const char*, 5> words{"holds", "fails", "inconclusive", "no check", "error"};
    const refine::Verdict& verdict = a.result.verdict;
    Json json{{"assertion_string", a.text}, {"errors", a.errors}, {"is_negated", a.result.negated ? 1 : 0}};
    json["result"] = result_number(a.answer);
    json["visited_states"] = verdict.statistics.states;
    json["visited_transitions"] = verdict.statistics.transitions;
    json["visited_plys"] = verdict.statistics.depth;
    json["counterexamples"] = Json::array();
    if (verdict.counterexample && !options.script.brief)
        json["counterexamples"].push_back(script_counterexample_json(a, events, options));
    json["number"] = a.number;
    json["place"] = a.place;
    json["answer"] = words[static_cast<std::size_t>(a.answer)];
    json["compile_seconds"] = a.result.compile_seconds;
    json["compile_cpu_seconds"] = a.result.compile_cpu_seconds;
    json["seconds"] = verdict.statistics.seconds;
    json["specification_nodes"] = verdict.statistics.spec_nodes;
    json["decided_by"] = proof_name(verdict.statistics.decided_by);
    if (verdict.statistics.decided_by == refine::DecidedBy::diagrams) {
        json["diagram_nodes"] = verdict.statistics.diagram_nodes;
        json["log10_states"] = verdict.statistics.log10_states;
    }
    json["chased_states"] = verdict.statistics.chased;
    if (verdict.statistics.ranks > 0) json["ranks"] = verdict.statistics.ranks;
    json["replicas"] = verdict.statistics.replicas;
    json["distinguished_replicas"] = verdict.statistics.distinguished;
    if (verdict.known) json["known"] = true;
    if (!a.basis.empty()) json["basis"] = grounds_json(a.basis);
    if (a.certificate) json["certificate"] = certificate_json(*a.certificate);
    return json;
}

Json print_json(const ScriptPrint& statement) {
    const Json errors = statement.error.empty() ? Json::array() : Json::array({statement.error});
    return {{"print_statement", statement.expression}, {"result", statement.value}, {"errors", errors}};
}

}  // namespace

void name_events(ScriptAssertion& assertion, const process::EventTable& table, const Options& options) {
    EventMap events;
    (void)script_result_json(assertion, events, options);
    for (const Event event : events.used_events()) assertion.events.try_emplace(event, table.name(event));
}

std::string refines_json(const ScriptReport& report, const Options& options) {
    EventMap events;
    const auto result = [&](const ScriptAssertion& assertion) {
        return script_result_json(assertion, events, options);
    };
    Json json{{"schema", "robochart-verify/refines/1"},
              {"copyright_notice", std::string("robochart-verify ") + program_version},
              {"license_type", "Apache License 2.0"},
              {"results", json_array(report.assertions, result)},
              {"print_statement_results", json_array(report.prints, print_json)},
              {"file_name", report.path},
              {"event_map", event_map(report.assertions)},
              {"warnings", report.warnings},
              {"errors", report.errors}};
    return diagnostics::json_text(json) + "\n";
}

}  // namespace robochart::app
