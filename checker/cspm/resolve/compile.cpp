// SPDX-License-Identifier: Apache-2.0
// The second part of the resolver: converts expressions and patterns to code.
#include <algorithm>
#include <utility>

#include "checker/cspm/resolve/resolver.hpp"

namespace robochart::cspm {

Unit& Resolver::new_unit(Unit* parent) {
    Unit& unit = program_.units.emplace_back();
    unit.parent = parent;
    return unit;
}

Resolver::Scope& Resolver::new_scope(Scope* parent) {
    Scope& scope = scopes_.emplace_back();
    scope.parent = parent;
    return scope;
}

Code& Resolver::new_code(const Expr& expr) {
    Code& code = program_.codes.emplace_back();
    code.kind = expr.kind;
    code.span = expr.span;
    code.timed = timed_;
    return code;
}

const Code* Resolver::compile(const ExprPtr& expr) {
    budget_->poll();
    switch (expr->kind) {
        case ExprKind::parenthesised:
            return compile(expr->args[0]);
        case ExprKind::integer:
        case ExprKind::character:
        case ExprKind::string:
        case ExprKind::boolean:
            return compile_literal(*expr);
        case ExprKind::name:
            return compile_name(*expr);
        case ExprKind::lambda:
            return compile_lambda(*expr);
        case ExprKind::let:
            return compile_let(*expr);
        case ExprKind::prefix:
            return compile_prefix(*expr, {});
        case ExprKind::replicated_external:
            return offers_events(*expr) ? compile_prefix(*expr->args[0], expr->clauses) : with_clauses(*expr);
        default:
            return with_clauses(*expr);
    }
}

// Returns true if the choice is `[] e : S @ e -> P`. It is compiled as a single prefix with many
// events. In a timed section it remains a choice, because there all operands of a choice synchronise on
// tock.
bool Resolver::offers_events(const Expr& choice) const {
    const Expr& body = *choice.args[0];
    if (timed_ != nullptr || choice.clauses.size() != 1 || body.kind != ExprKind::prefix) return false;
    const PatternPtr& variable = choice.clauses[0].pattern;
    const Expr& event = *body.args[0];
    return variable && variable->kind == PatternKind::name && body.fields.empty() && event.kind == ExprKind::name &&
           event.text == variable->text;
}

const Code* Resolver::compile_literal(const Expr& expr) {
    Code& code = new_code(expr);
    switch (expr.kind) {
        case ExprKind::integer:
            code.constant = store_.integer(expr.number);
            break;
        case ExprKind::character:
            code.constant = store_.character(expr.number);
            break;
        case ExprKind::boolean:
            code.constant = store_.boolean(expr.number != 0);
            break;
        default:
            code.constant = store_.make_string(expr.text);
            break;
    }
    return &code;
}

// Compiles clauses. They bind their variables in the frame of the expression that contains them.
std::vector<ClauseCode> Resolver::compile_clauses(const std::vector<Clause>& clauses) {
    std::vector<ClauseCode> result;
    for (const Clause& clause : clauses) {
        ClauseCode code;
        code.generator = clause.pattern != nullptr;
        code.value = compile(clause.value);
        if (clause.pattern) {
            scope_ = &new_scope(scope_);
            code.pattern = compile_pattern(*clause.pattern);
        }
        result.push_back(std::move(code));
    }
    return result;
}

namespace {

// Returns true if the clauses do not bind variables in this argument. Such arguments are the process of a renaming,
// both processes of a linked parallel, and the interface of a replicated parallel.
bool outside_clauses(ExprKind kind, std::size_t arg) {
    if (kind == ExprKind::rename || kind == ExprKind::linked) return true;
    return (kind == ExprKind::replicated_parallel || kind == ExprKind::replicated_synchronising) && arg == 1;
}

}  // namespace

const Code* Resolver::with_clauses(const Expr& expr) {
    Code& code = new_code(expr);
    Scope* const outer = scope_;
    code.args.resize(expr.args.size(), nullptr);
    const auto args = [&](bool outside) {
        for (std::size_t i = 0; i < expr.args.size(); ++i) {
            if (expr.args[i] && outside_clauses(expr.kind, i) == outside) code.args[i] = compile(expr.args[i]);
        }
    };
    args(true);
    code.clauses = compile_clauses(expr.clauses);
    if (expr.kind == ExprKind::replicated_linked && expr.args.size() > 1) {
        code.args.resize(1);
        code.args[0] = compile(expr.args[0]);
        code.link_clauses = compile_clauses(expr.args[1]->clauses);
    } else {
        args(false);
    }
    for (const Link& link : expr.links) code.links.emplace_back(compile(link.from), compile(link.to));
    scope_ = outer;
    return &code;
}

const Code* Resolver::compile_lambda(const Expr& expr) {
    Code& code = new_code(expr);
    Function& function = program_.lambdas.emplace_back();
    function.number = functions_++;
    function.name = "\\";
    function.span = expr.span;
    Decl clause;
    clause.kind = DeclKind::function;
    clause.patterns = {expr.patterns};
    clause.body = expr.args[0];
    clause.span = expr.span;
    clause_of(function, clause, unit_, nullptr);
    function.environment = function.clauses[0].unit->captures.size();
    code.function = &function;
    return &code;
}

const Code* Resolver::compile_let(const Expr& expr) {
    Code& code = new_code(expr);
    Group& group = program_.groups.emplace_back();
    group.number = static_cast<std::uint32_t>(program_.groups.size());
    group.unit = &new_unit(unit_);
    group.unit->group = &group;
    Scope* const outer = scope_;
    scope_ = &new_scope(outer);
    code.slot = unit_->size++;
    std::vector<std::function<void()>> jobs;
    LetScope scope{group, code.slot, jobs};
    let_members(expr.decls, scope);
    for (const auto& job : jobs) job();
    code.args = {compile(expr.args[0])};
    scope_ = outer;
    code.group = &group;
    return &code;
}

std::size_t Resolver::let_member(LetScope& let, const std::string& name, Span span) {
    Member& member = let.group.members.emplace_back();
    member.function.number = functions_++;
    member.function.name = name;
    member.function.span = span;
    member.function.environment = 1;
    return let.group.members.size() - 1;
}

void Resolver::let_bind(LetScope& let, const std::string& name, std::size_t index, Span span) {
    const Binding binding{What::member, unit_, let.slot, &let.group, static_cast<int>(index), nullptr, span};
    if (!scope_->names.emplace(name, binding).second) fail("'" + name + "' is declared twice in one let", span);
}

void Resolver::let_clause(LetScope& let, std::size_t index, const Decl& decl) {
    let.jobs.emplace_back([this, &group = let.group, index, &decl, timed = timed_] {
        TimedSection* const outside = std::exchange(timed_, timed);
        clause_of(group.members[index].function, decl, group.unit, &group);
        timed_ = outside;
    });
}

void Resolver::let_members(const std::vector<DeclPtr>& decls, LetScope& let) {
    const Decl* previous = nullptr;
    for (const DeclPtr& pointer : decls) {
        const Decl& decl = *pointer;
        const bool more = previous != nullptr && previous->kind == DeclKind::function &&
                          decl.kind == DeclKind::function && previous->names == decl.names;
        previous = &decl;
        if (decl.kind == DeclKind::function) {
            const std::size_t last = let.group.members.size() - 1;
            const std::size_t index = more ? last : let_member(let, decl.names.at(0), decl.span);
            if (!more) let_bind(let, decl.names.at(0), index, decl.span);
            let_clause(let, index, decl);
        } else if (decl.kind == DeclKind::value) {
            let_value(decl, let);
        } else if (decl.kind == DeclKind::transparent || decl.kind == DeclKind::external) {
            declare_builtins(decl, *scope_, nullptr);
        } else if (decl.kind == DeclKind::timed) {
            let_timed(decl, let);
        }
    }
}

void Resolver::let_value(const Decl& decl, LetScope& let) {
    if (const std::vector<DeclPtr> parts = split_tuple(decl); !parts.empty()) {
        for (const DeclPtr& part : parts) let_value(*part, let);
        return;
    }
    const Pattern& pattern = *decl.patterns.at(0).at(0);
    const bool plain = pattern.kind == PatternKind::name;
    const std::size_t whole = let_member(let, plain ? pattern.text : "_", decl.span);
    let_clause(let, whole, decl);
    if (plain) return let_bind(let, pattern.text, whole, decl.span);
    for (const std::string& variable : pattern_variables(pattern)) {
        const std::size_t component = let_member(let, variable, decl.span);
        let.group.members[component].component_of = static_cast<int>(whole);
        let_bind(let, variable, component, decl.span);
        let.jobs.emplace_back([this, &group = let.group, whole, component, variable, &pattern] {
            std::vector<std::pair<std::string, int>> slots;
            collect_variables(group.members[whole].function.clauses.at(0).patterns.at(0), pattern, slots);
            for (const auto& [found, at] : slots) {
                if (found == variable) group.members[component].component_slot = at;
            }
        });
    }
}

// Returns the names that a pattern binds. Names of constructors and channels match only themselves.
std::vector<std::string> Resolver::pattern_variables(const Pattern& pattern) {
    std::vector<std::string> result;
    if (pattern.kind == PatternKind::name) {
        const Binding* known = find(pattern.text, scope_);
        if (known == nullptr || known->what != What::head) result.push_back(pattern.text);
    }
    for (const PatternPtr& arg : pattern.args) {
        const std::vector<std::string> more = pattern_variables(*arg);
        result.insert(result.end(), more.begin(), more.end());
    }
    return result;
}

// Compiles a timed section in a `let`. The duration function cannot use the names of the `let`.
void Resolver::let_timed(const Decl& decl, LetScope& let) {
    TimedSection& section = program_.timed.emplace_back();
    const Binding* tock = find("tock", scope_);
    if (tock == nullptr || tock->what != What::head) fail("a timed section needs a channel 'tock' in scope", decl.span);
    section.tock = tock->index;
    if (decl.body) {
        Unit* const outer = std::exchange(unit_, &new_unit(nullptr));
        section.unit = unit_;
        Scope* const inside = std::exchange(scope_, global_);
        section.duration = compile(decl.body);
        scope_ = inside;
        unit_ = outer;
    }
    TimedSection* const outside = std::exchange(timed_, &section);
    let_members(decl.decls, let);
    timed_ = outside;
}

const Code* Resolver::compile_prefix(const Expr& expr, const std::vector<Clause>& offered) {
    Code& code = new_code(expr);
    code.number = static_cast<std::uint32_t>(program_.prefixes.size());
    program_.prefixes.push_back(&code);
    code.unit = &new_unit(unit_);
    Unit* const outer_unit = std::exchange(unit_, code.unit);
    Scope* const outer_scope = scope_;
    code.clauses = compile_clauses(offered);
    code.args.push_back(compile(expr.args[0]));
    for (const Field& field : expr.fields) code.fields.push_back(compile_field(field));
    code.args.push_back(compile(expr.args[1]));
    scope_ = outer_scope;
    unit_ = outer_unit;
    // Compiling the body shows which variables of the enclosing frame the prefix captures.
    return &code;
}

FieldCode Resolver::compile_field(const Field& given) {
    FieldCode result;
    result.kind = given.kind;
    result.span = given.span;
    if (given.value) result.value = compile(given.value);
    if (given.kind == FieldKind::nondeterministic && timed_ != nullptr) {
        fail("$ is not allowed in a timed section", given.span);
    }
    if (!given.pattern) return result;
    scope_ = &new_scope(scope_);
    if (given.value) {
        result.patterns.push_back(compile_pattern(*given.pattern));
    } else {
        field_parts(*given.pattern, result.patterns);
    }
    return result;
}

void Resolver::field_parts(const Pattern& pattern, std::vector<MatchCode>& parts) {
    if (pattern.kind == PatternKind::dot) {
        for (const PatternPtr& arg : pattern.args) field_parts(*arg, parts);
        return;
    }
    if (pattern.kind == PatternKind::both) fail("@@ is not allowed in a prefix", pattern.span);
    parts.push_back(compile_pattern(pattern));
}

MatchCode Resolver::compile_pattern(const Pattern& pattern) {
    MatchCode result;
    result.kind = pattern.kind;
    result.number = pattern.number;
    if (pattern.kind == PatternKind::set && pattern.args.size() > 1) {
        fail("a set pattern has at most one element", pattern.span);
    }
    if (pattern.kind == PatternKind::string) {
        result.kind = PatternKind::sequence;
        for (const char c : pattern.text) {
            MatchCode character;
            character.kind = PatternKind::character;
            character.number = static_cast<unsigned char>(c);
            result.args.push_back(character);
        }
    }
    if (pattern.kind == PatternKind::name) {
        const Binding* found = find(pattern.text, scope_);
        if (found != nullptr && found->what == What::head) {
            result.head = true;
            result.number = found->index;
        } else {
            if (pattern.text.find("::") != std::string::npos) {
                fail("'" + pattern.text + "' is not a constructor or channel", pattern.span);
            }
            result.number = unit_->size++;
            const Binding binding{What::local, unit_,       static_cast<int>(result.number), nullptr, -1,
                                  nullptr,     pattern.span};
            if (!scope_->names.emplace(pattern.text, binding).second) {
                fail("'" + pattern.text + "' is bound twice in one pattern", pattern.span);
            }
        }
    }
    for (const PatternPtr& arg : pattern.args) result.args.push_back(compile_pattern(*arg));
    return result;
}

}  // namespace robochart::cspm
