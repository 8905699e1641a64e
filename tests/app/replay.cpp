// SPDX-License-Identifier: Apache-2.0
// Parses descriptions of states independently of the code under test. The two share only the names that the generator
// of scripts records.
#include "tests/app/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "app/command/run.hpp"
#include "app/verbs/verbs.hpp"
#include "checker/cspm/session.hpp"
#include "driver/claims/class_project.hpp"
#include "driver/claims/model_claims.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::app::testing {
namespace {

using nlohmann::json;
using process::TermId;

std::vector<std::string> apart(const std::string& text, const std::string& separator) {
    std::vector<std::string> parts(1);
    int depth = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (depth == 0 && !quoted && text.compare(i, separator.size(), separator) == 0) {
            parts.emplace_back();
            i += separator.size() - 1;
            continue;
        }
        if (text[i] == '"') quoted = !quoted;
        if (!quoted && std::string("({<").find(text[i]) != std::string::npos) ++depth;
        if (!quoted && std::string(")}>").find(text[i]) != std::string::npos) --depth;
        parts.back() += text[i];
    }
    for (std::string& part : parts) {
        while (!part.empty() && part.front() == ' ') part.erase(0, 1);
        while (!part.empty() && part.back() == ' ') part.pop_back();
    }
    return parts;
}

/// A raw event, which is hidden if its text has the form "τ(a.1)".
struct Raw {
    bool hidden = false;
    std::string name;
};

Raw raw_event(const std::string& text) {
    const std::string tau = "τ";
    if (text.rfind(tau, 0) != 0) return {false, text};
    if (text == tau) return {true, text};
    return {true, text.substr(tau.size() + 1, text.size() - tau.size() - 2)};
}

/// Returns true if the script prints the value as the model does. It does so for numbers and truth values, unless
/// classes replace the values of the type.
bool is_plain(const ir::System& system, const json& value) {
    const std::string type = value.value("type", "");
    const bool replaced = std::ranges::find(system.types, type, &ir::Type::values_of) != system.types.end();
    return !replaced && (type == "nat" || type == "int" || type == "boolean");
}

class Replay {
public:
    Replay(const ir::System& system, const csp_emit::Emission& emission, cspm::Session& session,
           const csp_emit::Obligation& obligation, const json& run, Replayed& sum)
        : system_(system), emission_(emission), session_(session), obligation_(obligation), run_(run), sum_(sum) {}

    /// Replays the run on the process of this assertion. Returns the mismatches.
    std::vector<std::string> against(const cspm::ExprPtr& process);

private:
    using States = std::set<TermId>;
    void fault(const std::string& text) {
        if (faults_.size() < 5) faults_.push_back(obligation_.title + ": " + text);
    }
    [[nodiscard]] const csp_emit::EventMeaning* meaning_of(std::string name) const;
    States perform(const States& from, const Raw& event);
    States instantiated(TermId start);
    void step(const json& step, States& states);
    void time_of(const json& step);
    void values_of(const json& step, const std::string& name);
    void offers_of(const json& step, const States& before);
    [[nodiscard]] bool offered(const json& offer, const States& states);
    void machines_of(const json& machines, States& states);
    void note_compressed(TermId state);
    [[nodiscard]] bool is_compressed(const json& machine) const;
    [[nodiscard]] bool waits_to_begin(const json& machine, const std::vector<std::string>& calls) const;
    [[nodiscard]] bool fits(const json& machine, const std::vector<std::string>& calls) const;
    [[nodiscard]] bool complete(const json& machines, const std::vector<std::string>& calls) const;
    [[nodiscard]] std::vector<std::string> calls_of(TermId term);
    void end(const States& states, const States& loop_start);
    [[nodiscard]] const std::string& name(process::Event event) { return session_.event_table().name(event); }
    [[nodiscard]] std::string claimed(const std::string& component) const;

    const ir::System& system_;
    const csp_emit::Emission& emission_;
    cspm::Session& session_;
    const csp_emit::Obligation& obligation_;
    const json& run_;
    Replayed& sum_;
    std::vector<std::string> raw_;
    std::set<std::string> compressed_;  ///< components, with `::` appended
    std::int64_t time_ = 0;
    std::size_t next_ = 0;  ///< the raw event with which the next step starts
    std::vector<std::string> faults_;
};

/// Returns the name of the component in runs. Copies of a machine that observe it have the machine's name there.
std::string Replay::claimed(const std::string& component) const {
    if (!component.starts_with("OFW_") && !component.starts_with("CLW_")) return component;
    const std::string& title = obligation_.component;
    return obligation_.property == ir::no_id ? title.substr(title.rfind(' ') + 1)
                                             : ir::qualified_name(system_.properties[obligation_.property].subject);
}

/// Returns the meaning of an event, whose name may end in values, or null if it has none.
const csp_emit::EventMeaning* Replay::meaning_of(std::string name) const {
    for (;;) {
        const auto found = emission_.provenance.events.find(name);
        if (found != emission_.provenance.events.end()) return &found->second;
        const std::size_t value = name.rfind('.');
        if (value == std::string::npos) return nullptr;
        name.erase(value);
    }
}

Replay::States Replay::perform(const States& from, const Raw& event) {
    States result;
    for (const TermId state : from)
        for (const process::Transition& transition : session_.transitions(state)) {
            const bool same = event.hidden ? transition.event == process::tau && name(transition.revealed) == event.name
                                           : transition.event != process::tau && name(transition.event) == event.name;
            if (same) result.insert(transition.target);
        }
    return result;
}

/// Returns the calls in the description of the term, after the first definitions have been expanded.
std::vector<std::string> Replay::calls_of(TermId term) {
    return apart(process::describe(session_.terms(), session_.terms().unfold_calls(term, 20)), "‖");
}

/// Returns true if the machine has not moved. The description then shows an enclosing process, or a call that precedes
/// the machine's first definition.
bool Replay::waits_to_begin(const json& machine, const std::vector<std::string>& calls) const {
    const std::string component = machine["component"].get<std::string>() + "::";
    const bool initial = std::any_of(run_["initial"].begin(), run_["initial"].end(),
                                     [&](const json& initial_machine) { return initial_machine == machine; });
    return std::ranges::any_of(calls, [&](const std::string& call) {
        const std::string name = call.substr(0, call.find('('));
        const auto at = name.rfind("::");
        const bool around = at != std::string::npos && component.rfind(claimed(name.substr(0, at)) + "::", 0) == 0;
        return around && initial;
    });
}

/// Adds the components inside a compression (O__). Their steps are not steps of the whole process.
void Replay::note_compressed(TermId state) {
    for (const std::string& call : calls_of(state)) {
        const std::string name = call.substr(0, call.find('('));
        if (name.ends_with("::O__")) compressed_.insert(name.substr(0, name.size() - std::string("O__").size()));
    }
}

bool Replay::is_compressed(const json& machine) const {
    const std::string component = machine["component"].get<std::string>() + "::";
    return std::ranges::any_of(compressed_, [&](const std::string& part) { return component.rfind(part, 0) == 0; });
}

bool Replay::fits(const json& machine, const std::vector<std::string>& calls) const {
    const std::string component = machine["component"];
    const auto owner = [&](const std::string& call) {
        const auto found = emission_.provenance.definitions.find(call.substr(0, call.find('(')));
        return found != emission_.provenance.definitions.end() && claimed(found->second.component) == component
                   ? &found->second
                   : nullptr;
    };
    bool found = false;
    std::set<std::pair<std::string, std::string>> values;  // several temporary variables may have the same name
    for (const std::string& call : calls) {
        const csp_emit::DefinitionMeaning* const definition = owner(call);
        if (definition == nullptr) continue;
        if (!definition->memory) {
            if (definition->text != machine["text"]) return false;
            std::vector<std::string> active;
            for (const ir::Origin& state : definition->active) active.push_back(state.element);
            if (active != machine["active"].get<std::vector<std::string>>()) return false;
            found = true;
        }
        const auto bracket = call.find('(');
        if (bracket == std::string::npos) continue;
        const auto arguments = apart(call.substr(bracket + 1, call.size() - bracket - 2), ",");
        for (std::size_t i = 0; i < arguments.size() && i < definition->parameters.size(); ++i)
            values.emplace(definition->parameters[i], arguments[i]);
    }
    if (!found) return waits_to_begin(machine, calls);
    return std::all_of(machine["variables"].begin(), machine["variables"].end(), [&](const json& variable) {
        const std::string name = variable["name"];
        const auto has = [&](const std::string& value) { return values.contains({name, value}); };
        if (variable["value"].is_null()) return has("_") || has("'_'");
        if (!is_plain(system_, variable) && variable.contains("type"))
            return std::ranges::any_of(values, [&](const auto& entry) { return entry.first == name; });
        return has(variable["value"]);
    });
}

/// Returns true if the list contains every machine of the script's state.
bool Replay::complete(const json& machines, const std::vector<std::string>& calls) const {
    return std::ranges::all_of(calls, [&](const std::string& call) {
        const auto found = emission_.provenance.definitions.find(call.substr(0, call.find('(')));
        if (found == emission_.provenance.definitions.end()) return true;
        // Only control processes show that a machine is active: the memory of a machine may outlive the machine.
        if (found->second.memory) return true;
        return std::ranges::any_of(
            machines, [&](const json& machine) { return machine["component"] == claimed(found->second.component); });
    });
}

/// Keeps only the states in which the machines are where the JSON says.
void Replay::machines_of(const json& machines, States& states) {
    std::string seen;
    const auto wrong = [&](TermId state) {
        const auto calls = calls_of(state);
        seen = process::describe(session_.terms(), state);
        // The description of the whole shows no state for machines inside a compression. Before an internal choice is
        // resolved, a machine is not in any state.
        const bool compressed = seen.find(" state ") != std::string::npos || seen.find("bisim(") != std::string::npos ||
                                seen.find("…") != std::string::npos || seen.find("⊓") != std::string::npos;
        if (compressed) return false;
        sum_.machines += machines.size();
        return !complete(machines, calls) || !std::ranges::all_of(machines, [&](const json& machine) {
            return is_compressed(machine) || fits(machine, calls);
        });
    };
    std::erase_if(states, wrong);
    if (states.empty()) fault("no state has these machines: " + machines.dump() + "\n  but " + seen);
}

void Replay::time_of(const json& step) {
    const bool timed = run_["timed"];
    if (step.contains("time") != timed) return fault("a step with a time, or a timed one without");
    if (timed && step["time"] != time_)
        fault(fmt::format("step {} at time {}, not {}", step["n"].dump(), time_, step["time"].dump()));
}

void Replay::values_of(const json& step, const std::string& name) {
    if (!step.contains("values")) return;
    std::string end;
    for (const json& value : step["values"]) {
        if (!is_plain(system_, value)) return;
        end += "." + value["value"].get<std::string>();
    }
    const bool there = name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
    if (!there) fault(name + " has not the values " + step["values"].dump());
}

/// Returns true if one of the states makes this offer. A transition is compared by its own hidden event, other offers
/// by their values.
bool Replay::offered(const json& offer, const States& states) {
    std::set<std::string> keys;
    for (const auto& [key, meaning] : emission_.provenance.events)
        if (meaning.text == offer["text"] && claimed(meaning.component) == offer.value("component", ""))
            keys.insert(key);
    std::string end;
    if (offer.contains("values"))
        for (const json& value : offer["values"]) {
            if (!is_plain(system_, value)) return true;
            end += "." + value["value"].get<std::string>();
        }
    for (const TermId state : states)
        for (const process::Transition& transition : session_.transitions(state)) {
            const std::string& found = name(transition.event == process::tau ? transition.revealed : transition.event);
            if (offer["kind"] == "transition" ? keys.contains(found) : found.ends_with(end)) return true;
        }
    return false;
}

void Replay::offers_of(const json& step, const States& before) {
    for (const json& offer : step["offered"])
        if (!offered(offer, before)) fault("not offered: " + offer.dump());
}

void Replay::step(const json& step, States& states) {
    ++sum_.steps;
    ++sum_.kinds[step["kind"]];
    if (step["kind"] == "event" && obligation_.property == ir::no_id)
        fault("a step that is none of the model's: " + step["text"].dump());
    const std::size_t first = step["raw"];
    const std::size_t count = step["rawCount"];
    if (count > 0 && first != next_) fault(fmt::format("raw event {} instead of {}", first, next_));
    time_of(step);
    std::int64_t units = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Raw event = raw_event(raw_.at(next_++));
        if (i == 0) offers_of(step, states);
        const csp_emit::EventMeaning* const meaning = meaning_of(event.name);
        const bool memory = meaning != nullptr && meaning->kind == csp_emit::MeaningKind::memory;
        // A read or write of a memory after the first event belongs to the step, but is hidden and has other values.
        const bool follows = memory && i > 0;
        if (!follows && event.hidden != step["hidden"]) fault("hidden or not: " + raw_.at(next_ - 1));
        states = perform(states, event);
        if (states.empty())
            return fault(fmt::format("the process cannot do {} (step {})", raw_.at(next_ - 1), step["n"].dump()));
        if (event.name == "tock" || event.name == "tock'") ++units;
        const bool noted = memory && meaning->component.empty();
        if (!noted && !follows) values_of(step, event.name);
    }
    time_ += units;
    const bool passes = step["kind"] == "tock";
    if (passes != (units > 0)) fault("time passes or not in step " + step["n"].dump() + ": " + step["text"].dump());
    if (passes && step["units"] != units) fault("units of step " + step["n"].dump());
    // A step inside a compression has no raw event, so the whole process does not move.
    if (count > 0) machines_of(step["machines"], states);
}

void Replay::end(const States& states, const States& loop_start) {
    const json& end = run_["end"];
    const std::string kind = end["kind"];
    const auto some = [&](const auto& test) { return std::ranges::any_of(states, test); };
    const bool loop = !run_["loopStart"].is_null();
    if (loop && !some([&](TermId state) { return loop_start.contains(state); })) fault("the loop does not close");
    if (loop) return;
    for (const json& offer : end["offered"])
        if (!offered(offer, states)) fault("not offered at the end: " + offer.dump());
    if (kind == "deadlock" && !some([&](TermId state) { return session_.transitions(state).empty(); }))
        fault("no deadlock");
    if (kind == "timelock" && !some([&](TermId state) {
            const auto list = session_.transitions(state);
            return std::ranges::none_of(list, [&](const auto& transition) {
                return transition.event == process::tau || name(transition.event) == "tock";
            });
        }))
        fault("time can pass");
    if (kind == "refusal" && end["required"].empty()) fault("nothing is required");
    if (kind == "forbidden" && !end.contains("event")) fault("no event is forbidden");
}

std::vector<std::string> Replay::against(const cspm::ExprPtr& process) {
    raw_ = run_["events"].get<std::vector<std::string>>();
    const std::size_t loop = raw_.size();
    for (const auto& event : run_["loopEvents"]) raw_.push_back(event);
    States states{session_.process(process)};
    States loop_start;
    note_compressed(*states.begin());
    for (const json& run_step : run_["steps"]) {
        if (!run_["loopStart"].is_null() && run_step["n"] == run_["loopStart"]) {
            if (next_ != loop) fault("the loop begins elsewhere");
            if (run_["timed"] == true && run_["time"] != time_) fault("time of the end");
            loop_start = states;
        }
        step(run_step, states);
        if (!faults_.empty()) return faults_;
    }
    if (next_ != raw_.size()) fault("steps are missing");
    if (run_["loopStart"].is_null() && run_["timed"] == true && run_["time"] != time_) fault("time of the end");
    end(states, loop_start);
    return faults_;
}

/// Replays the run on the process of each assertion of the obligation, because the run is a run of the assertion that
/// has failed. Returns no mismatches if one of the processes has this run.
std::vector<std::string> replay_one(const ir::System& system, const csp_emit::Emission& emission,
                                    cspm::Session& session, const csp_emit::Obligation& obligation, const json& run,
                                    Replayed& sum) {
    std::vector<std::string> faults{obligation.title + ": no assertion of it can fail with a run"};
    for (const cspm::DeclPtr& assertion : obligation.assertions) {
        const cspm::Assertion& checked = assertion->assertion;
        if (checked.negated) continue;
        const bool refinement = checked.kind == cspm::AssertionKind::refinement;
        Replayed tally = sum;
        faults = Replay(system, emission, session, obligation, run, tally)
                     .against(refinement ? checked.implementation : checked.specification);
        if (!faults.empty()) continue;
        sum = tally;
        return {};
    }
    return faults;
}

using ClaimFilter = std::function<bool(const csp_emit::Obligation&)>;

/// Replays the counterexamples of the claims that `takes` selects.
void replay_time(driver::Project& project, const Options& options, csp_emit::Time time, const json& report,
                 const ClaimFilter& takes, Replayed& sum) {
    const csp_emit::Emission emission = emit_csp(project, options.claims, options.swarm, time);
    if (!project.diagnostics.ok()) return;
    std::map<std::string, const json*> answers;
    for (const json& answer : report["assertions"]) answers[answer["title"]] = &answer;
    cspm::Session session(emission.script);
    for (const csp_emit::Obligation& obligation : emission.obligations) {
        const auto found = answers.find(obligation.title);
        if (found == answers.end() || !takes(obligation)) continue;
        ++sum.assertions;
        if (!found->second->contains("counterexample")) continue;
        const json& run = (*found->second)["counterexample"];
        ++sum.counterexamples;
        ++sum.endings[run["end"]["kind"]];
        for (std::string& fault : replay_one(project.system, emission, session, obligation, run, sum)) {
            std::string where = options.load.inputs.front();
            sum.faults.push_back(where + ": " + fault);
        }
    }
}

}  // namespace

void replay(const std::vector<std::string>& inputs, bool core, Replayed& sum) try {
    Options options;
    set_verb(options, Verb::check);
    options.load.inputs = inputs;
    options.claims.core = core;
    // Longer runs show no further kinds of steps.
    options.limits.timeout_seconds = 2;
    options.limits.max_states = 20'000;
    Run whole(options);
    whole.finish();  // a run that passes its limit must not end the test process
    options.run = &whole;
    const auto project = load_project(options, whole.budget());
    if (!project->diagnostics.ok()) return;
    Report report;
    check_assertions(*project, search_context(options), report);
    if (!project->diagnostics.ok()) return;
    const json parsed = json::parse(render_json(report));
    const driver::ClassProject classes = driver::class_project(*project, options);
    const auto in_carriers = [&](const driver::Project& of, bool wanted) -> ClaimFilter {
        return [&, wanted](const csp_emit::Obligation& obligation) {
            return (!classes.project || driver::is_decided_in_carriers(classes, of.system, obligation)) == wanted;
        };
    };
    for (const auto time : {csp_emit::Time::untimed, csp_emit::Time::timed}) {
        if (classes.project)
            replay_time(*classes.project, options, time, parsed, in_carriers(*classes.project, false), sum);
        replay_time(*project, options, time, parsed, in_carriers(*project, true), sum);
    }
} catch (const diagnostics::LimitReached&) {
    // Keeps the counterexamples that were compared before the limit.
}

}  // namespace robochart::app::testing
