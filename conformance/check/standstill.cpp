// SPDX-License-Identifier: Apache-2.0
// See standstill.hpp. What M does in a run of NF_c(M) is itself a run of M, which is described like a counterexample.
#include "conformance/check/standstill.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "checker/refine/search/budget.hpp"
#include "conformance/model/rules.hpp"

namespace robochart::conformance {

namespace {

/// The maximal number of places and of events in one explanation.
constexpr std::size_t most_listed = 6;

/// Returns the frame in which the problem is found. With hidden writes, endless outputs are a divergence. A missed
/// deadline of an input is not a standstill.
Frame frame_for(const refine::Counterexample& found) {
    return {AfterTermination::idle, Outputs::sequence, Deadlines::idle,
            found.kind == refine::ViolationKind::divergence};
}

bool writes_in(const std::vector<refine::Step>& steps, const Alphabet& alphabet) {
    return std::ranges::any_of(steps, [&](const refine::Step& step) {
        const process::Event event = step.event == process::tau ? step.revealed : step.event;
        return alphabet.cycle_role(event).kind == CycleRole::Kind::write;
    });
}

std::string with_place(const std::string& text, const std::optional<runs::Place>& place) {
    return place ? fmt::format("{} ({}:{})", text, place->file, place->line) : text;
}

/// Returns the event without its values, and its cause: "output x, entry action of B (model.rct:9)".
std::string words_of(const runs::Event& event) {
    const std::string what = event.text.substr(0, event.text.find(" with "));
    const bool known = !event.via.empty() && what.find(event.via) == std::string::npos;
    return with_place(known ? fmt::format("{}, {}", what, event.via) : what, event.place);
}

void add_unique(std::vector<std::string>& list, std::string text) {
    const bool known = std::ranges::find(list, text) != list.end();
    if (!known && list.size() < most_listed) list.push_back(std::move(text));
}

bool is_output(const runs::Event& event) {
    return event.kind == runs::Kind::output || event.kind == runs::Kind::call || event.kind == runs::Kind::assignment;
}

const std::vector<runs::Machine>& last_machines(const runs::Run& run) {
    return run.steps.empty() ? run.initial : run.steps.back().machines;
}

/// Writes the text of one explanation, from the run of M.
class Words {
public:
    Words(Explanation& explanation, const runs::Run& run, std::uint32_t cycle_length)
        : explanation_(explanation), run_(run), cycle_length_(cycle_length) {}

    void write_explanation() {
        const diagnostics::Rule* const rule = explanation_.rule;
        if (rule == &rules::endless_steps || rule == &rules::endless_outputs) return explain_loop();
        if (rule == &rules::time_stops) return explain_stop();
        in_mid_cycle(rule);
    }

private:
    void explain_loop() {
        const auto first = run_.steps.begin() + static_cast<std::ptrdiff_t>(run_.loop_start.value_or(0));
        const runs::Event* transition = nullptr;
        bool calls = false;
        for (auto step = first; step != run_.steps.end(); ++step) {
            const runs::Event& event = step->event;
            const bool passing = event.kind == runs::Kind::internal || event.kind == runs::Kind::entered ||
                                 event.kind == runs::Kind::exited || event.kind == runs::Kind::tock;
            if (passing) continue;
            add_unique(explanation_.where, words_of(event));
            calls = calls || event.kind == runs::Kind::call;
            if (event.kind == runs::Kind::transition && transition == nullptr) transition = &event;
        }
        explanation_.remedy =
            transition == nullptr
                ? "let some step of the loop take time (`wait(1)`) or await an event, or let a condition end the loop"
                : fmt::format(
                      "give {} an action that takes time (`action wait(1)`), a trigger to await, or a condition "
                      "that ends the loop; a wait in an action of a state on the loop does as well",
                      transition->text);
        if (calls)
            explanation_.remedy +=
                "; operations take no time here: if one that is called takes time, check what defines it, its "
                "controller or module";
    }

    void explain_stop() {
        std::int64_t lacking = 0;
        for (const runs::Machine& machine : last_machines(run_)) {
            bool late = false;
            std::int64_t left = 0;
            for (const runs::Variable& variable : machine.variables) {
                if (variable.kind != runs::VariableKind::countdown || !variable.value) continue;
                if (!variable.deadline.empty()) {
                    if (*variable.value != "0" && !variable.value->starts_with("-")) continue;
                    late = true;
                    add_unique(
                        explanation_.where,
                        with_place(fmt::format("the deadline of {} is over", variable.deadline), variable.place));
                } else if (!variable.value->empty() &&
                           std::isdigit(static_cast<unsigned char>(variable.value->front())))
                    left = std::stoll(variable.value->substr(0, 9));
            }
            if (!late) continue;
            add_unique(explanation_.where, with_place(machine.text, machine.place));
            lacking = std::max(lacking, left);
        }
        const bool deadline = !explanation_.where.empty();
        if (!deadline)
            for (const runs::Machine& machine : last_machines(run_))
                add_unique(explanation_.where, with_place(machine.text, machine.place));
        for (const runs::Event& event : run_.end.offered)
            if (event.kind == runs::Kind::input) add_unique(explanation_.where, "awaits " + words_of(event));
        if (lacking > 0)
            explanation_.remedy = fmt::format(
                "make the deadline at least {0} time unit{1} longer, or the wait that it bounds at least {0} shorter",
                lacking, lacking == 1 ? "" : "s");
        else
            explanation_.remedy =
                deadline ? "make the deadline longer, or let what it bounds be ready earlier: what it waits for does "
                           "not happen by then"
                         : "let something happen here, or let time pass: what is awaited does not happen";
    }

    void in_mid_cycle(const diagnostics::Rule* rule) {
        std::int64_t passed = 0;
        for (const runs::Step& step : run_.steps) passed += step.units;
        const std::int64_t behind = passed % cycle_length_;
        for (const runs::Event& event : run_.end.offered) {
            const bool output = rule == &rules::output_in_mid_cycle && is_output(event);
            const bool input = rule == &rules::input_in_mid_cycle &&
                               (event.kind == runs::Kind::input || event.kind == runs::Kind::external_write);
            if (output || input) add_unique(explanation_.where, words_of(event));
        }
        if (explanation_.where.empty() && rule == &rules::end_in_mid_cycle) last_transition();
        if (explanation_.where.empty())
            for (const runs::Machine& machine : last_machines(run_))
                add_unique(explanation_.where, with_place(machine.text, machine.place));
        const std::string remedy =
            rule == &rules::input_in_mid_cycle
                ? fmt::format("extend the deadline by {}, to the beginning of the next cycle", cycle_length_ - behind)
                : fmt::format("let the waits before it add up to a multiple of {}", cycle_length_);
        explanation_.remedy = fmt::format(
            "{} {} time unit{} after the beginning of a cycle of {}: {}, or run the model in cycles of 1 (`--cycle 1`)",
            what_is_due(rule), behind, behind == 1 ? "" : "s", cycle_length_, remedy);
    }

    static const char* what_is_due(const diagnostics::Rule* rule) {
        if (rule == &rules::output_in_mid_cycle) return "the output is due";
        if (rule == &rules::input_in_mid_cycle) return "the deadline is over";
        return "the end is due";
    }

    void last_transition() {
        const auto moves = [](const runs::Step& step) {
            return !step.event.via.empty() || step.event.kind == runs::Kind::transition;
        };
        const auto last = std::find_if(run_.steps.rbegin(), run_.steps.rend(), moves);
        if (last != run_.steps.rend()) add_unique(explanation_.where, "terminates behind " + words_of(last->event));
    }

    Explanation& explanation_;
    const runs::Run& run_;
    std::uint32_t cycle_length_;
};

}  // namespace

const diagnostics::Rule* rule_of(Standstill standstill) {
    switch (standstill) {
        case Standstill::other:
            return &rules::time_stops;
        case Standstill::output_in_mid_cycle:
            return &rules::output_in_mid_cycle;
        case Standstill::input_in_mid_cycle:
            return &rules::input_in_mid_cycle;
        case Standstill::end_in_mid_cycle:
            return &rules::end_in_mid_cycle;
        case Standstill::none:
        case Standstill::inputs:
        case Standstill::terminated:
            break;
    }
    return nullptr;
}

const diagnostics::Rule& rule_of(const refine::Counterexample& found, ModelGraph& graph, const Alphabet& alphabet,
                                 std::uint32_t cycle_length, const refine::Limits& limits) {
    if (found.kind == refine::ViolationKind::divergence)
        return writes_in(found.loop, alphabet) ? rules::endless_outputs : rules::endless_steps;
    const Frame frame = frame_for(found);
    NormalFormSystem normal_form(graph, alphabet, cycle_length, frame);
    const auto again = find_violation(normal_form, frame, found, alphabet, limits_of_explanation(limits));
    const diagnostics::Rule* const rule =
        again ? rule_of(normal_form.standstill_kind(again->run.last_state())) : nullptr;
    return rule == nullptr ? rules::time_stops : *rule;
}

refine::Counterexample trace_as_run(const std::vector<process::Event>& trace) {
    refine::Counterexample run;
    run.kind = refine::ViolationKind::no_trace;
    for (const process::Event event : trace) run.steps.push_back({event, event, ""});
    return run;
}

void set_model_run(Result& result, const diagnostics::Rule* rule, const std::vector<process::Event>& trace) {
    const bool endless = rule == &rules::endless_steps || rule == &rules::endless_outputs;
    refine::Counterexample run = trace_as_run(trace);
    if (rule != nullptr) run.kind = endless ? refine::ViolationKind::divergence : refine::ViolationKind::deadlock;
    result.explanation.rule = rule;
    result.model_run = std::move(run);
}

namespace {

/// The data for the explanations of one result.
struct Explained {
    cspm::Session& session;
    const cspm::ExprPtr& process;
    const Alphabet& alphabet;
    const ModelWords& words;
    const Options& options;

    [[nodiscard]] std::optional<refine::Counterexample> find_run(const Frame& frame,
                                                                 const refine::Counterexample& found) const {
        return run_of_model(session, process, alphabet, options.cycle_length, frame, found,
                            limits_of_explanation(options.limits));
    }
    [[nodiscard]] runs::Run in_words(const refine::Counterexample& run, ir::PropertyKind kind) const {
        return conformance::interpret_run(run, kind, session, words);
    }
};

void explain_standstill(Result& result, const Explained& explained) {
    const auto run = explained.find_run(frame_for(*result.model_run), *result.model_run);
    if (!run) return;
    const bool diverges = run->kind == refine::ViolationKind::divergence;
    result.explanation.run =
        explained.in_words(*run, diverges ? ir::PropertyKind::divergence_free : ir::PropertyKind::timelock_free);
    Words(result.explanation, *result.explanation.run, explained.options.cycle_length).write_explanation();
}

/// Returns a run of M with a trace of NF_c(M). M may have several such runs. The text at the end of the run is true for
/// all of them.
std::optional<runs::Run> run_with(const refine::Counterexample& trace, const std::string& why,
                                  const Explained& explained) {
    const auto run = explained.find_run({}, trace);
    if (!run) return std::nullopt;
    runs::Run result = explained.in_words(*run, ir::PropertyKind::refines);
    result.end.why = why;
    return result;
}

}  // namespace

void explain_result(Result& result, cspm::Session& session, const cspm::ExprPtr& process, const Alphabet& alphabet,
                    const ModelWords& words, const Options& options) {
    const Explained explained{session, process, alphabet, words, options};
    try {
        if (result.outcome == Outcome::not_schedulable && result.model_run) explain_standstill(result, explained);
        if (result.outcome == Outcome::differs && result.model_run)
            result.explanation.run = run_with(*result.model_run, result.reason, explained);
        for (std::optional<Aside>* const aside : {&result.register_cycles, &result.deadlines})
            if (*aside && (*aside)->model_run)
                (*aside)->run = run_with(*(*aside)->model_run, (*aside)->reason, explained);
    } catch (const process::Interrupted&) {
    } catch (const cspm::EvaluationError&) {
    }
}

}  // namespace robochart::conformance
