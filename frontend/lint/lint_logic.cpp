// SPDX-License-Identifier: Apache-2.0
// Reads expressions as formulas over atoms. lint_logic_search.cpp searches for values that satisfy them. Numbers are
// doubles here: integers below 2^53 are exact, and equal decimal literals are equal.
#include "frontend/lint/lint_logic.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "frontend/syntax/print.hpp"
#include "frontend/types/typer.hpp"
#include "frontend/types/types.hpp"

namespace robochart::frontend::logic {

Formula constant_formula(bool value) {
    Formula result;
    result.value = value;
    return result;
}

Formula negate_formula(Formula part) {
    if (part.form == Formula::Form::constant) return constant_formula(!part.value);
    Formula result;
    result.form = Formula::Form::negation;
    result.parts.push_back(std::move(part));
    return result;
}

namespace {

Formula combine_formulas(Formula::Form form, std::vector<Formula> parts) {
    Formula result;
    result.form = form;
    result.parts = std::move(parts);
    return result;
}

bool is_form(const TypePtr& type, TypeForm form) {
    return type != nullptr && type->form == form;
}
bool is_number(const Expr& expr) {
    return is_form(expr.type, TypeForm::nat) || is_form(expr.type, TypeForm::integer) ||
           is_form(expr.type, TypeForm::real);
}

Linear scale_linear(Linear form, double factor) {
    for (auto& entry : form.terms) entry.second *= factor;
    form.constant *= factor;
    return form;
}

Linear add_linear(Linear a, const Linear& b) {
    for (const auto& [text, factor] : b.terms) {
        double& total = a.terms[text];
        total += factor;
        if (total == 0) a.terms.erase(text);
    }
    a.constant += b.constant;
    return a;
}

/// True for names, their fields and their elements, which the reasoner treats as variables with any values. The values
/// of calls and of binders are unknown.
bool is_plain(const Expr& expr) {
    if (expr.kind == ExprKind::parenthesised || expr.kind == ExprKind::member) return is_plain(*expr.args[0]);
    return expr.kind == ExprKind::name || expr.kind == ExprKind::result || expr.kind == ExprKind::since ||
           expr.kind == ExprKind::since_entry;
}

std::string text_of(const Expr& expr) {
    return to_text(strip_parentheses(expr));
}

/// Returns the enumeration literal that an expression names.
const EnumLiteral* literal_of(const Expr& expr) {
    const Expr& bare = strip_parentheses(expr);
    return bare.kind == ExprKind::name ? dynamic_cast<const EnumLiteral*>(bare.target) : nullptr;
}

bool is_integral(double value) {
    return std::floor(value) == value;
}

constexpr unsigned max_depth = 64;  ///< limit for chains of constants that are defined by constants

}  // namespace

Formula all_of(std::vector<Formula> parts) {
    return combine_formulas(Formula::Form::conjunction, std::move(parts));
}
Formula any_of(std::vector<Formula> parts) {
    return combine_formulas(Formula::Form::disjunction, std::move(parts));
}

// ---------------------------------------------------------------- numbers

/// Returns the defining expression of a constant, if constants are folded.
const Expr* Reasoner::folded_definition(const Expr& expr) const {
    const auto* variable = dynamic_cast<const Variable*>(expr.target);
    const bool known = fold_ && depth_ < max_depth && variable != nullptr && variable->kind == DeclKind::constant;
    return known ? variable->initial.get() : nullptr;
}

Linear Reasoner::read_term(const Expr& expr) {
    const std::string text = text_of(expr);
    Term& known = terms_[text];
    const bool clock = expr.kind == ExprKind::since || expr.kind == ExprKind::since_entry;
    known.integer = is_form(expr.type, TypeForm::nat) || is_form(expr.type, TypeForm::integer);
    if (is_form(expr.type, TypeForm::nat) || clock) known.least = 0;
    return {{{text, 1.0}}, 0};
}

std::optional<Linear> Reasoner::linear_binary(const Expr& expr) {
    const bool known =
        expr.binary == BinaryOp::plus || expr.binary == BinaryOp::minus || expr.binary == BinaryOp::times;
    if (!known) return read_term(expr);
    const auto left = read_linear(*expr.args[0]);
    const auto right = read_linear(*expr.args[1]);
    if (!left || !right) return std::nullopt;
    if (expr.binary == BinaryOp::plus) return add_linear(*left, *right);
    if (expr.binary == BinaryOp::minus) return add_linear(*left, scale_linear(*right, -1));
    if (left->terms.empty()) return scale_linear(*right, left->constant);
    if (right->terms.empty()) return scale_linear(*left, right->constant);
    return read_term(expr);
}

std::optional<Linear> Reasoner::read_linear(const Expr& written) {
    const Expr& expr = strip_parentheses(written);
    if (expr.kind == ExprKind::integer || expr.kind == ExprKind::real)
        return Linear{{}, std::strtod(expr.text.c_str(), nullptr)};
    if (!is_number(expr)) return std::nullopt;
    if (expr.kind == ExprKind::unary && expr.unary == UnaryOp::negate) {
        auto inner = read_linear(*expr.args[0]);
        return inner ? std::optional(scale_linear(std::move(*inner), -1)) : std::nullopt;
    }
    if (expr.kind == ExprKind::binary) return linear_binary(expr);
    if (const Expr* value = folded_definition(expr)) {
        ++depth_;
        auto result = read_linear(*value);
        --depth_;
        return result;
    }
    return read_term(expr);
}

/// Returns the formula `difference RELATION 0`, scaled so that the leading coefficient of the key is 1.
Formula Reasoner::comparison_with_zero(Linear difference, Relation relation, const std::string& text) {
    if (difference.terms.empty()) {
        const double left = difference.constant;
        if (relation == Relation::less) return constant_formula(left < 0);
        return constant_formula(relation == Relation::equal ? left == 0 : left <= 0);
    }
    const double leading = difference.terms.begin()->second;
    const Linear form = scale_linear(std::move(difference), 1 / leading);
    std::string name;
    for (const auto& [part, factor] : form.terms) name += std::to_string(factor) + "*" + part + " ";
    const std::size_t index = key_index(KeyKind::number, name);
    Key& found = keys_[index];
    found.form = form.terms;
    found.integer = std::ranges::all_of(
        form.terms, [&](const auto& part) { return is_integral(part.second) && terms_.at(part.first).integer; });
    Atom atom;
    atom.key = index;
    atom.relation = relation;
    atom.reversed = leading < 0;
    atom.bound = form.constant == 0 ? 0 : -form.constant;
    atom.text = text;
    found.bounds.push_back(atom.bound);
    Formula result;
    result.form = Formula::Form::atom;
    result.atom = add(std::move(atom));
    return result;
}

std::optional<Formula> Reasoner::linear_atom(const Expr& left, const Expr& right, Relation relation,
                                             const std::string& text) {
    const auto a = read_linear(left);
    const auto b = read_linear(right);
    if (!a || !b) return std::nullopt;
    return comparison_with_zero(add_linear(*a, scale_linear(*b, -1)), relation, text);
}

Formula Reasoner::compare_to_zero(const Expr& expr, Relation relation) {
    const auto form = read_linear(expr);
    constexpr const char* signs[] = {" < 0", " <= 0", " == 0"};
    const std::string text = text_of(expr) + signs[static_cast<int>(relation)];
    return form ? comparison_with_zero(*form, relation, text) : opaque_atom(text, false);
}

// ---------------------------------------------------------------- atoms

std::size_t Reasoner::key_index(KeyKind kind, const std::string& text) {
    const auto [at, fresh] = key_index_.emplace(std::pair(kind, text), keys_.size());
    if (fresh) {
        Key made;
        made.kind = kind;
        made.text = text;
        keys_.push_back(std::move(made));
    }
    return at->second;
}

std::size_t Reasoner::add(Atom atom) {
    atoms_.push_back(std::move(atom));
    return atoms_.size() - 1;
}

Formula Reasoner::opaque_atom(const std::string& text, bool trusted) {
    Atom atom;
    atom.key = key_index(KeyKind::boolean, text);
    atom.text = text;
    keys_[atom.key].opaque = !trusted;
    Formula result;
    result.form = Formula::Form::atom;
    result.atom = add(std::move(atom));
    return result;
}

Formula Reasoner::read_name(const Expr& expr) {
    if (const Expr* value = folded_definition(expr)) {
        ++depth_;
        Formula result = read(*value);
        --depth_;
        return result;
    }
    return opaque_atom(text_of(expr), true);
}

std::optional<Formula> Reasoner::enumeration_equality(const Expr& left, const Expr& right) {
    const EnumLiteral* literal = literal_of(right);
    if (literal == nullptr || !literal->arguments.empty()) return std::nullopt;
    if (const EnumLiteral* other = literal_of(left)) return constant_formula(other == literal);
    const auto& type = static_cast<const TypeDeclaration&>(*literal->parent);
    Atom atom;
    atom.key = key_index(KeyKind::enumeration, text_of(left));
    Key& found = keys_[atom.key];
    found.literals.clear();
    for (const auto& declared : type.literals) {
        if (declared.get() == literal) atom.literal = found.literals.size();
        found.literals.push_back(declared->name);
    }
    found.opaque = !is_plain(left);
    atom.text = text_of(left) + " == " + literal->name;
    Formula result;
    result.form = Formula::Form::atom;
    result.atom = add(std::move(atom));
    return result;
}

Formula Reasoner::read_equality(const Expr& left, const Expr& right) {
    if (is_form(left.type, TypeForm::boolean) && is_form(right.type, TypeForm::boolean))
        return combine_formulas(Formula::Form::equivalence, {read(left), read(right)});
    if (auto found = linear_atom(left, right, Relation::equal, text_of(left) + " == " + text_of(right)))
        return std::move(*found);
    if (auto found = enumeration_equality(left, right)) return std::move(*found);
    if (auto found = enumeration_equality(right, left)) return std::move(*found);
    const std::string a = text_of(left);
    const std::string b = text_of(right);
    if (a == b) return constant_formula(true);
    return opaque_atom(std::min(a, b) + " == " + std::max(a, b),
                       is_plain(strip_parentheses(left)) && is_plain(strip_parentheses(right)));
}

Formula Reasoner::read_comparison(const Expr& expr) {
    const Expr& left = *expr.args[0];
    const Expr& right = *expr.args[1];
    const BinaryOp op = *expr.binary;
    const bool strict = op == BinaryOp::less || op == BinaryOp::greater;
    const bool swapped = op == BinaryOp::greater || op == BinaryOp::greater_equal;
    auto found = linear_atom(swapped ? right : left, swapped ? left : right,
                             strict ? Relation::less : Relation::less_equal, to_text(expr));
    return found ? std::move(*found) : opaque_atom(to_text(expr), false);
}

/// Returns the formula a <= value <= b, with < at an open end of the range.
Formula Reasoner::range_membership(const Expr& value, const Expr& range, const Expr& whole) {
    const auto relation = [](bool closed) { return closed ? Relation::less_equal : Relation::less; };
    auto above = linear_atom(*range.args[0], value, relation(range.lower_closed), to_text(whole));
    auto below = linear_atom(value, *range.args[1], relation(range.upper_closed), to_text(whole));
    if (!above || !below) return opaque_atom(to_text(whole), false);
    return all_of({std::move(*above), std::move(*below)});
}

Formula Reasoner::read_membership(const Expr& expr) {
    const Expr& set = strip_parentheses(*expr.args[1]);
    if (set.kind == ExprKind::range || set.kind == ExprKind::set_range)
        return range_membership(*expr.args[0], set, expr);
    if (set.kind != ExprKind::set) return opaque_atom(to_text(expr), false);
    std::vector<Formula> cases;
    for (const ExprPtr& element : set.args) cases.push_back(read_equality(*expr.args[0], *element));
    return any_of(std::move(cases));
}

// ---------------------------------------------------------------- formulas

Formula Reasoner::read_binary(const Expr& expr) {
    const auto left = [&] { return read(*expr.args[0]); };
    const auto right = [&] { return read(*expr.args[1]); };
    switch (*expr.binary) {
        case BinaryOp::conjunction:
            return all_of({left(), right()});
        case BinaryOp::disjunction:
            return any_of({left(), right()});
        case BinaryOp::implies:
            return any_of({negate_formula(left()), right()});
        case BinaryOp::iff:
        case BinaryOp::equal:
            return read_equality(*expr.args[0], *expr.args[1]);
        case BinaryOp::not_equal:
            return negate_formula(read_equality(*expr.args[0], *expr.args[1]));
        case BinaryOp::less:
        case BinaryOp::less_equal:
        case BinaryOp::greater:
        case BinaryOp::greater_equal:
            return read_comparison(expr);
        case BinaryOp::in:
            return read_membership(expr);
        case BinaryOp::plus:
        case BinaryOp::minus:
        case BinaryOp::times:
        case BinaryOp::divide:
        case BinaryOp::modulus:
        case BinaryOp::concat:
            break;
    }
    return opaque_atom(to_text(expr), false);
}

Formula Reasoner::read(const Expr& expr) {
    switch (expr.kind) {
        case ExprKind::boolean:
            return constant_formula(expr.text == "true");
        case ExprKind::parenthesised:
            return read(*expr.args[0]);
        case ExprKind::unary:
            return expr.unary == UnaryOp::logical_not ? negate_formula(read(*expr.args[0]))
                                                      : opaque_atom(to_text(expr), false);
        case ExprKind::binary:
            return read_binary(expr);
        case ExprKind::if_then_else:
            return combine_formulas(Formula::Form::choice,
                                    {read(*expr.args[0]), read(*expr.args[1]), read(*expr.args[2])});
        case ExprKind::name:
            return read_name(expr);
        default:
            return opaque_atom(to_text(expr), is_plain(expr));
    }
}

}  // namespace robochart::frontend::logic
