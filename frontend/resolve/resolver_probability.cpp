// SPDX-License-Identifier: Apache-2.0
// Resolves the names in probabilistic assertions: paths of states, variables, constants and events of the model,
// literals, and definitions of assertion files. A definition is looked up in the same file first, then in all others.
#include <algorithm>
#include <functional>

#include "frontend/resolve/component_paths.hpp"
#include "frontend/resolve/resolver.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::frontend {

namespace {

/// The declaration that a name refers to, with the names that would have been possible.
struct Found {
    const Declaration* target = nullptr;
    std::string where;
    std::vector<std::string> candidates;
    bool unknowable = false;  ///< true for a name inside a construct that is not resolved
};

/// A machine or state, with its inner states.
struct Region {
    const Declaration* declaration = nullptr;
    const NodeContainer* nodes = nullptr;
};

template <class Items>
Found find_among(const Items& items, const std::string& name, std::string where) {
    Found found{nullptr, std::move(where), {}, false};
    for (const auto& item : items) {
        if (item->name == name && found.target == nullptr) found.target = &*item;
        found.candidates.push_back(item->name);
    }
    return found;
}

std::string place_inside(const Declaration& declaration) {
    return "in `" + declaration.name + "`";
}

class ProbabilityResolver {
public:
    ProbabilityResolver(Model& model, Finder& finder, Typer& typer) : model_(model), finder_(finder), typer_(typer) {}

    void run(File& file);

private:
    void resolve_definition(ProbabilisticDefinition& definition);
    void resolve_function(ProbabilisticFunction& function);
    void resolve_module(ProbabilisticModule& module);
    void resolve_updates(std::vector<Update>& updates);
    void resolve_clause(const ProbabilisticClause& clause);
    void resolve_expression(const ExprPtr& expr);
    void resolve(Expr& expr);
    void resolve_value(Expr& expr);
    void resolve_event(Expr& expr);
    void in_state(Expr& expr);
    void resolve_marked_name(Expr& expr);
    void resolve_definition_name(const QualifiedName& name, ProbabilisticKind kind, std::string_view what);
    const Declaration* module_variable(const QualifiedName& name);

    [[nodiscard]] Found find_member(const QualifiedName& name, bool events) const;
    [[nodiscard]] const Declaration* find_literal(const QualifiedName& name) const;
    [[nodiscard]] Found find_constant(const QualifiedName& name) const;
    [[nodiscard]] Region find_region(const QualifiedName& name) const;
    /// Calls `visit` for every definition of the kind, first for those of the same file.
    void each_definition(ProbabilisticKind kind,
                         const std::function<void(const ProbabilisticDefinition&)>& visit) const;
    [[nodiscard]] Way way_to(const QualifiedName& name) const {
        return component_way(model_, finder_.names(), *file_, name);
    }

    Model& model_;
    Finder& finder_;
    Typer& typer_;
    const File* file_ = nullptr;
    const ProbabilisticModule* module_ = nullptr;      ///< the module that is being resolved
    const ProbabilisticFunction* function_ = nullptr;  ///< the function that is being resolved
};

// ---------------------------------------------------------------- looking up

void ProbabilityResolver::each_definition(ProbabilisticKind kind,
                                          const std::function<void(const ProbabilisticDefinition&)>& visit) const {
    const auto of = [&](const File& file) {
        for (const ProbabilisticDefinition& definition : file.probabilistic_definitions)
            if (definition.kind == kind) visit(definition);
        for (const ProbabilisticAssertion& assertion : file.probabilistic_assertions)
            for (const ProbabilisticClause& clause : assertion.clauses)
                if (clause.definition.kind == kind) visit(clause.definition);
    };
    of(*file_);
    for (const auto& file : model_.files)
        if (file.get() != file_) of(*file);
}

/// Returns the variable, constant or event of a component that the last part of the path names. The path may lead
/// through the platform of a module.
Found ProbabilityResolver::find_member(const QualifiedName& name, bool events) const {
    const Way found = way_to(name);
    const std::size_t left = name.parts.size() - found.used;
    if (found.used == 0) return {nullptr, "that is visible here", finder_.candidate_names(component_kinds), false};
    const auto* owner = follow_to<Context>(found.end());
    if (owner == nullptr || left == 0) return {nullptr, "", {}, owner == nullptr};
    const Context* platform = platform_of(found.end(), name.parts[found.used]);
    if (platform != nullptr && left == 2) {
        if (events) return find_among(visible_events(*platform), name.parts.back(), place_inside(*platform));
        return find_among(offered_variables(*platform), name.parts.back(), place_inside(*platform));
    }
    const auto* machine = dynamic_cast<const Machine*>(owner);
    if (left > 1) return {nullptr, place_inside(*owner), {}, machine != nullptr};
    if (events) return find_among(visible_events(*owner), name.parts.back(), place_inside(*owner));
    std::vector<const Variable*> variables = visible_variables(*owner);
    if (machine != nullptr)
        for (const VariablePtr& parameter : machine->parameters) variables.push_back(parameter.get());
    return find_among(variables, name.parts.back(), place_inside(*owner));
}

/// Returns the literal for `E::l`. The enumeration E may be in any package.
const Declaration* ProbabilityResolver::find_literal(const QualifiedName& name) const {
    const Kinds literals = {DeclKind::enum_literal};
    if (const Declaration* found = finder_.names().find({file_, nullptr}, name, literals)) return found;
    if (name.parts.size() < 2) return nullptr;
    const Declaration* type =
        finder_.names().find_anywhere(name.parts[name.parts.size() - 2], Kinds{DeclKind::enumeration});
    const auto* enumeration = dynamic_cast<const TypeDeclaration*>(type);
    return enumeration != nullptr ? find_among(enumeration->literals, name.parts.back(), "").target : nullptr;
}

/// Returns the constant that an assertion file declares with `const t : T`.
Found ProbabilityResolver::find_constant(const QualifiedName& name) const {
    std::vector<const Variable*> constants;
    each_definition(ProbabilisticKind::constant, [&](const ProbabilisticDefinition& definition) {
        if (definition.constant) constants.push_back(definition.constant.get());
    });
    return find_among(constants, name.parts.back(), "in the assertion files");
}

/// Returns the machine or state that a name refers to.
Region ProbabilityResolver::find_region(const QualifiedName& name) const {
    const Way found = way_to(name);
    const auto* machine = found.used > 0 ? follow_to<Machine>(found.end()) : nullptr;
    if (machine == nullptr || found.used == name.parts.size()) return {machine, machine};
    const State* state = state_at(*machine, name, found.used);
    return {state, state};
}

// ---------------------------------------------------------------- names

/// Resolves a name to a variable, constant or literal of the model, a constant of an assertion file, or one of the
/// labels `deadlock` and `init`.
void ProbabilityResolver::resolve_value(Expr& expr) {
    const QualifiedName& name = expr.name;
    const bool simple = name.parts.size() == 1;
    if (simple && (name.parts.front() == "deadlock" || name.parts.front() == "init")) return;
    if (!simple) {
        Found found = find_member(name, false);
        expr.target = found.target != nullptr ? found.target : find_literal(name);
        if (expr.target != nullptr || found.unknowable) return;
        const Declaration* type =
            finder_.names().find_anywhere(name.parts[name.parts.size() - 2], Kinds{DeclKind::enumeration});
        if (const auto* enumeration = dynamic_cast<const TypeDeclaration*>(type))
            found = find_among(enumeration->literals, name.parts.back(), place_inside(*enumeration));
        const bool package = finder_.names().has_package(first_parts(name, name.parts.size() - 1).text());
        if (package) found = find_constant(name);
        expr.target = found.target;
        if (expr.target == nullptr)
            finder_.report_unknown(name, "variable, constant or literal", found.where, found.candidates);
        return;
    }
    const Found found = find_constant(name);
    expr.target = found.target;
    if (expr.target == nullptr) finder_.report_unknown(name, "constant", found.where, found.candidates);
}

void ProbabilityResolver::resolve_event(Expr& expr) {
    const Found found = find_member(expr.name, true);
    expr.target = found.target;
    if (expr.target == nullptr && !found.unknowable && expr.name.parts.size() > 1)
        finder_.report_unknown(expr.name, "event", found.where, found.candidates);
}

/// Resolves `M is in S`. S is a full path, or a path relative to M.
void ProbabilityResolver::in_state(Expr& expr) {
    const Region machine = find_region(expr.name);
    Expr& state = *expr.args.front();
    state.target = nullptr;
    if (machine.nodes == nullptr) {
        finder_.report_unknown(expr.name, "state machine", "that is visible here",
                               finder_.candidate_names(component_kinds));
        return;
    }
    expr.target = machine.declaration;
    state.target = state_at(*machine.nodes, state.name, 0);
    if (state.target == nullptr) state.target = find_region(state.name).declaration;
    if (state.target != nullptr && state.target->kind == DeclKind::state_machine) state.target = nullptr;
    if (state.target != nullptr) return;
    std::vector<std::string> candidates;
    collect_states(*machine.nodes, candidates);
    finder_.report_unknown(state.name, "state", place_inside(*expr.target), candidates);
}

/// Resolves the name of a definition of assertion files, and reports an unknown name.
void ProbabilityResolver::resolve_definition_name(const QualifiedName& name, ProbabilisticKind kind,
                                                  std::string_view what) {
    std::vector<std::string> candidates;
    each_definition(kind, [&](const ProbabilisticDefinition& definition) { candidates.push_back(definition.name); });
    if (std::ranges::find(candidates, name.parts.back()) == candidates.end())
        finder_.report_unknown(name, what, "in the assertion files", candidates);
}

/// Returns the variable for `@M::N::x` or `@N::x`, or for `@x` of the enclosing module.
const Declaration* ProbabilityResolver::module_variable(const QualifiedName& name) {
    std::vector<const Variable*> variables;
    const auto add = [&](const ProbabilisticModule& module) {
        for (const ModuleVariable& declared : module.variables) variables.push_back(declared.variable.get());
    };
    const std::size_t parts = name.parts.size();
    if (parts == 1 && module_ != nullptr) add(*module_);
    each_definition(ProbabilisticKind::modules, [&](const ProbabilisticDefinition& definition) {
        for (const ProbabilisticModule& module : definition.modules) {
            const bool fits = parts > 1 && module.name == name.parts[parts - 2] &&
                              (parts == 2 || definition.name == name.parts[parts - 3]);
            if (fits || (parts == 1 && module_ == nullptr)) add(module);
        }
    });
    const Found found = find_among(variables, name.parts.back(), "in the modules of the assertion files");
    if (found.target == nullptr) finder_.report_unknown(name, "variable", found.where, found.candidates);
    return found.target;
}

void ProbabilityResolver::resolve_marked_name(Expr& expr) {
    if (expr.text == "#") return resolve_definition_name(expr.name, ProbabilisticKind::label, "label");
    if (expr.text == "$") return resolve_definition_name(expr.name, ProbabilisticKind::formula, "formula");
    if (expr.text == "@") {
        expr.target = module_variable(expr.name);
        return;
    }
    if (expr.text == "$$") {
        const Found found = function_ != nullptr ? find_among(function_->parameters, expr.name.parts.back(),
                                                              "in `" + function_->name + "`")
                                                 : Found{nullptr, "outside a function", {}, false};
        expr.target = found.target;
        if (expr.target == nullptr) finder_.report_unknown(expr.name, "parameter", found.where, found.candidates);
        return;
    }
    std::vector<std::string> functions;
    each_definition(ProbabilisticKind::definitions, [&](const ProbabilisticDefinition& definition) {
        for (const ProbabilisticFunction& function : definition.functions) functions.push_back(function.name);
    });
    if (std::ranges::find(functions, expr.name.parts.back()) == functions.end())
        finder_.report_unknown(expr.name, "function", "in the assertion files", functions);
}

void ProbabilityResolver::resolve(Expr& expr) {
    expr.target = nullptr;
    switch (expr.kind) {
        case ExprKind::name:
            return resolve_value(expr);
        case ExprKind::event:
            return resolve_event(expr);
        case ExprKind::in_state:
            return in_state(expr);
        case ExprKind::marked:
            return resolve_marked_name(expr);
        case ExprKind::reward:
            if (!expr.name.empty()) resolve_definition_name(expr.name, ProbabilisticKind::rewards, "reward structure");
            return;
        default:
            return;
    }
}

void ProbabilityResolver::resolve_expression(const ExprPtr& expr) {
    if (!expr) return;
    resolve(*expr);
    if (expr->kind == ExprKind::in_state) return;
    resolve_expression(expr->callee);
    for (const Binding& binding : expr->bindings) resolve_expression(binding.value);
    for (const ExprPtr& arg : expr->args) resolve_expression(arg);
}

// ---------------------------------------------------------------- definitions and assertions

void ProbabilityResolver::resolve_updates(std::vector<Update>& updates) {
    for (Update& update : updates) {
        resolve_expression(update.probability);
        if (update.variable && update.variable->kind == ExprKind::marked) resolve_expression(update.variable);
        resolve_expression(update.value);
    }
}

void ProbabilityResolver::resolve_function(ProbabilisticFunction& function) {
    function_ = &function;
    resolve_expression(function.result);
    resolve_updates(function.updates);
    function_ = nullptr;
}

void ProbabilityResolver::resolve_module(ProbabilisticModule& module) {
    module_ = &module;
    for (ModuleVariable& declared : module.variables)
        for (const ExprPtr* part : {&declared.low, &declared.high, &declared.variable->initial})
            resolve_expression(*part);
    for (Command& command : module.commands) {
        if (command.event && command.event->kind == ExprKind::event) resolve_expression(command.event);
        resolve_expression(command.guard);
        resolve_updates(command.updates);
    }
    module_ = nullptr;
}

void ProbabilityResolver::resolve_definition(ProbabilisticDefinition& definition) {
    Surroundings around{{file_, nullptr}, nullptr, nullptr, nullptr, {}};
    if (definition.constant && definition.constant->type_expr)
        definition.constant->type = typer_.assign_type(*definition.constant->type_expr, around);
    resolve_expression(definition.value);
    for (ConstantValues& setting : definition.constants) {
        resolve_expression(setting.constant);
        resolve_expression(setting.value);
    }
    for (RewardItem& item : definition.rewards) {
        if (item.event && item.event->kind == ExprKind::event) resolve_expression(item.event);
        resolve_expression(item.guard);
        resolve_expression(item.value);
    }
    for (ProbabilisticFunction& function : definition.functions) resolve_function(function);
    for (ProbabilisticModule& module : definition.modules) resolve_module(module);
}

void ProbabilityResolver::resolve_clause(const ProbabilisticClause& clause) {
    const ProbabilisticKind kind = clause.definition.kind;
    std::string_view what = "set of modules";
    if (kind == ProbabilisticKind::constants) what = "set of constants";
    if (kind == ProbabilisticKind::definitions) what = "set of definitions";
    if (!clause.name.empty()) resolve_definition_name(clause.name, kind, what);
}

void ProbabilityResolver::run(File& file) {
    file_ = &file;
    for (ProbabilisticDefinition& definition : file.probabilistic_definitions)
        if (!definition.broken) resolve_definition(definition);
    for (ProbabilisticAssertion& assertion : file.probabilistic_assertions) {
        if (assertion.broken) continue;
        for (ProbabilisticClause& part : assertion.clauses) {
            resolve_clause(part);
            resolve_definition(part.definition);
        }
        resolve_expression(assertion.property);
        for (const ExprPtr* part : {&assertion.path.steps, &assertion.path.repeats, &assertion.path.limit})
            resolve_expression(*part);
    }
}

}  // namespace

void resolve_probabilistic(Model& model, Finder& finder, Typer& typer) {
    ProbabilityResolver resolver(model, finder, typer);
    for (auto& file : model.files) resolver.run(*file);
}

}  // namespace robochart::frontend
