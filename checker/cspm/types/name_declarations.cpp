// SPDX-License-Identifier: Apache-2.0
// Resolves the declarations of a list, which may have any order. Therefore it works in phases: modules; channels
// and constructors, which determine the meaning of names in patterns; all other names; and then the right-hand
// sides.
#include <algorithm>
#include <utility>

#include "checker/cspm/types/builtins.hpp"
#include "checker/cspm/types/names.hpp"
#include "checker/cspm/types/rules.hpp"

namespace robochart::cspm::types {

DeclarationList* NameResolver::resolve_declarations(const std::vector<DeclPtr>& decls, const Place& place) {
    Place inside = place;
    inside.list = &script_->lists.emplace_back();
    inside.enclosing = current_;
    Scope* const scope = scope_;
    const bool timed = timed_;
    Items items;
    flatten(decls, inside, items);
    for (Item& item : items) add_labels(item);
    for (Item& item : items) add_names(item);
    Declaration* const current = current_;
    for (Item& item : items) {
        scope_ = item.inside != nullptr ? item.inside : item.place.scope;
        timed_ = item.place.timed;
        current_ = item.declaration;
        add_body(item);
    }
    scope_ = scope;
    timed_ = timed;
    current_ = current;
    return inside.list;
}

// ---------------------------------------------------------------- phase 1: modules, and flattened lists

NameResolver::Item& NameResolver::add_item(Items& items, const DeclPtr& decl, const Place& place) {
    Declaration& declaration = place.list->items.emplace_back();
    declaration.kind = decl->kind;
    declaration.span = decl->span;
    declaration.list = place.list;
    declaration.index = place.list->items.size() - 1;
    declaration.enclosing = place.enclosing;
    Item& item = items.emplace_back();
    item.decls = {decl};
    item.place = place;
    item.declaration = &declaration;
    return item;
}

void NameResolver::flatten(const std::vector<DeclPtr>& decls, const Place& place, Items& items) {
    for (const DeclPtr& decl : decls) {
        if (decl->kind != DeclKind::annotation) continue;
        for (const std::string& name : decl->names) place.scope->annotations.emplace(name, decl.get());
    }
    std::size_t function = items.size();  // the item for the clauses of the current function
    for (const DeclPtr& decl : decls) {
        if (decl->kind == DeclKind::annotation || decl->kind == DeclKind::include) continue;
        // FDR does not combine clauses from two files. In an included file, a clause declares the name again.
        if (decl->kind == DeclKind::function && function < items.size() &&
            items[function].decls[0]->names == decl->names &&
            items[function].decls[0]->span.source == decl->span.source) {
            items[function].decls.push_back(decl);
            items[function].declaration->span = diagnostics::join_spans(items[function].declaration->span, decl->span);
            continue;
        }
        if (decl->kind == DeclKind::module) {
            flatten_module(decl, place, items);
        } else {
            Item& item = add_item(items, decl, place);
            if (decl->kind == DeclKind::instance) find_original(item);
            if (decl->kind == DeclKind::timed) {
                Place inside = place;
                inside.timed = true;
                flatten(decl->decls, inside, items);
            }
        }
        function = decl->kind == DeclKind::function ? items.size() - 1 : items.size();
    }
}

void NameResolver::flatten_module(const DeclPtr& decl, const Place& place, Items& items) {
    Module& module = script_->modules.emplace_back();
    module.name = place.prefix + decl->names.at(0);
    module.span = decl->span;
    module.parameters = decl->parameters.size();
    module.parametrised = module.parameters > 0;
    module.outer = place.module;
    module.symbol = &new_symbol(module.name, decl->span, SymbolKind::module);
    enter_name(place, decl->names.at(0), {nullptr, &module}, decl->span);

    Item& item = add_item(items, decl, place);
    Declaration* const declaration = item.declaration;
    item.made = &module;
    Scope* const scope = item.inside = new_scope(place.scope);
    declaration->module = &module;
    declaration->binds.push_back(module.symbol);
    module.symbol->owner = declaration;

    Place inside = place;
    inside.scope = scope;
    inside.module = &module;
    inside.prefix = module.name + "::";
    if (module.parametrised) {
        inside.list = declaration->inside = &script_->lists.emplace_back();
        inside.enclosing = declaration;
        inside.top = false;
        for (const std::string& name : decl->parameters) {
            Symbol& parameter = new_symbol(name, decl->span, SymbolKind::variable);
            declaration->parameters.push_back(&parameter);
            Place here = inside;
            here.module = nullptr;
            enter_name(here, name, {&parameter, nullptr}, decl->span);
        }
    }
    inside.exported = false;
    flatten(decl->decls, inside, items);
    inside.exported = true;
    flatten(decl->exports, inside, items);
}

void NameResolver::find_original(Item& item) {
    const Decl& decl = *item.decls[0];
    Module& module = script_->modules.emplace_back();
    item.made = &module;
    item.declaration->module = &module;
    module.name = item.place.prefix + decl.names.at(0);
    module.span = decl.span;
    module.symbol = &new_symbol(module.name, decl.span, SymbolKind::module);
    module.symbol->owner = item.declaration;
    item.declaration->binds.push_back(module.symbol);
    scope_ = item.place.scope;
    const Lookup found = find(decl.text);
    const Module* around = item.place.module;
    while (around != nullptr && around != found.entry.module) around = around->outer;
    if (around != nullptr) {
        script_->names_missing = true;
        report(rules::module_cycle, decl.span, {around->name, module.name});
    } else if (found.entry.module != nullptr) {
        item.original = module.original = found.entry.module;
        module.parameters = found.entry.module->parameters;
        copy_modules(*found.entry.module, module);
    } else {
        script_->names_missing = true;
        if (found.entry.symbol != nullptr) {
            report(rules::wrong_kind_of_name, decl.span, {decl.text, "a value", "a module"});
        } else {
            const std::string hint = found.hint.empty() ? "an instance must follow its module" : found.hint;
            report_not_found(decl.text, decl.span, hint);
        }
    }
    enter_name(item.place, decl.names.at(0), {nullptr, &module}, decl.span);
}

void NameResolver::copy_modules(const Module& from, Module& to) {
    const auto copy_all = [&](const Names& names, Names& into) {
        for (const auto& [name, entry] : names) {
            if (entry.module == nullptr) continue;
            Module& module = script_->modules.emplace_back();
            module.name = to.name + "::" + name;
            module.span = to.span;
            module.parametrised = entry.module->parametrised;
            module.parameters = entry.module->parameters;
            module.symbol = &new_symbol(module.name, to.span, SymbolKind::module);
            into.emplace(name, Entry{nullptr, &module});
            copy_modules(*entry.module, module);
        }
    };
    copy_all(from.exported, to.exported);
    copy_all(from.hidden, to.hidden);
}

void NameResolver::copy_names(const Module& from, Module& to, bool labels, bool checked, Declaration& instance) {
    const auto copy_all = [&](const Names& names, Names& into) {
        for (const auto& [name, entry] : names) {
            if (entry.module != nullptr) {
                const auto made = into.find(name);
                if (made == into.end() || made->second.module == nullptr) continue;
                Module& inner = *made->second.module;
                copy_names(*entry.module, inner, labels, checked && !entry.module->parametrised, instance);
                if (!labels) instance.copies.push_back({entry.module->symbol, inner.symbol, false});
            } else if (entry.symbol->kind == SymbolKind::builtin) {
                into.emplace(name, entry);
            } else if (entry.symbol->label() == labels) {
                Symbol& copy = new_symbol(to.name + "::" + name, to.span, entry.symbol->kind);
                into.emplace(name, Entry{&copy, nullptr});
                instance.copies.push_back({entry.symbol, &copy, checked});
            }
        }
    };
    copy_all(from.exported, to.exported);
    copy_all(from.hidden, to.hidden);
}

// ---------------------------------------------------------------- phases 2 and 3: names

void NameResolver::add_labels(Item& item) {
    const Decl& decl = *item.decls[0];
    if (decl.kind == DeclKind::channel) {
        for (const std::string& name : decl.names) declare_symbol(item, name, decl.span, SymbolKind::channel);
    } else if (decl.kind == DeclKind::datatype) {
        for (const Constructor& constructor : decl.constructors) {
            ConstructorTerm& term = item.declaration->constructors.emplace_back();
            term.symbol = declare_symbol(item, constructor.name, constructor.span, SymbolKind::constructor);
            term.span = constructor.span;
        }
    } else if (decl.kind == DeclKind::instance && item.original != nullptr) {
        copy_names(*item.original, *item.made, true, true, *item.declaration);
    }
}

void NameResolver::add_names(Item& item) {
    const Decl& decl = *item.decls[0];
    scope_ = item.place.scope;
    switch (decl.kind) {
        case DeclKind::function:
        case DeclKind::subtype:
        case DeclKind::nametype:
            declare_symbol(item, decl.names.at(0), decl.span, SymbolKind::variable);
            break;
        case DeclKind::datatype: {
            Symbol* symbol = declare_symbol(item, decl.names.at(0), decl.span, SymbolKind::datatype);
            symbol->datatype = store_.new_datatype(symbol->name);
            item.place.scope->types.emplace(decl.names.at(0), symbol);
            break;
        }
        case DeclKind::value:
            item.declaration->pattern = declared_pattern(item, *decl.patterns.at(0).at(0));
            break;
        case DeclKind::transparent:
        case DeclKind::external:
            add_imports(item);
            break;
        case DeclKind::instance:
            if (item.original == nullptr) break;
            copy_names(*item.original, *item.made, false, true, *item.declaration);
            for (const Copy& copied : item.declaration->copies) {
                copied.copy->owner = item.declaration;
                item.declaration->binds.push_back(copied.copy);
                if (copied.original->kind == SymbolKind::datatype) {
                    copied.copy->datatype = store_.new_datatype(copied.copy->name);
                }
                if (item.place.top && copied.copy->kind != SymbolKind::module) script_->shown.push_back(copied.copy);
            }
            break;
        case DeclKind::channel:
        case DeclKind::module:
        case DeclKind::timed:
        case DeclKind::annotation:
        case DeclKind::print:
        case DeclKind::assertion:
        case DeclKind::include:
            break;
    }
}

void NameResolver::add_imports(const Item& item) {
    const Decl& decl = *item.decls[0];
    const bool transparent = decl.kind == DeclKind::transparent;
    using enum BuiltinTypes::Where;
    for (const std::string& name : decl.names) {
        Symbol* symbol = builtins_.find(name, transparent ? transparent_line : external_line);
        if (symbol == nullptr) {
            script_->names_missing = true;
            diagnostics::Diagnostic& finding =
                report(rules::wrong_import, decl.span, {transparent ? "transparent" : "external", name});
            const std::string_view line = BuiltinTypes::hint(name);
            if (!line.empty() && line != "timed") {
                finding.notes.push_back({decl.span, "'" + name + "' is " + std::string(line)});
            }
            // The symbol exists only so that uses of the name cause no further findings.
            symbol = &new_symbol(name, decl.span, SymbolKind::variable);
            symbol->failed = true;
        }
        enter_name(item.place, name, {symbol, nullptr}, decl.span);
    }
}

PatternTerm NameResolver::declared_pattern(const Item& item, const Pattern& pattern) {
    PatternTerm term;
    term.syntax = &pattern;
    check_form(pattern);
    if (pattern.kind == PatternKind::name) {
        term.symbol = constructor_named(pattern);
        if (term.symbol != nullptr && term.symbol->owner != nullptr) item.declaration->uses.push_back(term.symbol);
        if (term.symbol == nullptr && pattern.text.find("::") == std::string::npos) {
            term.symbol = declare_symbol(item, pattern.text, pattern.span, SymbolKind::variable);
        }
    }
    for (const PatternPtr& argument : pattern.args) term.args.push_back(declared_pattern(item, *argument));
    return term;
}

const Annotation* NameResolver::annotation_of(const Item& item, const std::string& name) {
    const auto found = item.place.scope->annotations.find(name);
    return found == item.place.scope->annotations.end() ? nullptr : resolve_annotation(*found->second);
}

// ---------------------------------------------------------------- phase 4: bodies

void NameResolver::add_body(Item& item) {
    const Decl& decl = *item.decls[0];
    Declaration& declaration = *item.declaration;
    Scope* const outer = scope_;
    scope_ = new_scope(outer);
    switch (decl.kind) {
        case DeclKind::function:
            body_of_function(item);
            break;
        case DeclKind::value:
            if (decl.patterns[0][0]->kind == PatternKind::name) {
                declaration.annotation = annotation_of(item, decl.patterns[0][0]->text);
            }
            declaration.body = resolve_expression(decl.body);
            break;
        case DeclKind::nametype:
            declaration.annotation = annotation_of(item, decl.names[0]);
            declaration.body = resolve_expression(decl.body);
            break;
        case DeclKind::channel:
            for (const std::string& name : decl.names) {
                if (declaration.annotation == nullptr) declaration.annotation = annotation_of(item, name);
            }
            if (decl.body) declaration.body = resolve_expression(decl.body);
            break;
        case DeclKind::datatype:
        case DeclKind::subtype:
            body_of_datatype(item);
            break;
        case DeclKind::timed:
            declaration.tock = value_named("tock", decl.span);
            if (decl.body) declaration.body = resolve_expression(decl.body);
            break;
        case DeclKind::module:
            if (item.made->parametrised) break;
            for (const Names* names : {&item.made->exported, &item.made->hidden}) {
                for (const auto& [name, entry] : *names) {
                    record_use(entry.module != nullptr ? entry.module->symbol : entry.symbol);
                }
            }
            break;
        case DeclKind::instance:
            body_of_instance(item);
            break;
        case DeclKind::assertion:
            body_of_assertion(item);
            break;
        case DeclKind::print:
            body_of_print(item);
            break;
        case DeclKind::transparent:
        case DeclKind::external:
        case DeclKind::annotation:
        case DeclKind::include:
            break;
    }
    scope_ = outer;
}

void NameResolver::body_of_function(Item& item) {
    item.declaration->annotation = annotation_of(item, item.decls[0]->names[0]);
    for (const DeclPtr& decl : item.decls) {
        EquationTerm& equation = item.declaration->equations.emplace_back();
        equation.span = decl->span;
        Scope* const outer = scope_;
        scope_ = new_scope(outer);
        std::vector<Symbol*> distinct;
        for (const auto& group : decl->patterns) {
            std::vector<PatternTerm>& terms = equation.groups.emplace_back();
            for (const PatternPtr& pattern : group)
                terms.push_back(resolve_pattern(*pattern, equation.binds, distinct));
        }
        equation.body = resolve_expression(decl->body);
        scope_ = outer;
    }
}

// Resolves the constructors of a datatype or subtype. In this phase, all constructors of datatypes are declared. So a
// subtype can refer to them.
void NameResolver::body_of_datatype(Item& item) {
    const Decl& decl = *item.decls[0];
    for (std::size_t i = 0; i < decl.constructors.size(); ++i) {
        const Constructor& constructor = decl.constructors[i];
        if (decl.kind == DeclKind::subtype) {
            Symbol* symbol = value_named(constructor.name, constructor.span);
            if (symbol != nullptr && !symbol->label()) {
                script_->names_missing = true;
                report(rules::wrong_kind_of_name, constructor.span, {constructor.name, "a value", "a constructor"});
                symbol = nullptr;
            }
            item.declaration->constructors.push_back({symbol, nullptr, nullptr, constructor.span});
        }
        ConstructorTerm& term = item.declaration->constructors[i];
        Scope* const outer = scope_;
        scope_ = new_scope(outer);
        if (decl.kind == DeclKind::datatype) term.annotation = annotation_of(item, constructor.name);
        if (constructor.fields) term.fields = resolve_expression(constructor.fields);
        scope_ = outer;
    }
}

void NameResolver::body_of_instance(Item& item) {
    const Decl& decl = *item.decls[0];
    for (const ExprPtr& argument : decl.arguments) item.declaration->arguments.push_back(resolve_expression(argument));
    if (item.original != nullptr) record_use(item.original->symbol);
}

void NameResolver::body_of_assertion(Item& item) {
    const Decl& decl = *item.decls[0];
    Declaration& declaration = *item.declaration;
    declaration.assertion = &decl.assertion;
    declaration.specification = resolve_expression(decl.assertion.specification);
    if (decl.assertion.implementation) declaration.implementation = resolve_expression(decl.assertion.implementation);
    if (decl.assertion.tau_priority) declaration.tau_priority = resolve_expression(decl.assertion.tau_priority);
}

// Resolves a print statement. An unknown name in it is only a warning.
void NameResolver::body_of_print(const Item& item) {
    diagnostics::Diagnostics inside;
    diagnostics::Diagnostics* const outside = std::exchange(diagnostics_, &inside);
    const bool missing = script_->names_missing;
    item.declaration->body = resolve_expression(item.decls[0]->body);
    script_->names_missing = missing;
    diagnostics_ = outside;
    if (inside.ok()) return;
    const diagnostics::Diagnostic first = inside.sorted_findings().front();
    report(rules::print_ill_typed, first.span, {first.message()});
    item.declaration->body = nullptr;
}

}  // namespace robochart::cspm::types
