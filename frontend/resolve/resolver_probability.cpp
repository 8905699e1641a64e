// SPDX-License-Identifier: Apache-2.0
// Names in probabilistic assertions: states, variables, constants and events of the model by their paths, literals, and
// definitions of assertion files. A definition is looked up in the same file first, then in all others.
#include <algorithm>
#include <functional>

#include "frontend/resolve/component_paths.hpp"
#include "frontend/resolve/resolver.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::frontend {

namespace {

/// The declaration that a name refers to, with the candidates that were possible in its place.
struct Found {
    const Declaration* target = nullptr;
    std::string where;
    std::vector<std::string> candidates;
    bool unknowable = false;  ///< inside a construct that is not resolved
};

/// A machine or state, with its inner states.
struct Region {
    const Declaration* declaration = nullptr;
    const NodeContainer* nodes = nullptr;
};

template <class Items>
Found among(const Items& items, const std::string& name, std::string where) {
    Found found{nullptr, std::move(where), {}, false};
    for (const auto& item : items) {
        if (item->name == name && found.target == nullptr) found.target = &*item;
        found.candidates.push_back(item->name);
    }
    return found;
}

std::string inside(const Declaration& declaration) {
    return "in `" + declaration.name + "`";
}

class ProbabilityResolver {
public:
    ProbabilityResolver(Model& model, Finder& finder, Typer& typer) : model_(model), finder_(finder), typer_(typer) {}

    void run(File& file);

private:
    void definition(ProbabilisticDefinition& definition);
    void function(ProbabilisticFunction& function);
    void module(ProbabilisticModule& module);
    void updates(std::vector<Update>& updates);
    void clause(const ProbabilisticClause& clause);
    void expression(const ExprPtr& expr);
    void resolve(Expr& expr);
    void value(Expr& expr);
    void event(Expr& expr);
    void in_state(Expr& expr);
    void marked(Expr& expr);
    void defined(const QualifiedName& name, ProbabilisticKind kind, std::string_view what);
    const Declaration* module_variable(const QualifiedName& name);

    [[nodiscard]] Found member(const QualifiedName& name, bool events) const;
    [[nodiscard]] const Declaration* literal(const QualifiedName& name) const;
    [[nodiscard]] Found constant(const QualifiedName& name) const;
    [[nodiscard]] Region region(const QualifiedName& name) const;
    /// Calls `visit` for every definition of the kind; those of the same file come first.
    void each_definition(ProbabilisticKind kind,
                         const std::function<void(const ProbabilisticDefinition&)>& visit) const;
    [[nodiscard]] Way way(const QualifiedName& name) const {
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

/// A variable, constant or event of a component: the last part of a path. The path may lead through the platform of a
/// module.
Found ProbabilityResolver::member(const QualifiedName& name, bool events) const {
    const Way found = way(name);
    const std::size_t left = name.parts.size() - found.used;
    if (found.used == 0) return {nullptr, "that is visible here", finder_.candidates(component_kinds), false};
    const auto* owner = followed<Context>(found.end());
    if (owner == nullptr || left == 0) return {nullptr, "", {}, owner == nullptr};
    const Context* platform = platform_of(found.end(), name.parts[found.used]);
    if (platform != nullptr && left == 2) {
        if (events) return among(visible_events(*platform), name.parts.back(), inside(*platform));
        return among(offered_variables(*platform), name.parts.back(), inside(*platform));
    }
    const auto* machine = dynamic_cast<const Machine*>(owner);
    if (left > 1) return {nullptr, inside(*owner), {}, machine != nullptr};
    if (events) return among(visible_events(*owner), name.parts.back(), inside(*owner));
    std::vector<const Variable*> variables = visible_variables(*owner);
    if (machine != nullptr)
        for (const VariablePtr& parameter : machine->parameters) variables.push_back(parameter.get());
    return among(variables, name.parts.back(), inside(*owner));
}

/// `E::l`; the enumeration may be in any package.
const Declaration* ProbabilityResolver::literal(const QualifiedName& name) const {
    const Kinds literals = {DeclKind::enum_literal};
    if (const Declaration* found = finder_.names().find({file_, nullptr}, name, literals)) return found;
    if (name.parts.size() < 2) return nullptr;
    const Declaration* type = finder_.names().anywhere(name.parts[name.parts.size() - 2], Kinds{DeclKind::enumeration});
    const auto* enumeration = dynamic_cast<const TypeDeclaration*>(type);
    return enumeration != nullptr ? among(enumeration->literals, name.parts.back(), "").target : nullptr;
}

/// `const t : T` of an assertion file.
Found ProbabilityResolver::constant(const QualifiedName& name) const {
    std::vector<const Variable*> constants;
    each_definition(ProbabilisticKind::constant, [&](const ProbabilisticDefinition& each) {
        if (each.constant) constants.push_back(each.constant.get());
    });
    return among(constants, name.parts.back(), "in the assertion files");
}

/// The machine or state that a name refers to.
Region ProbabilityResolver::region(const QualifiedName& name) const {
    const Way found = way(name);
    const auto* machine = found.used > 0 ? followed<Machine>(found.end()) : nullptr;
    if (machine == nullptr || found.used == name.parts.size()) return {machine, machine};
    const State* state = state_at(*machine, name, found.used);
    return {state, state};
}

// ---------------------------------------------------------------- names

/// Resolves a name to a variable, constant or literal of the model, a constant of an assertion file, or one of the
/// labels `deadlock` and `init`.
void ProbabilityResolver::value(Expr& expr) {
    const QualifiedName& name = expr.name;
    const bool simple = name.parts.size() == 1;
    if (simple && (name.parts.front() == "deadlock" || name.parts.front() == "init")) return;
    if (!simple) {
        Found found = member(name, false);
        expr.target = found.target != nullptr ? found.target : literal(name);
        if (expr.target != nullptr || found.unknowable) return;
        const Declaration* type =
            finder_.names().anywhere(name.parts[name.parts.size() - 2], Kinds{DeclKind::enumeration});
        if (const auto* enumeration = dynamic_cast<const TypeDeclaration*>(type))
            found = among(enumeration->literals, name.parts.back(), inside(*enumeration));
        const bool package = finder_.names().has_package(first_parts(name, name.parts.size() - 1).text());
        if (package) found = constant(name);
        expr.target = found.target;
        if (expr.target == nullptr)
            finder_.unknown(name, "variable, constant or literal", found.where, found.candidates);
        return;
    }
    const Found found = constant(name);
    expr.target = found.target;
    if (expr.target == nullptr) finder_.unknown(name, "constant", found.where, found.candidates);
}

void ProbabilityResolver::event(Expr& expr) {
    const Found found = member(expr.name, true);
    expr.target = found.target;
    if (expr.target == nullptr && !found.unknowable && expr.name.parts.size() > 1)
        finder_.unknown(expr.name, "event", found.where, found.candidates);
}

/// `M is in S`: S is a full path, or a path relative to M.
void ProbabilityResolver::in_state(Expr& expr) {
    const Region machine = region(expr.name);
    Expr& state = *expr.args.front();
    state.target = nullptr;
    if (machine.nodes == nullptr) {
        finder_.unknown(expr.name, "state machine", "that is visible here", finder_.candidates(component_kinds));
        return;
    }
    expr.target = machine.declaration;
    state.target = state_at(*machine.nodes, state.name, 0);
    if (state.target == nullptr) state.target = region(state.name).declaration;
    if (state.target != nullptr && state.target->kind == DeclKind::state_machine) state.target = nullptr;
    if (state.target != nullptr) return;
    std::vector<std::string> candidates;
    collect_states(*machine.nodes, candidates);
    finder_.unknown(state.name, "state", inside(*expr.target), candidates);
}

/// Resolves a definition of assertion files; an unknown name is reported.
void ProbabilityResolver::defined(const QualifiedName& name, ProbabilisticKind kind, std::string_view what) {
    std::vector<std::string> candidates;
    each_definition(kind, [&](const ProbabilisticDefinition& each) { candidates.push_back(each.name); });
    if (std::ranges::find(candidates, name.parts.back()) == candidates.end())
        finder_.unknown(name, what, "in the assertion files", candidates);
}

/// `@x` of the enclosing module, `@M::N::x` or `@N::x`.
const Declaration* ProbabilityResolver::module_variable(const QualifiedName& name) {
    std::vector<const Variable*> variables;
    const auto add = [&](const ProbabilisticModule& module) {
        for (const ModuleVariable& each : module.variables) variables.push_back(each.variable.get());
    };
    const std::size_t parts = name.parts.size();
    if (parts == 1 && module_ != nullptr) add(*module_);
    each_definition(ProbabilisticKind::modules, [&](const ProbabilisticDefinition& each) {
        for (const ProbabilisticModule& module : each.modules) {
            const bool fits =
                parts > 1 && module.name == name.parts[parts - 2] && (parts == 2 || each.name == name.parts[parts - 3]);
            if (fits || (parts == 1 && module_ == nullptr)) add(module);
        }
    });
    const Found found = among(variables, name.parts.back(), "in the modules of the assertion files");
    if (found.target == nullptr) finder_.unknown(name, "variable", found.where, found.candidates);
    return found.target;
}

void ProbabilityResolver::marked(Expr& expr) {
    if (expr.text == "#") return defined(expr.name, ProbabilisticKind::label, "label");
    if (expr.text == "$") return defined(expr.name, ProbabilisticKind::formula, "formula");
    if (expr.text == "@") {
        expr.target = module_variable(expr.name);
        return;
    }
    if (expr.text == "$$") {
        const Found found = function_ != nullptr
                                ? among(function_->parameters, expr.name.parts.back(), "in `" + function_->name + "`")
                                : Found{nullptr, "outside a function", {}, false};
        expr.target = found.target;
        if (expr.target == nullptr) finder_.unknown(expr.name, "parameter", found.where, found.candidates);
        return;
    }
    std::vector<std::string> functions;
    each_definition(ProbabilisticKind::definitions, [&](const ProbabilisticDefinition& each) {
        for (const ProbabilisticFunction& function : each.functions) functions.push_back(function.name);
    });
    if (std::ranges::find(functions, expr.name.parts.back()) == functions.end())
        finder_.unknown(expr.name, "function", "in the assertion files", functions);
}

void ProbabilityResolver::resolve(Expr& expr) {
    expr.target = nullptr;
    switch (expr.kind) {
        case ExprKind::name:
            return value(expr);
        case ExprKind::event:
            return event(expr);
        case ExprKind::in_state:
            return in_state(expr);
        case ExprKind::marked:
            return marked(expr);
        case ExprKind::reward:
            if (!expr.name.empty()) defined(expr.name, ProbabilisticKind::rewards, "reward structure");
            return;
        default:
            return;
    }
}

void ProbabilityResolver::expression(const ExprPtr& expr) {
    if (!expr) return;
    resolve(*expr);
    if (expr->kind == ExprKind::in_state) return;
    expression(expr->callee);
    for (const Binding& binding : expr->bindings) expression(binding.value);
    for (const ExprPtr& arg : expr->args) expression(arg);
}

// ---------------------------------------------------------------- definitions and assertions

void ProbabilityResolver::updates(std::vector<Update>& updates) {
    for (Update& update : updates) {
        expression(update.probability);
        if (update.variable && update.variable->kind == ExprKind::marked) expression(update.variable);
        expression(update.value);
    }
}

void ProbabilityResolver::function(ProbabilisticFunction& function) {
    function_ = &function;
    expression(function.result);
    updates(function.updates);
    function_ = nullptr;
}

void ProbabilityResolver::module(ProbabilisticModule& module) {
    module_ = &module;
    for (ModuleVariable& each : module.variables)
        for (const ExprPtr* part : {&each.low, &each.high, &each.variable->initial}) expression(*part);
    for (Command& command : module.commands) {
        if (command.event && command.event->kind == ExprKind::event) expression(command.event);
        expression(command.guard);
        updates(command.updates);
    }
    module_ = nullptr;
}

void ProbabilityResolver::definition(ProbabilisticDefinition& definition) {
    Surroundings around{{file_, nullptr}, nullptr, nullptr, nullptr, {}};
    if (definition.constant && definition.constant->type_expr)
        definition.constant->type = typer_.type(*definition.constant->type_expr, around);
    expression(definition.value);
    for (ConstantValues& each : definition.constants) {
        expression(each.constant);
        expression(each.value);
    }
    for (RewardItem& item : definition.rewards) {
        if (item.event && item.event->kind == ExprKind::event) expression(item.event);
        expression(item.guard);
        expression(item.value);
    }
    for (ProbabilisticFunction& each : definition.functions) function(each);
    for (ProbabilisticModule& each : definition.modules) module(each);
}

void ProbabilityResolver::clause(const ProbabilisticClause& clause) {
    const ProbabilisticKind kind = clause.definition.kind;
    const std::string_view what = kind == ProbabilisticKind::constants     ? "set of constants"
                                  : kind == ProbabilisticKind::definitions ? "set of definitions"
                                                                           : "set of modules";
    if (!clause.name.empty()) defined(clause.name, kind, what);
}

void ProbabilityResolver::run(File& file) {
    file_ = &file;
    for (ProbabilisticDefinition& each : file.probabilistic_definitions)
        if (!each.broken) definition(each);
    for (ProbabilisticAssertion& each : file.probabilistic_assertions) {
        if (each.broken) continue;
        for (ProbabilisticClause& part : each.clauses) {
            clause(part);
            definition(part.definition);
        }
        expression(each.property);
        for (const ExprPtr* part : {&each.path.steps, &each.path.repeats, &each.path.limit}) expression(*part);
    }
}

}  // namespace

void resolve_probabilistic(Model& model, Finder& finder, Typer& typer) {
    ProbabilityResolver resolver(model, finder, typer);
    for (auto& file : model.files) resolver.run(*file);
}

}  // namespace robochart::frontend
