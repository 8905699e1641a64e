// SPDX-License-Identifier: Apache-2.0
// Runs the checker and converts its counterexamples to cycles; see conformance_check.hpp.
#include "conformance/check/conformance_check.hpp"

#include <fmt/format.h>
#include <algorithm>

#include <optional>
#include <stdexcept>

#include "conformance/check/cycle_schedule.hpp"
#include "conformance/check/dispatch_equivalence.hpp"
#include "conformance/check/lost_events.hpp"
#include "conformance/check/reading_on_demand.hpp"
#include "conformance/check/standstill.hpp"
#include "conformance/check/violated_precondition.hpp"
#include "conformance/code/cycle_graph.hpp"
#include "conformance/model/normal_form_system.hpp"
#include "conformance/model/register_system.hpp"
#include "conformance/model/rules.hpp"
#include "conformance/model/tick_tock.hpp"

namespace robochart::conformance {

namespace {

/// A run of NF_c(M) or L(G), cycle by cycle.
struct Witness {
    std::vector<Cycle> cycles;
    std::vector<std::vector<std::uint32_t>> readings;  ///< by cycle: a reading for each register
    std::vector<std::vector<process::Event>> writes;   ///< by cycle
    std::vector<std::string> raw;
};

void add_step(Witness& run, const Alphabet& alphabet, const refine::Step& step, std::uint32_t& tocks,
              std::uint32_t cycle_length) {
    // Hidden writes are reported too.
    const process::Event event = step.event == process::tau ? step.revealed : step.event;
    if (event == process::tau) return;
    const CycleRole role = alphabet.cycle_role(event);
    if (role.kind == CycleRole::Kind::other) return;
    if (step.event == process::tau && role.kind != CycleRole::Kind::write) return;
    run.raw.push_back(alphabet.events().name(event));
    Cycle& cycle = run.cycles.back();
    if (role.kind == CycleRole::Kind::read) {
        run.readings.back().push_back(role.reading);
        if (role.reading != 0) cycle.inputs.push_back(alphabet.describe_event(event));
    } else if (role.kind == CycleRole::Kind::write) {
        cycle.outputs.push_back(alphabet.describe_event(event));
        run.writes.back().push_back(event);
    } else if (role.kind == CycleRole::Kind::tock && ++tocks == cycle_length) {
        cycle.state = step.state;
        tocks = 0;
        run.cycles.emplace_back();
        run.readings.emplace_back();
        run.writes.emplace_back();
    }
}

Witness make_witness(const std::vector<refine::Step>& steps, const Alphabet& alphabet, std::uint32_t cycle_length) {
    Witness run;
    run.cycles.emplace_back();
    run.readings.emplace_back();
    run.writes.emplace_back();
    std::uint32_t tocks = 0;
    for (const refine::Step& step : steps) add_step(run, alphabet, step, tocks, cycle_length);
    const bool ended = run.readings.back().empty() && run.cycles.back().outputs.empty();
    if (ended && run.cycles.size() > 1 && !alphabet.interface().inputs.empty()) {
        run.cycles.pop_back();
        run.readings.pop_back();
    }
    return run;
}

/// Runs the code again over the inputs of the counterexample, and adds its states to the run.
void add_code_states(Witness& run, CodeSystem& code) {
    std::uint32_t image = code.reset_image();
    for (std::size_t c = 0; c < run.cycles.size(); ++c) {
        image = code.step(image, run.readings[c], run.writes[c]).next;
        run.cycles[c].state = code.print_image(image);
    }
}

std::string describe_events(const process::EventSet& events, const Alphabet& alphabet) {
    constexpr std::size_t shown = 6;
    std::string text;
    for (std::size_t i = 0; i < events.size() && i < shown; ++i)
        text += (i == 0 ? "" : " or ") + alphabet.describe_event(events[i]);
    if (events.size() > shown) text += fmt::format(" or {} others", events.size() - shown);
    return text.empty() ? "nothing" : text;
}

std::string expected_text(const refine::Counterexample& found, const Alphabet& alphabet) {
    if (found.kind == refine::ViolationKind::divergence) return "an end of the cycle";
    std::string text;
    for (const process::EventSet& events : found.required)
        text += (text.empty() ? "" : "; or all of: ") + describe_events(events, alphabet);
    return text.empty() ? "nothing" : text;
}

/// Returns the event of the code that the model does not allow. L(G) offers one event at a time, except for reads. If
/// the model requires another event instead, the search stops at the refusal, before the event of the code.
std::optional<process::Event> forbidden_event(const refine::Counterexample& found) {
    if (found.kind == refine::ViolationKind::refusal && found.offered.size() == 1) return found.offered.front();
    if (found.kind == refine::ViolationKind::trace && !found.steps.empty()) return found.steps.back().event;
    return std::nullopt;
}

std::string describe_difference(const refine::Counterexample& found, const Alphabet& alphabet, const CodeSystem& code) {
    if (found.kind == refine::ViolationKind::divergence && code.endless())
        return "the code's cycle does not end: `step` does not return";
    if (found.kind == refine::ViolationKind::divergence)
        return "the code's cycle does not end: its step bound is reached";
    const auto event = forbidden_event(found);
    // L(G) offers no event only after a missed deadline (code_system.cpp).
    if (!event && found.offered.empty()) return "the code misses a deadline";
    if (!event) return fmt::format("the code offers only {}", describe_events(found.offered, alphabet));
    const std::string& name = alphabet.events().name(*event);
    if (name == "code.precondition") return std::string(outside_precondition);
    if (alphabet.cycle_role(*event).kind == CycleRole::Kind::write)
        return fmt::format("the code writes {}, which the model does not allow here", alphabet.describe_event(*event));
    const bool stopped =
        std::ranges::all_of(found.required, [](const process::EventSet& allowed) { return allowed.empty(); });
    if (*event == alphabet.tock() && stopped)
        return "the code ends its cycle where time stops in the model: it misses a deadline and does not report it";
    if (*event == alphabet.tock()) return "the code ends its cycle although the model must go on";
    return fmt::format("the code does {}, which the model does not allow here", alphabet.describe_event(*event));
}

const std::string& last_state(const refine::Counterexample& found) {
    return found.steps.empty() ? found.initial : found.steps.back().state;
}

std::string timelock_reason(const refine::Counterexample& found) {
    const std::string& where = last_state(found);
    if (found.kind == refine::ViolationKind::divergence)
        return "the model takes infinitely many steps without time passing, at " + where;
    return "the model can neither go on nor let time pass, at " + where;
}

void report_difference(Result& result, const refine::Counterexample& found, const Alphabet& alphabet, CodeSystem& code,
                       std::uint32_t cycle_length) {
    std::vector<refine::Step> steps = found.steps;
    const auto event = forbidden_event(found);
    if (found.kind == refine::ViolationKind::refusal && event) steps.push_back({*event, *event, ""});
    std::vector<process::Event> agreed;
    for (const refine::Step& step : found.steps) agreed.push_back(step.event);
    if (found.kind == refine::ViolationKind::trace && event) agreed.pop_back();
    set_model_run(result, nullptr, agreed);
    Witness run = make_witness(steps, alphabet, cycle_length);
    add_code_states(run, code);
    result.outcome = Outcome::differs;
    result.reason = describe_difference(found, alphabet, code);
    result.expected = expected_text(found, alphabet);
    result.cycles = std::move(run.cycles);
    result.raw = std::move(run.raw);
}

/// Checks the relation. Tick-tock does not cover divergences, so they are searched separately: a schedulable M has no
/// divergence in NF_c(M), so the code must not have any either.
refine::Verdict check_relation(lts::TransitionSystem& specification, CodeSystem& code, const Alphabet& alphabet,
                               const refine::Limits& limits, Relation relation) {
    if (relation == Relation::failures_divergences)
        return refine::refines(specification, code, refine::Model::failures_divergences, limits);
    refine::Verdict verdict = tick_tock_refines(specification, code, alphabet.tock(), limits);
    if (verdict.outcome != refine::Outcome::holds) return verdict;
    const refine::Statistics statistics = verdict.statistics;
    verdict = refine::divergence_free(code, limits);
    verdict.statistics = statistics;
    return verdict;
}

void record_counts(Result& result, const ModelGraph& model, const CodeSystem& code) {
    result.model_states = model.size();
    result.code_states = code.image_count();
    result.code_cycles = code.cycle_count();
    if (code.has_alias())
        result.warnings.emplace_back("the code's state is not canonical: different bytes print alike");
}

}  // namespace

void report_not_schedulable(Result& result, const refine::Counterexample& found, ModelGraph& model,
                            const Alphabet& alphabet, std::uint32_t cycle_length, const refine::Limits& limits) {
    Witness run = make_witness(found.steps, alphabet, cycle_length);
    if (!found.steps.empty()) run.cycles.back().state = found.steps.back().state;
    result.outcome = Outcome::not_schedulable;
    result.reason = timelock_reason(found);
    result.explanation.rule = &rule_of(found, model, alphabet, cycle_length, limits);
    result.model_run = found;
    result.cycles = std::move(run.cycles);
    result.raw = std::move(run.raw);
}

Aside found_aside(const diagnostics::Rule& rule, std::string reason, const refine::Counterexample& found,
                  const Alphabet& alphabet, std::uint32_t cycle_length) {
    Witness run = make_witness(found.steps, alphabet, cycle_length);
    std::vector<process::Event> trace;
    for (const refine::Step& step : found.steps) {
        const process::Event event = step.event == process::tau ? step.revealed : step.event;
        const bool write = alphabet.cycle_role(event).kind == CycleRole::Kind::write;  // reported even if it is hidden
        if (step.event != process::tau || write) trace.push_back(event);
    }
    trace.pop_back();  // removes the event that marks the violation
    return {false, std::move(reason), std::move(run.cycles), &rule, trace_as_run(trace), {}};
}

std::string_view meaning_of(const Aside& aside) {
    if (aside.rule == &rules::output_made_twice)
        return "A robot that takes its outputs from registers once in a cycle sees the last of these values only: the "
               "others are lost. A robot on which each output is a call, as in generated code, sees all of them.";
    if (aside.rule == &rules::input_not_in_time)
        return "If the input does not come in time, the generated code reports `StepResult::deadline`, and what it "
               "does then is not specified: the robot must provide the input in time, or stop at that report.";
    return "";
}

/// Checks schedulability. The first search checks whether M can be run in cycles, and also whether each cycle makes an
/// output only once and no deadline is missed. It ends at the first violation. If this violation concerns only an
/// output or a deadline, the next search checks the rest.
Result check_schedulability(ModelGraph& model, const Alphabet& alphabet, std::uint32_t cycle_length,
                            const refine::Limits& limits) {
    Result result;
    Frame frame{AfterTermination::idle, Outputs::once, Deadlines::mark, false};
    for (;;) {
        NormalFormSystem normal_form(model, alphabet, cycle_length, frame);
        const refine::Verdict verdict = refine::deadlock_free(normal_form, refine::Model::failures_divergences, limits);
        result.schedulability = verdict.statistics;
        result.model_states = model.size();
        result.reason = verdict.reason;
        if (verdict.outcome == refine::Outcome::holds) break;
        if (verdict.outcome != refine::Outcome::fails || !verdict.counterexample) return result;
        const refine::Counterexample& found = *verdict.counterexample;
        const process::Event last = found.steps.empty() ? process::tau : found.steps.back().event;
        if (last == normal_form.repeat_event()) {
            result.register_cycles =
                found_aside(rules::output_made_twice, last_state(found), found, alphabet, cycle_length);
            frame.outputs = Outputs::sequence;
            frame.writes_hidden = true;
        } else if (last == normal_form.deadline_event()) {
            result.deadlines = found_aside(rules::input_not_in_time,
                                           "time stops in the model, which waits for an input, at " + last_state(found),
                                           found, alphabet, cycle_length);
            frame.deadlines = Deadlines::idle;
        } else {
            report_not_schedulable(result, found, model, alphabet, cycle_length, limits);
            return result;
        }
    }
    result.outcome = Outcome::conforms;
    if (!result.register_cycles) result.register_cycles.emplace();
    if (!result.deadlines) result.deadlines.emplace();
    return result;
}

namespace {

/// Compares the code with the specification.
Result compare(ModelGraph& model, lts::TransitionSystem& specification, const Alphabet& alphabet,
               const rc_interface& compiled, std::uint32_t cycle_length, const refine::Limits& limits,
               Relation relation, const EventPlaces& places) {
    Result result;
    CodeSystem code(compiled, alphabet, cycle_length);
    const refine::Verdict verdict = check_relation(specification, code, alphabet, limits, relation);
    result.product = verdict.statistics;
    if (!code.unsound_reason().empty()) {
        result.outcome = Outcome::differs;
        result.reason = code.unsound_reason();
    } else if (verdict.outcome == refine::Outcome::fails && verdict.counterexample) {
        report_difference(result, *verdict.counterexample, alphabet, code, cycle_length);
    } else {
        result.outcome = verdict.outcome == refine::Outcome::holds ? Outcome::conforms : Outcome::inconclusive;
        result.reason = verdict.reason;
    }
    if (!alphabet.interface().robosim) {
        compare_event_api(result, compiled, code, alphabet, limits);
        add_lost_events(result, code, alphabet, places);
    }
    record_counts(result, model, code);
    return result;
}

}  // namespace

Result refined_by(ModelGraph& model, const Alphabet& alphabet, const rc_interface& compiled, std::uint32_t cycle_length,
                  const refine::Limits& limits, Relation relation, const EventPlaces& places) {
    NormalFormSystem specification(model, alphabet, cycle_length);
    return compare(model, specification, alphabet, compiled, cycle_length, limits, relation, places);
}

namespace {

/// Up to this number of valuations of the inputs, it is fast to try all of them. Above it, a search that reads
/// registers on demand is faster.
constexpr double few_valuations = 128;

}  // namespace

bool many_valuations(const Interface& interface) {
    double valuations = 1;
    for (const Register& input : interface.inputs) valuations *= input.reading_count();
    return valuations > few_valuations;
}

namespace {

bool on_demand(InputSearch inputs, const Interface& interface, const rc_interface& code) {
    if (inputs != InputSearch::automatic) return inputs == InputSearch::on_demand;
    return code.probe != nullptr && many_valuations(interface);
}

/// Checks the code by a search that reads on demand. Throws NotProbed if another search must decide.
Result judged_on_demand(ModelGraph& graph, const Alphabet& alphabet, const rc_interface& code,
                        std::uint32_t cycle_length, const refine::Limits& limits, const EventPlaces& places) {
    Result result;
    try {
        result = schedulable_on_demand(graph, alphabet, cycle_length, limits);
        if (result.outcome != Outcome::conforms) return result;
        Result refined = refined_on_demand(graph, alphabet, code, cycle_length, limits, places);
        refined.schedulability = result.schedulability;
        refined.register_cycles = std::move(result.register_cycles);
        refined.deadlines = std::move(result.deadlines);
        return refined;
    } catch (const process::Interrupted& limit) {
        result.outcome = Outcome::inconclusive;
        result.reason = limit.what();
        return result;
    }
}

}  // namespace

namespace {

/// Checks RoboSim code; its specification is the component itself. If the component cannot end a cycle, it may stop
/// time. The code reports this as a missed deadline. The code writes no output twice in a cycle, because the component
/// cannot.
Result judge_registers(ModelGraph& model, const Alphabet& alphabet, const rc_interface& code,
                       std::uint32_t cycle_length, const refine::Limits& limits, Relation relation,
                       const EventPlaces& places) {
    RegisterSystem idle(model, alphabet, cycle_length, AfterEnd::idle);
    const refine::Verdict endless = refine::divergence_free(idle, limits);
    Result result;
    result.schedulability = endless.statistics;
    result.model_states = model.size();
    result.reason = endless.reason;
    if (endless.outcome == refine::Outcome::fails && endless.counterexample)
        report_not_schedulable(result, *endless.counterexample, model, alphabet, cycle_length, limits);
    if (endless.outcome != refine::Outcome::holds) return result;
    const refine::Verdict stops = refine::deadlock_free(idle, refine::Model::failures_divergences, limits);
    RegisterSystem specification(model, alphabet, cycle_length, AfterEnd::stop);
    result = compare(model, specification, alphabet, code, cycle_length, limits, relation, places);
    result.schedulability = stops.statistics;
    result.register_cycles.emplace();
    if (stops.outcome == refine::Outcome::holds) result.deadlines.emplace();
    if (stops.outcome == refine::Outcome::fails && stops.counterexample) {
        Witness run = make_witness(stops.counterexample->steps, alphabet, cycle_length);
        result.deadlines = {
            false,
            "the component can neither go on nor end its cycle, at " + last_state(*stops.counterexample),
            std::move(run.cycles),
            &rules::time_stops,
            {},
            {}};
    }
    return result;
}

}  // namespace

Result judge_component(lts::TransitionSystem& model, process::EventTable& events, const Interface& interface,
                       const rc_interface& code, std::uint32_t cycle_length, const refine::Limits& limits,
                       Relation relation, const EventPlaces& places, InputSearch inputs) {
    Result result;
    try {
        const Alphabet alphabet(interface, events);
        ModelGraph graph(model, alphabet);
        if (interface.robosim) return judge_registers(graph, alphabet, code, cycle_length, limits, relation, places);
        if (relation == Relation::failures_divergences && on_demand(inputs, interface, code)) {
            try {
                return judged_on_demand(graph, alphabet, code, cycle_length, limits, places);
            } catch (const NotProbed& reason) {
                result.reason = reason.what();
                if (inputs == InputSearch::on_demand) return result;
            }
        }
        result = check_schedulability(graph, alphabet, cycle_length, limits);
        if (result.outcome != Outcome::conforms) return result;
        Result refined = refined_by(graph, alphabet, code, cycle_length, limits, relation, places);
        refined.schedulability = result.schedulability;
        refined.register_cycles = std::move(result.register_cycles);
        refined.deadlines = std::move(result.deadlines);
        result = std::move(refined);
    } catch (const AlphabetError& mismatch) {
        result.outcome = Outcome::differs;
        result.reason = mismatch.what();
    } catch (const std::length_error& limit) {
        result.outcome = Outcome::inconclusive;
        result.reason = limit.what();
    }
    return result;
}

}  // namespace robochart::conformance
