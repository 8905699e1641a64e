// SPDX-License-Identifier: Apache-2.0
// Lowers the variables, constants, events, clocks and operations of a context: its own and those of its interfaces.
#include <algorithm>
#include <map>

#include "semantics/lower/machines.hpp"
#include "semantics/lower/types.hpp"
#include "semantics/rules.hpp"

namespace robochart::ir {
namespace {

namespace ast = frontend;

template <class T, class IdType>
void map_declaration(const std::vector<T>& items, ByDeclaration<IdType>& map, const ast::Declaration& declaration) {
    map[&declaration] = IdType{static_cast<std::uint32_t>(items.size() - 1)};
}

/// Collects the declarations of one context. Initial values are lowered at the end, when all names are known.
class Collector {
public:
    Collector(Lowering& lowering, const ast::Context& context) : lowering_(lowering), context_(context) {}

    Declarations collect_declarations(const std::string& path, const std::vector<ast::VariablePtr>* parameters);

private:
    void add_members(const ast::Context& owner, const std::string& element, const ast::InterfaceClause* clause);
    void add_interface(const ast::InterfaceClause& clause);
    void add_variable(const ast::Variable& source, const std::string& element, const ast::InterfaceClause* clause);
    void add_parameter(const ast::Variable& source, const std::string& element);
    void add_event(const ast::Event& source, const std::string& element, const std::string& interface);
    void add_clock(const ast::Clock& source, const std::string& element, const ast::InterfaceClause* clause);
    void add_operation(const ast::OperationSignature& source, const std::string& element, const std::string& interface);
    void initial_values();
    template <class Item>
    void check_names(const std::vector<Item>& items, const std::string& kind);
    [[nodiscard]] bool owns_variables() const;
    [[nodiscard]] VariableScope scope_of(const ast::InterfaceClause* clause) const;

    Lowering& lowering_;
    const ast::Context& context_;
    Declarations result_;
    std::vector<const ast::Variable*> variable_sources_;
    std::vector<const ast::Variable*> constant_sources_;
    std::vector<const ast::Declaration*> seen_;
};

std::string name_of(const ast::InterfaceClause* clause) {
    return clause == nullptr || clause->target == nullptr ? "" : clause->target->name;
}

/// True for a machine or an operation: the variables that it declares are part of its process.
bool Collector::owns_variables() const {
    return context_.kind == ast::DeclKind::state_machine || context_.kind == ast::DeclKind::operation;
}

/// Returns the scope of a clause's variables. Machines and controllers share the variables that they require. A
/// platform shares those that it provides (semantics 3.7).
VariableScope Collector::scope_of(const ast::InterfaceClause* clause) const {
    if (clause == nullptr) return VariableScope::local;
    const bool platform = context_.kind == ast::DeclKind::platform;
    const auto shared = platform ? ast::InterfaceUse::provides : ast::InterfaceUse::requires_;
    return clause->use == shared ? VariableScope::required : VariableScope::local;
}

void Collector::add_variable(const ast::Variable& source, const std::string& element,
                             const ast::InterfaceClause* clause) {
    const Origin origin = origin_of(element + "::" + source.name, source.span);
    const TypeId type = lower_type(lowering_, source.type, source.span);
    if (source.kind == ast::DeclKind::constant) {
        const bool required = clause != nullptr && clause->use == ast::InterfaceUse::requires_;
        result_.constants.push_back({source.name, type, nullptr, required, name_of(clause), origin});
        constant_sources_.push_back(&source);
        map_declaration(result_.constants, result_.names.constants, source);
        return;
    }
    result_.variables.push_back({source.name, type, scope_of(clause), nullptr, name_of(clause), origin});
    variable_sources_.push_back(&source);
    map_declaration(result_.variables, result_.names.variables, source);
}

void Collector::add_parameter(const ast::Variable& source, const std::string& element) {
    const TypeId type = lower_type(lowering_, source.type, source.span);
    result_.variables.push_back({source.name, type, VariableScope::parameter, nullptr, "",
                                 origin_of(element + "::" + source.name, source.span)});
    variable_sources_.push_back(&source);
    map_declaration(result_.variables, result_.names.variables, source);
}

void Collector::add_event(const ast::Event& source, const std::string& element, const std::string& interface) {
    Event event;
    event.name = source.name;
    if (source.type_expr || source.type) event.type = lower_type(lowering_, source.type, source.span);
    event.broadcast = source.broadcast;
    event.interface = interface;
    event.origin = origin_of(element + "::" + source.name, source.span);
    result_.events.push_back(std::move(event));
    map_declaration(result_.events, result_.names.events, source);
}

void Collector::add_clock(const ast::Clock& source, const std::string& element, const ast::InterfaceClause* clause) {
    const bool required = clause != nullptr && clause->use == ast::InterfaceUse::requires_;
    result_.clocks.push_back(
        {source.name, {}, required, name_of(clause), origin_of(element + "::" + source.name, source.span)});
    map_declaration(result_.clocks, result_.names.clocks, source);
}

/// Adds an operation. Identical declarations in several interfaces are one operation.
void Collector::add_operation(const ast::OperationSignature& source, const std::string& element,
                              const std::string& interface) {
    OperationSignature signature;
    signature.name = source.name;
    for (const auto& item : source.parameters) {
        signature.parameter_names.push_back(item->name);
        signature.parameters.push_back(lower_type(lowering_, item->type, item->span));
    }
    signature.terminates = source.terminates;
    signature.interface = interface;
    signature.origin = origin_of(element + "::" + source.name, source.span);
    for (std::size_t i = 0; i < result_.operations.size(); ++i) {
        const OperationSignature& known = result_.operations[i];
        if (known.name != signature.name || known.parameters != signature.parameters ||
            known.terminates != signature.terminates)
            continue;
        result_.names.operations[&source] = OperationId{static_cast<std::uint32_t>(i)};
        return;
    }
    result_.operations.push_back(std::move(signature));
    map_declaration(result_.operations, result_.names.operations, source);
}

void Collector::add_members(const ast::Context& owner, const std::string& element, const ast::InterfaceClause* clause) {
    const std::string interface = name_of(clause);
    for (const auto& item : owner.variables) add_variable(*item, element, clause);
    for (const auto& item : owner.events) add_event(*item, element, interface);
    for (const auto& item : owner.clocks) add_clock(*item, element, clause);
    for (const auto& item : owner.signatures) add_operation(*item, element, interface);
}

void Collector::add_interface(const ast::InterfaceClause& clause) {
    if (clause.target == nullptr || clause.target->kind != ast::DeclKind::interface)
        return lowering_.report_unresolved("interface '" + clause.name.text() + "'", clause.name.span);
    if (std::ranges::find(seen_, clause.target) != seen_.end()) return;
    seen_.push_back(clause.target);
    result_.interfaces.push_back(clause.target->name);
    add_members(static_cast<const ast::Context&>(*clause.target), clause.target->name, &clause);
}

void Collector::initial_values() {
    for (std::size_t i = 0; i < constant_sources_.size(); ++i)
        if (const auto& value = constant_sources_[i]->initial)
            result_.constants[i].value = lower_expression(lowering_, result_.names, *value, result_.constants[i].type);
    for (std::size_t i = 0; i < variable_sources_.size(); ++i)
        if (const auto& value = variable_sources_[i]->initial)
            result_.variables[i].initial =
                lower_expression(lowering_, result_.names, *value, result_.variables[i].type);
}

/// Reports members with the same name, because names identify them. Variables that the machine itself declares are
/// excepted, because no other component refers to them.
template <class Item>
void Collector::check_names(const std::vector<Item>& items, const std::string& kind) {
    std::map<std::string, diagnostics::Span> named;
    for (const Item& item : items) {
        if constexpr (requires { item.scope; })
            if (item.scope != VariableScope::required && owns_variables()) continue;
        const auto [first, added] = named.try_emplace(item.name, item.origin.span);
        if (!added)
            lowering_.diagnostics.report(rules::declared_twice, item.origin.span, {context_.name, kind, item.name})
                .notes.push_back({first->second, "the first one"});
    }
}

Declarations Collector::collect_declarations(const std::string& path, const std::vector<ast::VariablePtr>* parameters) {
    if (parameters != nullptr)
        for (const auto& item : *parameters) add_parameter(*item, path);
    add_members(context_, path, nullptr);
    for (const auto& clause : context_.interfaces) add_interface(clause);
    initial_values();
    check_names(result_.events, "event");
    check_names(result_.clocks, "clock");
    check_names(result_.operations, "operation");
    check_names(result_.constants, "constant");
    check_names(result_.variables, "shared variable");
    return std::move(result_);
}

}  // namespace

Declarations lower_declarations(Lowering& lowering, const ast::Context& context, const std::string& path,
                                const std::vector<ast::VariablePtr>* parameters) {
    return Collector(lowering, context).collect_declarations(path, parameters);
}

}  // namespace robochart::ir
