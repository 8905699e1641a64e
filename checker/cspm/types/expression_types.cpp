// SPDX-License-Identifier: Apache-2.0
// Infers the types of expressions and patterns (FDR manual, chapter CSPM: functional syntax, defining processes).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "checker/cspm/types/expression_types.hpp"
#include "checker/cspm/types/rules.hpp"

namespace robochart::cspm::types {

namespace {

const Term& inside_parentheses(const Term& term) {
    const Term* result = &term;
    while (result->syntax->kind == ExprKind::parenthesised) result = result->args[0];
    return *result;
}

std::string arguments_text(std::size_t count) {
    return std::to_string(count) + (count == 1 ? " argument" : " arguments");
}

}  // namespace

// ---------------------------------------------------------------- expectations

TypeId ExpressionTypes::unify(diagnostics::Span span, TypeId expected, TypeId actual, std::string_view because) {
    const diagnostics::Span before = std::exchange(here_, span);
    try {
        const TypeId result = unifier_.unify(expected, actual);
        here_ = before;
        return result;
    } catch (TypeFault& fault) {
        here_ = before;
        if (!because.empty()) fault.notes.push_back({span, std::string(because)});
        throw;
    }
}

void ExpressionTypes::constrain(diagnostics::Span span, Constraint constraint, TypeId type, std::string_view because) {
    const diagnostics::Span before = std::exchange(here_, span);
    try {
        unifier_.constrain(constraint, type);
        here_ = before;
    } catch (TypeFault& fault) {
        here_ = before;
        if (!because.empty()) fault.notes.push_back({span, std::string(because)});
        throw;
    }
}

TypeId ExpressionTypes::expect_type(const Term& term, TypeId type, std::string_view because) {
    const TypeId actual = infer(term);
    return unify(inside_parentheses(term).syntax->span, type, actual, because);
}

// Requires a type of this kind. Reports an error at the branch or the body of a let that causes it, and not at the
// whole expression.
void ExpressionTypes::expect_atom(const Term& term, TypeKind kind, std::string_view because) {
    const Term& at = inside_parentheses(term);
    if (at.syntax->kind == ExprKind::if_then_else) {
        expect_atom(*at.args[0], TypeKind::boolean, "the condition of an `if` is a Bool");
        expect_atom(*at.args[1], kind, because);
        expect_atom(*at.args[2], kind, because);
    } else if (at.syntax->kind == ExprKind::let) {
        check_let_(*at.decls);
        expect_atom(*at.args[0], kind, because);
    } else {
        (void)expect_type(at, atom(kind), because);
    }
}

TypeId ExpressionTypes::expect_extendable(const Term& term, TypeId type, std::string_view because) {
    return expect_type(term, store_.extendable_type(type, store_.fresh_variable()), because);
}

void ExpressionTypes::expect_processes(const Term& term, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        expect_atom(*term.args[i], TypeKind::process,
                    "the operator takes processes; an event needs a process after it: `a -> P`");
    }
}

void ExpressionTypes::expect_events(const Term& term, std::size_t index) {
    (void)expect_type(*term.args[index], store_.set_of(atom(TypeKind::event)),
                      "the operator takes a set of events here; `{| c |}` are all events of channel c");
}

// ---------------------------------------------------------------- values

TypeId ExpressionTypes::infer(const Term& term) {
    diagnostics_.poll();
    switch (term.syntax->kind) {
        case ExprKind::parenthesised:
            return infer(*term.args[0]);
        case ExprKind::name:
            return infer_name(term);
        case ExprKind::apply:
            return infer_application(term);
        case ExprKind::prefix:
            return infer_prefix(term);
        case ExprKind::let:
            return infer_let(term);
        case ExprKind::dot:
            return infer_dot(term);
        case ExprKind::if_then_else:
            return infer_conditional(term);
        case ExprKind::lambda:
            return infer_lambda(term);
        default:
            return infer_value(term);
    }
}

TypeId ExpressionTypes::infer_value(const Term& term) {
    using enum ExprKind;
    switch (term.syntax->kind) {
        case integer:
            return atom(TypeKind::integer);
        case character:
            return atom(TypeKind::character);
        case string:
            return store_.sequence_of(atom(TypeKind::character));
        case boolean:
            return atom(TypeKind::boolean);
        case tuple:
            return this->infer_tuple(term);
        case ExprKind::map:
            return this->infer_map(term);
        case negate:
        case plus:
        case minus:
        case times:
        case divide:
        case modulus:
            for (const Term* argument : term.args)
                expect_atom(*argument, TypeKind::integer, "arithmetic is done on integers");
            return atom(TypeKind::integer);
        case equal:
        case not_equal:
        case less:
        case less_equal:
        case greater:
        case greater_equal:
            return infer_comparison(term);
        case logical_not:
        case logical_and:
        case logical_or:
            for (const Term* argument : term.args)
                expect_atom(*argument, TypeKind::boolean, "`not`, `and` and `or` take Bools");
            return atom(TypeKind::boolean);
        case concat: {
            const TypeId sequence = store_.sequence_of(store_.fresh_variable());
            const TypeId left = expect_type(*term.args[0], sequence, "`^` joins sequences");
            return expect_type(*term.args[1], left, "`^` joins sequences of one type");
        }
        case length:
            (void)expect_type(*term.args[0], store_.sequence_of(store_.fresh_variable()),
                              "`#` gives the length of a sequence");
            return atom(TypeKind::integer);
        default:
            return infer_collection(term);
    }
}

TypeId ExpressionTypes::infer_name(const Term& term) {
    if (term.symbol == nullptr || term.symbol->failed) return store_.fresh_variable();
    return unifier_.instantiate(term.symbol->scheme);
}

TypeId ExpressionTypes::infer_tuple(const Term& term) {
    std::vector<TypeId> types;
    for (const Term* argument : term.args) types.push_back(infer(*argument));
    return store_.make_type(TypeKind::tuple, types);
}

TypeId ExpressionTypes::infer_map(const Term& term) {
    const TypeId key = store_.fresh_variable();
    const TypeId value = store_.fresh_variable();
    for (std::size_t i = 0; i + 1 < term.args.size(); i += 2) {
        (void)expect_type(*term.args[i], key, "the keys of a map have one type");
        (void)expect_type(*term.args[i + 1], value, "the values of a map have one type");
    }
    return store_.make_type(TypeKind::map, {key, value});
}

TypeId ExpressionTypes::infer_dot(const Term& term) {
    std::vector<TypeId> types;
    for (const Term* argument : term.args) types.push_back(infer(*argument));
    return store_.dot_type(types);
}

TypeId ExpressionTypes::infer_conditional(const Term& term) {
    expect_atom(*term.args[0], TypeKind::boolean, "the condition of an `if` is a Bool");
    const TypeId type = infer(*term.args[1]);
    return expect_type(*term.args[2], type, "both branches of an `if` have one type");
}

TypeId ExpressionTypes::infer_comparison(const Term& term) {
    const TypeId left = infer(*term.args[0]);
    const TypeId type = expect_type(*term.args[1], left, "both sides of a comparison have one type");
    const bool equality = term.syntax->kind == ExprKind::equal || term.syntax->kind == ExprKind::not_equal;
    constrain(term.syntax->span, equality ? can_equal : can_order, type,
              equality ? "`==` and `!=` compare values for equality" : "`<`, `<=`, `>` and `>=` order values");
    return atom(TypeKind::boolean);
}

TypeId ExpressionTypes::infer_let(const Term& term) {
    check_let_(*term.decls);
    return infer(*term.args[0]);
}

TypeId ExpressionTypes::infer_lambda(const Term& term) {
    bind_locals(term.binds);
    const TypeId result = infer(*term.args[0]);
    std::vector<TypeId> types;
    for (const PatternTerm& pattern : term.patterns) types.push_back(infer_pattern(pattern));
    types.push_back(result);
    return store_.make_type(TypeKind::function, types);
}

namespace {

/// Returns the parameters of a function as text, such as " (id__, x)", if all of them are names in its first equation.
std::string parameters_text(const Symbol* function) {
    if (function == nullptr || function->owner == nullptr || function->owner->equations.empty()) return "";
    const auto& groups = function->owner->equations.front().groups;
    std::vector<std::string> names;
    for (const PatternTerm& pattern : groups.empty() ? std::vector<PatternTerm>{} : groups.front()) {
        if (pattern.syntax == nullptr || pattern.syntax->kind != PatternKind::name) return "";
        names.push_back(pattern.syntax->text);
    }
    return names.empty() ? "" : fmt::format(" ({})", fmt::join(names, ", "));
}

}  // namespace

TypeId ExpressionTypes::infer_application(const Term& term) {
    const Term& function = *term.args[0];
    const std::size_t count = term.args.size() - 1;
    const TypeId type = store_.head(infer(function));
    const TypeKind kind = store_.node(type).kind;
    const diagnostics::Span span = inside_parentheses(function).syntax->span;
    std::vector<TypeId> expected;
    if (kind == TypeKind::function) {
        expected = store_.arguments(type);
        if (expected.size() != count + 1) {
            const std::string subject = inside_parentheses(function).symbol != nullptr
                                            ? "'" + inside_parentheses(function).symbol->name + "'"
                                            : "this function";
            throw TypeFault{
                &rules::wrong_arity,
                {subject, arguments_text(expected.size() - 1) + parameters_text(inside_parentheses(function).symbol),
                 arguments_text(count)},
                {},
                term.syntax->span};
        }
    } else if (kind == TypeKind::variable && !store_.node(type).rigid) {
        for (std::size_t i = 0; i <= count; ++i) expected.push_back(store_.fresh_variable());
        (void)unify(span, store_.make_type(TypeKind::function, expected), type);
    } else {
        TypeWriter writer(store_);
        TypeFault fault{&rules::not_a_function, {writer.type_text(type)}, {}, span};
        if (fault.arguments.front() == "Proc")
            fault.notes.push_back({span, "a process without parameters is named without parentheses"});
        throw fault;
    }
    std::vector<TypeId> given;
    for (std::size_t i = 0; i < count; ++i) given.push_back(infer(*term.args[i + 1]));
    for (std::size_t i = 0; i < count; ++i) {
        here_ = inside_parentheses(*term.args[i + 1]).syntax->span;
        const TypeId actual = unifier_.evaluate_dots(given[i]);
        (void)unifier_.unify_one_way(unifier_.evaluate_dots(expected[i]), actual);
    }
    return expected.back();
}

// ---------------------------------------------------------------- sets, sequences

TypeId ExpressionTypes::infer_elements(const Term& term, Constraints constraints) {
    const TypeId type = store_.fresh_variable(constraints);
    for (const Term* element : term.args) (void)expect_type(*element, type, "the elements have one type");
    return type;
}

void ExpressionTypes::check_range(const Term& term) {
    for (const Term* bound : term.args) {
        if (bound != nullptr) expect_atom(*bound, TypeKind::integer, "a range runs over integers");
    }
}

TypeId ExpressionTypes::infer_collection(const Term& term) {
    using enum ExprKind;
    const ExprKind kind = term.syntax->kind;
    const bool sequences = kind == sequence || kind == sequence_comprehension || kind == sequence_range ||
                           kind == sequence_range_comprehension;
    bind_locals(term.binds);
    switch (kind) {
        case sequence:
        case set:
        case sequence_comprehension:
        case set_comprehension: {
            check_clauses(term.clauses, sequences ? TypeKind::sequence : TypeKind::set);
            const TypeId element = infer_elements(term, sequences ? Constraints{0} : Constraints{can_collect});
            return sequences ? store_.sequence_of(element) : store_.set_of(element);
        }
        case sequence_range:
        case set_range:
        case sequence_range_comprehension:
        case set_range_comprehension:
            check_clauses(term.clauses, sequences ? TypeKind::sequence : TypeKind::set);
            check_range(term);
            return sequences ? store_.sequence_of(atom(TypeKind::integer)) : store_.set_of(atom(TypeKind::integer));
        case productions:
        case productions_comprehension: {
            check_clauses(term.clauses, TypeKind::set);
            const TypeId type = store_.fresh_variable(can_yield);
            for (const Term* argument : term.args) {
                (void)expect_extendable(*argument, type,
                                        "`{| |}` takes channels and constructors, with their first fields");
            }
            return store_.set_of(type);
        }
        default:
            return infer_process(term);
    }
}

// ---------------------------------------------------------------- processes

TypeId ExpressionTypes::infer_prefix(const Term& term) {
    const Term& event = *term.args[0];
    const TypeId channel = infer(event);
    bind_locals(term.binds);
    std::vector<TypeId> parts{channel};
    for (const FieldTerm& field : term.fields) parts.push_back(infer_field(field));
    diagnostics::Span span = inside_parentheses(event).syntax->span;
    if (!term.fields.empty()) span = diagnostics::join_spans(span, term.fields.back().span);
    (void)unify(span, atom(TypeKind::event), store_.dot_type(parts), "an event must precede `->`");
    expect_atom(*term.args[1], TypeKind::process, "a process must follow `->`");
    return atom(TypeKind::process);
}

TypeId ExpressionTypes::infer_field(const FieldTerm& field) {
    if (field.pattern.syntax == nullptr) return infer(*field.value);
    const TypeId values = field.value != nullptr ? infer(*field.value) : no_type;
    const TypeId type = infer_pattern(field.pattern);
    if (field.value != nullptr) {
        (void)unify(inside_parentheses(*field.value).syntax->span, store_.set_of(type), values,
                    "an input is restricted by a set");
    }
    constrain(field.span, can_input, type, "an input takes whole values");
    return type;
}

TypeId ExpressionTypes::infer_process(const Term& term) {
    using enum ExprKind;
    switch (term.syntax->kind) {
        case guard:
            expect_atom(*term.args[0], TypeKind::boolean, "a guard is a Bool");
            expect_atom(*term.args[1], TypeKind::process, "a process must follow a guard");
            break;
        case external_choice:
        case internal_choice:
        case sequential:
        case interrupt:
        case sliding_choice:
        case interleave:
            expect_processes(term, 2);
            break;
        case parallel:
        case exception:
        case synchronising_choice:
        case synchronising_interrupt:
            expect_processes(term, 2);
            expect_events(term, 2);
            break;
        case alphabetised:
            expect_processes(term, 2);
            expect_events(term, 2);
            expect_events(term, 3);
            break;
        case hide:
        case project:
            expect_processes(term, 1);
            expect_events(term, 1);
            break;
        case rename:
        case linked:
            expect_processes(term, term.args.size());
            bind_locals(term.binds);
            check_clauses(term.clauses, TypeKind::set);
            check_links(term);
            break;
        default:
            return infer_replicated(term);
    }
    return atom(TypeKind::process);
}

TypeId ExpressionTypes::infer_replicated(const Term& term) {
    using enum ExprKind;
    const ExprKind kind = term.syntax->kind;
    if (kind == replicated_parallel || kind == replicated_synchronising) expect_events(term, 1);
    bind_locals(term.binds);
    const bool ordered = kind == replicated_sequential || kind == replicated_linked;
    check_clauses(term.clauses, ordered ? TypeKind::sequence : TypeKind::set);
    if (kind == replicated_alphabetised) expect_events(term, 1);
    check_clauses(term.link_clauses, TypeKind::set);
    check_links(term);
    expect_processes(term, 1);
    return atom(TypeKind::process);
}

// Checks links and renamings. Both ends must become events when the same fields are added to them.
void ExpressionTypes::check_links(const Term& term) {
    std::vector<TypeId> left;
    for (const LinkTerm& link : term.links) {
        left.push_back(
            expect_extendable(*link.from, atom(TypeKind::event), "events and channels are renamed and linked"));
    }
    for (std::size_t i = 0; i < left.size(); ++i) {
        (void)expect_type(*term.links[i].to, left[i], "both sides take the same further fields");
    }
}

void ExpressionTypes::check_clauses(const std::vector<ClauseTerm>& clauses, TypeKind collection) {
    for (const ClauseTerm& clause : clauses) {
        if (!clause.generator) {
            expect_atom(*clause.value, TypeKind::boolean, "a condition is a Bool");
            continue;
        }
        const TypeId values = infer(*clause.value);
        here_ = inside_parentheses(*clause.value).syntax->span;
        const TypeId evaluated = unifier_.evaluate_dots(values);
        const TypeId element = unifier_.evaluate_dots(infer_pattern(clause.pattern));
        here_ = inside_parentheses(*clause.value).syntax->span;
        try {
            (void)unifier_.unify_one_way(store_.make_type(collection, {element}), evaluated);
        } catch (TypeFault& fault) {
            fault.notes.push_back({here_, collection == TypeKind::set ? "a generator draws from a set here"
                                                                      : "a generator draws from a sequence here"});
            throw;
        }
    }
}

// ---------------------------------------------------------------- patterns

void ExpressionTypes::bind_locals(const std::vector<Symbol*>& symbols) {
    for (Symbol* symbol : symbols) {
        symbol->scheme = {{}, store_.fresh_variable()};
        symbol->failed = false;
    }
}

void ExpressionTypes::expect_pattern(const PatternTerm& term, TypeId type) {
    (void)unify(term.syntax->span, type, infer_pattern(term));
}

TypeId ExpressionTypes::infer_pattern(const PatternTerm& term) {
    switch (term.syntax->kind) {
        case PatternKind::wildcard:
            return store_.fresh_variable();
        case PatternKind::name:
            return term.symbol == nullptr || term.symbol->failed ? store_.fresh_variable() : term.symbol->scheme.type;
        case PatternKind::integer:
            return atom(TypeKind::integer);
        case PatternKind::character:
            return atom(TypeKind::character);
        case PatternKind::string:
            return store_.sequence_of(atom(TypeKind::character));
        case PatternKind::boolean:
            return atom(TypeKind::boolean);
        case PatternKind::tuple:
        case PatternKind::dot: {
            std::vector<TypeId> types;
            for (const PatternTerm& argument : term.args) types.push_back(infer_pattern(argument));
            const bool dot = term.syntax->kind == PatternKind::dot;
            return dot ? store_.dot_type(types) : store_.make_type(TypeKind::tuple, types);
        }
        case PatternKind::sequence:
        case PatternKind::set: {
            const TypeId element = store_.fresh_variable();
            for (const PatternTerm& argument : term.args) expect_pattern(argument, element);
            if (term.syntax->kind == PatternKind::sequence) return store_.sequence_of(element);
            // Eq instead of Set, because matching a pattern compares elements.
            constrain(term.syntax->span, can_equal, element, "a pattern compares what it matches");
            return store_.set_of(element);
        }
        case PatternKind::concat: {
            const TypeId sequence = store_.sequence_of(store_.fresh_variable());
            for (const PatternTerm& argument : term.args) expect_pattern(argument, sequence);
            return sequence;
        }
        case PatternKind::both: {
            const TypeId type = infer_pattern(term.args.at(0));
            expect_pattern(term.args.at(1), type);
            return type;
        }
    }
    return store_.fresh_variable();
}

}  // namespace robochart::cspm::types
