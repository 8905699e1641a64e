// SPDX-License-Identifier: Apache-2.0
// Infers types group by group, and generalises them after each group. Reports one finding for an ill-typed group. Its
// names then match every type, so that no further findings follow from the first.
#include <algorithm>
#include <utility>

#include "checker/cspm/types/groups.hpp"
#include "checker/cspm/types/infer.hpp"
#include "checker/cspm/types/rules.hpp"

namespace robochart::cspm::types {

void Inference::run() {
    check_list(*script_.top, ListKind::top);
}

void Inference::check_list(DeclarationList& list, ListKind kind) {
    for (Group& group : dependency_groups(list)) {
        if (kind == ListKind::let) {
            check_group(std::move(group), kind);
            continue;
        }
        const std::uint32_t level = store_.level();
        try {
            check_group(group, kind);
        } catch (TypeFault& fault) {
            fail_group(group, std::move(fault));
        } catch (const TypeOverflow& overflow) {
            const std::string how = overflow.deep ? "nested too deeply" : "too large";
            fail_group(group, {&rules::type_overflow, {how}, {}, terms_.current_span()});
        }
        while (store_.level() > level) store_.leave_level();
    }
}

void Inference::fail_group(const Group& group, TypeFault fault) {
    diagnostics::Diagnostic& finding = diagnostics_.report(*fault.rule, fault.span, std::move(fault.arguments));
    finding.notes = std::move(fault.notes);
    for (const Declaration* declaration : group) {
        for (Symbol* symbol : declaration->binds) symbol->failed = true;
    }
}

namespace {

// Returns an instance whose module belongs to the same group, if any. Such a group is a cycle.
const Declaration* cyclic_instance(const std::vector<Declaration*>& group) {
    for (const Declaration* declaration : group) {
        if (declaration->kind != DeclKind::instance || declaration->module->original == nullptr) continue;
        const Declaration* original = declaration->module->original->symbol->owner;
        if (std::ranges::find(group, original) != group.end()) return declaration;
    }
    return nullptr;
}

bool has_datatypes(const std::vector<Declaration*>& group) {
    return std::ranges::any_of(group,
                               [](const Declaration* declaration) { return declaration->kind == DeclKind::datatype; });
}

}  // namespace

void Inference::check_group(Group group, ListKind kind) {
    if (const Declaration* instance = cyclic_instance(group)) {
        const Module& original = *instance->module->original;
        throw TypeFault{&rules::module_cycle, {original.name, instance->module->name}, {}, instance->span};
    }
    std::stable_partition(group.begin(), group.end(),
                          [](const Declaration* declaration) { return declaration->kind == DeclKind::datatype; });
    if (has_datatypes(group)) {
        check_datatypes_with(group, kind);
    } else {
        try_group(group, kind);
    }
    for (const Declaration* declaration : group) check_fields_known(*declaration, kind);
}

// Checks a group with datatypes. Values of a datatype can be compared if its fields can, but a field may contain the
// datatype. So the inference first assumes that they can be compared, and repeats without this assumption if it fails.
void Inference::check_datatypes_with(const Group& group, ListKind kind) {
    const auto set_comparable = [&](bool value) {
        for (const Declaration* declaration : group) {
            for (const Symbol* symbol : declaration->binds) {
                if (symbol->kind == SymbolKind::datatype) store_.set_comparable(symbol->datatype, value);
            }
        }
    };
    set_comparable(true);
    const std::size_t mark = store_.trail_mark();
    const std::uint32_t level = store_.level();
    ++attempts_;
    store_.recording(true);
    bool done = false;
    try {
        try_group(group, kind);
        done = true;
    } catch (const TypeFault&) {  // checked again below, without the assumption
    } catch (...) {
        store_.recording(--attempts_ > 0);
        throw;
    }
    store_.recording(--attempts_ > 0);
    if (done) return;
    store_.undo_to(mark);
    while (store_.level() > level) store_.leave_level();
    set_comparable(false);
    try_group(group, kind);
}

void Inference::try_group(const Group& group, ListKind kind) {
    store_.enter_level();
    for (const Declaration* declaration : group) {
        for (Symbol* symbol : declaration->binds) symbol->scheme = {{}, store_.fresh_variable()};
    }
    for (Declaration* declaration : group) {
        store_.renew_steps();
        terms_.set_span(declaration->span);
        check_declaration(*declaration);
    }
    store_.leave_level();
    for (const Declaration* declaration : group) generalise(*declaration, kind);
}

void Inference::generalise(const Declaration& declaration, ListKind kind) {
    for (Symbol* symbol : declaration.binds) {
        if (kind == ListKind::let && declaration.annotation == nullptr) {
            (void)store_.lower_and_find(symbol->scheme.type, no_type, store_.level());
        } else {
            symbol->scheme.quantified = store_.open_variables(symbol->scheme.type);
        }
    }
}

// Checks that the types of the fields of channels and constructors are known. In a module with parameters, they may
// depend on the parameters.
void Inference::check_fields_known(const Declaration& declaration, ListKind kind) {
    if (script_.names_missing) return;
    const auto check_symbol = [&](const Symbol& symbol, diagnostics::Span span) {
        if (!symbol.label() || symbol.failed || symbol.scheme.quantified.empty()) return;
        if (store_.kind(symbol.scheme.type) != TypeKind::dotable) return;
        TypeWriter writer(store_);
        throw TypeFault{&rules::open_fields, {symbol.name, writer.type_text(symbol.scheme.type)}, {}, span};
    };
    if (declaration.kind == DeclKind::instance) {
        for (const Copy& copied : declaration.copies) {
            if (copied.checked) check_symbol(*copied.copy, declaration.span);
        }
    } else if (kind == ListKind::top) {
        for (const Symbol* symbol : declaration.binds) check_symbol(*symbol, symbol->span);
    }
}

void Inference::check_declaration(Declaration& declaration) {
    switch (declaration.kind) {
        case DeclKind::function:
            return check_function(declaration);
        case DeclKind::value:
            return check_value(declaration);
        case DeclKind::channel:
            return check_channel(declaration);
        case DeclKind::datatype:
            return check_datatype(declaration);
        case DeclKind::subtype:
            return check_subtype(declaration);
        case DeclKind::nametype:
            return check_nametype(declaration);
        case DeclKind::timed:
            return check_timed(declaration);
        case DeclKind::module:
            return check_module(declaration);
        case DeclKind::instance:
            return check_instance(declaration);
        case DeclKind::assertion:
            return check_assertion(declaration);
        case DeclKind::print:
            return check_print(declaration);
        case DeclKind::transparent:
        case DeclKind::external:
        case DeclKind::annotation:
        case DeclKind::include:
            return;
    }
}

// ---------------------------------------------------------------- annotations

TypeId Inference::bind_annotation(const Annotation& annotation) {
    for (TypeVariable* variable : annotation.binds)
        variable->type = store_.rigid_variable(variable->name, variable->constraints);
    return annotated_type(annotation.type);
}

TypeId Inference::annotated_type(const TypeTerm& term) {
    if (term.kind == TypeKind::variable)
        return term.variable == nullptr ? store_.fresh_variable() : term.variable->type;
    if (term.kind == TypeKind::datatype) return store_.datatype(term.datatype->datatype);
    std::vector<TypeId> args;
    for (const TypeTerm& argument : term.args) args.push_back(annotated_type(argument));
    if (args.empty() && term.kind != TypeKind::tuple) return store_.atom(term.kind);
    if (term.kind == TypeKind::extendable) std::swap(args[0], args[1]);
    return store_.make_type(term.kind, args);
}

// ---------------------------------------------------------------- functions and values

void Inference::check_function(const Declaration& declaration) {
    const TypeId own = declaration.binds.at(0)->scheme.type;
    TypeId signature = no_type;
    if (declaration.annotation != nullptr) signature = bind_annotation(*declaration.annotation);
    std::vector<TypeId> types;
    for (const EquationTerm& equation : declaration.equations) {
        terms_.set_span(equation.span);
        terms_.bind_locals(equation.binds);
        types.push_back(signature == no_type ? infer_equation(equation)
                                             : check_annotated_equation(equation, signature));
    }
    TypeId type = own;
    for (std::size_t i = 0; i < types.size(); ++i) {
        type = terms_.unify(declaration.equations[i].span, type, types[i], "the equations of a function have one type");
    }
}

namespace {

TypeId function_type(TypeStore& store, const std::vector<std::vector<TypeId>>& groups, TypeId result) {
    for (std::size_t i = groups.size(); i > 0; --i) {
        std::vector<TypeId> args = groups[i - 1];
        args.push_back(result);
        result = store.make_type(TypeKind::function, args);
    }
    return result;
}

}  // namespace

// Infers the type of an equation. Checks the patterns again after the body: the body may determine the type of a
// variable, and a dotted pattern may then match more fields.
TypeId Inference::infer_equation(const EquationTerm& equation) {
    std::vector<std::vector<TypeId>> groups;
    const auto patterns = [&] {
        groups.clear();
        for (const auto& group : equation.groups) {
            std::vector<TypeId>& types = groups.emplace_back();
            for (const PatternTerm& pattern : group) {
                terms_.set_span(pattern.syntax->span);
                types.push_back(unifier_.evaluate_dots(terms_.infer_pattern(pattern)));
            }
        }
    };
    patterns();
    const TypeId body = terms_.infer(*equation.body);
    terms_.set_span(equation.body->syntax->span);
    const TypeId result = unifier_.evaluate_dots(body);
    patterns();
    return function_type(store_, groups, result);
}

TypeId Inference::check_annotated_equation(const EquationTerm& equation, TypeId signature) {
    std::vector<std::vector<TypeId>> expected;
    for (const auto& group : equation.groups) {
        std::vector<TypeId>& types = expected.emplace_back();
        for (std::size_t i = 0; i < group.size(); ++i) types.push_back(store_.fresh_variable());
    }
    const TypeId result = store_.fresh_variable();
    (void)terms_.unify(equation.span, signature, function_type(store_, expected, result),
                       "the annotation has another form");
    for (std::size_t i = 0; i < expected.size(); ++i) {
        for (std::size_t k = 0; k < expected[i].size(); ++k) {
            const PatternTerm& pattern = equation.groups[i][k];
            terms_.set_span(pattern.syntax->span);
            const TypeId annotated = unifier_.evaluate_dots(expected[i][k]);
            const TypeId type = unifier_.evaluate_dots(terms_.infer_pattern(pattern));
            (void)unifier_.evaluate_dots(unifier_.unify_one_way(type, annotated));
        }
    }
    const TypeId body = terms_.expect_type(*equation.body, result, "the annotation says so");
    std::vector<std::vector<TypeId>> groups;
    for (const auto& group : equation.groups) {
        std::vector<TypeId>& types = groups.emplace_back();
        for (const PatternTerm& pattern : group) types.push_back(unifier_.evaluate_dots(terms_.infer_pattern(pattern)));
    }
    return function_type(store_, groups, unifier_.evaluate_dots(body));
}

void Inference::check_value(const Declaration& declaration) {
    TypeId left = no_type;
    TypeId right = no_type;
    if (declaration.annotation != nullptr) {
        const TypeId type = bind_annotation(*declaration.annotation);
        left = terms_.unify(declaration.span, type, terms_.infer_pattern(declaration.pattern));
        right = terms_.expect_type(*declaration.body, type, "the annotation says so");
    } else {
        left = terms_.infer_pattern(declaration.pattern);
        right = terms_.infer(*declaration.body);
    }
    terms_.set_span(declaration.pattern.syntax->span);
    left = unifier_.evaluate_dots(left);
    right = unifier_.evaluate_dots(right);
    // For c.x, the left side splits an event only if c is a channel. Parameters of functions have the same rule.
    const bool splits = store_.kind(left) == TypeKind::dot;
    (void)(splits ? unifier_.unify_one_way(left, right) : unifier_.unify_one_way(right, left));
}

void Inference::check_nametype(const Declaration& declaration) {
    TypeId type = no_type;
    if (declaration.annotation != nullptr) {
        type = bind_annotation(*declaration.annotation);
        type = terms_.expect_type(*declaration.body, type, "the annotation says so");
    } else {
        type = terms_.infer(*declaration.body);
    }
    terms_.set_span(declaration.body->syntax->span);
    const TypeId values = element_type(type);
    terms_.constrain(declaration.body->syntax->span, can_input, values, "a nametype holds whole values");
    (void)terms_.unify(declaration.span, declaration.binds.at(0)->scheme.type, store_.set_of(values));
}

// ---------------------------------------------------------------- channels and datatypes

// Returns the type of the elements that a written type denotes. A written type is a set, or a tuple or dot of written
// types.
TypeId Inference::element_type(TypeId type) {
    const TypeStore::Depth guard(store_);
    type = store_.head(type);
    const TypeKind kind = store_.node(type).kind;
    if (kind == TypeKind::tuple || kind == TypeKind::dot) {
        std::vector<TypeId> types;
        for (const TypeId part : store_.arguments(type)) types.push_back(element_type(part));
        return store_.make_type(kind, types);
    }
    const TypeId result = store_.fresh_variable();
    (void)terms_.unify(terms_.current_span(), type, store_.set_of(result), "fields are given by sets");
    return result;
}

TypeId Inference::infer_fields(const Term& fields, Constraints constraints) {
    const TypeId written = terms_.infer(fields);
    terms_.set_span(fields.syntax->span);
    const TypeId values = element_type(unifier_.evaluate_dots(written));
    for (const Constraint constraint : {can_equal, can_input}) {
        if ((constraints & constraint) == 0) continue;
        terms_.constrain(
            fields.syntax->span, constraint, values,
            constraint == can_equal ? "the values of channels are compared" : "a field holds whole values");
    }
    return values;
}

void Inference::check_channel(const Declaration& declaration) {
    TypeId type = store_.atom(TypeKind::event);
    if (declaration.body != nullptr) {
        type = store_.dotable_type(store_.dot_parts(channel_fields(declaration)), 0, type);
    } else if (declaration.annotation != nullptr) {
        (void)terms_.unify(declaration.span, bind_annotation(*declaration.annotation), type,
                           "the annotation has another type");
    }
    for (const Symbol* symbol : declaration.binds) (void)terms_.unify(declaration.span, symbol->scheme.type, type);
}

// Returns the type of the fields of a channel. If its annotation is `A => B => Event`, its fields are a set of A and a
// set of B.
TypeId Inference::channel_fields(const Declaration& declaration) {
    constexpr Constraints needed = can_equal | can_input;
    if (declaration.annotation == nullptr) return infer_fields(*declaration.body, needed);
    std::vector<TypeId> given;
    const TypeId written = bind_annotation(*declaration.annotation);
    const TypeId end = store_.split(written, given);
    (void)terms_.unify(declaration.span, store_.atom(TypeKind::event), end, "a channel's annotation ends in Event");
    (void)terms_.unify(declaration.span, store_.dotable_type(store_.fresh_variable(), store_.atom(TypeKind::event)),
                       written, "the channel has fields");
    std::vector<TypeId> sets;
    for (const TypeId field : given) sets.push_back(store_.set_of(field));
    const TypeId type = terms_.expect_type(*declaration.body, store_.dot_type(sets), "the annotation says so");
    terms_.set_span(declaration.body->syntax->span);
    const TypeId values = element_type(unifier_.evaluate_dots(type));
    terms_.constrain(terms_.current_span(), can_equal, values, "the values of channels are compared");
    terms_.constrain(terms_.current_span(), can_input, values, "a field holds whole values");
    return values;
}

void Inference::check_datatype(const Declaration& declaration) {
    const auto symbol = std::ranges::find(declaration.binds, SymbolKind::datatype, &Symbol::kind);
    const TypeId type = store_.datatype((*symbol)->datatype);
    (void)terms_.unify(declaration.span, (*symbol)->scheme.type, store_.set_of(type));
    std::vector<std::pair<TypeId, diagnostics::Span>> all;
    for (const ConstructorTerm& constructor : declaration.constructors) {
        TypeId signature = no_type;
        if (constructor.annotation != nullptr) {
            signature = bind_annotation(*constructor.annotation);
            (void)terms_.unify(constructor.span, signature, store_.extendable_type(type, store_.fresh_variable()),
                               "a constructor's annotation ends in its datatype");
        }
        std::vector<TypeId> parts;
        if (constructor.fields != nullptr) {
            const TypeId values = infer_fields(*constructor.fields, can_input);
            parts = store_.dot_parts(values);
            for (const TypeId part : parts) all.emplace_back(part, constructor.fields->syntax->span);
        }
        const TypeId own = store_.dotable_type(parts, 0, type);
        if (signature != no_type) (void)terms_.unify(constructor.span, signature, own, "the annotation says so");
        (void)terms_.unify(constructor.span, own, constructor.symbol->scheme.type);
    }
    if (!store_.is_comparable((*symbol)->datatype)) return;
    for (const auto& [part, span] : all) terms_.constrain(span, can_equal, part, "values of the datatype are compared");
}

void Inference::check_subtype(const Declaration& declaration) {
    const TypeId parent = store_.fresh_variable();
    for (const ConstructorTerm& constructor : declaration.constructors) {
        std::vector<TypeId> parts;
        if (constructor.fields != nullptr) parts = store_.dot_parts(infer_fields(*constructor.fields, can_input));
        if (constructor.symbol == nullptr || constructor.symbol->failed) continue;
        std::vector<TypeId> has;
        const TypeId datatype = store_.split(constructor.symbol->scheme.type, has);
        if (parts.size() > has.size()) {
            const auto count = [](std::size_t n) { return std::to_string(n) + (n == 1 ? " field" : " fields"); };
            throw TypeFault{&rules::subtype_fields,
                            {constructor.symbol->name, count(has.size()), count(parts.size())},
                            {},
                            constructor.span};
        }
        (void)terms_.unify(constructor.span, store_.extendable_type(parent, store_.fresh_variable()), datatype,
                           "all constructors of a subtype belong to one datatype");
        for (std::size_t i = 0; i < parts.size(); ++i)
            (void)terms_.unify(constructor.fields->syntax->span, has[i], parts[i]);
    }
    (void)terms_.unify(declaration.span, declaration.binds.at(0)->scheme.type, store_.set_of(parent));
}

// ---------------------------------------------------------------- timed sections, assertions, print

void Inference::check_timed(const Declaration& declaration) {
    const TypeId event = store_.atom(TypeKind::event);
    if (declaration.tock != nullptr && !declaration.tock->failed) {
        const TypeId tock = unifier_.instantiate(declaration.tock->scheme);
        (void)terms_.unify(declaration.span, event, tock, "`tock` is an event without fields in a timed section");
    }
    if (declaration.body == nullptr) return;
    const TypeId duration = store_.make_type(TypeKind::function, {event, store_.atom(TypeKind::integer)});
    (void)terms_.expect_type(*declaration.body, duration,
                             "the function of a timed section gives each event's duration");
}

void Inference::check_assertion(const Declaration& declaration) {
    terms_.expect_atom(*declaration.specification, TypeKind::process, "an assertion is about processes");
    const Term* other = declaration.implementation;
    if (other != nullptr && declaration.assertion->kind == AssertionKind::has_trace) {
        if (other->syntax->kind == ExprKind::sequence) {
            for (const Term* event : other->args)
                (void)terms_.expect_type(*event, store_.atom(TypeKind::event), "a trace is made of events");
        } else {
            (void)terms_.expect_type(*other, store_.sequence_of(store_.atom(TypeKind::event)),
                                     "a trace is a sequence of events");
        }
    } else if (other != nullptr) {
        terms_.expect_atom(*other, TypeKind::process, "an assertion is about processes");
    }
    if (declaration.tau_priority != nullptr) {
        (void)terms_.expect_type(*declaration.tau_priority, store_.set_of(store_.atom(TypeKind::event)),
                                 "tau has priority over events");
    }
}

void Inference::check_print(const Declaration& declaration) {
    if (declaration.body == nullptr) return;
    try {
        (void)terms_.infer(*declaration.body);
    } catch (const TypeFault& fault) {
        diagnostics::Diagnostic finding;
        finding.rule = fault.rule;
        finding.arguments = fault.arguments;
        diagnostics_.report(rules::print_ill_typed, fault.span, {finding.message()});
    }
}

}  // namespace robochart::cspm::types
