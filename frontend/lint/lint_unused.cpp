// SPDX-License-Identifier: Apache-2.0
// Reports unused declarations (RC-W07), variables that are assigned but never read (RC-W08), and clocks that are read
// but never reset (RC-W18). All files of the project are considered. Interfaces and operations may be a library for
// other projects, so their declarations are not reported. An exception is an interface that is only named with `uses`:
// its variables and clocks belong to the machines that use it.

#include "frontend/lint/lints.hpp"
#include "frontend/names/scopes.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/expression_visitor.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::frontend {

namespace {

struct Use {
    std::size_t reads = 0;
    std::size_t others = 0;            ///< stored inputs, resets, communications, connections
    const Stmt* assignment = nullptr;  ///< the first assignment
    Span reset;                        ///< the first reset of the clock
};

class Uses {
public:
    explicit Uses(const Model& model) {
        for (const auto& file : model.files) {
            for (const auto& declaration : file->declarations) add(*declaration);
            for (const Assertion& assertion : file->assertions) add(assertion);
        }
    }

    [[nodiscard]] const Use& uses_of(const Declaration& declaration) const {
        static const Use none;
        const auto found = uses_.find(&declaration);
        return found != uses_.end() ? found->second : none;
    }
    /// True if a required interface, an assertion or an event of an operation has or mentions this name.
    [[nodiscard]] bool is_wanted(const std::string& name) const { return wanted_.contains(name); }
    [[nodiscard]] const std::vector<const Context*>& all_contexts() const { return contexts_; }
    [[nodiscard]] const std::unordered_set<const Declaration*>& given_out() const { return given_out_; }
    [[nodiscard]] const std::unordered_set<const Declaration*>& used_interfaces() const { return used_; }

private:
    void add(const Declaration& declaration) {
        if (const auto* function = dynamic_cast<const Function*>(&declaration)) {
            for (const ExprPtr& condition : function->preconditions) read(*condition);
            for (const ExprPtr& condition : function->postconditions) read(*condition);
        }
        if (const auto* type = dynamic_cast<const TypeDeclaration*>(&declaration))
            for (const VariablePtr& field : type->fields) read(field->type_expr.get());
        if (const auto* context = dynamic_cast<const Context*>(&declaration)) add_context(*context);
        if (const auto* machine = dynamic_cast<const Machine*>(&declaration)) add_machine(*machine);
        if (const auto* component = dynamic_cast<const Component*>(&declaration)) add_component(*component);
    }

    void add(const Assertion& assertion) {
        for (const AssertionParameter& parameter : assertion.parameters) {
            if (!parameter.name.empty()) wanted_.insert(parameter.name.parts.back());
            if (parameter.value) read(*parameter.value);
        }
        if (!assertion.other.empty()) wanted_.insert(assertion.other.parts.back());
    }

    void add_context(const Context& context) {
        contexts_.push_back(&context);
        for (const InterfaceClause& clause : context.interfaces) {
            const Context* interface = interface_of(clause);
            if (interface == nullptr) continue;
            (clause.use == InterfaceUse::uses ? used_ : given_out_).insert(interface);
            if (clause.use != InterfaceUse::requires_) continue;
            for (const auto& variable : interface->variables) wanted_.insert(variable->name);
            for (const auto& clock : interface->clocks) wanted_.insert(clock->name);
        }
        if (context.kind == DeclKind::operation)  // the callers have events with these names
            for (const Event* event : visible_events(context)) wanted_.insert(event->name);
        for (const auto& variable : context.variables) {
            read(variable->type_expr.get());
            if (variable->initial) read(*variable->initial);
        }
        for (const auto& event : context.events) read(event->type_expr.get());
        if (context.cycle) read(*context.cycle);
        for (const Context* registers : {context.input.get(), context.output.get()})
            if (registers != nullptr) this->add_context(*registers);
    }

    void add_machine(const Machine& machine) {
        for (const auto& parameter : machine.parameters) read(parameter->type_expr.get());
        for (const ExprPtr& condition : machine.preconditions) read(*condition);
        for (const ExprPtr& condition : machine.postconditions) read(*condition);
        for_actions(machine, [&](const Stmt& action) {
            walk_tree(action, [&](const Stmt& statement) { this->read_statement(statement); });
        });
        walk_tree(machine, [&](const NodeContainer& container) {
            for (const auto& transition : container.transitions) this->read_transition(*transition);
        });
    }

    void read_transition(const Transition& transition) {
        for (const ExprPtr* expr : {&transition.condition, &transition.deadline, &transition.probability})
            if (*expr) read(**expr);
        for (const auto& reset : transition.resets) this->reset(reset.clock, reset.name.span);
        if (!transition.trigger) return;
        read_communication(*transition.trigger);
        if (transition.trigger->predicate) read(*transition.trigger->predicate);
    }

    void read_statement(const Stmt& statement) {
        const Declaration* assigned = nullptr;
        if (statement.kind == StmtKind::assignment && statement.target) assigned = assigned_root(*statement.target);
        for_expressions(statement, [&](const Expr& expr) {
            walk_tree(expr, [&](const Expr& part) {
                // `v = v + 1` and `v[i] = e` read v only to update it.
                if (part.target != nullptr && part.target != assigned) ++uses_[part.target].reads;
                if (part.type_expr) read(part.type_expr.get());
            });
        });
        if (assigned != nullptr && uses_[assigned].assignment == nullptr) uses_[assigned].assignment = &statement;
        if (statement.kind == StmtKind::clock_reset) reset(statement.declaration, statement.name.span);
        if (statement.communication) read_communication(*statement.communication);
    }

    void read_communication(const Communication& communication) {
        if (communication.event_target != nullptr) ++uses_[communication.event_target].others;
        if (communication.variable_target != nullptr) ++uses_[communication.variable_target].others;
        if (!communication.from_variable.empty()) wanted_.insert(communication.from_variable.parts.back());
    }

    void reset(const Declaration* clock, Span span) {
        if (clock == nullptr) return;
        Use& use = uses_[clock];
        if (!use.reset.is_known()) use.reset = span;
    }

    void add_component(const Component& component) {
        for (const auto& connection : component.connections)
            for (const Connection::End* end : {&connection->from, &connection->to})
                if (end->event_target != nullptr) ++uses_[end->event_target].others;
        for (const auto& part : component.platforms) add(*part);
        for (const auto& part : component.controllers) add(*part);
        for (const auto& part : component.machines) add(*part);
        for (const auto& part : component.operations) add(*part);
    }

    void read(const Expr& expr) {
        walk_tree(expr, [&](const Expr& part) {
            if (part.target != nullptr) ++uses_[part.target].reads;
            if (part.type_expr) read(part.type_expr.get());
        });
    }

    void read(const TypeExpr* type) {
        if (type == nullptr) return;
        for (const ExprPtr& size : type->sizes) read(*size);
        for (const TypeExprPtr& argument : type->args) read(argument.get());
    }

    std::unordered_map<const Declaration*, Use> uses_;
    std::unordered_set<std::string> wanted_;
    std::unordered_set<const Declaration*> given_out_, used_;
    std::vector<const Context*> contexts_;
};

class Unused {
public:
    Unused(const Uses& uses, Diagnostics& out) : uses_(uses), out_(out) {}

    void check(const Context& context) {
        const bool interface = context.kind == DeclKind::interface;
        if (interface && (uses_.given_out().contains(&context) || !uses_.used_interfaces().contains(&context))) return;
        for (const auto& variable : context.variables) check_variable(*variable);
        for (const auto& clock : context.clocks) check_clock(*clock);
        if (!interface && context.kind != DeclKind::platform)  // RC-W01 reports unused events of a platform
            for (const auto& event : context.events) check_event(*event);
        const auto* machine = dynamic_cast<const Machine*>(&context);
        if (machine != nullptr && machine->has_body && !machine->nodes.empty())
            for (const auto& parameter : machine->parameters) check_variable(*parameter);
    }

private:
    void check_variable(const Variable& variable) {
        const Use& use = uses_.uses_of(variable);
        if (use.reads > 0 || use.others > 0 || uses_.is_wanted(variable.name)) return;
        if (use.assignment != nullptr) {
            out_.report(rules::w_unread, variable.name_span, {variable.name})
                .notes.push_back({use.assignment->span, "assigned here"});
        } else {
            out_.report(rules::w_unused, variable.name_span,
                        {std::string(to_text(variable.kind)), variable.name, "used"});
        }
    }

    void check_clock(const Clock& clock) {
        const Use& use = uses_.uses_of(clock);
        if (uses_.is_wanted(clock.name)) return;
        if (use.reads > 0 && !use.reset.is_known()) out_.report(rules::w_never_reset, clock.name_span, {clock.name});
        if (use.reads > 0) return;
        auto& finding = out_.report(rules::w_unused, clock.name_span, {"clock", clock.name, "read"});
        if (use.reset.is_known()) finding.notes.push_back({use.reset, "reset here"});
    }

    void check_event(const Event& event) {
        const Use& use = uses_.uses_of(event);
        if (use.others == 0 && use.reads == 0 && !uses_.is_wanted(event.name))
            out_.report(rules::w_unused, event.name_span, {"event", event.name, "used"});
    }

    const Uses& uses_;
    Diagnostics& out_;
};

}  // namespace

void lint_unused(const Model& model, Diagnostics& out) {
    const Uses uses(model);
    Unused unused(uses, out);
    for (const Context* context : uses.all_contexts()) unused.check(*context);
}

}  // namespace robochart::frontend
