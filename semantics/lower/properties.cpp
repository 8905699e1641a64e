// SPDX-License-Identifier: Apache-2.0
// Lowers assertions and csp blocks (reference: assertion language 4). Name resolution has already found the components
// that they name.
#include "semantics/lower/properties.hpp"

#include <algorithm>
#include <map>

#include "base/diagnostics/text.hpp"
#include "semantics/ir/query.hpp"
#include "semantics/lower/expressions.hpp"
#include "semantics/lower/paths.hpp"
#include "semantics/lower/registers.hpp"
#include "semantics/rules.hpp"

namespace robochart::ir {
namespace {

namespace ast = frontend;

PropertyKind kind_of(ast::AssertionKind kind) {
    switch (kind) {
        case ast::AssertionKind::deadlock_free:
            return PropertyKind::deadlock_free;
        case ast::AssertionKind::divergence_free:
            return PropertyKind::divergence_free;
        case ast::AssertionKind::deterministic:
            return PropertyKind::deterministic;
        case ast::AssertionKind::timelock_free:
            return PropertyKind::timelock_free;
        case ast::AssertionKind::terminates:
            return PropertyKind::terminates;
        case ast::AssertionKind::refines:
            return PropertyKind::refines;
        case ast::AssertionKind::equals:
            return PropertyKind::equals;
        case ast::AssertionKind::reachable:
            return PropertyKind::reachable;
        case ast::AssertionKind::event_missed:
            return PropertyKind::event_missed;
        case ast::AssertionKind::conforms:
            return PropertyKind::conforms;
        case ast::AssertionKind::schedulable:
            return PropertyKind::schedulable;
        case ast::AssertionKind::clock_initialised:
            break;
    }
    return PropertyKind::clock_initialised;
}

PropertyModel model_of(const std::optional<ast::AssertionModel>& model) {
    switch (model.value_or(ast::AssertionModel::failures_divergences)) {
        case ast::AssertionModel::traces:
            return PropertyModel::traces;
        case ast::AssertionModel::failures:
            return PropertyModel::failures;
        case ast::AssertionModel::tick_tock:
            return PropertyModel::tick_tock;
        case ast::AssertionModel::failures_divergences:
            break;
    }
    return PropertyModel::failures_divergences;
}

/// Returns the text of the assertion in the source. The word `timed` or `untimed` may be before the assertion's span.
std::string wording_of(const diagnostics::SourceManager& sources, const ast::Assertion& source) {
    const auto text = sources.source_text(source.span.source);
    const std::string line =
        diagnostics::on_one_line(text.substr(source.span.begin, source.span.end - source.span.begin));
    const bool begins = line.starts_with("assertion") || line.starts_with("sleec");
    if (!begins || source.time == ast::AssertionTime::both) return line;
    return (source.time == ast::AssertionTime::timed ? "timed " : "untimed ") + line;
}

class Properties {
public:
    using Blocks = std::map<const ast::CspBlock*, std::uint32_t>;
    Properties(Lowering& lowering, const ast::File& file, Blocks& blocks)
        : lowering_(lowering), file_(file), blocks_(blocks) {}

    void lower_simulations();
    void lower_blocks();
    void lower_assertions();

private:
    void lower_assertion(const ast::Assertion& source);
    void lower_block(const ast::CspBlock& source);
    std::optional<FoundComponent> find_component(const ast::ComponentPath& path, const ast::QualifiedName& name);
    void lower_reachable(const ast::Assertion& source, Property& property);
    void lower_clock(const ast::Assertion& source, Property& property);
    void missed_event(const ast::Assertion& source, Property& property);
    void lower_parameter(const ast::AssertionParameter& source, Property& property);
    void lower_constant(const ast::AssertionParameter& source, const FoundComponent& context, Property& property);
    void operation_parameter(const ast::AssertionParameter& source, const FoundComponent& context, Property& property);
    void lower_cycle(const ast::AssertionParameter& source, Property& property);
    void lower_simulation(const ast::Simulation& source);
    ExprPtr lower_value(const ast::AssertionParameter& source, TypeId type);

    Lowering& lowering_;
    const ast::File& file_;
    Blocks& blocks_;  ///< index of each block in System::csp_blocks
};

/// Returns the component that name resolution found for a name, or the csp block.
std::optional<FoundComponent> Properties::find_component(const ast::ComponentPath& path,
                                                         const ast::QualifiedName& name) {
    if (path.process != nullptr) {
        FoundComponent process;
        process.ref.path = path.process->name;
        if (const auto at = blocks_.find(path.process); at != blocks_.end()) process.ref.definition = at->second;
        return process;
    }
    if (!path.steps.empty() && path.steps.front()->kind == ast::DeclKind::simulation) {
        FoundComponent simulation;
        const auto& all = lowering_.system.simulations;
        const auto at = std::ranges::find(all, path.steps.front()->name, &Simulation::name);
        simulation.ref = {ComponentKind::simulation, path.steps.front()->name, "",
                          static_cast<std::uint32_t>(at - all.begin())};
        return simulation;
    }
    auto found = component_at(lowering_, path);
    if (!found) lowering_.report_unresolved(name.text(), name.span);
    return found;
}

/// Returns the path of a node from the top of its machine.
std::string node_path(const ast::State& state) {
    std::string path = state.name;
    for (const auto* above = dynamic_cast<const ast::State*>(state.parent); above != nullptr;
         above = dynamic_cast<const ast::State*>(above->parent))
        path = above->name + "::" + path;
    return path;
}

/// Sets the path of the state relative to the subject: from the subject to the machine, then the node's path.
void Properties::lower_reachable(const ast::Assertion& source, Property& property) {
    const auto machine = find_component(source.other_path, source.other);
    if (!machine || source.state == nullptr) return;
    const std::string& above = property.subject.path;
    const std::string& at = machine->ref.path;
    const std::string way = at.size() > above.size() ? at.substr(above.size() + 2) + "::" : "";
    property.state = way + node_path(*source.state);
}

/// Lowers `clock X::S::C is initialised`. The subject is the machine at the end of the path.
void Properties::lower_clock(const ast::Assertion& source, Property& property) {
    const auto machine = find_component(source.other_path, source.other);
    if (!machine || source.clock == nullptr) return;
    property.subject = machine->ref;
    property.state = source.clock->name;
}

/// Lowers `event E is missed in S`. The subject is the machine.
void Properties::missed_event(const ast::Assertion& source, Property& property) {
    const auto machine = find_component(source.other_path, source.other);
    if (!machine || source.missed == nullptr) return;
    property.subject = machine->ref;
    property.event = source.missed->name;
    if (source.state != nullptr) property.state = node_path(*source.state);
    property.time_units = source.time_units.value_or(1);
}

ExprPtr Properties::lower_value(const ast::AssertionParameter& source, TypeId type) {
    if (source.value) return lower_expression(lowering_, {}, *source.value, type);
    lowering_.report_unresolved("the value of " + source.name.text(), source.name.span);
    return make_boolean(true, source.name.span);
}

template <class Declaration>
std::optional<std::uint32_t> position_of(const std::vector<Declaration>& items, const std::string& name) {
    for (std::uint32_t i = 0; i < items.size(); ++i)
        if (items[i].name == name) return i;
    return std::nullopt;
}

/// Returns the constants of the innermost component.
const std::vector<Constant>& constants_of(const FoundComponent& context) {
    if (context.machine != nullptr) return context.machine->constants;
    if (context.controller != nullptr) return context.controller->constants;
    return context.module->platform.constants;
}

/// Gives a value to the constant. Its name is that of the process parameter of the component that determines its value.
void Properties::lower_constant(const ast::AssertionParameter& source, const FoundComponent& context,
                                Property& property) {
    const std::vector<Constant>& constants = constants_of(context);
    const auto at = position_of(constants, source.name.parts.back());
    if (!at) return lowering_.report_unresolved(source.name.text(), source.name.span);
    std::string name = constant_name(context.ref.package, context.ref.path, source.name.parts.back());
    if (context.machine != nullptr)
        name = constant_source(lowering_.system, context.module, context.controller, context.part, *context.machine,
                               ConstantId{*at})
                   .name;
    else if (context.controller != nullptr)
        name = constant_source(context.module, *context.controller, ConstantId{*at}).name;
    property.constants.emplace_back(name, lower_value(source, constants[*at].type));
}

/// Gives a value to a parameter (`parameter p of O`). Its name begins with "param_" instead of "const_".
void Properties::operation_parameter(const ast::AssertionParameter& source, const FoundComponent& context,
                                     Property& property) {
    const bool operation = context.machine != nullptr && context.machine->kind == MachineKind::operation;
    const auto at = operation ? position_of(context.machine->variables, source.name.parts.back()) : std::nullopt;
    if (!at || context.machine->variables[*at].scope != VariableScope::parameter)
        return lowering_.report_unresolved(source.name.text(), source.name.span);
    const std::string path =
        context.controller != nullptr ? context.controller->path + "::" + context.part : context.machine->path;
    std::string name = constant_name(context.ref.package, path, source.name.parts.back());
    name.replace(0, std::string("const_").size(), "param_");
    property.constants.emplace_back(name, lower_value(source, context.machine->variables[*at].type));
}

/// Lowers `cycleDef of X set to n`. The name is that of the constant of X itself.
void Properties::lower_cycle(const ast::AssertionParameter& source, Property& property) {
    const auto context = find_component(source.context_path, source.context);
    if (!context || !source.value) return;
    const ExprPtr length = lower_cycle_length(lowering_, {}, *source.value);
    if (length->kind == ExprKind::integer && length->number <= 0)
        return lowering_.report_unsupported("a cycle of " + std::to_string(length->number) + " time units",
                                            source.value->span);
    property.constants.emplace_back(constant_name(context->ref.package, context->ref.path, cycle_length), length);
}

void Properties::lower_parameter(const ast::AssertionParameter& source, Property& property) {
    if (source.kind == ast::ParameterKind::cycle) return lower_cycle(source, property);
    const auto context = find_component(source.context_path, source.context);
    if (!context) return;
    if (source.kind == ast::ParameterKind::constant)
        lower_constant(source, *context, property);
    else
        operation_parameter(source, *context, property);
}

void Properties::lower_assertion(const ast::Assertion& source) {
    Property property;
    property.name = source.name;
    property.kind = kind_of(source.kind);
    property.negated = source.negated;
    property.timed = source.time != ast::AssertionTime::untimed;
    // RoboSim has only the timed semantics
    property.untimed = source.time != ast::AssertionTime::timed && file_.dialect == ast::Dialect::robochart;
    property.model = model_of(source.model);
    property.file = lowering_.sources.path(file_.source);
    property.wording = wording_of(lowering_.sources, source);
    property.origin = origin_of(source.name, source.span);
    if (property.kind == PropertyKind::clock_initialised) {
        lower_clock(source, property);
    } else if (property.kind == PropertyKind::event_missed) {
        missed_event(source, property);
    } else if (const auto subject = find_component(source.subject_path, source.subject)) {
        property.subject = subject->ref;
        if (property.kind == PropertyKind::reachable) lower_reachable(source, property);
        if (property.kind == PropertyKind::conforms) property.rule = source.other.text();
    }
    if (property.kind == PropertyKind::refines || property.kind == PropertyKind::equals)
        if (const auto other = find_component(source.other_path, source.other)) property.other = other->ref;
    for (const auto& item : source.parameters) lower_parameter(item, property);
    if (property.kind == PropertyKind::conforms && file_.dialect == ast::Dialect::robosim)
        lowering_.diagnostics.report(rules::robosim_unsupported, source.span,
                                     {"a rule of SLEEC about RoboSim", "claim it of the RoboChart model"});
    lowering_.system.properties.push_back(std::move(property));
}

void Properties::lower_block(const ast::CspBlock& source) {
    CspBlock block;
    block.name = source.name;
    block.timed = source.time != ast::AssertionTime::untimed;
    block.untimed = source.time != ast::AssertionTime::timed && file_.dialect == ast::Dialect::robochart;
    for (std::size_t i = 0; i < source.associated_paths.size(); ++i)
        if (const auto found = find_component(source.associated_paths[i], source.associated[i]))
            block.associated.push_back(found->ref);
    block.text = source.text;
    block.text_span = source.text_span;
    block.file = lowering_.sources.path(file_.source);
    blocks_[&source] = static_cast<std::uint32_t>(lowering_.system.csp_blocks.size());
    lowering_.system.csp_blocks.push_back(std::move(block));
}

/// Returns the names of the members of a context.
std::vector<std::string> names_in(const ast::Context* registers) {
    std::vector<std::string> result;
    const auto add = [&](const ast::Context& owner, bool events) {
        for (const auto& event : owner.events)
            if (events) result.push_back(event->name);
        for (const auto& variable : owner.variables)
            if (variable->kind == ast::DeclKind::variable) result.push_back(variable->name);
        for (const auto& operation : owner.signatures) result.push_back(operation->name);
    };
    if (registers == nullptr) return result;
    add(*registers, true);
    const bool input = registers->kind == ast::DeclKind::input_context;
    for (const ast::InterfaceClause& clause : registers->interfaces)
        if (const auto* interface = dynamic_cast<const ast::Context*>(clause.target))
            add(*interface, !input || clause.use == ast::InterfaceUse::uses);
    return result;
}

void Properties::lower_simulation(const ast::Simulation& source) {
    const auto subject = find_component(source.subject_path, source.subject);
    if (!subject) return;
    for (const Simulation& known : lowering_.system.simulations)
        if (known.name == source.name) {
            lowering_.diagnostics
                .report(rules::declared_twice, source.name_span, {"the project", "simulation", source.name})
                .notes.push_back({known.origin.span, "the first one"});
            return;
        }
    Simulation simulation;
    simulation.name = source.name;
    simulation.subject = subject->ref;
    simulation.cycle = cycle_constant(lowering_, {}, source, false);
    simulation.inputs = names_in(source.input.get());
    simulation.outputs = names_in(source.output.get());
    simulation.origin = origin_of(source.name, source.name_span);
    lowering_.system.simulations.push_back(std::move(simulation));
}

void Properties::lower_simulations() {
    for (const auto& simulation : file_.simulations) this->lower_simulation(*simulation);
}

void Properties::lower_blocks() {
    for (const auto& block : file_.csp_blocks) this->lower_block(block);
}

void Properties::lower_assertions() {
    for (const auto& assertion : file_.assertions) this->lower_assertion(assertion);
}

}  // namespace

namespace {

/// Reports RC-S19 for a claim that sets a constant in only one of several instances from which an operation requires
/// the constant.
void check_shared_constants(const Lowering& lowering) {
    const std::vector<SharedConstant> all = shared_constants(lowering.system);
    for (const Property& property : lowering.system.properties)
        for (const SharedConstant& shared : all)
            for (const auto& [name, value] : property.constants)
                if (std::ranges::find(shared.sources, name, &ConstantSource::name) != shared.sources.end())
                    lowering.diagnostics.report(
                        rules::ambiguous_constant, property.origin.span,
                        {shared.operation->name, shared.constant, shared.controller->name, shared.source_names()});
}

}  // namespace

void lower_properties(Lowering& lowering) {
    Properties::Blocks blocks;
    for (const auto* file : lowering.files) Properties(lowering, *file, blocks).lower_simulations();
    for (const auto* file : lowering.files) Properties(lowering, *file, blocks).lower_blocks();
    for (const auto* file : lowering.files) Properties(lowering, *file, blocks).lower_assertions();
    check_shared_constants(lowering);
}

}  // namespace robochart::ir
