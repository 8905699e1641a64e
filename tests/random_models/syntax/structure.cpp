// SPDX-License-Identifier: Apache-2.0
#include "tests/random_models/syntax/structure.hpp"

#include "frontend/syntax/print.hpp"

#include <array>
#include <string_view>

namespace robochart::random_models {

using namespace frontend;

namespace {

constexpr std::array<std::string_view, 9> type_words = {"named",    "type-variable", "Seq",    "Set",   "product",
                                                        "function", "relation",      "vector", "matrix"};
constexpr std::array<std::string_view, 33> expr_words = {
    "integer", "real",      "string",  "boolean",   "name", "result",    "to",
    "from",    "unary",     "binary",  "if",        "let",  "forall",    "exists",
    "exists1", "lambda",    "the",     "as",        "is",   "member",    "index",
    "call",    "tuple",     "record",  "sequence",  "set",  "set-range", "comprehension",
    "range",   "matrix-of", "inverse", "transpose", "since"};
constexpr std::array<std::string_view, 9> probabilistic_words = {
    "path", "probability", "reward", "all-paths", "some-path", "in-state", "event-of", "marked", "simulation"};
constexpr std::array<std::string_view, 17> operator_words = {"iff",   "implies", "or",     "and",     "eq",    "ne",
                                                             "gt",    "ge",      "lt",     "le",      "in",    "plus",
                                                             "minus", "times",   "divide", "modulus", "concat"};
constexpr std::array<std::string_view, 4> comm_words = {"simple", "input", "output", "sync"};
constexpr std::array<std::string_view, 13> stmt_words = {
    "skip",          "sequence-of", "if-statement", "assignment", "communication", "call-of", "wait",
    "wait-interval", "reset",       "deadline",     "group",      "exec",          "error"};
constexpr std::array<std::string_view, 31> decl_words = {
    "package",   "given",     "record-type", "field",      "enumeration",   "literal",    "function-declaration",
    "signature", "parameter", "var",         "const",      "event",         "clock",      "interface",
    "platform",  "operation", "stm",         "controller", "module",        "reference",  "connection",
    "state",     "initial",   "final",       "junction",   "probabilistic", "transition", "bound",
    "inputs",    "outputs",   "simulated"};
constexpr std::array<std::string_view, 10> assertion_words = {
    "deadlock-free", "divergence-free", "deterministic", "timelock-free",     "terminates",
    "refines",       "equals",          "reachable",     "clock-initialised", "event-missed"};
constexpr std::array<std::string_view, 3> parameter_words = {"constant-of", "parameter-of", "cycle-of"};
constexpr std::array<std::string_view, 4> model_words = {"failures-divergences", "traces", "failures", "tick-tock"};
constexpr std::array<std::string_view, 3> time_words = {"both", "timed", "untimed"};
constexpr std::array<std::string_view, 3> action_words = {"entry", "during", "exit"};
constexpr std::array<std::string_view, 3> use_words = {"uses", "requires", "provides"};

template <class Words, class Kind>
std::string_view word(const Words& words, Kind kind) {
    const auto index = static_cast<std::size_t>(kind);
    return index < words.size() ? words.at(index) : std::string_view("other");
}

/// Writes bracketed text.
class Structure {
public:
    void file(const File& file);
    [[nodiscard]] std::string take() { return std::move(out_); }

private:
    void open(std::string_view head) {
        out_ += "(";
        out_ += head;
    }
    void close() { out_ += ")"; }
    void add(std::string_view part) {
        out_ += " ";
        out_ += part;
    }
    void flag(bool set, std::string_view part) {
        if (set) add(part);
    }
    void name(const QualifiedName& name) { add("`" + name.text() + "`"); }
    void name(const std::string& name) { add("`" + name + "`"); }
    template <class Items, class Write>
    void all(std::string_view head, const Items& items, Write write) {
        if (items.empty()) return;
        add("");
        open(head);
        for (const auto& item : items) write(item);
        close();
    }
    void expr(const ExprPtr& expr);
    void optional(std::string_view head, const ExprPtr& expr);
    void type(const TypeExprPtr& type);
    void stmt(const StmtPtr& statement);
    void comm(const Communication& communication);
    void variable(const VariablePtr& variable);
    void declaration(const Declaration& declaration);
    void types(const TypeDeclaration& type);
    void function(const Function& function);
    void context(const Context& context);
    void machine(const Machine& machine);
    void component(const Component& component);
    void connection(const Connection& connection);
    void nodes(const NodeContainer& container);
    void transition(const Transition& transition);
    void assertion(const Assertion& assertion);
    void definition(const ProbabilisticDefinition& definition);
    void update(const Update& update);
    void probabilistic(const ProbabilisticAssertion& assertion);

    std::string out_;
};

void Structure::expr(const ExprPtr& owned) {
    if (!owned) return add("()");
    const Expr& expr = *owned;
    add("");
    if (expr.kind == ExprKind::since_entry)
        open("sinceEntry");
    else if (expr.kind == ExprKind::parenthesised)
        open("parenthesised");
    else if (expr.kind == ExprKind::register_)
        open("register");
    else if (expr.kind == ExprKind::cycle)
        open("cycle");
    else if (expr.kind > ExprKind::parenthesised && expr.kind < ExprKind::error)
        open(probabilistic_words.at(static_cast<std::size_t>(expr.kind) - static_cast<std::size_t>(ExprKind::path)));
    else
        open(word(expr_words, expr.kind));
    if (!expr.text.empty()) name(expr.text);
    if (!expr.name.empty() && expr.kind != ExprKind::member) name(expr.name);  // members store it as text and place
    if (expr.binary) add(word(operator_words, *expr.binary));
    if (expr.unary) add(*expr.unary == UnaryOp::negate ? "negate" : "not");
    if (expr.path) add(to_text(*expr.path));
    if (expr.kind == ExprKind::range) {
        add(expr.lower_closed ? "closed" : "open");
        add(expr.upper_closed ? "closed" : "open");
    }
    if (expr.kind == ExprKind::matrix) add(std::to_string(expr.columns));
    if (expr.callee) this->expr(expr.callee);
    for (const Binding& binding : expr.bindings) {
        variable(binding.variable);
        if (binding.value) this->expr(binding.value);
    }
    for (const ExprPtr& arg : expr.args) this->expr(arg);
    if (expr.type_expr) type(expr.type_expr);
    close();
}

void Structure::optional(std::string_view head, const ExprPtr& expr) {
    if (!expr) return;
    add("");
    open(head);
    this->expr(expr);
    close();
}

void Structure::type(const TypeExprPtr& owned) {
    if (!owned) return add("()");
    add("");
    open(word(type_words, owned->kind));
    if (!owned->name.empty()) name(owned->name);
    for (const TypeExprPtr& arg : owned->args) type(arg);
    for (const ExprPtr& size : owned->sizes) expr(size);
    close();
}

void Structure::variable(const VariablePtr& variable) {
    add("");
    open(word(decl_words, variable->kind));
    name(variable->name);
    if (variable->type_expr) type(variable->type_expr);
    optional("initially", variable->initial);
    close();
}

void Structure::comm(const Communication& communication) {
    add("");
    open(word(comm_words, communication.kind));
    flag(communication.through_register, "register");
    name(communication.event);
    if (!communication.variable.empty()) name(communication.variable);
    optional("value", communication.value);
    if (!communication.from_variable.empty()) {
        add("from-variable");
        name(communication.from_variable);
    }
    optional("predicate", communication.predicate);
    close();
}

void Structure::stmt(const StmtPtr& owned) {
    if (!owned) return add("()");
    const Stmt& statement = *owned;
    add("");
    open(word(stmt_words, statement.kind));
    flag(statement.send_keyword, "send");
    flag(statement.through_register, "register");
    if (statement.communication) comm(*statement.communication);
    if (!statement.name.empty()) name(statement.name);
    for (const ExprPtr& arg : statement.args) expr(arg);
    optional("condition", statement.condition);
    optional("target", statement.target);
    optional("value", statement.value);
    optional("upper", statement.upper);
    for (const StmtPtr& inner : statement.body) stmt(inner);
    close();
}

// ---------------------------------------------------------------- declarations

void Structure::types(const TypeDeclaration& type) {
    flag(type.record_keyword, "record-word");
    for (const VariablePtr& field : type.fields) variable(field);
    for (const auto& literal : type.literals) {
        add("");
        open("literal");
        name(literal->name);
        for (const TypeExprPtr& argument : literal->arguments) this->type(argument);
        close();
    }
}

void Structure::function(const Function& function) {
    for (const VariablePtr& parameter : function.parameters) variable(parameter);
    type(function.result_expr);
    for (const ExprPtr& condition : function.preconditions) optional("precondition", condition);
    for (const ExprPtr& condition : function.postconditions) optional("postcondition", condition);
}

void Structure::context(const Context& context) {
    all("clauses", context.interfaces, [&](const InterfaceClause& clause) {
        add(word(use_words, clause.use));
        name(clause.name);
    });
    for (const VariablePtr& declared : context.variables) variable(declared);
    for (const auto& event : context.events) {
        add("");
        open("event");
        flag(event->broadcast, "broadcast");
        name(event->name);
        if (event->type_expr) type(event->type_expr);
        close();
    }
    for (const auto& clock : context.clocks) {
        add("");
        open("clock");
        name(clock->name);
        close();
    }
    for (const auto& signature : context.signatures) {
        add("");
        open("signature");
        name(signature->name);
        for (const VariablePtr& parameter : signature->parameters) variable(parameter);
        flag(signature->terminates, "terminates-flag");
        close();
    }
    optional("cycle-length", context.cycle);
    for (const Context* registers : {context.input.get(), context.output.get()}) {
        if (registers == nullptr) continue;
        add("");
        open(word(decl_words, registers->kind));
        this->context(*registers);
        close();
    }
}

void Structure::machine(const Machine& machine) {
    for (const VariablePtr& parameter : machine.parameters) variable(parameter);
    flag(machine.terminates, "terminates-flag");
    flag(!machine.has_body, "no-body");
    for (const ExprPtr& condition : machine.preconditions) optional("precondition", condition);
    for (const ExprPtr& condition : machine.postconditions) optional("postcondition", condition);
    context(machine);
    nodes(machine);
}

void Structure::nodes(const NodeContainer& container) {
    for (const auto& node : container.nodes) {
        add("");
        open(word(decl_words, node->kind));
        name(node->name);
        for (const Action& action : node->actions) {
            add(word(action_words, action.kind));
            stmt(action.statement);
        }
        nodes(*node);
        close();
    }
    for (const auto& edge : container.transitions) transition(*edge);
}

void Structure::transition(const Transition& transition) {
    add("");
    open("transition");
    name(transition.name);
    name(transition.from);
    name(transition.to);
    flag(transition.legacy_trigger, "legacy-trigger");
    if (transition.trigger) {
        add("trigger");
        comm(*transition.trigger);
    }
    flag(transition.exec, "exec");
    optional("probability", transition.probability);
    for (const Transition::Reset& reset : transition.resets) {
        add("clock-reset");
        name(reset.name);
    }
    optional("transition-deadline", transition.deadline);
    flag(transition.otherwise, "else-condition");
    optional("condition", transition.condition);
    if (transition.action) {
        add("action");
        stmt(transition.action);
    }
    close();
}

void Structure::connection(const Connection& connection) {
    add("");
    open("connection");
    for (const Connection::End* end : {&connection.from, &connection.to}) {
        name(end->node);
        name(end->event);
    }
    flag(connection.async, "async");
    flag(connection.multiple, "mult");
    close();
}

void Structure::component(const Component& component) {
    context(component);
    for (const Declaration* part : component.order) {
        add("");
        declaration(*part);
    }
    for (const auto& link : component.connections) connection(*link);
}

void Structure::declaration(const Declaration& declared) {
    open(word(decl_words, declared.kind));
    name(declared.name);
    if (const auto* type = dynamic_cast<const TypeDeclaration*>(&declared)) types(*type);
    if (const auto* contract = dynamic_cast<const Function*>(&declared)) function(*contract);
    if (const auto* reference = dynamic_cast<const Reference*>(&declared)) {
        add(word(decl_words, reference->refers_to));
        name(reference->target_name);
    }
    if (const auto* stm = dynamic_cast<const Machine*>(&declared))
        machine(*stm);
    else if (const auto* whole = dynamic_cast<const Component*>(&declared))
        component(*whole);
    else if (const auto* plain = dynamic_cast<const Context*>(&declared))
        context(*plain);
    close();
}

// ---------------------------------------------------------------- assertions and files

void Structure::assertion(const Assertion& assertion) {
    open("assertion");
    name(assertion.name);
    add(word(time_words, assertion.time));
    add(word(assertion_words, assertion.kind));
    flag(assertion.negated, "negated");
    if (!assertion.subject.empty()) name(assertion.subject);
    if (!assertion.other.empty()) name(assertion.other);
    if (assertion.model) {
        add("model");
        add(word(model_words, *assertion.model));
    }
    for (const AssertionParameter& parameter : assertion.parameters) {
        add(word(parameter_words, parameter.kind));
        name(parameter.name);
        name(parameter.context);
        expr(parameter.value);
    }
    close();
}

void Structure::update(const Update& update) {
    for (const ExprPtr* part : {&update.probability, &update.variable, &update.value}) expr(*part);
}

void Structure::definition(const ProbabilisticDefinition& definition) {
    open(to_text(definition.kind));
    name(definition.name);
    if (definition.constant) variable(definition.constant);
    expr(definition.value);
    for (const ConstantValues& values : definition.constants) {
        expr(values.constant);
        add(values.from_set ? "from-set" : "set-to");
        expr(values.value);
    }
    for (const RewardItem& item : definition.rewards) {
        add(item.of_step ? "of-step" : "of-state");
        for (const ExprPtr* part : {&item.event, &item.guard, &item.value}) expr(*part);
    }
    for (const ProbabilisticFunction& function : definition.functions) {
        add(function.result ? "pfunction" : "poperation");
        name(function.name);
        for (const VariablePtr& parameter : function.parameters) variable(parameter);
        expr(function.result);
        for (const Update& part : function.updates) update(part);
    }
    for (const ProbabilisticModule& module : definition.modules) {
        add("pmodule");
        name(module.name);
        for (const ModuleVariable& declared : module.variables) {
            variable(declared.variable);
            expr(declared.low);
            expr(declared.high);
            expr(declared.variable->initial);
        }
        for (const Command& command : module.commands) {
            add("command");
            for (const ExprPtr* part : {&command.event, &command.guard}) expr(*part);
            for (const Update& part : command.updates) update(part);
        }
    }
    close();
}

void Structure::probabilistic(const ProbabilisticAssertion& assertion) {
    open(assertion.property ? "prob-property" : "prob-path");
    name(assertion.name);
    for (const ExprPtr* part :
         {&assertion.property, &assertion.path.steps, &assertion.path.repeats, &assertion.path.limit})
        expr(*part);
    for (const ProbabilisticClause& clause : assertion.clauses) {
        name(clause.name.text());
        definition(clause.definition);
    }
    if (!assertion.options.empty()) add("options");
    close();
}

void Structure::file(const File& file) {
    if (!file.package.empty()) out_ += "(package `" + file.package.text() + "`)\n";
    for (const Import& import : file.imports)
        out_ += "(import `" + import.name.text() + (import.wildcard ? "` all)\n" : "`)\n");
    for (const std::string& diagram : file.diagrams) out_ += "(diagram `" + diagram + "`)\n";
    for (const auto& declared : file.declarations) {
        declaration(*declared);
        out_ += "\n";
    }
    for (const Assertion& asserted : file.assertions) {
        assertion(asserted);
        out_ += "\n";
    }
    for (const CspBlock& block : file.csp_blocks) {
        open("csp");
        name(block.name);
        add(word(time_words, block.time));
        for (const QualifiedName& associated : block.associated) name(associated);
        out_ += " «" + block.text + "»)\n";
    }
    for (const ProbabilisticDefinition& defined : file.probabilistic_definitions) {
        definition(defined);
        out_ += "\n";
    }
    for (const ProbabilisticAssertion& asserted : file.probabilistic_assertions) {
        probabilistic(asserted);
        out_ += "\n";
    }
    for (const KeptPart& part : file.kept) out_ += "(verbatim «" + part.text + "»)\n";
}

}  // namespace

std::string structure_text(const File& file) {
    Structure writer;
    writer.file(file);
    return writer.take();
}

}  // namespace robochart::random_models
