// SPDX-License-Identifier: Apache-2.0
// Prints expressions and statements in a notation close to RoboChart, with all parentheses and with the names of the
// machine.
#include "semantics/ir/dump_expressions.hpp"

#include <fmt/format.h>

#include <optional>

#include "semantics/ir/dump.hpp"
#include "semantics/ir/numbers.hpp"

namespace robochart::ir {
namespace {

template <class T>
std::string name_at(const std::vector<T>& items, std::uint32_t index) {
    return index < items.size() ? items[index].name : "?";
}

}  // namespace

const char* operator_text(ExprKind kind) {
    switch (kind) {
        case ExprKind::negate:
            return "-";
        case ExprKind::logical_not:
            return "not ";
        case ExprKind::iff:
            return "iff";
        case ExprKind::implies:
            return "=>";
        case ExprKind::disjunction:
            return "\\/";
        case ExprKind::conjunction:
            return "/\\";
        case ExprKind::equal:
            return "==";
        case ExprKind::not_equal:
            return "!=";
        case ExprKind::greater:
            return ">";
        case ExprKind::greater_equal:
            return ">=";
        case ExprKind::less:
            return "<";
        case ExprKind::less_equal:
            return "<=";
        case ExprKind::plus:
            return "+";
        case ExprKind::minus:
            return "-";
        case ExprKind::times:
            return "*";
        case ExprKind::divide:
            return "/";
        case ExprKind::modulus:
            return "%";
        case ExprKind::concat:
            return "cat";
        case ExprKind::is_in:
            return "in";
        case ExprKind::tuple:
            return "tuple";
        case ExprKind::record:
            return "record";
        case ExprKind::sequence:
            return "seq";
        case ExprKind::set:
            return "set";
        case ExprKind::set_range:
            return "set_range";
        case ExprKind::matrix:
            return "matrix";
        case ExprKind::index:
            return "index";
        case ExprKind::apply:
            return "apply";
        case ExprKind::if_then_else:
            return "if";
        case ExprKind::forall:
            return "forall";
        case ExprKind::exists:
            return "exists";
        case ExprKind::exists_unique:
            return "exists1";
        case ExprKind::lambda:
            return "lambda";
        case ExprKind::the:
            return "the";
        case ExprKind::set_comprehension:
            return "comprehension";
        case ExprKind::let:
            return "let";
        case ExprKind::is_type:
            return "is";
        case ExprKind::range:
            return "range";
        case ExprKind::transpose:
            return "transpose";
        // `own_form` or `leaf_text` prints the remaining kinds.
        case ExprKind::boolean:
        case ExprKind::integer:
        case ExprKind::real:
        case ExprKind::string:
        case ExprKind::enum_literal:
        case ExprKind::variable:
        case ExprKind::trigger_value:
        case ExprKind::constant:
        case ExprKind::since:
        case ExprKind::since_entry:
        case ExprKind::bound:
        case ExprKind::call:
        case ExprKind::function_value:
        case ExprKind::toolkit:
        case ExprKind::member:
        case ExprKind::cast:
            break;
    }
    return "?";
}

namespace {

class ExpressionText {
public:
    ExpressionText(const System& system, const Machine* machine) : system_(system), machine_(machine) {}

    std::string whole_text(const Expr& expr) {
        if (const std::optional<std::string> own = own_form(expr)) return *own;
        if (expr.args.empty() && expr.bound_names.empty()) return leaf_text(expr);
        const bool infix = expr.kind >= ExprKind::iff && expr.kind <= ExprKind::modulus;
        if (infix || expr.kind == ExprKind::is_in || expr.kind == ExprKind::concat)
            return fmt::format("({} {} {})", argument_text(expr, 0), operator_text(expr.kind), argument_text(expr, 1));
        return operator_text(expr.kind) + bindings_text(expr) + arguments_text(expr, 0);
    }

private:
    /// Returns the text of an expression that is neither a name, an operator nor a keyword with operands.
    std::optional<std::string> own_form(const Expr& expr) {
        switch (expr.kind) {
            case ExprKind::boolean:
                return expr.number != 0 ? "true" : "false";
            case ExprKind::integer:
                return std::to_string(expr.number);
            case ExprKind::real:
                return to_string(expr.decimal) + "r";
            case ExprKind::string:
                return diagnostics::cspm_string(expr.characters);
            case ExprKind::enum_literal:
                return expr.text + (expr.args.empty() ? "" : arguments_text(expr, 0));
            case ExprKind::bound:
                return "\\" + expr.text;
            case ExprKind::trigger_value:
                return "received";
            case ExprKind::function_value:
                return name_at(system_.functions, expr.function.index);
            case ExprKind::call:
                return name_at(system_.functions, expr.function.index) + arguments_text(expr, 0);
            case ExprKind::toolkit:
                return expr.text + arguments_text(expr, 0);
            case ExprKind::cast:
                return arguments_text(expr, 0) + " as " + type_text(system_, expr.type);
            case ExprKind::member:
                return arguments_text(expr, 0) + "." + std::to_string(expr.number);
            case ExprKind::negate:
            case ExprKind::logical_not:
                return std::string(operator_text(expr.kind)) + arguments_text(expr, 0);
            case ExprKind::variable:
            case ExprKind::constant:
            case ExprKind::since:
            case ExprKind::since_entry:
            case ExprKind::iff:
            case ExprKind::implies:
            case ExprKind::disjunction:
            case ExprKind::conjunction:
            case ExprKind::equal:
            case ExprKind::not_equal:
            case ExprKind::greater:
            case ExprKind::greater_equal:
            case ExprKind::less:
            case ExprKind::less_equal:
            case ExprKind::plus:
            case ExprKind::minus:
            case ExprKind::times:
            case ExprKind::divide:
            case ExprKind::modulus:
            case ExprKind::if_then_else:
            case ExprKind::apply:
            case ExprKind::tuple:
            case ExprKind::record:
            case ExprKind::sequence:
            case ExprKind::set:
            case ExprKind::matrix:
            case ExprKind::index:
            case ExprKind::concat:
            case ExprKind::is_in:
            case ExprKind::set_range:
            case ExprKind::forall:
            case ExprKind::exists:
            case ExprKind::exists_unique:
            case ExprKind::lambda:
            case ExprKind::the:
            case ExprKind::set_comprehension:
            case ExprKind::let:
            case ExprKind::is_type:
            case ExprKind::range:
            case ExprKind::transpose:
                break;
        }
        return std::nullopt;
    }

    std::string leaf_text(const Expr& expr) {
        if (expr.kind == ExprKind::sequence || expr.kind == ExprKind::set || expr.kind == ExprKind::tuple)
            return std::string(operator_text(expr.kind)) + "()";
        if (machine_ == nullptr) return "?";
        if (expr.kind == ExprKind::variable) return name_at(machine_->variables, expr.variable.index);
        if (expr.kind == ExprKind::constant) return name_at(machine_->constants, expr.constant.index);
        if (expr.kind == ExprKind::since) return "since(" + name_at(machine_->clocks, expr.clock.index) + ")";
        if (expr.kind == ExprKind::since_entry) return "sinceEntry(" + name_at(machine_->nodes, expr.node.index) + ")";
        return "?";
    }
    std::string argument_text(const Expr& expr, std::size_t index) {
        return index < expr.args.size() && expr.args[index] ? whole_text(*expr.args[index]) : "?";
    }
    std::string arguments_text(const Expr& expr, std::size_t from) {
        std::string list;
        for (std::size_t i = from; i < expr.args.size(); ++i) list += (i > from ? ", " : "") + argument_text(expr, i);
        return "(" + list + ")";
    }
    std::string bindings_text(const Expr& expr) {
        std::string list;
        for (std::size_t i = 0; i < expr.bound_names.size(); ++i)
            list += " " + expr.bound_names[i] + ":" + type_text(system_, expr.bound_types.at(i));
        return list;
    }

    const System& system_;
    const Machine* machine_;
};

std::string expressions_text(const System& system, const Machine& machine, const std::vector<ExprPtr>& list) {
    std::string text;
    for (const auto& expr : list) text += (text.empty() ? "" : ", ") + expression_text(system, &machine, *expr);
    return text;
}

std::string statement_head(const System& system, const Machine& machine, const Stmt& stmt) {
    const auto value = [&](const ExprPtr& expr) { return expr ? expression_text(system, &machine, *expr) : "?"; };
    switch (stmt.kind) {
        case StmtKind::skip:
            return "skip";
        case StmtKind::sequence:
            return "sequence";
        case StmtKind::if_then_else:
            return "if " + value(stmt.condition);
        case StmtKind::assign: {
            const std::string path = expressions_text(system, machine, stmt.path);
            const std::string target = name_at(machine.variables, stmt.variable.index);
            return target + (path.empty() ? "" : "[" + path + "]") + " = " + value(stmt.value);
        }
        case StmtKind::communicate:
            return "send " + communication_text(system, machine, stmt.communication);
        case StmtKind::call:
            return fmt::format("call {}({})", name_at(machine.operations, stmt.operation.index),
                               expressions_text(system, machine, stmt.args));
        case StmtKind::wait:
            return "wait " + value(stmt.value);
        case StmtKind::wait_interval:
            return fmt::format("wait {} .. {}", value(stmt.value), value(stmt.upper));
        case StmtKind::clock_reset:
            return "reset " + name_at(machine.clocks, stmt.clock.index);
        case StmtKind::deadline:
            return "within " + value(stmt.value);
        case StmtKind::exec:
            return "exec";
        case StmtKind::choose:
            return "choose";
    }
    return "?";
}

}  // namespace

std::string type_text(const System& system, TypeId id) {
    if (id.index >= system.types.size()) return "?";
    const Type& type = system.type(id);
    if (!type.name.empty()) return type.package.empty() ? type.name : type.package + "::" + type.name;
    std::string args;
    for (const auto arg : type.args) args += (args.empty() ? "" : " * ") + type_text(system, arg);
    return args.empty() ? "?" : "(" + args + ")";
}

std::string expression_text(const System& system, const Machine* machine, const Expr& expr) {
    return ExpressionText(system, machine).whole_text(expr);
}

std::string clause_text(const System& system, const Machine* machine, const char* word, const ExprPtr& expr) {
    return expr ? fmt::format(" {} {}", word, expression_text(system, machine, *expr)) : "";
}

std::string communication_text(const System& system, const Machine& machine, const Communication& communication) {
    std::string text = name_at(machine.events, communication.event.index);
    if (communication.kind == CommKind::input) text += "?" + name_at(machine.variables, communication.variable.index);
    if (communication.kind == CommKind::output) text += "!";
    if (communication.kind == CommKind::sync) text += ".";
    if (communication.value) text += expression_text(system, &machine, *communication.value);
    return text + clause_text(system, &machine, "where", communication.predicate);
}

std::string program_text(const System& system, const Machine& machine, const Stmt& stmt, std::size_t indent) {
    std::string text = fmt::format("{:{}}{}: {}\n", "", indent, stmt.point, statement_head(system, machine, stmt));
    for (const auto& part : stmt.body)
        if (part) text += program_text(system, machine, *part, indent + 2);
    return text;
}

std::string dump_text(const System& system, const Machine* machine, const Expr& expr) {
    return expression_text(system, machine, expr);
}

}  // namespace robochart::ir
