// SPDX-License-Identifier: Apache-2.0
// Resolves names in expressions, patterns and annotations.
#include <algorithm>
#include <utility>

#include "checker/cspm/types/names.hpp"
#include "checker/cspm/types/rules.hpp"
#include "checker/cspm/types/written_type.hpp"

namespace robochart::cspm::types {

// ---------------------------------------------------------------- expressions

const Term* NameResolver::resolve_expression(const ExprPtr& expr) {
    diagnostics_->poll();
    Term& term = script_->terms.emplace_back();
    term.syntax = expr.get();
    if (depth_ >= max_depth) {
        report(rules::type_overflow, expr->span, {"nested too deeply"});
        throw TypeOverflow{true};
    }
    ++depth_;
    Scope* const outer = scope_;
    switch (expr->kind) {
        case ExprKind::name:
            resolve_name(*expr, term);
            break;
        case ExprKind::lambda:
            resolve_lambda(*expr, term);
            break;
        case ExprKind::let:
            resolve_let(*expr, term);
            break;
        case ExprKind::prefix:
            resolve_prefix(*expr, term);
            break;
        default:
            resolve_clauses(*expr, term);
            break;
    }
    scope_ = outer;
    --depth_;
    return &term;
}

void NameResolver::resolve_name(const Expr& expr, Term& term) {
    term.symbol = value_named(expr.text, expr.span);
}

// Resolves a lambda. Each of its patterns is a scope, so a name in a later pattern hides an earlier one.
void NameResolver::resolve_lambda(const Expr& expr, Term& term) {
    for (const PatternPtr& pattern : expr.patterns) {
        scope_ = new_scope(scope_);
        std::vector<Symbol*> distinct;
        term.patterns.push_back(resolve_pattern(*pattern, term.binds, distinct));
    }
    term.args = {resolve_expression(expr.args.at(0))};
}

void NameResolver::resolve_let(const Expr& expr, Term& term) {
    Place place;
    place.scope = scope_ = new_scope(scope_);
    place.timed = timed_;
    term.decls = resolve_declarations(expr.decls, place);
    term.args = {resolve_expression(expr.args.at(0))};
}

namespace {

// Returns how many parts of p ^ q ^ r match sequences of any length.
std::size_t open_parts(const Pattern& pattern) {
    if (pattern.kind == PatternKind::sequence || pattern.kind == PatternKind::string) return 0;
    if (pattern.kind != PatternKind::concat) return 1;
    std::size_t count = 0;
    for (const PatternPtr& argument : pattern.args) count += open_parts(*argument);
    return count;
}

// Returns true if @@ combines patterns of one field or of several fields. Does not look into tuples or sequences.
bool doubles_fields(const Pattern& pattern) {
    if (pattern.kind == PatternKind::both) return true;
    return pattern.kind == PatternKind::dot &&
           std::ranges::any_of(pattern.args, [](const PatternPtr& argument) { return doubles_fields(*argument); });
}

}  // namespace

// Resolves a prefix. Nondeterministic fields are chosen before the event is offered, so their names are bound first.
void NameResolver::resolve_prefix(const Expr& expr, Term& term) {
    term.args.push_back(resolve_expression(expr.args.at(0)));
    scope_ = new_scope(scope_);
    term.fields.resize(expr.fields.size());
    std::vector<Symbol*> distinct;
    bool others = false;
    for (const bool choosing : {true, false}) {
        for (std::size_t i = 0; i < expr.fields.size(); ++i) {
            const Field& field = expr.fields[i];
            if ((field.kind == FieldKind::nondeterministic) != choosing) continue;
            term.fields[i].kind = field.kind;
            term.fields[i].span = field.span;
            if (field.pattern && doubles_fields(*field.pattern)) {
                report(rules::bad_pattern, field.pattern->span, {"@@ is not allowed in a prefix"});
            }
            if (choosing && timed_) report(rules::not_timed, field.span, {"a `$` field"});
            if (field.value) term.fields[i].value = resolve_expression(field.value);
            if (field.pattern) term.fields[i].pattern = resolve_pattern(*field.pattern, term.binds, distinct);
        }
    }
    for (const Field& field : expr.fields) {
        if (field.kind == FieldKind::nondeterministic && others) report(rules::field_order, field.span, {});
        others = others || (field.kind != FieldKind::nondeterministic && field.kind != FieldKind::dot);
    }
    term.args.push_back(resolve_expression(expr.args.at(1)));
}

namespace {

// Returns true if the clauses do not bind variables in this argument. Such arguments are the processes of renaming and
// linked parallel, and the interface of replicated parallels.
bool outside_clauses(ExprKind kind, std::size_t arg) {
    if (kind == ExprKind::rename || kind == ExprKind::linked) return true;
    return (kind == ExprKind::replicated_parallel || kind == ExprKind::replicated_synchronising) && arg == 1;
}

}  // namespace

void NameResolver::resolve_clauses(const Expr& expr, Term& term) {
    const bool linked = expr.kind == ExprKind::replicated_linked;
    if (timed_ && (linked || expr.kind == ExprKind::linked)) report(rules::not_timed, expr.span, {"linked parallel"});
    const std::size_t count = linked ? 1 : expr.args.size();
    term.args.resize(count);
    const auto arguments = [&](bool outside) {
        for (std::size_t i = 0; i < count; ++i) {
            if (expr.args[i] && outside_clauses(expr.kind, i) == outside)
                term.args[i] = resolve_expression(expr.args[i]);
        }
    };
    arguments(true);
    if (!expr.clauses.empty()) clause_list(expr.clauses, term.clauses, term.binds);
    arguments(false);
    if (linked && expr.args.size() > 1) clause_list(expr.args[1]->clauses, term.link_clauses, term.binds);
    for (const Link& link : expr.links) {
        const Term* from = resolve_expression(link.from);
        term.links.push_back({from, resolve_expression(link.to)});
    }
}

void NameResolver::clause_list(const std::vector<Clause>& list, std::vector<ClauseTerm>& out,
                               std::vector<Symbol*>& binds) {
    scope_ = new_scope(scope_);
    std::vector<Symbol*> distinct;
    for (const Clause& clause : list) {
        ClauseTerm term;
        term.generator = clause.pattern != nullptr;
        term.value = resolve_expression(clause.value);
        if (clause.pattern) term.pattern = resolve_pattern(*clause.pattern, binds, distinct);
        out.push_back(std::move(term));
    }
}

// ---------------------------------------------------------------- patterns

void NameResolver::check_form(const Pattern& pattern) {
    if (pattern.kind == PatternKind::set && pattern.args.size() > 1) {
        report(rules::bad_pattern, pattern.span, {"a set pattern has at most one element"});
    }
    if (pattern.kind == PatternKind::concat && open_parts(*pattern.args[0]) == 1 && open_parts(*pattern.args[1]) == 1) {
        report(rules::bad_pattern, pattern.span,
               {"only one part of `^` may have any length; otherwise a sequence can be split in several ways"});
    }
}

Symbol* NameResolver::constructor_named(const Pattern& pattern) {
    const Lookup found = find(pattern.text);
    if (found.entry.symbol != nullptr && found.entry.symbol->label()) {
        record_use(found.entry.symbol);
        return found.entry.symbol;
    }
    if (pattern.text.find("::") == std::string::npos) return nullptr;
    script_->names_missing = true;
    diagnostics::Diagnostic& finding = report(rules::qualified_pattern, pattern.span, {pattern.text});
    if (!found.hint.empty()) finding.notes.push_back({pattern.span, found.hint});
    return nullptr;
}

Symbol* NameResolver::resolve_variable(const Pattern& pattern, std::vector<Symbol*>& binds,
                                       std::vector<Symbol*>& distinct) {
    Symbol& symbol = new_symbol(pattern.text, pattern.span, SymbolKind::variable);
    const auto same = std::ranges::find(distinct, pattern.text, &Symbol::name);
    if (same != distinct.end()) {
        report(rules::declared_twice, pattern.span, {pattern.text})
            .notes.push_back({(*same)->span, "the other variable"});
    }
    scope_->names.insert_or_assign(pattern.text, Entry{&symbol, nullptr});
    binds.push_back(&symbol);
    distinct.push_back(&symbol);
    return &symbol;
}

PatternTerm NameResolver::resolve_pattern(const Pattern& given, std::vector<Symbol*>& binds,
                                          std::vector<Symbol*>& distinct) {
    PatternTerm term;
    term.syntax = &given;
    check_form(given);
    if (given.kind == PatternKind::name) {
        term.symbol = constructor_named(given);
        const bool plain = given.text.find("::") == std::string::npos;
        if (term.symbol == nullptr && plain) term.symbol = resolve_variable(given, binds, distinct);
    }
    for (const PatternPtr& argument : given.args) term.args.push_back(resolve_pattern(*argument, binds, distinct));
    return term;
}

// ---------------------------------------------------------------- annotations

const Annotation* NameResolver::resolve_annotation(const Decl& decl) {
    Annotation& result = script_->annotations.emplace_back();
    result.span = decl.span;
    const WrittenScheme written = read_type(decl.text);
    result.type = type_term(written.type, result);
    for (const auto& [constraint, name] : written.constraints) {
        TypeVariable* variable = type_variable(name, result, false);
        if (variable == nullptr) continue;
        if (std::ranges::find(result.binds, variable) == result.binds.end()) {
            report(rules::bad_type_variable, decl.span,
                   {"the constraint on '" + name + "' belongs to the annotation that introduces '" + name + "'"});
        }
        variable->constraints |= constraint;
    }
    return &result;
}

TypeVariable* NameResolver::type_variable(const std::string& name, Annotation& into, bool may_bind) {
    for (Scope* scope = scope_; scope != nullptr; scope = scope->parent) {
        const auto found = scope->type_variables.find(name);
        if (found != scope->type_variables.end()) return found->second;
    }
    if (may_bind && name.find("::") == std::string::npos) {
        TypeVariable& variable = script_->type_variables.emplace_back();
        variable.name = name;
        scope_->type_variables.emplace(name, &variable);
        into.binds.push_back(&variable);
        return &variable;
    }
    script_->names_missing = true;
    report(rules::bad_type_variable, into.span, {"there is no type variable '" + name + "' here"});
    return nullptr;
}

TypeTerm NameResolver::named_type(const WrittenType& written, Annotation& into) {
    TypeTerm result;
    if (written.name.find("::") != std::string::npos) {
        const Lookup found = find(written.name);
        if (found.entry.symbol != nullptr && found.entry.symbol->kind == SymbolKind::datatype) {
            result.datatype = found.entry.symbol;
        }
    } else {
        for (Scope* scope = scope_; scope != nullptr && result.datatype == nullptr; scope = scope->parent) {
            if (scope->type_variables.contains(written.name)) break;
            const auto found = scope->types.find(written.name);
            if (found != scope->types.end()) result.datatype = found->second;
        }
    }
    if (result.datatype != nullptr) {
        record_use(result.datatype);
        result.kind = TypeKind::datatype;
        return result;
    }
    result.kind = primitive_kind(written.name);
    if (result.kind == TypeKind::variable) result.variable = type_variable(written.name, into, true);
    return result;
}

TypeTerm NameResolver::type_term(const WrittenType& written, Annotation& into) {
    if (written.kind == TypeKind::variable) return named_type(written, into);
    TypeTerm result;
    result.kind = written.kind;
    for (const WrittenType& argument : written.args) result.args.push_back(type_term(argument, into));
    if (written.kind == TypeKind::extendable && result.args[0].kind != TypeKind::variable) {
        report(rules::bad_type_variable, into.span, {"the left of `=>*` must be a type variable"});
        result.args[0] = TypeTerm{TypeKind::variable, {}, nullptr, nullptr};
    }
    return result;
}

}  // namespace robochart::cspm::types
