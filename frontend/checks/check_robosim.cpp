// SPDX-License-Identifier: Apache-2.0
// Checks the rules about RoboSim: contexts, cycles, members that operations require from their callers, and
// simulations. RoboTool's validator for RoboSim checks contexts and callers too. The other rules report models that
// have no meaning.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "frontend/checks/checks.hpp"
#include "frontend/names/scopes.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/expression_visitor.hpp"
#include "frontend/syntax/print.hpp"
#include "frontend/types/typer.hpp"

namespace robochart::frontend {

namespace {

// ---------------------------------------------------------------- contexts

/// Returns the kinds of members of an interface that an input or output context must not use, as a list, or "" if there
/// are none.
std::string unwanted_members(const Context& interface, bool input) {
    std::vector<std::string_view> kinds;
    if (!interface.variables.empty()) kinds.emplace_back("variables or constants");
    if (!interface.clocks.empty()) kinds.emplace_back("clocks");
    if (input && !interface.signatures.empty()) kinds.emplace_back("operations");
    return fmt::format("{}", fmt::join(kinds, " and "));
}

void check_used_interfaces(const Context& registers, Diagnostics& out) {
    const bool input = registers.kind == DeclKind::input_context;
    for (const InterfaceClause& clause : registers.interfaces) {
        const Context* const interface = interface_of(clause);
        if (interface == nullptr || clause.use != InterfaceUse::uses) continue;
        const std::string unwanted = unwanted_members(*interface, input);
        if (unwanted.empty()) continue;
        out.report(input ? rules::input_members : rules::output_members, clause.name.span, {interface->name, unwanted})
            .notes.push_back({interface->name_span, "the interface is declared here"});
    }
}

/// Checks that a machine or operation declares one context of each kind, even if the context is empty.
void check_contexts(const Context& owner, Diagnostics& out) {
    const bool needs = owner.kind == DeclKind::state_machine || owner.kind == DeclKind::operation;
    for (const auto& [registers, kind] : {std::pair(owner.input.get(), DeclKind::input_context),
                                          std::pair(owner.output.get(), DeclKind::output_context)}) {
        const std::string word(to_text(kind));
        if (registers != nullptr) check_used_interfaces(*registers, out);
        if (needs && registers == nullptr)
            out.report(rules::no_context, owner.name_span, {std::string(to_text(owner.kind)), owner.name, word, word});
        if (!needs && registers != nullptr && owner.kind != DeclKind::simulation)
            out.report(rules::misplaced_context, registers->name_span,
                       {std::string(to_text(owner.kind)), owner.name, word});
    }
}

// ---------------------------------------------------------------- cycles

bool is_cycle(const Expr& expr) {
    return strip_parentheses(expr).kind == ExprKind::cycle;
}

/// Returns the length e in `cycle == e`, `(cycle == e)`, `{ cycle == e }` or `e`.
const Expr& cycle_length(const Expr& written) {
    const Expr& expr = strip_parentheses(written);
    if (expr.kind == ExprKind::set && expr.args.size() == 1) return cycle_length(*expr.args[0]);
    if (expr.kind != ExprKind::binary || expr.binary != BinaryOp::equal) return expr;
    if (is_cycle(*expr.args[0])) return *expr.args[1];
    return is_cycle(*expr.args[1]) ? *expr.args[0] : expr;
}

void check_cycle_length(const Expr& length, Diagnostics& out) {
    const std::optional<double> value = constant_value(length);
    if (!value)
        out.report(rules::cycle_open, length.span, {});
    else if (!(*value > 0))
        out.report(rules::cycle_value, length.span, {fmt::format("{:g}", *value)});
}

void check_cycle(const Context& owner, Diagnostics& out) {
    const bool runs = owner.kind == DeclKind::state_machine || owner.kind == DeclKind::controller ||
                      owner.kind == DeclKind::module || owner.kind == DeclKind::simulation;
    if (owner.cycle && !runs)
        out.report(rules::misplaced_context, owner.cycle->span,
                   {std::string(to_text(owner.kind)), owner.name, "cycleDef"});
    if (owner.cycle && runs) check_cycle_length(cycle_length(*owner.cycle), out);
    // An inner component has the cycle of the component that contains it.
    const bool outermost = runs && owner.parent == nullptr && !owner.broken;
    if (outermost && !owner.cycle)
        out.report(rules::no_cycle, owner.name_span, {std::string(to_text(owner.kind)), owner.name});
}

// ---------------------------------------------------------------- registers of components

template <class Items>
void add_names(const Items& items, std::set<std::string>& names) {
    for (const auto* item : items) names.insert(item->name);
}

void add_scope(const Scope& scope, std::set<std::string>& names) {
    for (const auto& [name, event] : scope.events) names.emplace(name);
    for (const auto& [name, variable] : scope.variables)
        if (variable->kind == DeclKind::variable) names.emplace(name);
    for (const auto& [name, operation] : scope.operations) names.emplace(name);
}

/// Returns the names of the registers that a component shows. Those of a module belong to its platform.
std::set<std::string> register_names(const Declaration* component) {
    std::set<std::string> names;
    const auto* context = dynamic_cast<const Context*>(component);
    if (context == nullptr) return names;
    if (context->input || context->output) {
        const Registers registers = registers_of(*context);
        add_scope(registers.inputs, names);
        add_scope(registers.outputs, names);
    } else if (const auto* simulation = dynamic_cast<const Simulation*>(context)) {
        const auto& steps = simulation->subject_path.steps;
        if (!steps.empty()) return register_names(follow_reference(steps.back()));
    } else if (context->kind == DeclKind::module) {
        for (const Declaration* part : static_cast<const Component&>(*context).order)
            if (const auto* platform = follow_to<Context>(part);
                platform != nullptr && platform->kind == DeclKind::platform) {
                add_names(visible_events(*platform), names);
                add_names(offered_variables(*platform), names);
                add_names(provided_operations(*platform), names);
            }
    } else {
        add_names(visible_events(*context), names);
        add_names(required_variables(*context), names);
        add_names(required_operations(*context), names);
    }
    return names;
}

// ---------------------------------------------------------------- operations and their callers

using Definitions = std::map<std::string_view, const Machine*>;

/// Calls `visit` for each call of a defined operation in a machine, once for each operation.
template <class Visit>
void for_calls(const Machine& caller, const Definitions& defined, Visit visit) {
    std::set<std::string_view> seen;
    for_actions(caller, [&](const Stmt& action) {
        walk_tree(action, [&](const Stmt& statement) {
            if (statement.kind != StmtKind::call || statement.through_register) return;
            const auto found = defined.find(statement.name.parts.back());
            if (found != defined.end() && seen.insert(found->first).second) visit(statement, *found->second);
        });
    });
}

/// Returns the names in `needed` that `offered` does not have.
template <class Map>
std::string missing_names(const Map& needed, const Map& offered) {
    std::string names;
    for (const auto& [name, declaration] : needed)
        if (!offered.contains(name)) names += fmt::format("{}`{}`", names.empty() ? "" : ", ", name);
    return names;
}

void check_caller(const Machine& caller, const Stmt& call, const Machine& operation, Diagnostics& out) {
    const Registers needed = registers_of(operation);
    const Registers offered = registers_of(caller);
    const auto report = [&](const char* context, const char* what, const std::string& names) {
        if (names.empty()) return;
        out.report(rules::caller_context, call.span, {caller.name, operation.name, context, what, names})
            .notes.push_back({operation.name_span, "the operation is defined here"});
    };
    report("input", "events", missing_names(needed.inputs.events, offered.inputs.events));
    report("input", "variables", missing_names(needed.inputs.variables, offered.inputs.variables));
    report("output", "events", missing_names(needed.outputs.events, offered.outputs.events));
    report("output", "variables", missing_names(needed.outputs.variables, offered.outputs.variables));
    report("output", "operations", missing_names(needed.outputs.operations, offered.outputs.operations));
}

/// Reports operations that call themselves, directly or through others. The depth-first search has its own stack,
/// because chains of calls may be long.
class Recursion {
public:
    Recursion(const Definitions& defined, Diagnostics& out) : defined_(defined), out_(out) {}

    void search_from(const Machine& operation) {
        if (done_.contains(&operation)) return;
        enter(operation);
        while (!path_.empty()) {
            Frame& frame = path_.back();
            if (frame.next == frame.calls.size()) {
                done_.insert(frame.operation);
                path_.pop_back();
                continue;
            }
            const auto [call, called] = frame.calls[frame.next++];
            if (!done_.contains(called)) follow(*call, *called);
        }
    }

private:
    struct Frame {
        const Machine* operation;
        std::vector<std::pair<const Stmt*, const Machine*>> calls;
        std::size_t next = 0;
    };

    void enter(const Machine& operation) {
        Frame frame{&operation, {}};
        for_calls(operation, defined_,
                  [&](const Stmt& call, const Machine& called) { frame.calls.emplace_back(&call, &called); });
        path_.push_back(std::move(frame));
    }

    void follow(const Stmt& call, const Machine& called) {
        const auto again = std::ranges::find(path_, &called, &Frame::operation);
        if (again == path_.end()) return enter(called);
        if (!reported_.insert(&called).second) return;
        std::string way;
        for (auto step = again; step != path_.end(); ++step) way += step->operation->name + " -> ";
        out_.report(rules::operation_recursive, call.span, {called.name, way + called.name});
    }

    const Definitions& defined_;
    Diagnostics& out_;
    std::vector<Frame> path_;
    std::set<const Machine*> done_, reported_;  // for lookup only; the order of pointers is never used
};

void check_callers(const Component& controller, Diagnostics& out) {
    Definitions defined;
    for (const Machine* operation : defined_operations(controller)) defined.emplace(operation->name, operation);
    Recursion recursion(defined, out);
    std::set<const Machine*> seen;
    for (const Declaration* part : controller.order) {
        const auto* caller = follow_to<Machine>(part);
        if (caller == nullptr || !seen.insert(caller).second) continue;
        for_calls(*caller, defined,
                  [&](const Stmt& call, const Machine& operation) { check_caller(*caller, call, operation, out); });
        if (caller->kind == DeclKind::operation) recursion.search_from(*caller);
    }
}

}  // namespace

void check_claim(const Assertion& assertion, Diagnostics& out) {
    for (const AssertionParameter& parameter : assertion.parameters)
        if (parameter.kind == ParameterKind::cycle && parameter.value) check_cycle_length(*parameter.value, out);
    const auto& subject = assertion.subject_path.steps;
    const auto& other = assertion.other_path.steps;
    const bool compares = assertion.kind == AssertionKind::refines || assertion.kind == AssertionKind::equals;
    if (!compares || subject.empty() || other.empty()) return;
    const std::set<std::string> names = register_names(follow_reference(subject.back()));
    const std::set<std::string> others = register_names(follow_reference(other.back()));
    if (names.empty() || others.empty()) return;
    if (std::ranges::none_of(names, [&](const std::string& name) { return others.contains(name); }))
        out.report(rules::nothing_common, assertion.other.span, {assertion.subject.text(), assertion.other.text()});
}

void check_robosim(const Context& context, Diagnostics& out) {
    check_contexts(context, out);
    check_cycle(context, out);
    if (context.kind == DeclKind::controller) check_callers(static_cast<const Component&>(context), out);
}

void check_simulation(const Simulation& simulation, Diagnostics& out) {
    if (simulation.broken) return;
    check_robosim(simulation, out);
    const Declaration* subject =
        simulation.subject_path.steps.empty() ? nullptr : follow_reference(simulation.subject_path.steps.back());
    if (subject == nullptr) return;
    const auto* component = dynamic_cast<const Context*>(subject);
    const bool fits = component != nullptr && component->dialect == Dialect::robochart &&
                      (subject->kind == DeclKind::module || subject->kind == DeclKind::controller ||
                       subject->kind == DeclKind::state_machine);
    if (!fits) {
        const std::string kind = fmt::format("a {} of {}", to_text(subject->kind),
                                             to_text(component != nullptr ? component->dialect : Dialect::robosim));
        out.report(rules::simulation_subject, simulation.subject.span,
                   {simulation.name, simulation.subject.text(), kind})
            .notes.push_back({subject->name_span, "it is declared here"});
        return;
    }
    if (subject->kind != DeclKind::state_machine) return;
    for (const auto& [registers, kind] : {std::pair(simulation.input.get(), DeclKind::input_context),
                                          std::pair(simulation.output.get(), DeclKind::output_context)})
        if (registers == nullptr)
            out.report(rules::simulation_contexts, simulation.name_span,
                       {simulation.name, std::string(to_text(subject->kind)),
                        fmt::format("an `{} {{ ... }}`", to_text(kind))});
}

}  // namespace robochart::frontend
