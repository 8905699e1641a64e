// SPDX-License-Identifier: Apache-2.0
// Makes calls of the generic functions of random models: those of the toolkits and some of the model. The types of a
// call are found by matching the declared result type with the required one.
#include <fmt/format.h>

#include <algorithm>

#include "frontend/project/project.hpp"
#include "frontend/syntax/parse.hpp"
#include "frontend/syntax/print.hpp"
#include "frontend/toolkits/toolkits.hpp"
#include "tests/random_models/models/data.hpp"

namespace robochart::random_models {

using frontend::TypeExpr;
using frontend::TypeKind;

std::vector<Generic> read_generics(const std::string& package, const std::string& text) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    const auto file = frontend::parse(sources, sources.add("functions.rct", text), false, findings);
    std::vector<Generic> result;
    for (const auto& declaration : file->declarations) {
        auto* function = dynamic_cast<frontend::Function*>(declaration.get());
        if (function == nullptr) continue;
        Generic generic{function->name, package, {}, std::move(function->result_expr)};
        for (const frontend::VariablePtr& parameter : function->parameters)
            generic.parameters.push_back(std::move(parameter->type_expr));
        result.push_back(std::move(generic));
    }
    return result;
}

const std::vector<Generic>& toolkit_functions() {
    static const std::vector<Generic> functions = [] {
        std::vector<Generic> all;
        for (const frontend::Toolkit& toolkit : frontend::all_toolkits())
            for (Generic& generic : read_generics(std::string(toolkit.package), std::string(toolkit.text)))
                all.push_back(std::move(generic));
        return all;
    }();
    return functions;
}

namespace {

Form form_of(TypeKind kind) {
    switch (kind) {
        case TypeKind::sequence:
            return Form::sequence;
        case TypeKind::set:
            return Form::set;
        case TypeKind::product:
            return Form::product;
        case TypeKind::function:
            return Form::function;
        case TypeKind::relation:
        case TypeKind::name:
        case TypeKind::variable:
        case TypeKind::vector:
        case TypeKind::matrix:
            break;
    }
    return Form::relation;
}

/// Parenthesises operands of `*`, `->` and `<->`.
std::string operand(const DataType& type) {
    const bool loose = type.form == Form::product || type.form == Form::function || type.form == Form::relation ||
                       type.form == Form::vector || type.form == Form::matrix;  // RC-P26
    return loose ? "(" + type.written + ")" : type.written;
}

/// Returns the operator of a product, function or relation type.
const char* type_operator(Form form) {
    if (form == Form::product) return " * ";
    return form == Form::function ? " -> " : " <-> ";
}

std::string written_type(const DataType& type) {
    if (type.form == Form::sequence) return "Seq(" + type.parts[0]->written + ")";
    if (type.form == Form::set) return "Set(" + type.parts[0]->written + ")";
    const std::string sign = type_operator(type.form);
    std::string out;
    for (const DataType* part : type.parts) out += (out.empty() ? "" : sign) + operand(*part);
    return out;
}

/// Returns whether a type variable of a toolkit is restricted to numbers.
bool is_numeric(const TypeExpr& variable) {
    return variable.name.text() == "Number";
}

}  // namespace

const DataType* Types::sought_type(DataType type) {
    for (const std::deque<DataType>* types : {&types_, &sought_})
        for (const DataType& known : *types)
            if (known.written == type.written) return &known;
    sought_.push_back(std::move(type));
    return &sought_.back();
}

/// Returns `nat`, `int` or `boolean`, even if the shape has no such variables.
const DataType* Types::basic(const std::string& name) const {
    static const DataType integer{Form::integer, "int", {}, {}, 0, 0, {}};
    for (const DataType& known : types_)
        if (known.written == name) return &known;
    return name == integer.written ? &integer : nullptr;
}

bool Types::unify(const TypeExpr& written, const DataType& type, TypeChoice& choice) const {
    if (written.kind == TypeKind::variable) {
        if (is_numeric(written) && !is_number(type)) return false;
        const auto [slot, fresh] = choice.emplace(written.name.text(), &type);
        return fresh || slot->second == &type;
    }
    if (written.kind == TypeKind::name) {
        const DataType* known = basic(written.name.text());
        return known != nullptr && fits_type(*known, type);
    }
    if (form_of(written.kind) != type.form || written.args.size() != type.parts.size()) return false;
    for (std::size_t i = 0; i < type.parts.size(); ++i)
        if (!unify(*written.args[i], *type.parts[i], choice)) return false;
    return true;
}

const DataType* Types::instance(const TypeExpr& expr, TypeChoice& choice) {
    if (expr.kind == TypeKind::name) return basic(expr.name.text());
    if (expr.kind == TypeKind::variable) {
        const auto [slot, fresh] = choice.emplace(expr.name.text(), nullptr);
        if (fresh) slot->second = is_numeric(expr) ? basic("nat") : existing_part();
        return slot->second;
    }
    DataType type;
    type.form = form_of(expr.kind);
    for (const frontend::TypeExprPtr& part : expr.args) type.parts.push_back(instance(*part, choice));
    type.written = written_type(type);
    return sought_type(std::move(type));
}

void Types::declare_generics() {
    if (!shape_.data.toolkits) return;
    const std::vector<std::string> heads = {"(p : ?X, q : Seq(?X)) : ?X", "(p : ?X -> ?Y, q : ?X) : Seq(?Y)",
                                            "(p : ?X <-> ?Y) : ?Y -> ?X", "() : Set(?X)"};
    for (std::size_t i = random_.below(3); i > 0; --i) {
        const std::string name = names_.unused_name("gen");
        const std::string head = random_.pick(heads);
        declarations_.push_back("function " + name + head + " {\n}\n");
        for (Generic& generic : read_generics("", declarations_.back())) {
            generic.name = name;  // in the written form, with its `^`
            generics_.push_back(std::move(generic));
        }
    }
}

// ---------------------------------------------------------------- expressions

/// Returns a call of a generic function whose result fits the type.
Written Expressions::generic_call(const DataType& type, std::size_t depth) {
    std::vector<std::pair<const Generic*, TypeChoice>> found;
    for (const std::vector<Generic>* functions : {&toolkit_functions(), &types_.generics()})
        for (const Generic& function : *functions) {
            TypeChoice choice;
            if (types_.unify(*function.result, type, choice)) found.emplace_back(&function, std::move(choice));
        }
    if (found.empty()) return leaf(type);
    const auto& [function, choice] = random_.pick(found);
    return generic_call(*function, choice, depth);
}

Written Expressions::generic_call(const Generic& function, TypeChoice choice, std::size_t depth) {
    constexpr int call_level = 12;
    std::vector<const DataType*> parameters;
    for (const frontend::TypeExprPtr& parameter : function.parameters)
        parameters.push_back(types_.instance(*parameter, choice));
    const bool qualified = !function.package.empty() && random_.chance(20);
    const std::string package = qualified ? function.package + "::" : "";
    return {package + function.name + "(" + list(parameters, depth, -1) + ")", call_level};
}

/// Returns `f(..) == e` for any function, because the result types of some functions occur nowhere else.
Written Expressions::generic_comparison(std::size_t depth) {
    constexpr int compare_level = 5;
    const Generic& function = random_.pick(toolkit_functions());
    TypeChoice choice;
    const DataType& result = *types_.instance(*function.result, choice);
    const std::string left = generic_call(function, choice, depth).text;
    return {left + (random_.chance(70) ? " == " : " != ") + text_at_level(compare_level + 1, result, depth),
            compare_level};
}

/// Returns `lambda x : A @ e`, in parentheses if it is an argument or operand. For a relation, returns the set of its
/// pairs.
std::string Expressions::mapping(const DataType& type, std::size_t depth) {
    if (type.form == Form::function) {
        scope.push_back({"b" + std::to_string(bound_++), type.parts[0]});
        const std::string name = scope.back().name;
        std::string domain;
        if (random_.chance(30)) domain = " | " + list({types_.boolean()}, depth, -1);
        const std::string body = list({type.parts[1]}, depth, -1);
        scope.pop_back();
        return fmt::format("(lambda {} : {}{} @ {})", name, type.parts[0]->written, domain, body);
    }
    std::string out;
    for (std::size_t i = random_.below(3); i > 0; --i)
        out += (out.empty() ? "" : ", ") + ("(|" + tuple_parts(type, depth) + "|)");
    return "{" + out + "}";
}

/// Returns `E::L` or `E::L(a, b)`.
std::string Expressions::literal_of(const DataType& type, std::size_t depth) {
    const std::size_t which = random_.below(type.labels.size());
    const std::string name = type.written + "::" + type.labels[which];
    const std::vector<const DataType*>& arguments = type.arguments[which];
    return arguments.empty() ? name : name + "(" + list(arguments, depth, -1) + ")";
}

/// Returns `e is T`, where T is the type of e, or a narrower or wider one.
Written Expressions::type_test(std::size_t depth) {
    constexpr int cast_level = 7;
    const DataType& type = *types_.existing_type();
    const DataType& other = *types_.existing_type();
    const bool related = fits_type(type, other) || fits_type(other, type);
    const std::string value = text_at_level(cast_level + 1, type, depth);
    return {fmt::format("{} is {}", value, related ? other.written : type.written), cast_level};
}

/// Returns `{x : T}`, with a condition, a result expression, or both.
Written Expressions::comprehension(const DataType& element, std::size_t depth) {
    scope.push_back({"b" + std::to_string(bound_++), &element});
    const std::string name = scope.back().name;
    std::string condition;
    if (!shape_.data.type_tests || random_.chance(70)) condition = " | " + list({types_.boolean()}, depth + 1, -1);
    std::string body;
    if (random_.chance(50)) body = " @ " + list({&element}, depth + 1, -1);
    scope.pop_back();
    return {fmt::format("{{{} : {}{}{}}}", name, element.written, condition, body), 13};
}

/// Returns a vector or matrix: a sum, a transpose, an inverse, or one that is built from its parts.
Written Expressions::matrix(const DataType& type, std::size_t depth) {
    constexpr int plus_level = 8;
    const std::size_t way = random_.below(10);
    if (way < 3) return binary(type, random_.chance(50) ? "+" : "-", type, plus_level, depth);
    const bool square = type.rows == type.columns;
    if (way == 3 && square && type.form == Form::matrix && type.parts[0]->form == Form::real)
        return {"inverse(" + list({&type}, depth + 1, -1) + ")", 13};
    if (way < 6 && type.form == Form::matrix && type.columns > 1) {
        DataType turned = type;
        std::swap(turned.rows, turned.columns);
        turned.written = fmt::format("matrix({}, {}, {})", type.parts[0]->written, turned.rows, turned.columns);
        return {"transpose(" + list({types_.sought_type(std::move(turned))}, depth + 1, -1) + ")", 13};
    }
    return {constructor(type, depth), 13};
}

}  // namespace robochart::random_models
