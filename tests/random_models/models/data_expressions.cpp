// SPDX-License-Identifier: Apache-2.0
// Makes the expressions of random models.
#include <fmt/format.h>

#include <algorithm>

#include "tests/random_models/models/data.hpp"
#include "tests/random_models/models/hostile.hpp"

namespace robochart::random_models {

namespace {

// Levels of the grammar, lowest precedence first.
constexpr int data_quantifier_level = -1;
constexpr int implies_level = 1;
constexpr int or_level = 2;
constexpr int and_level = 3;
constexpr int data_not_level = 4;
constexpr int data_compare_level = 5;
constexpr int data_let_level = 6;
constexpr int data_cast_level = 7;
constexpr int data_plus_level = 8;
constexpr int times_level = 9;
constexpr int data_concat_level = 10;
constexpr int data_negate_level = 11;
constexpr int data_select_level = 12;
constexpr int data_atom_level = 13;

bool is_mapping(const DataType& type) {
    return type.form == Form::function || type.form == Form::relation;
}

std::string parenthesised(const std::string& text) {
    return "(" + text + ")";
}

}  // namespace

bool is_number(const DataType& type) {
    return type.form == Form::nat || type.form == Form::integer || type.form == Form::real;
}

bool fits_type(const DataType& from, const DataType& to) {
    return &from == &to || (is_number(from) && is_number(to) && from.form < to.form);
}

std::string Expressions::expression_text(const DataType& type) {
    return operand(type, data_quantifier_level);
}

std::string Expressions::operand(const DataType& type, int level) {
    const std::size_t depth = random_.below(shape_.data.expression_depth + 1);
    return text_at_level(level, type, depth);
}

std::string Expressions::text_at_level(int level, const DataType& type, std::size_t depth) {
    const Written written = make(type, depth);
    return written.level < level || random_.chance(3) ? parenthesised(written.text) : written.text;
}

std::string Expressions::number(std::size_t least) {
    return std::to_string(random_.between(least, std::max(least, shape_.data.largest)));
}

std::string Expressions::decimal() {
    const std::string whole = number();
    const std::size_t half = random_.below(2);
    return whole + (half == 0 ? ".0" : ".5");
}

// ---------------------------------------------------------------- literals

std::string Expressions::literal(const DataType& type) {
    return literal_text(type);
}

std::string Expressions::literal_text(const DataType& type) {
    const bool flag = random_.chance(50);
    switch (type.form) {
        case Form::boolean:
            return flag ? "true" : "false";
        case Form::nat:
        case Form::integer:
            return number();
        case Form::real:
            return flag ? decimal() : number();
        case Form::string:
            if (shape_.hostile) return std::string(random_.pick(hostile_strings()));
            return flag ? "\"left \\\"turn\\\"\"" : "'go'";
        case Form::given:
            return type.labels[0] + "()";
        case Form::enumeration:
            return literal_of(type, 0);
        case Form::set:
            return flag ? "{}" : "{" + literal_text(*type.parts[0]) + "}";
        case Form::sequence:
            return flag ? "<>" : "<" + literal_text(*type.parts[0]) + ">";
        case Form::record:
        case Form::product:
        case Form::vector:
        case Form::matrix:
        case Form::function:
        case Form::relation:
            break;
    }
    return constructor(type, 0);
}

/// Returns expressions of these types, separated by commas.
std::string Expressions::list(const std::vector<const DataType*>& types, std::size_t depth, int level) {
    std::string out;
    for (const DataType* type : types) {
        const std::string next = depth == 0 ? literal_text(*type) : text_at_level(level, *type, depth - 1);
        out += (out.empty() ? "" : ", ") + next;
    }
    return out;
}

/// Returns the parts of a tuple, cast to the wider number type, because `nat * int` and `int * nat` have no common
/// type.
std::string Expressions::tuple_parts(const DataType& type, std::size_t depth) {
    std::string out;
    for (const DataType* part : type.parts) {
        const bool wide = part->form == Form::integer || part->form == Form::real;
        const std::string value = list({part}, depth, wide ? data_plus_level : data_quantifier_level);
        out += (out.empty() ? "" : ", ") + value + (wide ? " as " + part->written : "");
    }
    return out;
}

/// Returns a record, product, sequence, vector or matrix that is built from its parts.
std::string Expressions::constructor(const DataType& type, std::size_t depth) {
    if (type.form == Form::product) return "(|" + tuple_parts(type, depth) + "|)";
    if (type.form == Form::function || type.form == Form::relation) return mapping(type, depth);
    if (type.form == Form::sequence) {
        const std::vector<const DataType*> parts(random_.between(1, 3), type.parts[0]);
        const std::string elements = list(parts, depth, data_plus_level);
        // A sequence whose first element is a set would be parsed as a deadline.
        return elements.starts_with("{") ? "< " + elements + ">" : "<" + elements + ">";
    }
    if (type.form == Form::record) {
        std::string out;
        for (std::size_t i = 0; i < type.parts.size(); ++i) {
            const std::string value = list({type.parts[i]}, depth, data_quantifier_level);
            out += fmt::format("{}{} = {}", i > 0 ? ", " : "", type.labels[i], value);
        }
        return type.written + "(|" + out + "|)";
    }
    std::string out;
    const std::vector<const DataType*> row(type.columns, type.parts[0]);
    const std::size_t rows = type.form == Form::matrix ? type.rows : 1;
    for (std::size_t i = 0; i < rows; ++i) out += (i > 0 ? "; " : "") + list(row, depth, data_quantifier_level);
    return "[|" + out + "|]";
}

std::vector<std::string> Expressions::readable(const DataType& type) const {
    std::vector<std::string> names;
    for (const Named& named : scope)
        if (fits_type(*named.type, type)) names.push_back(named.name);
    return names;
}

Written Expressions::leaf(const DataType& type) {
    const std::vector<std::string> names = readable(type);
    if (!names.empty() && random_.chance(70)) return {random_.pick(names), data_atom_level};
    return {literal_text(type), data_atom_level};
}

// ---------------------------------------------------------------- composition

Written Expressions::make(const DataType& type, std::size_t depth) {
    if (depth == 0) return leaf(type);
    if (random_.chance(25)) return common(type, depth - 1);
    return compound(type, depth - 1);
}

Written Expressions::compound(const DataType& type, std::size_t depth) {
    switch (type.form) {
        case Form::boolean:
            return boolean(depth);
        case Form::nat:
        case Form::integer:
        case Form::real:
            return shape_.data.arithmetic ? numeric(type, depth) : leaf(type);
        case Form::sequence:
            if (random_.chance(30))
                return binary(type, random_.chance(50) ? "cat" : "^", type, data_concat_level, depth);
            return {constructor(type, depth), data_atom_level};
        case Form::set:
            return set(type, depth);
        case Form::vector:
        case Form::matrix:
            return matrix(type, depth);
        case Form::enumeration:
            return shape_.data.constructors ? Written{literal_of(type, depth), data_select_level} : leaf(type);
        case Form::function:
        case Form::relation:
        case Form::record:
        case Form::product:
            return {constructor(type, depth), data_atom_level};
        case Form::string:
        case Form::given:
            break;
    }
    return leaf(type);
}

/// Returns one of the forms that exist for every type.
Written Expressions::common(const DataType& type, std::size_t depth) {
    const std::size_t way = random_.below(6);
    if (way == 5 && shape_.data.binders) return application(type, depth);
    if (way == 0) return conditional(type, depth);
    if (way == 1 && shape_.data.toolkits && calls && random_.chance(50)) return generic_call(type, depth);
    if (way == 1 && shape_.data.functions && calls) return call(type, depth);
    if (way == 2 && shape_.data.binders) return let(type, depth);
    if (way == 3 && shape_.data.binders) return definite_description(type, depth);
    return part(type);
}

Written Expressions::conditional(const DataType& type, std::size_t depth) {
    const std::string condition = text_at_level(data_quantifier_level, *types_.boolean(), depth);
    const std::string yes = text_at_level(data_quantifier_level, type, depth);
    const std::string no = text_at_level(data_quantifier_level, type, depth);
    return {fmt::format("if {} then {} else {} end", condition, yes, no), data_let_level};
}

Written Expressions::let(const DataType& type, std::size_t depth) {
    const DataType& bound = *types_.existing_type();
    const std::string value = text_at_level(data_quantifier_level, bound, depth);
    scope.push_back({"b" + std::to_string(bound_++), &bound});
    const std::string name = scope.back().name;
    const std::string body = text_at_level(data_cast_level, type, depth);
    scope.pop_back();
    return {fmt::format("let {} == {} @ {}", name, value, body), data_let_level};
}

Written Expressions::definite_description(const DataType& type, std::size_t depth) {
    const std::string value = text_at_level(data_let_level, type, depth);
    const std::string name = "b" + std::to_string(bound_++);
    if (shape_.data.type_tests && random_.chance(30))
        return {fmt::format("the {} : {} @ {}", name, types_.existing_type()->written, value), data_let_level};
    return {fmt::format("the {0} : {1} | {0} == {2} @ {0}", name, type.written, value), data_let_level};
}

/// Returns an application `(lambda x : T @ e)(a)`.
Written Expressions::application(const DataType& type, std::size_t depth) {
    const DataType& bound = *types_.existing_type();
    const std::string argument = text_at_level(data_quantifier_level, bound, depth);
    scope.push_back({"b" + std::to_string(bound_++), &bound});
    const std::string name = scope.back().name;
    const std::string body = text_at_level(data_quantifier_level, type, depth);
    scope.pop_back();
    return {fmt::format("(lambda {} : {} @ {})({})", name, bound.written, body, argument), data_select_level};
}

/// Returns a field of a record in scope, or an element of a product, sequence or vector.
Written Expressions::part(const DataType& type) {
    std::vector<std::string> parts;
    for (const Named& named : scope) {
        const DataType& whole = *named.type;
        for (std::size_t i = 0; i < whole.parts.size(); ++i) {
            if (!fits_type(*whole.parts[i], type) || whole.form == Form::set || is_mapping(whole)) continue;
            if (whole.form == Form::record)
                parts.push_back(named.name + "." + whole.labels[i]);
            else
                parts.push_back(named.name + (whole.form == Form::matrix ? "[1, " : "[") + std::to_string(i + 1) + "]");
        }
    }
    if (parts.empty()) return leaf(type);
    return {random_.pick(parts), data_select_level};
}

Written Expressions::call(const DataType& type, std::size_t depth) {
    std::vector<const Operator*> functions;
    for (const Operator& function : types_.functions())
        if (fits_type(*function.result, type)) functions.push_back(&function);
    for (const Named& named : scope)
        if (named.type->form == Form::function && fits_type(*named.type->parts[1], type) && random_.chance(50))
            return {named.name + "(" + list({named.type->parts[0]}, depth, data_quantifier_level) + ")",
                    data_select_level};
    if (functions.empty()) return leaf(type);
    const Operator& function = *random_.pick(functions);
    return {function.name + "(" + list(function.parameters, depth, data_quantifier_level) + ")", data_select_level};
}

Written Expressions::binary(const DataType& left, const std::string& op, const DataType& right, int level,
                            std::size_t depth) {
    const std::string first = text_at_level(level, left, depth);
    const std::string second = text_at_level(level + 1, right, depth);
    return {fmt::format("{} {} {}", first, op, second), level};
}

// ---------------------------------------------------------------- booleans

Written Expressions::boolean(std::size_t depth) {
    const DataType& type = *types_.boolean();
    if (shape_.data.type_tests && random_.chance(5)) return type_test(depth);
    if (shape_.data.toolkits && calls && random_.chance(8))
        return random_.chance(50) ? generic_call(type, depth) : generic_comparison(depth);
    switch (random_.below(shape_.data.binders ? 9 : 8)) {
        case 0:
            return {"not " + text_at_level(data_not_level, type, depth), data_not_level};
        case 1:
            return binary(type, "/\\", type, and_level, depth);
        case 2:
            return binary(type, "\\/", type, or_level, depth);
        case 3:
            return random_.chance(50) ? binary(type, "=>", type, implies_level, depth)
                                      : binary(type, "iff", type, 0, depth);
        case 4:
            return membership(depth);
        case 8:
            return quantified_formula(depth);
        default:
            return comparison(depth);
    }
}

Written Expressions::comparison(std::size_t depth) {
    const DataType& type = *types_.existing_type();
    const std::vector<std::string> orders = {"<", "<=", ">", ">="};
    const bool ordered = is_number(type) && random_.chance(60);
    if (ordered) return binary(type, random_.pick(orders), type, data_compare_level, depth);
    return binary(type, random_.chance(75) ? "==" : "!=", type, data_compare_level, depth);
}

Written Expressions::membership(std::size_t depth) {
    if (!shape_.data.sets) return comparison(depth);
    if (shape_.data.naturals && random_.chance(40)) {
        const std::string number = text_at_level(data_compare_level, *types_.nat(), depth);
        return {number + " in " + interval(depth), data_compare_level};
    }
    const DataType& type = *types_.existing_type();
    const std::string element = text_at_level(data_compare_level, type, depth);
    const std::string first = text_at_level(data_quantifier_level, type, depth);
    return {fmt::format("{} in {{{}}}", element, first), data_compare_level};
}

Written Expressions::quantified_formula(std::size_t depth) {
    const std::vector<std::string> words = {"forall", "exists", "exists1"};
    const std::string word = random_.pick(words);
    const DataType& bound = *types_.existing_type();
    scope.push_back({"b" + std::to_string(bound_++), &bound});
    const std::string name = scope.back().name;
    std::string range;
    if (random_.chance(50)) range = " | " + text_at_level(data_quantifier_level, *types_.boolean(), depth);
    const std::string body = text_at_level(data_quantifier_level, *types_.boolean(), depth);
    scope.pop_back();
    return {fmt::format("{} {} : {}{} @ {}", word, name, bound.written, range, body), data_quantifier_level};
}

// ---------------------------------------------------------------- numbers and sets

/// Returns a number expression: `nat - nat` is an int, `/` yields a real, and `%` an int.
Written Expressions::numeric(const DataType& type, std::size_t depth) {
    switch (random_.below(6)) {
        case 0:
            return binary(type, "*", type, times_level, depth);
        case 1:
            if (type.form != Form::nat) return binary(type, "-", type, data_plus_level, depth);
            break;
        case 2:
            if (type.form != Form::nat) return {"-" + text_at_level(data_negate_level, type, depth), data_negate_level};
            break;
        case 3:
            if (type.form == Form::real) return binary(type, "/", type, times_level, depth);
            if (type.form == Form::integer) return binary(type, "%", type, times_level, depth);
            break;
        case 4:
            if (!shape_.data.binders) break;
            return {text_at_level(data_plus_level, type, depth) + " as " + type.written, data_cast_level};
        default:
            break;
    }
    return binary(type, "+", type, data_plus_level, depth);
}

/// Returns an interval such as `{a to b}` or `[a, b)`.
std::string Expressions::interval(std::size_t depth) {
    const std::string low = text_at_level(data_quantifier_level, *types_.nat(), depth);
    const std::string high = text_at_level(data_quantifier_level, *types_.nat(), depth);
    if (random_.chance(50)) return fmt::format("{{{} to {}}}", low, high);
    const bool open = random_.chance(50);
    const bool open_end = random_.chance(50);
    return fmt::format("{}{}, {}{}", open ? "(" : "[", low, high, open_end ? ")" : "]");
}

Written Expressions::set(const DataType& type, std::size_t depth) {
    const DataType& element = *type.parts[0];
    const std::size_t way = random_.below(4);
    if (way == 0 && element.form == Form::nat) return {interval(depth), data_atom_level};
    if (way == 1 && shape_.data.binders) return comprehension(element, depth);
    if (way == 2 && shape_.data.toolkits && calls) return generic_call(type, depth);
    const std::vector<const DataType*> parts(random_.between(1, 3), &element);
    return {"{" + list(parts, depth, data_quantifier_level) + "}", data_atom_level};
}

}  // namespace robochart::random_models
