// SPDX-License-Identifier: Apache-2.0
// Writes one CSPM form for each kind of property, as RoboTool generates it and FDR decides it.
#include "csp_emit/assertions.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/assertion_forms.hpp"
#include "csp_emit/base/names.hpp"
#include "csp_emit/base/registers.hpp"
#include "csp_emit/base/rules.hpp"
#include "csp_emit/base/types.hpp"
#include "csp_emit/base/variants.hpp"
#include "csp_emit/expressions/expressions.hpp"
#include "semantics/ir/own_constants.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::AssertionKind;
using cspm::DeclPtr;
using cspm::ExprPtr;
using ir::PropertyKind;

namespace {

cspm::Model model_of(ir::PropertyModel model) {
    switch (model) {
        case ir::PropertyModel::traces:
            return cspm::Model::traces;
        case ir::PropertyModel::failures:
            return cspm::Model::failures;
        case ir::PropertyModel::failures_divergences:
        case ir::PropertyModel::tick_tock:
            break;
    }
    return cspm::Model::failures_divergences;
}

std::string wording_of(const ir::Property& property) {
    const std::size_t colon = property.wording.find(':');
    if (colon == std::string::npos) return property.wording;
    return property.wording.substr(property.wording.find_first_not_of(' ', colon + 1));
}

/// Returns the text for a claim that fails without a counterexample, such as the negation of deadlock freedom. The text
/// states what is true instead.
std::string opposite_claim(const ir::Property& property) {
    switch (property.kind) {
        case PropertyKind::deadlock_free:
            return "it is deadlock-free";
        case PropertyKind::divergence_free:
            return "it is divergence-free";
        case PropertyKind::deterministic:
            return "it is deterministic";
        case PropertyKind::timelock_free:
            return "it is timelock-free";
        case PropertyKind::terminates:
            return "no run terminates, and none ends in a deadlock";
        case PropertyKind::reachable:
            return "no run reaches the state";
        case PropertyKind::event_missed:
            return "no run misses it";
        case PropertyKind::schedulable:
            return "it is schedulable";
        case PropertyKind::refines:
        case PropertyKind::equals:
        case PropertyKind::clock_initialised:
        case PropertyKind::conforms:
            break;
    }
    return "it refines the other";
}

class Asserter {
public:
    Asserter(const Project& project, NameManager& names, Emitted& emitted)
        : project_(project),
          names_(names),
          emitted_(emitted),
          open_cycles_(open_cycles(project.system)),
          own_(ir::own_constants(project.system)) {}

    Obligation make_obligation(std::uint32_t index);

private:
    bool timed() const { return project_.is_timed(); }
    std::string path_of(const ir::ComponentRef& ref) const { return qualified_name(ref.package, ref.path); }
    std::string name_of(const ir::ComponentRef& process, const std::string& ending) const;
    const ComponentEmission* find_component(const ir::ComponentRef& ref) const;
    b::Exprs process_arguments(const ir::ComponentRef& ref, const ir::Property& property) const;
    ExprPtr process_of(const ir::ComponentRef& ref, const ir::Property& property, const std::string& variant) const;
    ExprPtr find_argument(const std::vector<std::string>& names, const ir::Property& property) const;
    bool takes_constant(const ir::ComponentRef& ref, const std::string& constant) const;
    std::string own_name(const ConstantParameter& constant) const;
    void report_unused(const ir::Property& property) const;
    std::vector<DeclPtr> assert_unary(AssertionKind kind, const ExprPtr& process, cspm::Model model,
                                      bool negated) const;
    std::vector<DeclPtr> assert_termination(const ExprPtr& process, cspm::Model model, bool negated) const;
    void add_refinement(const ir::Property& property, Obligation& out);
    ExprPtr compared(const ir::ComponentRef& ref, const ir::ComponentRef& other, const ir::Property& property) const;
    bool runs_in_cycles(const ir::ComponentRef& ref) const;
    std::string open_registers(const ir::ComponentRef& ref, const ir::Property& property) const;
    std::string model_shifting(const ir::Property& property, Obligation& out);
    ExprPtr alphabet_of(const ir::ComponentRef& ref) const;
    std::string missing_alphabet(const ir::ComponentRef& ref, const ir::ComponentRef& other) const;
    ExprPtr joint_alphabet(const ir::Property& property) const;
    std::vector<DeclPtr> assert_reachability(const ir::Property& property) const;
    void add_initialisation(const ir::Property& property, Obligation& out);
    void missed_event(const ir::Property& property, Obligation& out);
    ExprPtr renamed_to(const ir::ComponentRef& ref, const ir::ComponentRef& other, const ExprPtr& process) const;
    std::string why_unavailable(const ir::Property& property) const;
    std::string unavailable_model(const ir::Property& property) const;
    void add_assertions(const ir::Property& property, Obligation& out);

    const Project& project_;
    NameManager& names_;
    Emitted& emitted_;
    std::set<std::string> open_cycles_;       // cycles without a length
    std::map<std::string, std::string> own_;  // maps a constant of a part to the machine's own constant
};

const ComponentEmission* Asserter::find_component(const ir::ComponentRef& ref) const {
    const auto found = emitted_.components.find(path_of(ref));
    return found == emitted_.components.end() ? nullptr : &found->second;
}

/// Returns the value that the assertion gives to one of these names, or null if it gives none.
ExprPtr Asserter::find_argument(const std::vector<std::string>& names, const ir::Property& property) const {
    for (const auto& [name, given] : property.constants)
        if (std::ranges::find(names, name) != names.end()) return translate_expression(project_, {}, *given);
    return nullptr;
}

/// Returns the name of the machine's own constant if the parameter is for the constant of a part, or "" otherwise.
std::string Asserter::own_name(const ConstantParameter& constant) const {
    const auto found = own_.find(constant.source);
    return found == own_.end() ? "" : found->second;
}

bool Asserter::takes_constant(const ir::ComponentRef& ref, const std::string& constant) const {
    const ComponentEmission* found = find_component(ref);
    if (found == nullptr) return false;
    return std::ranges::any_of(found->constants,
                               [&](const ConstantParameter& c) {
                                   return c.parameter == constant || c.source == constant || c.value == constant ||
                                          own_name(c) == constant;
                               }) ||
           std::ranges::any_of(found->arguments,
                               [&](const ArgumentParameter& argument) { return argument.name == constant; });
}

/// Reports RC-C08 for constants that the assertion sets but neither of its components has. A property that is checked
/// in both semantics is reported once.
void Asserter::report_unused(const ir::Property& property) const {
    if (timed() && property.untimed) return;
    for (const auto& [name, value] : property.constants)
        if (!ir::is_cycle_name(name) && !takes_constant(property.subject, name) &&
            !takes_constant(property.other, name))
            project_.diagnostics.report(rules::constant_without_use, property.origin.span, {property.name, name});
}

/// Returns the script's name for a process of a CSP block, or for a definition of that process such as its alphabet.
std::string Asserter::name_of(const ir::ComponentRef& process, const std::string& ending) const {
    const std::string name = process.path + ending;
    if (process.definition >= project_.system.csp_blocks.size()) return name;
    const auto names = emitted_.names_of_blocks.find(project_.system.csp_blocks[process.definition].file);
    if (names == emitted_.names_of_blocks.end()) return name;
    const auto changed = names->second.find(name);
    return changed == names->second.end() ? name : changed->second;
}

/// Returns `P::X::D__(0, constants...)` or, for a process of a CSP block, its name.
ExprPtr Asserter::process_of(const ir::ComponentRef& ref, const ir::Property& property,
                             const std::string& variant) const {
    if (ref.kind == ir::ComponentKind::process) {
        return b::name(name_of(ref, ""));
    }
    return b::call(path_of(ref) + "::" + variant, process_arguments(ref, property));
}

/// Returns the arguments of a component's process: `0`, an operation's parameters, then the constants. The assertion's
/// values take precedence over those of the instantiations.
b::Exprs Asserter::process_arguments(const ir::ComponentRef& ref, const ir::Property& property) const {
    const ComponentEmission* found = find_component(ref);
    b::Exprs arguments{b::number(0)};
    if (found != nullptr) {
        for (const ArgumentParameter& parameter : found->arguments) {
            const ExprPtr given = find_argument({parameter.name}, property);
            arguments.push_back(given ? given : default_literal(project_, parameter.type));
        }
        for (const ConstantParameter& constant : found->constants) {
            const ExprPtr given =
                find_argument({constant.parameter, constant.source, constant.value, own_name(constant)}, property);
            arguments.push_back(given ? given : b::name(constant.value));
        }
    }
    return arguments;
}

std::vector<DeclPtr> Asserter::assert_unary(AssertionKind kind, const ExprPtr& process, cspm::Model model,
                                            bool negated) const {
    return {b::assert_property(process, kind, model, negated)};
}

/// Writes `terminates`: not `P :[deadlock free]`, so some deadlock or ✓ is reachable, and `P; RUN({r__}) :[deadlock
/// free]`, so every deadlock of P is a ✓.
std::vector<DeclPtr> Asserter::assert_termination(const ExprPtr& process, cspm::Model model, bool negated) const {
    if (negated) return {never_terminates(process)};
    return {b::assert_property(process, AssertionKind::deadlock_free, model, true),
            b::assert_property(running_on(process, "r__"), AssertionKind::deadlock_free, model, false)};
}

/// Renames the events of one side of a comparison, because two components are compared by the names of their events
/// (csp-gen issue 91).
ExprPtr Asserter::renamed_to(const ir::ComponentRef& ref, const ir::ComponentRef& other, const ExprPtr& process) const {
    const ComponentEmission* from = find_component(ref);
    const ComponentEmission* to = find_component(other);
    if (from == nullptr || to == nullptr || path_of(ref) == path_of(other)) return process;
    std::vector<cspm::Link> links;
    for (const std::string& channel : from->visible)
        if (std::ranges::find(to->visible, channel) != to->visible.end())
            links.push_back({visible_event(path_of(ref), channel), visible_event(path_of(other), channel)});
    return links.empty() ? process : b::rename(process, links);
}

ExprPtr Asserter::alphabet_of(const ir::ComponentRef& ref) const {
    const bool process = ref.kind == ir::ComponentKind::process;
    return b::name(process ? name_of(ref, "__sem__events") : path_of(ref) + "::sem__events");
}

/// Explains that no CSP block of this semantics defines the alphabet of its process, and how to define it. Returns ""
/// if a block defines it.
std::string Asserter::missing_alphabet(const ir::ComponentRef& ref, const ir::ComponentRef& other) const {
    if (ref.kind != ir::ComponentKind::process) return "";
    const std::string alphabet = ref.path + "__sem__events";
    const auto& blocks = project_.system.csp_blocks;
    const bool defined = std::ranges::any_of(blocks, [&](const ir::CspBlock& block) {
        return project_.block_applies(block) && block.text.find(alphabet) != std::string::npos;
    });
    if (defined) return "";
    const bool between_blocks = other.kind == ir::ComponentKind::process;
    return fmt::format(
        "{} is not defined: the tick-tock model records refused events, so the csp block of {} must define the events "
        "of the process: `{} = {}`",
        alphabet, ref.path, alphabet, between_blocks ? "{| P::E, P::F |}" : path_of(other) + "::sem__events");
}

/// Returns the events of both sides, except events of the subject that are renamed to events of the other side.
ExprPtr Asserter::joint_alphabet(const ir::Property& property) const {
    const ComponentEmission* from = find_component(property.subject);
    const ComponentEmission* to = find_component(property.other);
    if (from == nullptr || to == nullptr || path_of(property.subject) == path_of(property.other))
        return b::call("union", {alphabet_of(property.other), alphabet_of(property.subject)});
    b::Exprs rest;
    for (const std::string& channel : from->visible)
        if (std::ranges::find(to->visible, channel) == to->visible.end())
            rest.push_back(visible_event(path_of(property.subject), channel));
    return rest.empty() ? alphabet_of(property.other)
                        : b::call("union", {alphabet_of(property.other), b::productions(rest)});
}

/// Adds an instance of the library's module for the events of both sides. Returns its name.
std::string Asserter::model_shifting(const ir::Property& property, Obligation& out) {
    const std::string name = names_.unique_name("MS_" + flatten_name(property.name));
    out.preparation.push_back(b::instance(name, "model_shifting", {joint_alphabet(property)}));
    emitted_.provenance.events[name + "::ref"] = {MeaningKind::refusal, "refusal of", {}, {}};
    emitted_.provenance.events[name + "::tick"] = {MeaningKind::terminate, "termination", {}, {}};
    return name;
}

/// Writes one side of a refinement. `X refines Y` is `Y [M= X`. `equals` is the refinement in both directions, and its
/// negation means that one of them fails. In the tick-tock model, traces are compared after model shifting. A
/// simulation has no `endexec` and no `terminate`, so these events are hidden in the process with which the simulation
/// is compared.
ExprPtr Asserter::compared(const ir::ComponentRef& ref, const ir::ComponentRef& other,
                           const ir::Property& property) const {
    const ExprPtr process = process_of(ref, property, "D__");
    const ComponentEmission* component = find_component(ref);
    if (other.kind != ir::ComponentKind::simulation || component == nullptr) return process;
    b::Exprs hidden;
    for (const char* event : {"endexec", "terminate"})
        if (std::ranges::find(component->visible, event) != component->visible.end())
            hidden.push_back(b::name(path_of(ref) + "::" + event));
    // a hidden termination has priority over time
    return hidden.empty() ? process : maximal_progress(project_, b::hide(process, b::productions(hidden)));
}

void Asserter::add_refinement(const ir::Property& property, Obligation& out) {
    ExprPtr subject =
        renamed_to(property.subject, property.other, compared(property.subject, property.other, property));
    ExprPtr other = compared(property.other, property.subject, property);
    cspm::Model model = model_of(property.model);
    if (property.model == ir::PropertyModel::tick_tock) {
        const std::string shifted = model_shifting(property, out) + "::TT";
        subject = b::call(shifted, {subject});
        other = b::call(shifted, {other});
        model = cspm::Model::traces;
    }
    out.assertions.push_back(b::assert_refines(other, model, subject, property.negated));
    if (property.kind != PropertyKind::equals) return;
    out.assertions.push_back(b::assert_refines(subject, model, other, property.negated));
    out.one_suffices = property.negated;
    if (property.negated) out.reason = "each of the two refines the other";
}

/// Writes `S is reachable`: not `SKIP [T= P |\ {| S::entered |}`, that is, `entered` of S is in a trace of P.
/// RoboTool's assertion uses VS_O__. This one uses VS__, the same process before compression, so that a counterexample
/// shows every step.
std::vector<DeclPtr> Asserter::assert_reachability(const ir::Property& property) const {
    const ExprPtr entered = b::name(path_of(property.subject) + "::" + property.state + "::entered");
    const ExprPtr only = b::project(process_of(property.subject, property, "VS__"), b::productions({entered}));
    return {never_performs(only, !property.negated)};
}

/// Writes `clock C is initialised`: no guard reads C before its first reset, and some run resets it. With an
/// instrumented copy W of the machine (clock_initialisation.cpp):
///     SKIP [T= W |\ {unset__}   and   not SKIP [T= W |\ {reset__}.
void Asserter::add_initialisation(const ir::Property& property, Obligation& out) {
    const WatchedCopy watch =
        clock_watch(project_, names_, emitted_, path_of(property.subject), property.state, flatten_name(property.name));
    out.preparation.push_back(watch.module);
    const b::Exprs given = process_arguments(property.subject, property);
    if (watch.reads > 0) out.assertions.push_back(never_performs(watch.only_event("unset__", given), property.negated));
    out.assertions.push_back(never_performs(watch.only_event("reset__", given), !property.negated));
    out.one_suffices = property.negated;
    out.reason = property.negated ? "every read of it follows a reset" : "no run resets it";
}

/// Writes `event E is missed in S for n time units`: while the machine is in S, n consecutive time units can pass in
/// which E is never offered. The platform accepts calls, outputs and writes at once. `is not missed` is
/// SKIP [T= M |\ {missed__} (see `missing`).
void Asserter::missed_event(const ir::Property& property, Obligation& out) {
    const ir::Node* state = nullptr;
    for (const ir::Node& node : find_component(property.subject)->machine->nodes)
        if (!property.state.empty() && node.path == property.state) state = &node;
    const WatchedCopy watch = offer_watch(project_, names_, emitted_, path_of(property.subject), property.event, state,
                                          flatten_name(property.name));
    out.preparation.push_back(watch.module);
    const std::string times =
        property.time_units == 1 ? "1 time unit" : fmt::format("{} time units", property.time_units);
    const std::string missed = fmt::format("{} is missed for {}", property.event, times);
    for (const char* const mark : {"inside__", "outside__", "refused__"})
        emitted_.provenance.events[watch.event_of_copy(mark)] = {
            MeaningKind::memory, "the watch of " + property.event, {}, {}};
    emitted_.provenance.events[watch.event_of_copy("missed__")] = {MeaningKind::transition, missed, {}, {}};
    const std::string name = names_.unique_name("Misses_" + flatten_name(property.name));
    out.assertions = {
        never_performs(missing_process(watch, emitted_, property.event, property.time_units,
                                       process_arguments(property.subject, property), name, out.preparation),
                       !property.negated)};
    if (property.negated)
        out.reason = fmt::format("no transition takes {} for {} (`robochart-verify explain RC-K09` lists remedies)",
                                 property.event, times);
}

/// Returns the reason why the property cannot be checked in its semantic model, or "" if it can be checked.
std::string Asserter::unavailable_model(const ir::Property& property) const {
    const bool binary = property.kind == PropertyKind::refines || property.kind == PropertyKind::equals;
    const bool of_traces = property.kind == PropertyKind::reachable ||
                           property.kind == PropertyKind::clock_initialised ||
                           property.kind == PropertyKind::event_missed;
    if (property.model == ir::PropertyModel::failures_divergences || of_traces) return "";
    if (binary && property.model != ir::PropertyModel::tick_tock) return "";
    if (binary && !timed()) return "the tick-tock model is about time";
    if (binary) {
        const std::string missing = missing_alphabet(property.subject, property.other);
        return missing.empty() ? missing_alphabet(property.other, property.subject) : missing;
    }
    if (property.model == ir::PropertyModel::traces) return "traces do not record refusals and divergences";
    if (property.kind == PropertyKind::divergence_free)
        return "divergence is visible only in the failures-divergences model";
    if (property.model == ir::PropertyModel::tick_tock && property.kind != PropertyKind::timelock_free)
        return "the tick-tock model decides only refinements and timelocks";
    if (property.kind == PropertyKind::deadlock_free && timed())
        return "a deadlock in time is visible only in the failures-divergences model";
    return "";
}

bool Asserter::runs_in_cycles(const ir::ComponentRef& ref) const {
    const ComponentEmission* component = find_component(ref);
    return component != nullptr && ref.kind != ir::ComponentKind::simulation &&
           std::ranges::any_of(component->visible, [](const std::string& channel) {
               return channel == "endexec" || channel.starts_with("registerRead.") ||
                      channel.starts_with("registerWrite.");
           });
}

/// Returns the reason why a RoboSim component has no process, or "" if it has one. Reasons are a cycle without a
/// length, and an operation that is checked separately and has inputs, which only a cycle reads.
std::string Asserter::open_registers(const ir::ComponentRef& ref, const ir::Property& property) const {
    const ComponentEmission* component = find_component(ref);
    if (component == nullptr) return "";
    if (ref.kind == ir::ComponentKind::operation && component->machine->robosim)
        return component->machine->inputs.empty()
                   ? ""
                   : ref.path + " alone has no cycle, which would read its inputs: claim it of a machine that calls it";
    for (const ConstantParameter* constant : open_parameters(*component, open_cycles_))
        if (!find_argument({constant->parameter, constant->source, constant->value}, property))
            return missing_cycle(ref.path);
    return "";
}

/// Returns the reason why a property has no CSPM form here, or "" if it has one.
std::string Asserter::why_unavailable(const ir::Property& property) const {
    const bool binary = property.kind == PropertyKind::refines || property.kind == PropertyKind::equals;
    const bool component_only =
        property.kind == PropertyKind::reachable || property.kind == PropertyKind::clock_initialised;
    if (property.kind == PropertyKind::conforms) return "the rule is in SLEEC: `check` decides it";
    if (property.kind == PropertyKind::timelock_free && !timed()) return "time cannot stop in the untimed semantics";
    if (property.kind == PropertyKind::event_missed && !timed()) return "an event is missed while time passes";
    const auto missing = [&](const ir::ComponentRef& ref) {
        return ref.kind != ir::ComponentKind::process && find_component(ref) == nullptr;
    };
    if (missing(property.subject)) return property.subject.path + " was not emitted";
    if (binary && missing(property.other)) return property.other.path + " was not emitted";
    const bool watched =
        property.kind == PropertyKind::clock_initialised || property.kind == PropertyKind::event_missed;
    if (watched && runs_in_cycles(property.subject)) return "this is decided of RoboChart machines only";
    for (const ir::ComponentRef* ref : {&property.subject, &property.other})
        if (const std::string open = open_registers(*ref, property); !open.empty()) return open;
    if (component_only && property.subject.kind == ir::ComponentKind::process)
        return "only components of the model have states to reach and clocks to reset";
    if (property.kind == PropertyKind::clock_initialised && find_component(property.subject)->machine == nullptr)
        return "clocks belong to machines and operations";
    return unavailable_model(property);
}

void Asserter::add_assertions(const ir::Property& property, Obligation& out) {
    const auto subject = [&] { return process_of(property.subject, property, "D__"); };
    // RoboTool leaves the model of process properties to FDR, whose default is failures-divergences.
    const cspm::Model model = property.model == ir::PropertyModel::failures ? cspm::Model::failures : cspm::Model::none;
    switch (property.kind) {
        case PropertyKind::deadlock_free:
            // the registers of other components may have too many values to list them
            out.assertions = {
                deadlock_free(subject(), timed(), model, property.negated,
                              runs_in_cycles(property.subject) ? alphabet_of(property.subject) : nullptr)};
            if (!property.negated && runs_in_cycles(property.subject))
                out.time_goes_on = RecurrenceQuestion{running_on(subject(), "tock"), b::productions({b::name("tock")})};
            break;
        case PropertyKind::divergence_free:
            out.assertions = assert_unary(AssertionKind::divergence_free, subject(), model, property.negated);
            break;
        case PropertyKind::deterministic:
            out.assertions = assert_unary(AssertionKind::deterministic, subject(), model, property.negated);
            break;
        case PropertyKind::timelock_free:
            out.assertions = {timelock_free(subject(), property.negated)};
            break;
        case PropertyKind::terminates:
            out.assertions = assert_termination(subject(), model, property.negated);
            break;
        case PropertyKind::refines:
        case PropertyKind::equals:
            add_refinement(property, out);
            break;
        case PropertyKind::reachable:
            out.assertions = assert_reachability(property);
            break;
        case PropertyKind::clock_initialised:
            add_initialisation(property, out);
            break;
        case PropertyKind::event_missed:
            missed_event(property, out);
            break;
        case PropertyKind::schedulable:
            out.assertions = assert_unary(AssertionKind::deadlock_free, process_of(property.subject, property, "TLF"),
                                          cspm::Model::failures, property.negated);
            break;
        case PropertyKind::conforms:
            break;
    }
}

Obligation Asserter::make_obligation(std::uint32_t index) {
    const ir::Property& property = project_.system.properties[index];
    Obligation result;
    result.property = index;
    result.time = project_.time;
    result.title = property.name + (timed() ? " [timed] " : " [untimed] ") + wording_of(property);
    result.reason = why_unavailable(property);
    report_unused(property);
    result.kind = property.kind;
    result.negated = property.negated;
    if (!result.reason.empty()) return result;
    add_assertions(property, result);
    if (result.reason.empty()) result.reason = opposite_claim(property);
    return result;
}

}  // namespace

std::set<std::string> open_cycles(const ir::System& system) {
    std::set<std::string> result;
    for (const ir::NamedConstant& constant : ir::named_constants(system))
        if (ir::is_cycle_name(constant.name) && !constant.has_value) result.insert(constant.name);
    return result;
}

std::vector<const ConstantParameter*> open_parameters(const ComponentEmission& component,
                                                      const std::set<std::string>& open_cycles) {
    std::vector<const ConstantParameter*> result;
    for (const ConstantParameter& constant : component.constants)
        if (constant.constant == ir::cycle_length &&
            open_cycles.contains(constant.source.empty() ? constant.value : constant.source))
            result.push_back(&constant);
    return result;
}

std::string missing_cycle(const std::string& component) {
    return component + " has no cycleDef, so its cycles have no length: add `cycleDef cycle == 1`";
}

ExprPtr default_process(const Project& project, const std::string& path, const ComponentEmission& component,
                        const std::string& variant) {
    return b::call(path + "::" + variant, default_arguments(project, component));
}

b::Exprs default_arguments(const Project& project, const ComponentEmission& component) {
    b::Exprs arguments{b::number(0)};
    for (const ArgumentParameter& parameter : component.arguments)
        arguments.push_back(default_literal(project, parameter.type));
    for (const ConstantParameter& constant : component.constants) arguments.push_back(b::name(constant.value));
    return arguments;
}

std::vector<Obligation> make_obligations(const Project& project, NameManager& names, Emitted& emitted) {
    Asserter asserter(project, names, emitted);
    std::vector<Obligation> result;
    for (std::uint32_t i = 0; i < project.system.properties.size(); ++i) {
        const ir::Property& property = project.system.properties[i];
        if (project.is_timed() ? property.timed : property.untimed) result.push_back(asserter.make_obligation(i));
    }
    return result;
}

}  // namespace robochart::csp_emit
