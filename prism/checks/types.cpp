// SPDX-License-Identifier: Apache-2.0
// See types.hpp.
#include "prism/checks/types.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "base/diagnostics/spelling.hpp"
#include "prism/checks/rewrite.hpp"
#include "prism/checks/rules.hpp"
#include "prism/syntax/rules.hpp"

namespace robochart::prism {
namespace {

constexpr bool is_number(Type type) {
    return type != Type::boolean;
}

/// Functions with the allowed numbers of arguments.
struct Function {
    std::string_view name;
    std::size_t least, most;
};
constexpr std::size_t any = 1'000'000'000;
constexpr std::array<Function, 8> functions_known{{{"min", 1, any},
                                                   {"max", 1, any},
                                                   {"floor", 1, 1},
                                                   {"ceil", 1, 1},
                                                   {"round", 1, 1},
                                                   {"pow", 2, 2},
                                                   {"mod", 2, 2},
                                                   {"log", 2, 2}}};

constexpr std::array<std::string_view, 17> filters{"min",   "max",    "count",  "sum",   "+",       "avg",
                                                   "first", "range",  "forall", "&",     "exists",  "|",
                                                   "state", "argmin", "argmax", "print", "printall"};

}  // namespace

void TypeChecker::expect_type(const ExprPtr& expr, Type expected, bool constant_wanted, const char* what) {
    if (!expr || !check_operand(expr, expected)) return;
    if (constant_wanted) check_constant(expr, what);
}

void TypeChecker::check_constant(const ExprPtr& expr, const char* what) {
    for_each_name(expr, [&](const Expr& name) {
        const auto found = scope_.symbols.find(name.text);
        if (found != scope_.symbols.end() && found->second.variable)
            diagnostics_.report(rules::not_constant, name.span, {what, name.text});
    });
}

TypeChecker::Result TypeChecker::type(const ExprPtr& expr, bool path) {
    auto& known = known_[path ? 1 : 0];
    if (const auto found = known.find(expr.get()); found != known.end()) return found->second;
    diagnostics_.poll();
    const Result result = compute_type(*expr, path);
    known.emplace(expr.get(), result);
    return result;
}

TypeChecker::Result TypeChecker::compute_type(const Expr& expr, bool path) {
    switch (expr.op) {
        case Op::boolean:
            return Type::boolean;
        case Op::integer: {
            std::int32_t value = 0;
            const char* const end = expr.text.data() + expr.text.size();
            if (std::from_chars(expr.text.data(), end, value).ec == std::errc()) return Type::integer;
            diagnostics_.report(rules::big_number, expr.span, {expr.text.substr(0, 20)});
            return std::nullopt;
        }
        case Op::real:
            return Type::real;
        case Op::name:
            return type_of_name(expr);
        case Op::label:
            return type_of_label(expr);
        case Op::conditional:
            return type_of_conditional(expr);
        case Op::implies:
        case Op::iff:
        case Op::disjunction:
        case Op::conjunction:
        case Op::negation:
            return type_of_logical(expr, path);
        case Op::equal:
        case Op::unequal:
            return type_of_equality(expr);
        case Op::less:
        case Op::less_equal:
        case Op::greater:
        case Op::greater_equal:
            return type_of_comparison(expr);
        case Op::add:
        case Op::subtract:
        case Op::multiply:
        case Op::divide:
        case Op::power:
        case Op::minus:
            return type_of_arithmetic(expr);
        case Op::call:
            return type_of_call(expr);
        case Op::probability:
        case Op::steady:
        case Op::reward:
        case Op::forall_paths:
        case Op::exists_path:
            return type_of_query(expr);
        case Op::filter:
            return type_of_filter(expr);
        case Op::next:
        case Op::eventually:
        case Op::globally:
        case Op::until:
        case Op::weak_until:
        case Op::release:
            if (path) return type_of_path_operator(expr);
            diagnostics_.report(rules::misplaced, expr.span, {"a path formula"});
            return std::nullopt;
        case Op::cumulative:
        case Op::total:
        case Op::instantaneous:
        case Op::long_run:
            diagnostics_.report(rules::misplaced, expr.span, {"a query about rewards"});
            return std::nullopt;
    }
    return std::nullopt;
}

TypeChecker::Result TypeChecker::report_wrong_type(const Expr& expr, const std::string& expected, Type found) {
    diagnostics_.report(rules::wrong_type, expr.span, {expected, type_name(found)});
    return std::nullopt;
}

bool TypeChecker::check_operand(const ExprPtr& expr, Type expected, bool path) {
    const Result found = type(expr, path);
    if (!found) return false;
    if (*found == expected || (expected == Type::real && *found == Type::integer)) return true;
    (void)report_wrong_type(*expr, type_name(expected), *found);
    return false;
}

TypeChecker::Result TypeChecker::type_of_name(const Expr& expr) {
    const auto found = scope_.symbols.find(expr.text);
    if (found != scope_.symbols.end()) return found->second.type;
    std::vector<std::string> known;
    for (const auto& [name, symbol] : scope_.symbols) known.push_back(name);
    auto& finding = diagnostics_.report(rules::not_declared, expr.span, {"name", expr.text});
    if (const std::string meant = diagnostics::nearest_spelling(expr.text, known); !meant.empty())
        finding.notes.push_back({{}, fmt::format("did you mean '{}'?", meant)});
    return std::nullopt;
}

TypeChecker::Result TypeChecker::type_of_label(const Expr& expr) {
    if (!scope_.properties) {
        diagnostics_.report(rules::misplaced, expr.span, {"a label"});
        return std::nullopt;
    }
    if (scope_.labels.contains(expr.text)) return Type::boolean;
    if (const auto found = scope_.named.find(expr.text); found != scope_.named.end()) return found->second;
    diagnostics_.report(rules::not_declared, expr.span, {"label or property", expr.text});
    return std::nullopt;
}

TypeChecker::Result TypeChecker::type_of_conditional(const Expr& expr) {
    const bool condition = check_operand(expr.parts[0], Type::boolean);
    const Result yes = type(expr.parts[1]);
    const Result no = type(expr.parts[2]);
    if (!condition || !yes || !no) return std::nullopt;
    if (is_number(*yes) != is_number(*no)) return report_wrong_type(*expr.parts[2], type_name(*yes), *no);
    return *yes == *no ? *yes : Type::real;
}

TypeChecker::Result TypeChecker::type_of_logical(const Expr& expr, bool path) {
    bool good = true;
    for (const ExprPtr& part : expr.parts) good = check_operand(part, Type::boolean, path) && good;
    return good ? Result(Type::boolean) : std::nullopt;
}

TypeChecker::Result TypeChecker::type_of_equality(const Expr& expr) {
    const Result left = type(expr.parts[0]);
    const Result right = type(expr.parts[1]);
    if (!left || !right) return std::nullopt;
    if (is_number(*left) != is_number(*right)) return report_wrong_type(*expr.parts[1], type_name(*left), *right);
    return Type::boolean;
}

TypeChecker::Result TypeChecker::type_of_comparison(const Expr& expr) {
    return type_of_numbers(expr.parts) ? Result(Type::boolean) : std::nullopt;
}

TypeChecker::Result TypeChecker::type_of_numbers(const std::vector<ExprPtr>& parts) {
    Result result = Type::integer;
    for (const ExprPtr& part : parts) {
        const Result found = type(part);
        if (found && !is_number(*found)) (void)report_wrong_type(*part, "a number", *found);
        if (!found || !is_number(*found))
            result = std::nullopt;
        else if (result && *found == Type::real)
            result = Type::real;
    }
    return result;
}

TypeChecker::Result TypeChecker::type_of_arithmetic(const Expr& expr) {
    const Result result = type_of_numbers(expr.parts);
    return result && expr.op == Op::divide ? Type::real : result;
}

TypeChecker::Result TypeChecker::type_of_call(const Expr& expr) {
    const auto* function =
        std::ranges::find_if(functions_known, [&](const Function& candidate) { return candidate.name == expr.text; });
    if (function == functions_known.end()) {
        diagnostics_.report(rules::wrong_function, expr.span, {fmt::format("there is no function '{}'", expr.text)});
        return std::nullopt;
    }
    if (expr.parts.size() < function->least || expr.parts.size() > function->most) {
        diagnostics_.report(rules::wrong_function, expr.span,
                            {fmt::format("'{}' takes {} argument{}, not {}", expr.text, function->least,
                                         function->least == 1 ? "" : "s", expr.parts.size())});
        return std::nullopt;
    }
    if (expr.text == "mod") {
        const bool left = check_operand(expr.parts[0], Type::integer);
        return check_operand(expr.parts[1], Type::integer) && left ? Result(Type::integer) : std::nullopt;
    }
    const Result result = type_of_numbers(expr.parts);
    if (!result) return result;
    if (expr.text == "floor" || expr.text == "ceil" || expr.text == "round") return Type::integer;
    return expr.text == "log" ? Type::real : result;
}

TypeChecker::Result TypeChecker::type_of_query(const Expr& expr) {
    if (!scope_.properties) {
        diagnostics_.report(rules::misplaced, expr.span, {"a question"});
        return std::nullopt;
    }
    if (expr.op == Op::forall_paths || expr.op == Op::exists_path)
        return check_operand(expr.parts[0], Type::boolean, true) ? Result(Type::boolean) : std::nullopt;
    const Query& query = *expr.query;
    bool good = true;
    if (query.bound) {
        good = check_operand(query.bound, Type::real);
        check_constant(query.bound, "a bound");
    } else if (scope_.kind == ModelKind::mdp && query.optimum == Optimum::none && expr.op != Op::steady) {
        const char* const letter = expr.op == Op::reward ? "R" : "P";
        diagnostics_.report(rules::no_optimum, expr.span, {letter, letter});
        good = false;
    }
    if (expr.op == Op::reward)
        good = type_of_reward(expr).has_value() && good;
    else
        good = check_operand(expr.parts[0], Type::boolean, expr.op == Op::probability) && good;
    if (!good) return std::nullopt;
    return query.bound ? Type::boolean : Type::real;
}

TypeChecker::Result TypeChecker::type_of_reward(const Expr& expr) {
    const Query& query = *expr.query;
    bool good = true;
    const auto missing = [&](Span span, std::string text) {
        diagnostics_.report(rules::no_rewards, span, {std::move(text)});
        good = false;
    };
    if (!query.reward.text.empty()) {
        if (std::ranges::find(scope_.rewards, query.reward.text) == scope_.rewards.end())
            missing(query.reward.span, fmt::format("there is no reward structure \"{}\"", query.reward.text));
    } else if (query.reward_index) {
        good = check_operand(query.reward_index, Type::integer);
        check_constant(query.reward_index, "the number of a reward structure");
    } else if (scope_.rewards.empty()) {
        missing(expr.span, "the model has no reward structure");
    }
    const Expr& body = *expr.parts[0];
    if (body.op == Op::cumulative || body.op == Op::instantaneous) {
        good = check_operand(body.parts[0], Type::integer) && good;
        check_constant(body.parts[0], "a number of steps");
    } else if (body.op != Op::total && body.op != Op::long_run) {
        good = check_operand(expr.parts[0], Type::boolean, true) && good;
    }
    return good ? Result(Type::real) : std::nullopt;
}

TypeChecker::Result TypeChecker::type_of_path_operator(const Expr& expr) {
    bool good = true;
    for (const ExprPtr& part : expr.parts) good = check_operand(part, Type::boolean, true) && good;
    if (expr.steps)
        for (const ExprPtr& side : {expr.steps->low, expr.steps->high})
            if (side) {
                good = check_operand(side, Type::integer) && good;
                check_constant(side, "a number of steps");
            }
    return good ? Result(Type::boolean) : std::nullopt;
}

TypeChecker::Result TypeChecker::type_of_filter(const Expr& expr) {
    if (!scope_.properties) {
        diagnostics_.report(rules::misplaced, expr.span, {"a filter"});
        return std::nullopt;
    }
    const std::string& kind = expr.text;
    if (std::ranges::find(filters, kind) == filters.end()) {
        diagnostics_.report(rules::wrong_function, expr.span, {fmt::format("there is no filter '{}'", kind)});
        return std::nullopt;
    }
    Result inner = type(expr.parts[0]);
    if (expr.parts.size() > 1 && !check_operand(expr.parts[1], Type::boolean)) inner = std::nullopt;
    if (!inner) return inner;
    const bool logical = kind == "count" || kind == "forall" || kind == "&" || kind == "exists" || kind == "|";
    const bool either = kind == "first" || kind == "state" || kind == "print" || kind == "printall";
    if (logical && *inner != Type::boolean) return report_wrong_type(*expr.parts[0], "bool", *inner);
    if (!logical && !either && *inner == Type::boolean) return report_wrong_type(*expr.parts[0], "a number", *inner);
    if (kind == "count") return Type::integer;
    if (kind == "argmin" || kind == "argmax") return Type::boolean;
    return kind == "avg" ? Type::real : *inner;
}

}  // namespace robochart::prism
