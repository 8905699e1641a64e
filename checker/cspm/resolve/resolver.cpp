// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/resolve/resolver.hpp"

#include <algorithm>
#include <utility>

namespace robochart::cspm {

namespace {
constexpr unsigned max_instances = 10'000;
}  // namespace

Resolver::Resolver(Program& program, ValueStore& store) : program_(program), store_(store) {
    global_ = &new_scope(nullptr);
    scope_ = global_;
}

void Resolver::fail(const std::string& message, Span span) {
    throw EvaluationError(message, span, {});
}

void Resolver::compile_script(const Script& script) {
    declare(script.decls, {global_, nullptr, "", nullptr});
    run_jobs();
}

const Code* Resolver::compile_expression(const ExprPtr& expr, const Decl* place, Unit*& unit) {
    const auto found = places_.find(place);
    const Place where = found == places_.end() ? Place{global_, nullptr} : found->second;
    unit = &new_unit(nullptr);
    unit_ = unit;
    scope_ = where.scope;
    timed_ = where.timed;
    const Code* code = compile(expr);
    run_jobs();
    return code;
}

void Resolver::run_jobs() {
    while (!jobs_.empty()) {
        const std::function<void()> job = std::move(jobs_.front());
        jobs_.pop_front();
        job();
    }
}

// ---------------------------------------------------------------- declarations

void Resolver::schedule_job(const Target& target, std::function<void()> job) {
    jobs_.push_back([this, scope = target.scope, timed = target.timed, job = std::move(job)] {
        scope_ = scope;
        timed_ = timed;
        unit_ = nullptr;
        job();
    });
}

void Resolver::bind_name(const Target& target, const std::string& name, Binding binding) {
    const auto [place, fresh] = target.scope->names.emplace(name, binding);
    if (!fresh) fail("'" + name + "' is declared twice in one scope", binding.span);
    if (target.exported != nullptr) target.exported->names.emplace(name, binding);
}

int Resolver::new_global(GlobalKind kind, const std::string& name, Span span) {
    Global& global = program_.globals.emplace_back();
    global.kind = kind;
    global.function.number = functions_++;
    global.function.name = name;
    global.function.span = span;
    return static_cast<int>(program_.globals.size()) - 1;
}

void Resolver::declare(const std::vector<DeclPtr>& decls, const Target& target) {
    for (std::size_t i = 0; i < decls.size(); ++i) {
        const Decl& decl = *decls[i];
        switch (decl.kind) {
            case DeclKind::function:
                i = declare_function(decls, i, target);
                break;
            case DeclKind::value:
                declare_value(decl, target);
                break;
            case DeclKind::channel:
                declare_channel(decl, target);
                break;
            case DeclKind::datatype:
                declare_datatype(decl, target);
                break;
            case DeclKind::subtype:
                declare_subtype(decl, target);
                break;
            case DeclKind::nametype:
                declare_nametype(decl, target);
                break;
            case DeclKind::module:
                declare_module(decl, target);
                break;
            case DeclKind::instance:
                declare_instance(decl, target);
                break;
            case DeclKind::timed:
                declare_timed(decl, target);
                break;
            case DeclKind::transparent:
            case DeclKind::external:
                declare_builtins(decl, *target.scope, target.exported);
                break;
            case DeclKind::annotation:
                break;
            case DeclKind::print:
            case DeclKind::assertion:
                places_[&decl] = {target.scope, target.timed};
                break;
            case DeclKind::include:
                fail("include \"" + decl.names.at(0) + "\" has not been read in", decl.span);
        }
    }
}

// Combines consecutive clauses of one name into one function. Returns the index of the last clause.
std::size_t Resolver::declare_function(const std::vector<DeclPtr>& decls, std::size_t first, const Target& target) {
    const Decl& decl = *decls[first];
    std::size_t last = first;
    while (last + 1 < decls.size() && decls[last + 1]->kind == DeclKind::function &&
           decls[last + 1]->names == decl.names) {
        ++last;
    }
    const int index = new_global(GlobalKind::function, target.prefix + decl.names.at(0), decl.span);
    bind_name(target, decl.names.at(0), {What::global, nullptr, -1, nullptr, index, nullptr, decl.span});
    const std::vector<DeclPtr> clauses(decls.begin() + static_cast<std::ptrdiff_t>(first),
                                       decls.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    schedule_job(target, [this, index, clauses] {
        for (const DeclPtr& clause : clauses) {
            clause_of(program_.globals[static_cast<std::size_t>(index)].function, *clause, nullptr, nullptr);
        }
    });
    return last;
}

// Compiles the parameters and the body of a clause. The clause has a frame of its variables.
void Resolver::clause_of(Function& function, const Decl& decl, Unit* parent, const Group* member_of) {
    FunctionClause clause;
    clause.unit = &new_unit(parent);
    clause.unit->member_of = member_of;
    Unit* const outer_unit = std::exchange(unit_, clause.unit);
    Scope* const outer_scope = scope_;
    scope_ = &new_scope(outer_scope);
    std::vector<std::size_t> groups;
    for (const auto& group : decl.patterns) {
        groups.push_back(group.size());
        for (const PatternPtr& pattern : group) clause.patterns.push_back(compile_pattern(*pattern));
    }
    if (decl.kind == DeclKind::value) groups.clear();
    if (!function.clauses.empty() && function.groups != groups) {
        fail("the clauses of '" + function.name + "' take different numbers of arguments", decl.span);
    }
    function.groups = groups;
    // The body of a constant must not use the variables that the left side of the same constant binds.
    if (decl.kind == DeclKind::value) scope_ = outer_scope;
    clause.body = compile(decl.body);
    scope_ = outer_scope;
    unit_ = outer_unit;
    function.clauses.push_back(std::move(clause));
}

void Resolver::collect_variables(const MatchCode& code, const Pattern& pattern,
                                 std::vector<std::pair<std::string, int>>& out) const {
    if (code.kind == PatternKind::name && !code.head) out.emplace_back(pattern.text, static_cast<int>(code.number));
    for (std::size_t i = 0; i < code.args.size(); ++i) collect_variables(code.args[i], *pattern.args[i], out);
}

namespace {

void pattern_names(const Pattern& pattern, std::vector<std::string>& out) {
    if (pattern.kind == PatternKind::name) out.push_back(pattern.text);
    for (const PatternPtr& arg : pattern.args) pattern_names(*arg, out);
}

}  // namespace

// Converts (a, b) = (x, y) to a = x and b = y. So evaluating `a` does not evaluate y.
std::vector<DeclPtr> Resolver::split_tuple(const Decl& decl) {
    const Pattern& pattern = *decl.patterns.at(0).at(0);
    const Expr* body = decl.body.get();
    while (body->kind == ExprKind::parenthesised) body = body->args[0].get();
    if (pattern.kind != PatternKind::tuple || body->kind != ExprKind::tuple ||
        pattern.args.size() != body->args.size()) {
        return {};
    }
    std::vector<DeclPtr> result;
    for (std::size_t i = 0; i < pattern.args.size(); ++i) {
        Decl part = decl;
        part.patterns = {{pattern.args[i]}};
        part.body = body->args[i];
        made_.push_back(std::make_shared<const Decl>(std::move(part)));
        result.push_back(made_.back());
    }
    return result;
}

void Resolver::declare_value(const Decl& decl, const Target& target) {
    if (const std::vector<DeclPtr> parts = split_tuple(decl); !parts.empty()) {
        for (const DeclPtr& part : parts) declare_value(*part, target);
        return;
    }
    const Pattern& pattern = *decl.patterns.at(0).at(0);
    const bool plain = pattern.kind == PatternKind::name;
    const int index = new_global(GlobalKind::function, target.prefix + (plain ? pattern.text : "_"), decl.span);
    if (plain) bind_name(target, pattern.text, {What::global, nullptr, -1, nullptr, index, nullptr, decl.span});
    schedule_job(target, [this, index, &decl] {
        clause_of(program_.globals[static_cast<std::size_t>(index)].function, decl, nullptr, nullptr);
    });
    if (plain) return;
    std::vector<std::string> names;
    pattern_names(pattern, names);
    for (const std::string& variable : names) {
        const Binding* existing = find_simple(variable, target.scope);
        if (existing != nullptr && existing->what == What::head) continue;
        const int component = new_global(GlobalKind::component, target.prefix + variable, decl.span);
        program_.globals[static_cast<std::size_t>(component)].component_of = index;
        bind_name(target, variable, {What::global, nullptr, -1, nullptr, component, nullptr, decl.span});
        schedule_job(target, [this, index, component, variable, &pattern] {
            const Function& whole = program_.globals[static_cast<std::size_t>(index)].function;
            std::vector<std::pair<std::string, int>> slots;
            collect_variables(whole.clauses.at(0).patterns.at(0), pattern, slots);
            for (const auto& [name, slot] : slots) {
                if (name == variable) program_.globals[static_cast<std::size_t>(component)].component_slot = slot;
            }
        });
    }
}

void Resolver::declare_channel(const Decl& decl, const Target& target) {
    std::vector<int> heads;
    for (const std::string& name : decl.names) {
        const int index = static_cast<int>(program_.heads.size());
        Head& head = program_.heads.emplace_back();
        head.name = target.prefix + name;
        head.span = decl.span;
        head.channel = true;
        heads.push_back(index);
        bind_name(target, name, {What::head, nullptr, -1, nullptr, index, nullptr, decl.span});
    }
    if (!decl.body) return;
    schedule_job(target, [this, heads, &decl] {
        unit_ = &new_unit(nullptr);
        const Code* code = compile(decl.body);
        for (const int index : heads) {
            program_.heads[static_cast<std::size_t>(index)].fields_code = code;
            program_.heads[static_cast<std::size_t>(index)].unit = unit_;
        }
    });
}

void Resolver::declare_datatype(const Decl& decl, const Target& target) {
    const int type = new_global(GlobalKind::datatype, target.prefix + decl.names.at(0), decl.span);
    bind_name(target, decl.names.at(0), {What::global, nullptr, -1, nullptr, type, nullptr, decl.span});
    for (const Constructor& constructor : decl.constructors) {
        const int index = static_cast<int>(program_.heads.size());
        Head& head = program_.heads.emplace_back();
        head.name = target.prefix + constructor.name;
        head.span = constructor.span;
        head.type = type;
        program_.globals[static_cast<std::size_t>(type)].heads.push_back(index);
        bind_name(target, constructor.name, {What::head, nullptr, -1, nullptr, index, nullptr, decl.span});
        if (!constructor.fields) continue;
        schedule_job(target, [this, index, &constructor] {
            unit_ = &new_unit(nullptr);
            program_.heads[static_cast<std::size_t>(index)].fields_code = compile(constructor.fields);
            program_.heads[static_cast<std::size_t>(index)].unit = unit_;
        });
    }
}

void Resolver::declare_subtype(const Decl& decl, const Target& target) {
    const int index = new_global(GlobalKind::subtype, target.prefix + decl.names.at(0), decl.span);
    bind_name(target, decl.names.at(0), {What::global, nullptr, -1, nullptr, index, nullptr, decl.span});
    schedule_job(target, [this, index, &decl] {
        FunctionClause clause;
        clause.unit = unit_ = &new_unit(nullptr);
        Global& global = program_.globals[static_cast<std::size_t>(index)];
        for (const Constructor& constructor : decl.constructors) {
            const Binding* head = find(constructor.name, scope_);
            if (head == nullptr || head->what != What::head) {
                fail("'" + constructor.name + "' is not a constructor", constructor.span);
            }
            const Code* fields = constructor.fields ? compile(constructor.fields) : nullptr;
            global.subtype.emplace_back(head->index, fields);
        }
        global.function.clauses.push_back(std::move(clause));
    });
}

void Resolver::declare_nametype(const Decl& decl, const Target& target) {
    const int index = new_global(GlobalKind::nametype, target.prefix + decl.names.at(0), decl.span);
    bind_name(target, decl.names.at(0), {What::global, nullptr, -1, nullptr, index, nullptr, decl.span});
    schedule_job(target, [this, index, &decl] {
        FunctionClause clause;
        clause.unit = unit_ = &new_unit(nullptr);
        clause.body = compile(decl.body);
        program_.globals[static_cast<std::size_t>(index)].function.clauses.push_back(std::move(clause));
    });
}

void Resolver::declare_builtins(const Decl& decl, Scope& scope, Scope* exported) {
    for (const std::string& name : decl.names) {
        const BuiltinName* found = find_builtin(name);
        const bool transparent = decl.kind == DeclKind::transparent;
        const bool right =
            found != nullptr && (found->visibility == Visibility::transparent_or_external ||
                                 found->visibility == (transparent ? Visibility::transparent : Visibility::external));
        if (!right) {
            fail("there is no " + std::string(transparent ? "transparent" : "external") + " function '" + name + "'",
                 decl.span);
        }
        const Binding binding{What::builtin, nullptr,  -1, nullptr, static_cast<int>(found->builtin),
                              nullptr,       decl.span};
        scope.names.insert_or_assign(name, binding);
        if (exported != nullptr) exported->names.insert_or_assign(name, binding);
    }
}

void Resolver::declare_timed(const Decl& decl, const Target& target) {
    TimedSection& section = program_.timed.emplace_back();
    const Target inside{target.scope, target.exported, target.prefix, &section};
    schedule_job(target, [this, &section, &decl] {
        const Binding* tock = find("tock", scope_);
        if (tock == nullptr || tock->what != What::head) {
            fail("a timed section needs a channel 'tock' in scope", decl.span);
        }
        section.tock = tock->index;
        if (!decl.body) return;
        section.unit = unit_ = &new_unit(nullptr);
        section.duration = compile(decl.body);
    });
    declare(decl.decls, inside);
}

void Resolver::declare_module(const Decl& decl, const Target& target) {
    Module& module = modules_.emplace_back();
    module.decl = &decl;
    module.outer = target.scope;
    module.timed = target.timed;
    module.name = target.prefix + decl.names.at(0);
    bind_name(target, decl.names.at(0), {What::module, nullptr, -1, nullptr, -1, &module, decl.span});
    if (decl.parameters.empty()) declare_contents(module, module.name + "::", target.timed, &new_scope(target.scope));
}

// Declares the contents of a module. `inner` gets all names. Only exported names are added to the exports of the
// module. `prefix` precedes the full names.
void Resolver::declare_contents(Module& module, const std::string& prefix, TimedSection* timed, Scope* inner) {
    declare(module.decl->decls, {inner, nullptr, prefix, timed});
    declare(module.decl->exports, {inner, &module.exported, prefix, timed});
}

void Resolver::declare_instance(const Decl& decl, const Target& target) {
    Module& module = modules_.emplace_back();
    module.instance = &decl;
    module.instance_scope = target.scope;
    module.timed = target.timed;
    module.name = target.prefix + decl.names.at(0);
    bind_name(target, decl.names.at(0), {What::module, nullptr, -1, nullptr, -1, &module, decl.span});
    jobs_.push_back([this, &module] { create_instance(module); });
}

// Creates an instance: copies the module and defines its parameters as the arguments.
void Resolver::create_instance(Module& module) {
    if (module.instance == nullptr) return;
    const Decl& decl = *module.instance;
    if (module.running) fail("instance '" + module.name + "' is made of itself", decl.span);
    if (++instances_ > max_instances) fail("more than 10000 module instances", decl.span);
    module.running = true;
    const Binding* found = find(decl.text, module.instance_scope);
    if (found == nullptr || found->what != What::module) fail("'" + decl.text + "' is not a module", decl.span);
    create_instance(*found->module);
    const Module& original = *found->module;
    if (original.decl == nullptr) fail("'" + decl.text + "' is an instance, not a module", decl.span);
    if (original.decl->parameters.size() != decl.arguments.size()) {
        fail("module '" + decl.text + "' takes " + std::to_string(original.decl->parameters.size()) + " arguments",
             decl.span);
    }
    module.instance = nullptr;
    Scope* inner = &new_scope(original.outer);
    const Target parameters{inner, nullptr, module.name + "::", module.timed};
    for (std::size_t i = 0; i < decl.arguments.size(); ++i) {
        const int index =
            new_global(GlobalKind::function, module.name + "::" + original.decl->parameters[i], decl.span);
        bind_name(parameters, original.decl->parameters[i],
                  {What::global, nullptr, -1, nullptr, index, nullptr, decl.span});
        const ExprPtr argument = decl.arguments[i];
        schedule_job({module.instance_scope, nullptr, "", module.timed}, [this, index, argument] {
            FunctionClause clause;
            clause.unit = unit_ = &new_unit(nullptr);
            clause.patterns.push_back({});
            clause.body = compile(argument);
            program_.globals[static_cast<std::size_t>(index)].function.clauses.push_back(std::move(clause));
        });
    }
    module.decl = original.decl;
    declare_contents(module, module.name + "::", original.timed, inner);
    module.decl = nullptr;
    module.running = false;
}

// ---------------------------------------------------------------- names

const Resolver::Binding* Resolver::find_simple(std::string_view name, Scope* scope) const {
    for (; scope != nullptr; scope = scope->parent) {
        const auto found = scope->names.find(name);
        if (found != scope->names.end()) return &found->second;
    }
    return nullptr;
}

// M::x is one name, so another declaration of M does not hide it (see types/names.cpp).
const Resolver::Binding* Resolver::find(std::string_view text, Scope* scope) {
    const std::size_t colons = text.find("::");
    if (colons == std::string_view::npos) return find_simple(text, scope);
    for (; scope != nullptr; scope = scope->parent) {
        const auto first = scope->names.find(text.substr(0, colons));
        if (first == scope->names.end() || first->second.what != What::module) continue;
        if (const Binding* found = find_inside(*first->second.module, text.substr(colons + 2))) return found;
    }
    return nullptr;
}

const Resolver::Binding* Resolver::find_inside(Module& module, std::string_view path) {
    create_instance(module);
    const std::size_t colons = path.find("::");
    const auto found = module.exported.names.find(path.substr(0, colons));
    if (found == module.exported.names.end()) return nullptr;
    if (colons == std::string_view::npos) return &found->second;
    if (found->second.what != What::module) return nullptr;
    return find_inside(*found->second.module, path.substr(colons + 2));
}

int Resolver::capture_variable(Unit& unit, int parent_slot) {
    for (const auto& [from, to] : unit.captures) {
        if (from == parent_slot) return to;
    }
    unit.captures.emplace_back(parent_slot, unit.size);
    return unit.size++;
}

int Resolver::import_local(Unit& unit, const Unit& owner, int slot) {
    if (&unit == &owner) return slot;
    return capture_variable(unit, import_local(*unit.parent, owner, slot));
}

int Resolver::import_group(Unit& unit, const Binding& binding) {
    if (&unit == binding.owner) return binding.slot;
    if (unit.member_of == binding.group) {
        if (unit.self_slot < 0) unit.self_slot = unit.size++;
        return unit.self_slot;
    }
    return capture_variable(unit, import_group(*unit.parent, binding));
}

const Code* Resolver::compile_reference(const Expr& expr, const Binding& binding) {
    Code& code = new_code(expr);
    code.kind = ExprKind::name;
    switch (binding.what) {
        case What::local:
            code.reference = Reference::local;
            code.slot = import_local(*unit_, *binding.owner, binding.slot);
            break;
        case What::member:
            code.reference = Reference::member;
            code.slot = import_group(*unit_, binding);
            code.index = binding.index;
            code.group = binding.group;
            break;
        case What::global:
            code.reference = Reference::global;
            code.slot = binding.index;
            break;
        case What::head:
            code.reference = Reference::head;
            code.slot = binding.index;
            break;
        case What::builtin:
            code.reference = Reference::builtin;
            code.slot = binding.index;
            break;
        case What::module:
            fail("'" + expr.text + "' is a module, not a value", expr.span);
    }
    return &code;
}

const Code* Resolver::compile_name(const Expr& expr) {
    if (const Binding* found = find(expr.text, scope_)) return compile_reference(expr, *found);
    const BuiltinName* builtin = find_builtin(expr.text);
    if (builtin == nullptr) fail("'" + expr.text + "' is not in scope", expr.span);
    if (builtin->visibility == Visibility::timed_sections && timed_ == nullptr) {
        fail("'" + expr.text + "' is defined in timed sections only", expr.span);
    }
    if (builtin->visibility != Visibility::always && builtin->visibility != Visibility::timed_sections) {
        fail("'" + expr.text + "' must be declared " +
                 (builtin->visibility == Visibility::external ? "external" : "transparent") + " before use",
             expr.span);
    }
    return compile_reference(expr,
                             {What::builtin, nullptr, -1, nullptr, static_cast<int>(builtin->builtin), nullptr, {}});
}

}  // namespace robochart::cspm
