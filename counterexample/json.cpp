// SPDX-License-Identifier: Apache-2.0
// Writes runs as JSON. Empty values are omitted, except for lists that readers always iterate over.
#include "counterexample/json.hpp"

#include "base/diagnostics/json_values.hpp"
#include "counterexample/cycles.hpp"

namespace robochart::runs {
namespace {

using diagnostics::Json;
using diagnostics::json_array;

const char* json_word(Kind kind) {
    switch (kind) {
        case Kind::transition:
            return "transition";
        case Kind::input:
            return "input";
        case Kind::output:
            return "output";
        case Kind::call:
            return "call";
        case Kind::assignment:
            return "assignment";
        case Kind::external_write:
            return "externalWrite";
        case Kind::entered:
            return "entered";
        case Kind::exited:
            return "exited";
        case Kind::tock:
            return "tock";
        case Kind::terminate:
            return "terminate";
        case Kind::refusal:
            return "refusal";
        case Kind::internal:
            return "internal";
        case Kind::event:
            return "event";
        case Kind::read:
            return "read";
        case Kind::empty_read:
            return "emptyRead";
        case Kind::cycle_end:
            return "cycleEnd";
    }
    return "";
}

const char* json_word(VariableKind kind) {
    switch (kind) {
        case VariableKind::variable:
            return "variable";
        case VariableKind::clock:
            return "clock";
        case VariableKind::constant:
            return "constant";
        case VariableKind::countdown:
            return "countdown";
        case VariableKind::temporary:
            return "temporary";
    }
    return "";
}

const char* json_word(EndKind kind) {
    switch (kind) {
        case EndKind::forbidden:
            return "forbidden";
        case EndKind::refusal:
            return "refusal";
        case EndKind::divergence:
            return "divergence";
        case EndKind::deadlock:
            return "deadlock";
        case EndKind::nondeterminism:
            return "nondeterminism";
        case EndKind::reached:
            return "reached";
        case EndKind::terminated:
            return "terminated";
        case EndKind::timelock:
            return "timelock";
        case EndKind::clock_not_initialised:
            return "clockNotInitialised";
        case EndKind::clock_initialised:
            return "clockInitialised";
        case EndKind::missed:
            return "missed";
        case EndKind::no_return:
            return "noReturn";
        case EndKind::no_trace:
            return "noTrace";
        case EndKind::undefined:
            return "undefined";
    }
    return "";
}

void add_place(Json& json, const std::optional<Place>& place) {
    if (!place) return;
    json["file"] = place->file;
    json["line"] = place->line;
    json["column"] = place->column;
    json["endLine"] = place->end_line;
    json["endColumn"] = place->end_column;
}

void add_text(Json& json, const char* key, const std::string& text) {
    if (!text.empty()) json[key] = text;
}

Json value_json(const Value& value) {
    Json json{{"value", value.text}};
    add_text(json, "type", value.type);
    return json;
}

void add_event(Json& json, const Event& event) {
    json["kind"] = json_word(event.kind);
    json["text"] = event.text;
    add_text(json, "component", event.component);
    add_text(json, "element", event.element);
    add_text(json, "via", event.via);
    add_place(json, event.place);
    if (!event.values.empty()) json["values"] = json_array(event.values, value_json);
}

Json event_json(const Event& event) {
    Json json;
    add_event(json, event);
    return json;
}

Json events_json(const std::vector<Event>& list) {
    return json_array(list, event_json);
}

Json variable_json(const Variable& variable) {
    Json json{{"name", variable.name}, {"kind", json_word(variable.kind)}};
    add_text(json, "type", variable.type);
    json["value"] = diagnostics::json_or_null(variable.value);
    add_text(json, "deadline", variable.deadline);
    return json;
}

Json machine_json(const Machine& machine) {
    Json json{{"component", machine.component},
              {"machine", machine.machine},
              {"text", machine.text},
              {"active", machine.active}};
    json["variables"] = json_array(machine.variables, variable_json);
    add_place(json, machine.place);
    return json;
}

Json change(const Change& change) {
    Json json{{"component", change.component}, {"name", change.name}};
    json["before"] = diagnostics::json_or_null(change.before);
    json["after"] = change.after;
    return json;
}

Json step_json(const Step& step, std::size_t number) {
    Json json{{"n", number}};
    if (step.time) json["time"] = *step.time;
    if (step.units > 0) json["units"] = step.units;
    add_event(json, step.event);
    json["hidden"] = step.hidden;
    json["raw"] = step.raw;
    json["rawCount"] = step.count;
    if (!step.with.empty()) json["with"] = events_json(step.with);
    json["changes"] = json_array(step.changes, change);
    json["machines"] = json_array(step.machines, machine_json);
    json["offered"] = events_json(step.offered);
    if (step.more_offered > 0) json["moreOffered"] = step.more_offered;
    return json;
}

Json cause_json(const Cause& cause) {
    Json json{{"text", cause.text}};
    add_text(json, "component", cause.component);
    add_place(json, cause.place);
    return json;
}

Json end(const End& end) {
    Json json{{"kind", json_word(end.kind)}, {"why", end.why}};
    if (end.event) json["event"] = event_json(*end.event);
    json["offered"] = events_json(end.offered);
    if (end.kind == EndKind::forbidden || !end.allowed.empty()) json["allowed"] = events_json(end.allowed);
    if (!end.required.empty()) json["required"] = json_array(end.required, events_json);
    if (!end.refused.empty()) json["refused"] = events_json(end.refused);
    if (!end.causes.empty()) json["causes"] = json_array(end.causes, cause_json);
    return json;
}

Json cycle_json(const RunCycle& cycle) {
    return {{"time", cycle.time}, {"inputs", cycle.inputs}, {"outputs", cycle.outputs}, {"states", cycle.states}};
}

}  // namespace

Json run_json(const Run& run) {
    Json json{{"schema", "robochart-verify/run/1"}, {"timed", run.timed}};
    if (run.timed) json["time"] = run.time;
    if (run.timed && run.unit) json["unitNanoseconds"] = *run.unit;
    json["initial"] = json_array(run.initial, machine_json);
    json["steps"] = Json::array();
    for (std::size_t i = 0; i < run.steps.size(); ++i) json["steps"].push_back(step_json(run.steps[i], i + 1));
    json["loopStart"] = run.loop_start ? Json(*run.loop_start + 1) : Json(nullptr);
    if (const auto cycles = cycles_of(run); !cycles.empty()) json["cycles"] = json_array(cycles, cycle_json);
    json["end"] = end(run.end);
    return json;
}

}  // namespace robochart::runs
