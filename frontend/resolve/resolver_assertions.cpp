// SPDX-License-Identifier: Apache-2.0
// Resolves assertions and csp blocks (assertion language 4). Component names are paths through references, such as
// `Module::controller_ref::machine_ref::State`. If a CSP block and a component have the same name, the name refers to
// the block.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "base/diagnostics/containers.hpp"
#include "base/diagnostics/scanner.hpp"
#include "base/diagnostics/spelling.hpp"
#include "frontend/resolve/component_paths.hpp"
#include "frontend/resolve/resolver.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::frontend {

namespace {

const Kinds other_kinds = {DeclKind::interface,   DeclKind::platform, DeclKind::primitive_type,
                           DeclKind::record_type, DeclKind::function, DeclKind::enumeration};

/// Collects every path from a component down to a machine.
void add_instances(const ComponentPath& above, const Machine& machine, std::vector<ComponentPath>& found) {
    if (follow_reference(above.steps.back()) == &machine) return found.push_back(above);
    const auto* component = follow_to<Component>(above.steps.back());
    if (component == nullptr) return;
    for (const Declaration* part : component->order) {
        if (!is_component(part)) continue;
        ComponentPath below = above;
        below.steps.push_back(part);
        add_instances(below, machine, found);
    }
}

class AssertionResolver {
public:
    AssertionResolver(Model& model, Finder& finder, Typer& typer) : model_(model), finder_(finder), typer_(typer) {}

    void run(File& file);

private:
    void resolve_simulation(Simulation& simulation);
    void resolve_assertion(Assertion& assertion);
    void check_dialect(const ComponentPath& path, const QualifiedName& name);
    void check_block(const CspBlock& block);
    void check_hidden(const CspBlock& block, std::size_t end, std::string_view event);
    void resolve_reachable(Assertion& assertion);
    bool find_state(Assertion& assertion);
    void resolve_clock(Assertion& assertion);
    void missed_event(Assertion& assertion);
    void unknown_place(const Assertion& assertion, const Way& way);
    void resolve_parameter(AssertionParameter& parameter);
    [[nodiscard]] const Variable* find_constant(const AssertionParameter& parameter, const Declaration& context);
    void check_value(AssertionParameter& parameter);
    void report_repeated(const Assertion& assertion);
    void report_open(const Assertion& assertion, const ComponentPath& path, const QualifiedName& name);

    [[nodiscard]] Way way_to(const QualifiedName& name) const {
        return component_way(model_, finder_.names(), *file_, name);
    }
    [[nodiscard]] const CspBlock* find_process(const std::string& name) const;
    ComponentPath find_component(const QualifiedName& name, bool processes);
    ComponentPath find_context(const QualifiedName& name);
    void report_unknown(const QualifiedName& name, const Way& way);
    void unknown_part(const QualifiedName& name, const Way& way);
    [[nodiscard]] std::vector<std::string> known_names() const;

    Model& model_;
    Finder& finder_;
    Typer& typer_;
    const File* file_ = nullptr;
    std::set<const Declaration*> reported_open_;  ///< RC-Q08 is reported once for each component of a file
};

// ---------------------------------------------------------------- paths

/// Returns the block of this name in the same file or, if there is none, in another file. Names of blocks are local to
/// a file, so several files may have one of this name.
const CspBlock* AssertionResolver::find_process(const std::string& name) const {
    const auto in = [&](const File& file) {
        const auto found =
            std::ranges::find_if(file.csp_blocks, [&](const CspBlock& block) { return block.name == name; });
        return found == file.csp_blocks.end() ? nullptr : &*found;
    };
    if (const CspBlock* block = in(*file_)) return block;
    for (const auto& file : model_.files)
        if (const CspBlock* block = in(*file)) return block;
    return nullptr;
}

ComponentPath AssertionResolver::find_component(const QualifiedName& name, bool processes) {
    if (processes)
        if (const CspBlock* block = find_process(name.text())) return {{}, block};
    Way found = way_to(name);
    if (found.used == name.parts.size()) return std::move(found.path);
    report_unknown(name, found);
    return {};
}

/// Returns the component to which a constant belongs. A platform is represented by its module.
ComponentPath AssertionResolver::find_context(const QualifiedName& name) {
    Way found = way_to(name);
    const bool all_but_one = found.used + 1 == name.parts.size() && found.used > 0;
    if (all_but_one && platform_of(found.end(), name.parts.back()) != nullptr) return std::move(found.path);
    return find_component(name, false);
}

// ---------------------------------------------------------------- missing names

std::vector<std::string> AssertionResolver::known_names() const {
    std::vector<std::string> names = finder_.candidate_names(component_kinds);
    for (const auto& file : model_.files)
        for (const CspBlock& block : file->csp_blocks)
            if (!block.name.starts_with('?')) names.push_back(block.name);  // generated for a block without a name
    return names;
}

/// Lists the existing names for a message. The result is empty if there are too many.
std::string list_alternatives(std::vector<std::string> names) {
    constexpr std::size_t most = 6;
    diagnostics::sort_unique(names);
    if (names.empty() || names.size() > most) return "";
    return fmt::format("; there are {}", fmt::join(names, ", "));
}

void AssertionResolver::report_unknown(const QualifiedName& name, const Way& way) {
    if (way.used > 0) return unknown_part(name, way);
    if (const Declaration* other = finder_.names().find({file_, nullptr}, name, other_kinds)) {
        finder_.out()
            .report(rules::not_a_component, name.span, {name.text(), std::string(to_text(other->kind))})
            .notes.push_back({other->name_span, "it is declared here"});
        return;
    }
    // The first part after the package is the wrong one.
    std::size_t wrong = 0;
    for (std::size_t parts = 1; parts < std::min(name.parts.size(), finder_.names().most_parts() + 1); ++parts)
        if (finder_.names().has_package(first_parts(name, parts).text())) wrong = parts;
    const std::string meant = diagnostics::nearest_spelling(name.parts[wrong], known_names());
    auto& finding = finder_.out().report(
        rules::unknown_component, name.span,
        {"component or csp process", name.text(), meant.empty() ? list_alternatives(known_names()) : std::string()});
    for (const auto& file : model_.files)
        for (const CspBlock& block : file->csp_blocks)
            if (name.parts.size() == 1 && !block.name.starts_with('?') && defines_name(block, name.text()))
                finding.notes.push_back(
                    {block.name_span, fmt::format("the csp block `{}` defines it, but an assertion must name a block "
                                                  "that defines a process with its own name",
                                                  block.name)});
    if (!meant.empty()) finding.fixes.push_back({name.spans[wrong], meant, diagnostics::suggestion_verb(false)});
}

void AssertionResolver::unknown_part(const QualifiedName& name, const Way& way) {
    const Declaration* behind = follow_reference(way.end());
    if (const auto* machine = dynamic_cast<const Machine*>(behind))
        if (const State* state = state_at(*machine, name, way.used)) {
            finder_.out()
                .report(rules::not_a_component, name.span, {name.text(), std::string(to_text(state->kind))})
                .notes.push_back({state->name_span, "it is declared here"});
            return;
        }
    const std::string where = fmt::format(" in {} `{}`", to_text(behind->kind), behind->name);
    auto& finding = finder_.out().report(rules::unknown_component, name.span, {"part", name.parts[way.used], where});
    std::vector<std::string> candidates;
    if (const auto* component = dynamic_cast<const Component*>(behind))
        for (const Declaration* part : component->order)
            if (is_component(part)) candidates.push_back(part->name);
    const std::string meant = diagnostics::nearest_spelling(name.parts[way.used], candidates);
    if (!meant.empty()) finding.fixes.push_back({name.spans[way.used], meant, diagnostics::suggestion_verb(false)});
    finding.notes.push_back({behind->name_span, fmt::format("`{}` is declared here", behind->name)});
}

// ---------------------------------------------------------------- states and clocks

/// Finds the state of an assertion. Its name may be relative to the subject, a full path through the subject, or a path
/// through the definition of one of the subject's components.
bool AssertionResolver::find_state(Assertion& assertion) {
    const QualifiedName& name = assertion.other;
    const auto take = [&](const ComponentPath& path, std::size_t used) {
        const auto* machine = follow_to<Machine>(path.steps.back());
        if (machine == nullptr) return false;
        assertion.state = state_at(*machine, name, used);
        if (assertion.state != nullptr) assertion.other_path = path;
        return assertion.state != nullptr;
    };
    const ComponentPath& subject = assertion.subject_path;
    const Way relative = walk_components({subject, 0, 0}, name, 0);
    if (take(relative.path, relative.used)) return true;
    const Way absolute = way_to(name);
    if (absolute.end() == nullptr) return false;
    const auto& steps = absolute.path.steps;
    const bool through_subject =
        steps.size() >= subject.steps.size() && std::equal(subject.steps.begin(), subject.steps.end(), steps.begin());
    if (through_subject) return take(absolute.path, absolute.used);
    const auto* machine = follow_to<Machine>(absolute.end());
    std::vector<ComponentPath> instances;
    if (machine != nullptr) add_instances(subject, *machine, instances);
    return instances.size() == 1 && take(instances.front(), absolute.used);
}

/// Collects the full paths of the states with this name in the machines of a component.
void add_states_below(const Declaration* component, const std::string& name, const std::string& above,
                      std::vector<std::string>& paths) {
    if (const auto* machine = follow_to<Machine>(component))
        return collect_paths_of(*machine, name, above + "::", paths);
    const auto* around = follow_to<Component>(component);
    if (around == nullptr) return;
    for (const Declaration* part : around->order)
        if (is_component(part)) add_states_below(part, name, above + "::" + part->name, paths);
}

/// Suggests the path of the only state with this name, or a similar name.
void suggest_state(const Machine& machine, const QualifiedName& name, diagnostics::Diagnostic& finding) {
    std::vector<std::string> paths;
    collect_paths_of(machine, name.parts.back(), "", paths);
    std::string meant = paths.size() == 1 ? paths.front() : "";
    if (meant == name.parts.back()) meant.clear();
    std::vector<std::string> names;
    collect_states(machine, names);
    if (meant.empty() && paths.empty()) meant = diagnostics::nearest_spelling(name.parts.back(), names);
    if (!meant.empty()) finding.fixes.push_back({name.spans.back(), meant, diagnostics::suggestion_verb(false)});
}

void AssertionResolver::resolve_reachable(Assertion& assertion) {
    if (assertion.subject_path.process != nullptr) {
        finder_.out().report(rules::no_state, assertion.other.span,
                             {assertion.other.text(), assertion.subject.text(), ", which is a csp process"});
        return;
    }
    if (assertion.subject_path.steps.empty() || find_state(assertion)) return;
    auto& finding = finder_.out().report(rules::no_state, assertion.other.span,
                                         {assertion.other.text(), assertion.subject.text(), ""});
    if (const auto* machine = follow_to<Machine>(assertion.subject_path.steps.back()))
        return suggest_state(*machine, assertion.other, finding);
    std::vector<std::string> paths;
    add_states_below(assertion.subject_path.steps.back(), assertion.other.parts.back(), assertion.subject.text(),
                     paths);
    if (paths.size() == 1)
        finding.fixes.push_back({assertion.other.span, paths.front(), diagnostics::suggestion_verb(false)});
}

/// Resolves `clock X::S::C is initialised`.
void AssertionResolver::resolve_clock(Assertion& assertion) {
    const QualifiedName& name = assertion.other;
    const Way found = way_to(name);
    const auto* machine = follow_to<Machine>(found.end());
    std::vector<std::string> candidates;
    if (machine != nullptr && found.used + 1 == name.parts.size()) {
        const Scope scope = scope_of(*machine);
        const auto clock = scope.clocks.find(name.parts.back());
        if (clock != scope.clocks.end()) {
            assertion.other_path = found.path;
            assertion.clock = clock->second;
            return;
        }
        candidates = finder_.keys_of(scope.clocks);
    }
    auto& finding = finder_.out().report(rules::no_clock, name.span, {name.text()});
    const std::string meant = diagnostics::nearest_spelling(name.parts.back(), candidates);
    if (!meant.empty()) finding.fixes.push_back({name.spans.back(), meant, diagnostics::suggestion_verb(false)});
}

/// Reports that the name after `in` is neither a machine nor a state of one.
void AssertionResolver::unknown_place(const Assertion& assertion, const Way& way) {
    const QualifiedName& name = assertion.other;
    if (way.used == 0) return report_unknown(name, way);
    const Declaration* behind = follow_reference(way.end());
    const auto* machine = dynamic_cast<const Machine*>(behind);
    if (machine == nullptr) {
        const std::string kind(to_text(behind->kind));
        finder_.out().report(rules::missed_where, name.span,
                             {fmt::format("a state machine or one of its states; `{}` is a {}", name.text(), kind)});
        return;
    }
    auto& finding = finder_.out().report(rules::no_state, name.span, {name.text(), machine->name, ""});
    suggest_state(*machine, name, finding);
}

/// Resolves `event E is missed in S`. S is the path of a machine or of one of its states, and E is an event of the
/// machine.
void AssertionResolver::missed_event(Assertion& assertion) {
    const QualifiedName& name = assertion.other;
    const Way found = way_to(name);
    const auto* machine = follow_to<Machine>(found.end());
    if (machine != nullptr && found.used < name.parts.size()) assertion.state = state_at(*machine, name, found.used);
    if (machine == nullptr || (found.used < name.parts.size() && assertion.state == nullptr))
        return unknown_place(assertion, found);
    assertion.other_path = found.path;
    constexpr std::int64_t most_units = 1'000'000;
    if (assertion.time_units && (*assertion.time_units < 1 || *assertion.time_units > most_units))
        finder_.out().report(rules::missed_where, assertion.time_units_span,
                             {fmt::format("a number of time units from 1 to {}", most_units)});
    const Scope scope = scope_of(*machine);
    if (const auto event = scope.events.find(assertion.event.parts.back()); event != scope.events.end()) {
        assertion.missed = event->second;
        return;
    }
    const std::string text = assertion.event.text();
    auto& finding = finder_.out().report(rules::missed_where, assertion.event.span,
                                         {fmt::format("an event of `{}`, but `{}` is not one", machine->name, text)});
    const std::string meant = diagnostics::nearest_spelling(text, finder_.keys_of(scope.events));
    if (!meant.empty())
        finding.fixes.push_back({assertion.event.spans.back(), meant, diagnostics::suggestion_verb(false)});
}

// ---------------------------------------------------------------- constants

std::vector<const Variable*> constants_of(const Declaration& context) {
    std::vector<const Variable*> all;
    if (const auto* component = dynamic_cast<const Component*>(&context);
        component != nullptr && component->kind == DeclKind::module) {
        for (const Declaration* part : component->order)
            if (const auto* platform = follow_to<Context>(part);
                platform != nullptr && platform->kind == DeclKind::platform)
                for (const Variable* variable : offered_variables(*platform)) all.push_back(variable);
    } else if (const auto* owner = dynamic_cast<const Context*>(&context)) {
        all = visible_variables(*owner);
    }
    all.erase(std::remove_if(all.begin(), all.end(), [](const Variable* v) { return v->kind != DeclKind::constant; }),
              all.end());
    return all;
}

std::vector<const Variable*> parameters_of(const Declaration& context) {
    std::vector<const Variable*> all;
    if (const auto* operation = dynamic_cast<const Machine*>(&context))
        for (const auto& parameter : operation->parameters) all.push_back(parameter.get());
    return all;
}

const Variable* AssertionResolver::find_constant(const AssertionParameter& parameter, const Declaration& context) {
    std::vector<std::string> candidates;
    const bool constant = parameter.kind == ParameterKind::constant;
    for (const Variable* variable : constant ? constants_of(context) : parameters_of(context)) {
        if (variable->name == parameter.name.parts.back()) return variable;
        candidates.push_back(variable->name);
    }
    auto& finding = finder_.out().report(
        rules::no_constant, parameter.name.span,
        {std::string(to_text(context.kind)), context.name, constant ? "constant" : "parameter", parameter.name.text()});
    const std::string meant = diagnostics::nearest_spelling(parameter.name.parts.back(), candidates);
    if (!meant.empty())
        finding.fixes.push_back({parameter.name.spans.back(), meant, diagnostics::suggestion_verb(false)});
    finding.notes.push_back({context.name_span, fmt::format("`{}` is declared here", context.name)});
    return nullptr;
}

void AssertionResolver::check_value(AssertionParameter& parameter) {
    Surroundings around{{file_, nullptr}, nullptr, nullptr, nullptr, {}};
    const TypePtr given = typer_.assign_type(parameter.value, around);
    const auto* variable = static_cast<const Variable*>(parameter.target);
    if (variable == nullptr || !given || !variable->type || is_compatible(given, variable->type)) return;
    finder_.out()
        .report(rules::constant_type, parameter.value->span,
                {variable->name, to_string(variable->type), to_string(given)})
        .notes.push_back({variable->name_span, "it is declared here"});
}

void AssertionResolver::resolve_parameter(AssertionParameter& parameter) {
    parameter.target = nullptr;
    if (parameter.kind == ParameterKind::cycle) {
        parameter.context_path = find_component(parameter.context, false);
        check_dialect(parameter.context_path, parameter.context);
        return check_value(parameter);
    }
    parameter.context_path = find_context(parameter.context);
    if (!parameter.context_path.steps.empty())
        if (const Declaration* behind = follow_reference(parameter.context_path.steps.back()))
            parameter.target = find_constant(parameter, *behind);
    check_value(parameter);
}

void AssertionResolver::report_repeated(const Assertion& assertion) {
    for (std::size_t i = 0; i < assertion.parameters.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const AssertionParameter& first = assertion.parameters[j];
            const AssertionParameter& second = assertion.parameters[i];
            const bool cycles = first.kind == ParameterKind::cycle && second.kind == ParameterKind::cycle &&
                                !first.context_path.steps.empty();
            const bool same = ((second.target != nullptr && first.target == second.target) || cycles) &&
                              first.context_path.steps == second.context_path.steps;
            if (!same) continue;
            finder_.out()
                .report(rules::constant_twice, second.name.span, {second.name.text(), second.context.text()})
                .notes.push_back({first.name.span, "the first value is given here"});
            break;
        }
}

/// Reports constants that a controller or machine requires and that have no value.
void AssertionResolver::report_open(const Assertion& assertion, const ComponentPath& path, const QualifiedName& name) {
    const auto* definition = path.steps.size() == 1 ? dynamic_cast<const Context*>(path.steps.front()) : nullptr;
    const bool asks = definition != nullptr &&
                      (definition->kind == DeclKind::controller || definition->kind == DeclKind::state_machine);
    if (!asks) return;
    std::vector<const Variable*> open;
    for (const Variable* variable : required_variables(*definition)) {
        const bool given = std::ranges::any_of(assertion.parameters,
                                               [&](const auto& p) { return p.name.parts.back() == variable->name; });
        if (variable->kind == DeclKind::constant && !variable->initial && !given) open.push_back(variable);
    }
    if (open.empty() || !reported_open_.insert(definition).second) return;
    std::string names;
    for (const Variable* variable : open) names += (names.empty() ? "`" : ", `") + variable->name + "`";
    auto& finding =
        finder_.out().report(rules::constants_open, name.span, {definition->name, open.size() == 1 ? "" : "s", names});
    for (const Variable* variable : open)
        finding.notes.push_back({variable->name_span, fmt::format("`{}` is declared here", variable->name)});
}

// ---------------------------------------------------------------- assertions

/// Resolves a simulation. Its subject is a RoboChart component, even if a RoboSim component has the same name.
void AssertionResolver::resolve_simulation(Simulation& simulation) {
    Way found = component_way(model_, finder_.names(), *file_, simulation.subject, Dialect::robochart);
    if (found.used == simulation.subject.parts.size())
        simulation.subject_path = std::move(found.path);
    else
        report_unknown(simulation.subject, found);
    const CspBlock* const block = find_process(simulation.name);
    if (block != nullptr)
        finder_.out()
            .report(rules::simulation_name, simulation.name_span, {simulation.name, "csp block"})
            .notes.push_back({block->name_span, "the block is declared here"});
}

/// Reports a component of the other dialect. A claim in a RoboSim file cannot name a RoboChart component directly, but
/// it can name a simulation of this component.
void AssertionResolver::check_dialect(const ComponentPath& path, const QualifiedName& name) {
    const auto* component =
        path.steps.empty() ? nullptr : dynamic_cast<const Context*>(follow_reference(path.steps.back()));
    if (component == nullptr || component->kind == DeclKind::simulation || component->dialect == file_->dialect) return;
    const bool chart = component->dialect == Dialect::robochart;
    finder_.out()
        .report(rules::claim_dialect, name.span,
                {name.text(), std::string(to_text(component->kind)), std::string(to_text(component->dialect)),
                 std::string(to_text(file_->dialect)),
                 chart ? fmt::format("; write `simulation N of {} {{ cycleDef cycle == 1 }}` and claims about `N`",
                                     name.text())
                       : "; write it into a `.rsa` file"})
        .notes.push_back({component->name_span, "it is declared here"});
}

/// Reports `M::endexec` and `M::terminate` of modules and simulations, which hide these events.
void AssertionResolver::check_block(const CspBlock& block) {
    for (const std::string_view event : {"endexec", "terminate"}) {
        const std::string ending = "::" + std::string(event);
        for (std::size_t at = block.text.find(ending); at != std::string::npos; at = block.text.find(ending, at + 1)) {
            const std::size_t end = at + ending.size();
            const std::size_t line = block.text.rfind('\n', at) + 1;
            const bool comment = block.text.substr(line, at - line).find("--") != std::string::npos;
            if (!comment && (end >= block.text.size() || !diagnostics::continues_name(block.text[end])))
                check_hidden(block, at, event);
        }
    }
}

/// Reports an event that is hidden outside of the component. `end` is the offset at which the name of the component
/// ends.
void AssertionResolver::check_hidden(const CspBlock& block, std::size_t end, std::string_view event) {
    std::size_t begin = end;
    while (begin > 0 && (diagnostics::continues_name(block.text[begin - 1]) || block.text[begin - 1] == ':')) --begin;
    const std::string text = block.text.substr(begin, end - begin);
    QualifiedName name;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t next = std::min(text.find("::", at), text.size());
        name.parts.push_back(text.substr(at, next - at));
        name.spans.emplace_back();
        at = next + 2;
    }
    const Way found = way_to(name);
    if (found.used != name.parts.size() || found.end() == nullptr) return;
    const Declaration* component = follow_reference(found.end());
    if (component->kind != DeclKind::module && component->kind != DeclKind::simulation) return;
    const auto place = block.text_span.begin + static_cast<std::uint32_t>(begin);
    const auto length = static_cast<std::uint32_t>(text.size() + 2 + event.size());
    finder_.out()
        .report(rules::hidden_event, {block.text_span.source, place, place + length},
                {fmt::format("{}::{}", text, event), std::string(to_text(component->kind))})
        .notes.push_back({component->name_span, "it is declared here"});
}

void AssertionResolver::resolve_assertion(Assertion& assertion) {
    assertion.subject_path = {};
    assertion.other_path = {};
    assertion.state = nullptr;
    assertion.clock = nullptr;
    assertion.missed = nullptr;
    const bool binary = assertion.kind == AssertionKind::refines || assertion.kind == AssertionKind::equals;
    if (assertion.kind == AssertionKind::clock_initialised) {
        resolve_clock(assertion);
    } else if (assertion.kind == AssertionKind::event_missed) {
        missed_event(assertion);
    } else {
        assertion.subject_path = find_component(assertion.subject, assertion.kind != AssertionKind::conforms);
        if (assertion.kind == AssertionKind::reachable) resolve_reachable(assertion);
        if (binary) assertion.other_path = find_component(assertion.other, true);
        check_dialect(assertion.subject_path, assertion.subject);
        check_dialect(assertion.other_path, assertion.other);
        const auto& steps = assertion.subject_path.steps;
        const bool other =
            assertion.subject_path.process != nullptr || (!steps.empty() && steps.back()->kind != DeclKind::simulation);
        if (assertion.kind == AssertionKind::schedulable && other)
            finder_.out().report(rules::not_a_simulation, assertion.subject.span, {assertion.subject.text()});
    }
    for (AssertionParameter& item : assertion.parameters) resolve_parameter(item);
    report_repeated(assertion);
    report_open(assertion, assertion.subject_path, assertion.subject);
    if (binary) report_open(assertion, assertion.other_path, assertion.other);
}

void AssertionResolver::run(File& file) {
    file_ = &file;
    reported_open_.clear();
    for (auto& simulation : file.simulations) this->resolve_simulation(*simulation);
    for (CspBlock& block : file.csp_blocks) {
        block.associated_paths.clear();
        for (const QualifiedName& name : block.associated) block.associated_paths.push_back(find_component(name, true));
    }
    for (Assertion& assertion : file.assertions) this->resolve_assertion(assertion);
    if (file.dialect == Dialect::robosim)
        for (const CspBlock& block : file.csp_blocks) check_block(block);
}

}  // namespace

void resolve_assertions(Model& model, Finder& finder, Typer& typer) {
    AssertionResolver resolver(model, finder, typer);
    for (auto& file : model.files) resolver.run(*file);
}

}  // namespace robochart::frontend
