// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/syntax/build.hpp"

#include <limits>
#include <utility>

namespace robochart::cspm::build {

namespace {

ExprPtr share_node(Expr node) {
    return std::make_shared<const Expr>(std::move(node));
}
PatternPtr share_node(Pattern node) {
    return std::make_shared<const Pattern>(std::move(node));
}
DeclPtr share_node(Decl node) {
    return std::make_shared<const Decl>(std::move(node));
}

ExprPtr node(ExprKind kind, Exprs args = {}) {
    Expr result;
    result.kind = kind;
    result.args = std::move(args);
    return share_node(std::move(result));
}

ExprPtr leaf(ExprKind kind, std::string text, std::int64_t number = 0) {
    Expr result;
    result.kind = kind;
    result.text = std::move(text);
    result.number = number;
    return share_node(std::move(result));
}

ExprPtr comprehension(ExprKind kind, Exprs heads, std::vector<Clause> clauses) {
    Expr result;
    result.kind = kind;
    result.args = std::move(heads);
    result.clauses = std::move(clauses);
    return share_node(std::move(result));
}

ExprPtr make_linked(ExprKind kind, Exprs args, std::vector<Link> links, std::vector<Clause> clauses) {
    Expr result;
    result.kind = kind;
    result.args = std::move(args);
    result.links = std::move(links);
    result.clauses = std::move(clauses);
    return share_node(std::move(result));
}

ExprPtr fold_operands(ExprKind op, Exprs operands, const ExprPtr& empty) {
    if (operands.empty()) return empty;
    ExprPtr result = operands.front();
    for (std::size_t i = 1; i < operands.size(); ++i) result = binary(op, result, operands[i]);
    return result;
}

PatternPtr pattern(PatternKind kind, Patterns args) {
    Pattern result;
    result.kind = kind;
    result.args = std::move(args);
    return share_node(std::move(result));
}

Field field(FieldKind kind, PatternPtr pattern, ExprPtr value) {
    Field result;
    result.kind = kind;
    result.pattern = std::move(pattern);
    result.value = std::move(value);
    return result;
}

Decl declaration(DeclKind kind, std::vector<std::string> names, std::string comment = "") {
    Decl result;
    result.kind = kind;
    result.names = std::move(names);
    result.comment = std::move(comment);
    return result;
}

DeclPtr with_body(DeclKind kind, std::vector<std::string> names, ExprPtr body, std::string comment) {
    Decl result = declaration(kind, std::move(names), std::move(comment));
    result.body = std::move(body);
    return share_node(std::move(result));
}

}  // namespace

// ---------------------------------------------------------------- patterns

PatternPtr wildcard() {
    return pattern(PatternKind::wildcard, {});
}

PatternPtr variable(std::string name) {
    Pattern result;
    result.kind = PatternKind::name;
    result.text = std::move(name);
    return share_node(std::move(result));
}

PatternPtr integer_pattern(std::int64_t value) {
    Pattern result;
    result.kind = PatternKind::integer;
    result.number = value;
    return share_node(std::move(result));
}

PatternPtr boolean_pattern(bool value) {
    Pattern result;
    result.kind = PatternKind::boolean;
    result.number = value ? 1 : 0;
    return share_node(std::move(result));
}

PatternPtr tuple_pattern(Patterns parts) {
    return pattern(PatternKind::tuple, std::move(parts));
}
PatternPtr dot_pattern(Patterns parts) {
    return pattern(PatternKind::dot, std::move(parts));
}
PatternPtr sequence_pattern(Patterns parts) {
    return pattern(PatternKind::sequence, std::move(parts));
}

Patterns variables(const std::vector<std::string>& names) {
    Patterns result;
    for (const std::string& name : names) result.push_back(variable(name));
    return result;
}

// ---------------------------------------------------------------- values

ExprPtr number(std::int64_t value) {
    constexpr auto least = std::numeric_limits<std::int64_t>::min();  // its absolute value is not representable
    if (value == least) return binary(ExprKind::minus, number(least + 1), number(1));
    if (value < 0) return negate(leaf(ExprKind::integer, "", -value));
    return leaf(ExprKind::integer, "", value);
}

ExprPtr boolean(bool value) {
    return leaf(ExprKind::boolean, "", value ? 1 : 0);
}
ExprPtr string(std::string value) {
    return leaf(ExprKind::string, std::move(value));
}
ExprPtr name(std::string text) {
    return leaf(ExprKind::name, std::move(text));
}
ExprPtr tuple(Exprs parts) {
    return node(ExprKind::tuple, std::move(parts));
}
ExprPtr sequence(Exprs items) {
    return node(ExprKind::sequence, std::move(items));
}
ExprPtr set(Exprs items) {
    return node(ExprKind::set, std::move(items));
}

ExprPtr set_range(ExprPtr first, ExprPtr last) {
    return node(ExprKind::set_range, {std::move(first), std::move(last)});
}

ExprPtr set_comprehension(Exprs heads, std::vector<Clause> clauses) {
    return comprehension(ExprKind::set_comprehension, std::move(heads), std::move(clauses));
}

ExprPtr sequence_comprehension(Exprs heads, std::vector<Clause> clauses) {
    return comprehension(ExprKind::sequence_comprehension, std::move(heads), std::move(clauses));
}

ExprPtr productions(Exprs items) {
    return node(ExprKind::productions, std::move(items));
}

ExprPtr productions_comprehension(Exprs heads, std::vector<Clause> clauses) {
    return comprehension(ExprKind::productions_comprehension, std::move(heads), std::move(clauses));
}

ExprPtr dot(Exprs parts) {
    Exprs flat;
    for (const ExprPtr& part : parts) {
        if (part->kind == ExprKind::dot) {
            flat.insert(flat.end(), part->args.begin(), part->args.end());
        } else {
            flat.push_back(part);
        }
    }
    if (flat.size() == 1) return flat.front();
    return node(ExprKind::dot, std::move(flat));
}

ExprPtr apply(ExprPtr function, Exprs arguments) {
    arguments.insert(arguments.begin(), std::move(function));
    return node(ExprKind::apply, std::move(arguments));
}

ExprPtr call(std::string function, Exprs arguments) {
    if (arguments.empty()) return name(std::move(function));
    return apply(name(std::move(function)), std::move(arguments));
}

ExprPtr lambda(Patterns parameters, ExprPtr body) {
    Expr result;
    result.kind = ExprKind::lambda;
    result.patterns = std::move(parameters);
    result.args = {std::move(body)};
    return share_node(std::move(result));
}

ExprPtr let_(Decls decls, ExprPtr body) {
    if (decls.empty()) return body;
    Expr result;
    result.kind = ExprKind::let;
    result.decls = std::move(decls);
    result.args = {std::move(body)};
    return share_node(std::move(result));
}

ExprPtr if_(ExprPtr condition, ExprPtr then, ExprPtr otherwise) {
    return node(ExprKind::if_then_else, {std::move(condition), std::move(then), std::move(otherwise)});
}

ExprPtr binary(ExprKind op, ExprPtr left, ExprPtr right) {
    return node(op, {std::move(left), std::move(right)});
}
ExprPtr negate(ExprPtr operand) {
    return node(ExprKind::negate, {std::move(operand)});
}
ExprPtr logical_not(ExprPtr operand) {
    return node(ExprKind::logical_not, {std::move(operand)});
}
ExprPtr all_of(Exprs operands) {
    return fold_operands(ExprKind::logical_and, std::move(operands), boolean(true));
}
ExprPtr any_of(Exprs operands) {
    return fold_operands(ExprKind::logical_or, std::move(operands), boolean(false));
}

ExprPtr union_of(Exprs sets) {
    if (sets.empty()) return set({});
    ExprPtr result = sets.front();
    for (std::size_t i = 1; i < sets.size(); ++i) result = call("union", {result, sets[i]});
    return result;
}

// ---------------------------------------------------------------- clauses

Clause generator(PatternPtr pattern, ExprPtr from) {
    return {std::move(pattern), std::move(from)};
}
Clause generator(std::string name, ExprPtr from) {
    return {variable(std::move(name)), std::move(from)};
}
Clause condition(ExprPtr value) {
    return {nullptr, std::move(value)};
}

// ---------------------------------------------------------------- processes

ExprPtr stop() {
    return name("STOP");
}
ExprPtr skip() {
    return name("SKIP");
}

Field output(ExprPtr value) {
    return field(FieldKind::output, nullptr, std::move(value));
}
Field input(PatternPtr pattern, ExprPtr from) {
    return field(FieldKind::input, std::move(pattern), std::move(from));
}
Field input(std::string name, ExprPtr from) {
    return input(variable(std::move(name)), std::move(from));
}

Field nondeterministic(PatternPtr pattern, ExprPtr from) {
    return field(FieldKind::nondeterministic, std::move(pattern), std::move(from));
}

ExprPtr prefix(ExprPtr event, ExprPtr process) {
    return prefix(std::move(event), {}, std::move(process));
}

ExprPtr prefix(ExprPtr event, std::vector<Field> fields, ExprPtr process) {
    Expr result;
    result.kind = ExprKind::prefix;
    result.fields = std::move(fields);
    result.args = {std::move(event), std::move(process)};
    return share_node(std::move(result));
}

ExprPtr guard(ExprPtr condition, ExprPtr process) {
    return binary(ExprKind::guard, std::move(condition), std::move(process));
}

ExprPtr choice(Exprs processes) {
    return fold_operands(ExprKind::external_choice, std::move(processes), stop());
}
ExprPtr internal_choice(Exprs processes) {
    return fold_operands(ExprKind::internal_choice, std::move(processes), nullptr);
}
ExprPtr sequential(Exprs processes) {
    return fold_operands(ExprKind::sequential, std::move(processes), skip());
}
ExprPtr interleave(Exprs processes) {
    return fold_operands(ExprKind::interleave, std::move(processes), skip());
}

ExprPtr interrupt(ExprPtr process, ExprPtr handler) {
    return binary(ExprKind::interrupt, std::move(process), std::move(handler));
}

ExprPtr sliding_choice(ExprPtr process, ExprPtr other) {
    return binary(ExprKind::sliding_choice, std::move(process), std::move(other));
}

ExprPtr parallel(ExprPtr left, ExprPtr events, ExprPtr right) {
    return node(ExprKind::parallel, {std::move(left), std::move(right), std::move(events)});
}

ExprPtr alphabetised(ExprPtr left, ExprPtr left_alphabet, ExprPtr right_alphabet, ExprPtr right) {
    return node(ExprKind::alphabetised,
                {std::move(left), std::move(right), std::move(left_alphabet), std::move(right_alphabet)});
}

ExprPtr exception(ExprPtr process, ExprPtr events, ExprPtr handler) {
    return node(ExprKind::exception, {std::move(process), std::move(handler), std::move(events)});
}

ExprPtr synchronising_choice(ExprPtr left, ExprPtr events, ExprPtr right) {
    return node(ExprKind::synchronising_choice, {std::move(left), std::move(right), std::move(events)});
}

ExprPtr synchronising_interrupt(ExprPtr left, ExprPtr events, ExprPtr right) {
    return node(ExprKind::synchronising_interrupt, {std::move(left), std::move(right), std::move(events)});
}

ExprPtr hide(ExprPtr process, ExprPtr events) {
    return binary(ExprKind::hide, std::move(process), std::move(events));
}

ExprPtr project(ExprPtr process, ExprPtr events) {
    return binary(ExprKind::project, std::move(process), std::move(events));
}

ExprPtr rename(ExprPtr process, std::vector<Link> links, std::vector<Clause> clauses) {
    return make_linked(ExprKind::rename, {std::move(process)}, std::move(links), std::move(clauses));
}

ExprPtr linked(ExprPtr left, std::vector<Link> links, ExprPtr right) {
    return make_linked(ExprKind::linked, {std::move(left), std::move(right)}, std::move(links), {});
}

ExprPtr replicated(ExprKind op, std::vector<Clause> clauses, ExprPtr body, ExprPtr set) {
    Exprs args{std::move(body)};
    if (set) args.push_back(std::move(set));
    return comprehension(op, std::move(args), std::move(clauses));
}

// ---------------------------------------------------------------- declarations

DeclPtr value(std::string name, ExprPtr body, std::string comment) {
    Decl result = declaration(DeclKind::value, {}, std::move(comment));
    result.patterns = {{variable(std::move(name))}};
    result.body = std::move(body);
    return share_node(std::move(result));
}

DeclPtr function_decl(std::string name, Patterns parameters, ExprPtr body, std::string comment) {
    if (parameters.empty()) return value(std::move(name), std::move(body), std::move(comment));
    Decl result = declaration(DeclKind::function, {std::move(name)}, std::move(comment));
    result.patterns = {std::move(parameters)};
    result.body = std::move(body);
    return share_node(std::move(result));
}

DeclPtr channel(std::vector<std::string> names, ExprPtr fields, std::string comment) {
    return with_body(DeclKind::channel, std::move(names), std::move(fields), std::move(comment));
}

DeclPtr datatype(std::string name, std::vector<Constructor> constructors, std::string comment) {
    Decl result = declaration(DeclKind::datatype, {std::move(name)}, std::move(comment));
    result.constructors = std::move(constructors);
    return share_node(std::move(result));
}

Constructor constructor(std::string name, ExprPtr fields) {
    return {std::move(name), std::move(fields), {}};
}

DeclPtr nametype(std::string name, ExprPtr set, std::string comment) {
    return with_body(DeclKind::nametype, {std::move(name)}, std::move(set), std::move(comment));
}

DeclPtr module_(std::string name, std::vector<std::string> parameters, Decls private_part, Decls exported,
                std::string comment) {
    Decl result = declaration(DeclKind::module, {std::move(name)}, std::move(comment));
    result.parameters = std::move(parameters);
    result.decls = std::move(private_part);
    result.exports = std::move(exported);
    return share_node(std::move(result));
}

DeclPtr instance(std::string name, std::string module, Exprs arguments) {
    Decl result = declaration(DeclKind::instance, {std::move(name)});
    result.text = std::move(module);
    result.arguments = std::move(arguments);
    return share_node(std::move(result));
}

DeclPtr timed(ExprPtr duration, Decls decls) {
    Decl result = declaration(DeclKind::timed, {});
    result.body = std::move(duration);
    result.decls = std::move(decls);
    return share_node(std::move(result));
}

DeclPtr transparent(std::vector<std::string> names) {
    return share_node(declaration(DeclKind::transparent, std::move(names)));
}

DeclPtr external(std::vector<std::string> names) {
    return share_node(declaration(DeclKind::external, std::move(names)));
}
DeclPtr include(std::string path) {
    return share_node(declaration(DeclKind::include, {std::move(path)}));
}

DeclPtr assert_refines(ExprPtr specification, Model model, ExprPtr implementation, bool negated) {
    Decl result = declaration(DeclKind::assertion, {});
    result.assertion.kind = AssertionKind::refinement;
    result.assertion.model = model;
    result.assertion.negated = negated;
    result.assertion.specification = std::move(specification);
    result.assertion.implementation = std::move(implementation);
    return share_node(std::move(result));
}

DeclPtr assert_property(ExprPtr process, AssertionKind kind, Model model, bool negated) {
    Decl result = declaration(DeclKind::assertion, {});
    result.assertion.kind = kind;
    result.assertion.model = model;
    result.assertion.negated = negated;
    result.assertion.specification = std::move(process);
    return share_node(std::move(result));
}

DeclPtr assert_has_trace(ExprPtr process, ExprPtr trace, Model model, bool negated) {
    Decl result = declaration(DeclKind::assertion, {});
    result.assertion.kind = AssertionKind::has_trace;
    result.assertion.model = model;
    result.assertion.negated = negated;
    result.assertion.specification = std::move(process);
    result.assertion.implementation = std::move(trace);
    return share_node(std::move(result));
}

}  // namespace robochart::cspm::build
