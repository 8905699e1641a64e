// SPDX-License-Identifier: Apache-2.0
// Prints expressions, types and statements. Parentheses of the source are nodes of the tree, so printing adds none.
#include "frontend/syntax/print.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "frontend/syntax/lexer.hpp"

namespace robochart::frontend {

namespace {

template <class Items, class Write>
std::string join_items(const Items& items, std::string_view separator, Write write) {
    std::string out;
    bool first = true;
    for (const auto& item : items) {
        if (!first) out += separator;
        first = false;
        out += write(item);
    }
    return out;
}

std::string optional_text(const ExprPtr& expr) {
    return expr ? to_text(*expr) : std::string();
}
std::string list_text(const std::vector<ExprPtr>& items) {
    return join_items(items, ", ", optional_text);
}

std::string typed_bindings(const Expr& expr) {
    return join_items(expr.bindings, ", ", [](const Binding& b) {
        return written_name(b.variable->name) + ":" + (b.variable->type_expr ? to_text(*b.variable->type_expr) : "?");
    });
}

std::string valued_bindings(const Expr& expr, std::string_view sign) {
    return join_items(expr.bindings, ", ", [&](const Binding& b) {
        return fmt::format("{} {} {}", written_name(b.variable->name), sign, optional_text(b.value));
    });
}

std::string quantified_text(const Expr& expr, std::string_view word) {
    const std::string condition = expr.args[0] ? " | " + optional_text(expr.args[0]) : "";
    return fmt::format("{} {}{} @ {}", word, typed_bindings(expr), condition, optional_text(expr.args[1]));
}

std::string comprehension_text(const Expr& expr) {
    std::string out = "{" + typed_bindings(expr);
    if (expr.args[0]) out += " | " + optional_text(expr.args[0]);
    if (expr.args[1]) out += " @ " + optional_text(expr.args[1]);
    return out + "}";
}

std::string matrix_text(const Expr& expr) {
    std::string out = "[|";
    for (std::size_t i = 0; i < expr.args.size(); ++i) {
        if (i > 0) out += expr.columns > 0 && i % expr.columns == 0 ? "; " : ", ";
        out += optional_text(expr.args[i]);
    }
    return out + "|]";
}

std::string index_text(const Expr& expr) {
    std::string out = optional_text(expr.args[0]) + "[";
    for (std::size_t i = 1; i < expr.args.size(); ++i) out += (i > 1 ? ", " : "") + optional_text(expr.args[i]);
    return out + "]";
}

std::string range_text(const Expr& expr) {
    return fmt::format("{}{}, {}{}", expr.lower_closed ? "[" : "(", optional_text(expr.args[0]),
                       optional_text(expr.args[1]), expr.upper_closed ? "]" : ")");
}

std::string unary_text(const Expr& expr) {
    return (expr.unary == UnaryOp::negate ? "-" : "not ") + optional_text(expr.args[0]);
}

std::string binary_text(const Expr& expr) {
    return fmt::format("{} {} {}", optional_text(expr.args[0]), to_text(*expr.binary), optional_text(expr.args[1]));
}

/// Prints a sequence. A blank follows `<` if the first element is a set, because `<{` is the token of deadlines.
std::string sequence_text(const Expr& expr) {
    const std::string elements = list_text(expr.args);
    return (elements.starts_with("{") ? "< " : "<") + elements + ">";
}

std::string call_text(const Expr& expr) {
    return fmt::format("{}({})", expr.callee ? optional_text(expr.callee) : written_name(expr.name),
                       list_text(expr.args));
}

/// Prints `$n` or `$e?v : p`.
std::string register_text(const Expr& expr) {
    std::string out = "$" + written_name(expr.name);
    if (expr.args.empty()) return out;
    out += "?" + optional_text(expr.args[0]);
    return expr.args[1] ? out + " : " + optional_text(expr.args[1]) : out;
}

/// Prints an expression that binds names.
std::string binder_text(const Expr& expr) {
    switch (expr.kind) {
        case ExprKind::let:
            return fmt::format("let {} @ {}", valued_bindings(expr, "=="), optional_text(expr.args[0]));
        case ExprKind::forall:
            return quantified_text(expr, "forall");
        case ExprKind::exists:
            return quantified_text(expr, "exists");
        case ExprKind::exists_unique:
            return quantified_text(expr, "exists1");
        case ExprKind::lambda:
            return quantified_text(expr, "lambda");
        case ExprKind::the:
            return quantified_text(expr, "the");
        case ExprKind::set_comprehension:
            return comprehension_text(expr);
        default:
            return probabilistic_text(expr);
    }
}

/// Returns a name as an expression. A name that would begin a path formula is escaped, which is always allowed.
std::string written_value(const QualifiedName& name) {
    constexpr std::array<std::string_view, 10> words = {"Exists", "Finally", "Forall", "Globally", "Next",
                                                        "Prob",   "Release", "Reward", "Until",    "Weak"};
    const bool escaped = !name.empty() && std::ranges::find(words, name.parts.front()) != words.end();
    return (escaped ? "^" : "") + written_name(name);
}

}  // namespace

/// Returns a name, escaped if necessary. `Set` and `Seq` are reserved only before a bracket, but escaping them is
/// always allowed.
std::string written_name(std::string_view name) {
    const bool escaped = is_reserved(name) || name == "Set" || name == "Seq";
    return (escaped ? "^" : "") + std::string(name);
}

std::string written_name(const QualifiedName& name) {
    return join_items(name.parts, "::", [](const std::string& part) { return written_name(part); });
}

std::string to_text(const Expr& expr) {
    switch (expr.kind) {
        case ExprKind::integer:
        case ExprKind::real:
        case ExprKind::string:
        case ExprKind::boolean:
            return expr.text;
        case ExprKind::name:
            return written_value(expr.name);
        case ExprKind::result:
            return "result";
        case ExprKind::to:
            return "to";
        case ExprKind::from:
            return "from";
        case ExprKind::unary:
            return unary_text(expr);
        case ExprKind::binary:
            return binary_text(expr);
        case ExprKind::if_then_else:
            return fmt::format("if {} then {} else {} end", optional_text(expr.args[0]), optional_text(expr.args[1]),
                               optional_text(expr.args[2]));
        case ExprKind::cast:
            return fmt::format("{} as {}", optional_text(expr.args[0]), to_text(*expr.type_expr));
        case ExprKind::is_type:
            return fmt::format("{} is {}", optional_text(expr.args[0]), to_text(*expr.type_expr));
        case ExprKind::member:
            return optional_text(expr.args[0]) + "." + written_name(expr.text);
        case ExprKind::index:
            return index_text(expr);
        case ExprKind::call:
            return call_text(expr);
        case ExprKind::tuple:
            return "(|" + list_text(expr.args) + "|)";
        case ExprKind::record:
            return fmt::format("{}(|{}|)", written_name(expr.name), valued_bindings(expr, "="));
        case ExprKind::sequence:
            return sequence_text(expr);
        case ExprKind::set:
            return "{" + list_text(expr.args) + "}";
        case ExprKind::set_range:
            return fmt::format("{{{} to {}{}}}", optional_text(expr.args[0]), optional_text(expr.args[1]),
                               expr.args.size() > 2 ? " by step " + optional_text(expr.args[2]) : "");
        case ExprKind::range:
            return range_text(expr);
        case ExprKind::matrix:
            return matrix_text(expr);
        case ExprKind::inverse:
            return "inverse(" + list_text(expr.args) + ")";
        case ExprKind::transpose:
            return "transpose(" + list_text(expr.args) + ")";
        case ExprKind::since:
            return "since(" + written_name(expr.name) + ")";
        case ExprKind::since_entry:
            return "sinceEntry(" + written_name(expr.name) + ")";
        case ExprKind::parenthesised:
            return "(" + optional_text(expr.args[0]) + ")";
        case ExprKind::register_:
            return register_text(expr);
        case ExprKind::cycle:
            return "cycle";
        default:
            return binder_text(expr);
    }
}

std::string to_text(const TypeExpr& type) {
    const auto arg = [&](std::size_t i) { return to_text(*type.args[i]); };
    // An operand that does not bind more tightly than the operator needs parentheses.
    const auto operand = [&](std::size_t i) {
        const TypeKind kind = type.args[i]->kind;
        const bool open = kind == TypeKind::product || kind == TypeKind::relation || kind == TypeKind::function;
        const bool right_of_arrow = type.kind == TypeKind::function && i == 1 && kind != TypeKind::relation;
        const bool product_of_arrow = type.kind != TypeKind::product && kind == TypeKind::product;
        const bool behind_star = type.kind == TypeKind::product && i > 0;
        const bool loose = behind_star && (kind == TypeKind::vector || kind == TypeKind::matrix);
        return loose || (open && !right_of_arrow && !product_of_arrow) ? "(" + arg(i) + ")" : arg(i);
    };
    switch (type.kind) {
        case TypeKind::name:
            return written_name(type.name);
        case TypeKind::variable:
            return "?" + written_name(type.name);
        case TypeKind::sequence:
            return "Seq(" + arg(0) + ")";
        case TypeKind::set:
            return "Set(" + arg(0) + ")";
        case TypeKind::function:
            return operand(0) + " -> " + operand(1);
        case TypeKind::relation:
            return operand(0) + " <-> " + operand(1);
        case TypeKind::vector:
            return fmt::format("vector({}, {})", arg(0), optional_text(type.sizes[0]));
        case TypeKind::matrix:
            return fmt::format("matrix({}, {}, {})", arg(0), optional_text(type.sizes[0]),
                               optional_text(type.sizes[1]));
        case TypeKind::product:
            break;
    }
    std::string out = operand(0);
    for (std::size_t i = 1; i < type.args.size(); ++i) out += " * " + operand(i);
    return out;
}

std::string to_text(const Communication& communication) {
    std::string out = (communication.through_register ? "$" : "") + written_name(communication.event);
    if (!communication.from_variable.empty() || communication.predicate) {
        out += "[|";
        if (!communication.from_variable.empty()) out += written_name(communication.from_variable) + " = from";
        if (!communication.from_variable.empty() && communication.predicate) out += " | ";
        out += optional_text(communication.predicate) + "|]";
    }
    switch (communication.kind) {
        case CommKind::simple:
            return out;
        case CommKind::input:
            return out + "?" + written_name(communication.variable);
        case CommKind::output:
            return out + "!" + optional_text(communication.value);
        case CommKind::sync:
            return out + "." + optional_text(communication.value);
    }
    return out;
}

std::string to_text(const Stmt& statement) {
    const auto body = [](const StmtPtr& s) { return s ? to_text(*s) : std::string(); };
    switch (statement.kind) {
        case StmtKind::skip:
            return "skip";
        case StmtKind::sequence:
            return join_items(statement.body, "; ", body);
        case StmtKind::if_then_else: {
            const std::string otherwise = statement.body.size() > 1 ? " else " + body(statement.body[1]) : "";
            return fmt::format("if {} then {}{} end", optional_text(statement.condition), body(statement.body[0]),
                               otherwise);
        }
        case StmtKind::assignment:
            return optional_text(statement.target) + " = " + optional_text(statement.value);
        case StmtKind::communication:
            return (statement.send_keyword ? "send " : "") + to_text(*statement.communication);
        case StmtKind::call:
            return fmt::format("{}{}({})", statement.through_register ? "$" : "", written_name(statement.name),
                               list_text(statement.args));
        case StmtKind::wait:
            return "wait(" + optional_text(statement.value) + ")";
        case StmtKind::wait_interval:
            return fmt::format("wait([{}, {}])", optional_text(statement.value), optional_text(statement.upper));
        case StmtKind::clock_reset:
            return "#" + written_name(statement.name);
        case StmtKind::deadline:
            return fmt::format("{} <{{{}}}", body(statement.body[0]), optional_text(statement.value));
        case StmtKind::parenthesised:
            return "(" + body(statement.body[0]) + ")";
        case StmtKind::exec:
            return "exec";
        case StmtKind::error:
            break;
    }
    return "<error>";
}

std::string_view to_text(BinaryOp op) {
    switch (op) {
        case BinaryOp::iff:
            return "iff";
        case BinaryOp::implies:
            return "=>";
        case BinaryOp::disjunction:
            return "\\/";
        case BinaryOp::conjunction:
            return "/\\";
        case BinaryOp::equal:
            return "==";
        case BinaryOp::not_equal:
            return "!=";
        case BinaryOp::greater:
            return ">";
        case BinaryOp::greater_equal:
            return ">=";
        case BinaryOp::less:
            return "<";
        case BinaryOp::less_equal:
            return "<=";
        case BinaryOp::in:
            return "in";
        case BinaryOp::plus:
            return "+";
        case BinaryOp::minus:
            return "-";
        case BinaryOp::times:
            return "*";
        case BinaryOp::divide:
            return "/";
        case BinaryOp::modulus:
            return "%";
        case BinaryOp::concat:
            return "cat";
    }
    return "?";
}

std::string_view to_text(DeclKind kind) {
    switch (kind) {
        case DeclKind::package:
            return "package";
        case DeclKind::primitive_type:
            return "type";
        case DeclKind::record_type:
            return "datatype";
        case DeclKind::field:
            return "field";
        case DeclKind::enumeration:
            return "enumeration";
        case DeclKind::enum_literal:
            return "literal";
        case DeclKind::function:
            return "function";
        case DeclKind::operation_signature:
            return "operation signature";
        case DeclKind::parameter:
            return "parameter";
        case DeclKind::variable:
            return "variable";
        case DeclKind::constant:
            return "constant";
        case DeclKind::event:
            return "event";
        case DeclKind::clock:
            return "clock";
        case DeclKind::interface:
            return "interface";
        case DeclKind::platform:
            return "robotic platform";
        case DeclKind::operation:
            return "operation";
        case DeclKind::state_machine:
            return "state machine";
        case DeclKind::controller:
            return "controller";
        case DeclKind::module:
            return "module";
        case DeclKind::reference:
            return "reference";
        case DeclKind::connection:
            return "connection";
        case DeclKind::state:
            return "state";
        case DeclKind::initial:
            return "initial junction";
        case DeclKind::final:
            return "final state";
        case DeclKind::junction:
            return "junction";
        case DeclKind::probabilistic:
            return "probabilistic junction";
        case DeclKind::transition:
            return "transition";
        case DeclKind::bound_variable:
            return "bound variable";
        case DeclKind::input_context:
            return "input context";
        case DeclKind::output_context:
            return "output context";
        case DeclKind::simulation:
            return "simulation";
    }
    return "?";
}

std::string_view to_text(ActionKind kind) {
    switch (kind) {
        case ActionKind::entry:
            return "entry";
        case ActionKind::during:
            return "during";
        case ActionKind::exit:
            return "exit";
    }
    return "?";
}

std::string_view to_text(InterfaceUse use) {
    switch (use) {
        case InterfaceUse::uses:
            return "uses";
        case InterfaceUse::requires_:
            return "requires";
        case InterfaceUse::provides:
            return "provides";
    }
    return "?";
}

std::string_view reference_word(DeclKind kind) {
    if (kind == DeclKind::state_machine) return "sref";
    if (kind == DeclKind::controller) return "cref";
    if (kind == DeclKind::platform) return "rref";
    return "opref";
}

}  // namespace robochart::frontend
