// SPDX-License-Identifier: Apache-2.0
// Finds the declaration of each name in a script. A declaration is in scope in its whole list. Modules without
// parameters are flattened into their list. An instance has copies of all names of its module.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "checker/cspm/types/builtin_types.hpp"
#include "checker/cspm/types/terms.hpp"

namespace robochart::cspm::types {

class NameResolver {
public:
    /// Maximal nesting of expressions.
    static constexpr unsigned max_depth = 4500;

    NameResolver(TypeStore& store, BuiltinTypes& builtins, diagnostics::Diagnostics& diagnostics)
        : store_(store), builtins_(builtins), diagnostics_(&diagnostics) {}

    [[nodiscard]] std::unique_ptr<ResolvedScript> run(const Script& script);

private:
    struct Scope {
        Scope* parent = nullptr;
        Names names;
        std::map<std::string, Symbol*, std::less<>> types;  // the datatypes that annotations may use
        std::map<std::string, TypeVariable*, std::less<>> type_variables;
        std::map<std::string, const Decl*, std::less<>> annotations;  // by name: its annotation
    };
    // The list that contains a declaration.
    struct Place {
        Scope* scope = nullptr;
        DeclarationList* list = nullptr;
        Module* module = nullptr;
        bool exported = false;
        bool timed = false;
        bool top = false;
        std::string prefix;
        Declaration* enclosing = nullptr;
    };
    struct Item {
        std::vector<DeclPtr> decls;  // the clauses of a function, or another single declaration
        Place place;
        Declaration* declaration = nullptr;
        Module* made = nullptr;  // for modules and instances
        const Module* original = nullptr;
        Scope* inside = nullptr;
    };
    using Items = std::vector<Item>;

    // The following functions resolve declarations, phase by phase: modules, labels, other names, bodies.
    DeclarationList* resolve_declarations(const std::vector<DeclPtr>& decls, const Place& place);
    void flatten(const std::vector<DeclPtr>& decls, const Place& place, Items& items);
    Item& add_item(Items& items, const DeclPtr& decl, const Place& place);
    void flatten_module(const DeclPtr& decl, const Place& place, Items& items);
    void find_original(Item& item);
    void copy_modules(const Module& from, Module& to);
    void copy_names(const Module& from, Module& to, bool labels, bool checked, Declaration& instance);
    void add_labels(Item& item);
    void add_names(Item& item);
    void add_imports(const Item& item);
    void add_body(Item& item);
    void body_of_function(Item& item);
    void body_of_datatype(Item& item);
    void body_of_instance(Item& item);
    void body_of_assertion(Item& item);
    void body_of_print(const Item& item);
    Symbol* declare_symbol(const Item& item, const std::string& name, Span span, SymbolKind kind);
    void enter_name(const Place& place, const std::string& name, const Entry& entry, Span span);
    const Annotation* annotation_of(const Item& item, const std::string& name);

    // expressions
    const Term* resolve_expression(const ExprPtr& expr);
    void resolve_name(const Expr& expr, Term& term);
    void resolve_lambda(const Expr& expr, Term& term);
    void resolve_let(const Expr& expr, Term& term);
    void resolve_prefix(const Expr& expr, Term& term);
    void resolve_clauses(const Expr& expr, Term& term);
    void clause_list(const std::vector<Clause>& clauses, std::vector<ClauseTerm>& out, std::vector<Symbol*>& binds);
    PatternTerm resolve_pattern(const Pattern& pattern, std::vector<Symbol*>& binds, std::vector<Symbol*>& distinct);
    void check_form(const Pattern& pattern);
    PatternTerm declared_pattern(const Item& item, const Pattern& pattern);
    Symbol* constructor_named(const Pattern& pattern);
    Symbol* resolve_variable(const Pattern& pattern, std::vector<Symbol*>& binds, std::vector<Symbol*>& distinct);

    // annotations
    const Annotation* resolve_annotation(const Decl& decl);
    TypeTerm type_term(const struct WrittenType& written, Annotation& into);
    TypeTerm named_type(const WrittenType& written, Annotation& into);
    TypeVariable* type_variable(const std::string& name, Annotation& into, bool may_bind);

    // names
    struct Lookup {
        Entry entry;
        std::string hint;  // why an existing name is not in scope
    };
    [[nodiscard]] Lookup find(std::string_view name);
    [[nodiscard]] const Entry* find_plain(std::string_view name) const;
    [[nodiscard]] static Lookup find_inside(const Module& module, std::string_view path);
    Symbol* value_named(std::string_view name, Span span);
    void record_use(Symbol* symbol);
    void report_not_found(std::string_view name, Span span, const std::string& hint);
    [[nodiscard]] std::string in_a_module(std::string_view name);
    [[nodiscard]] std::string suggest_member(std::string_view name);
    [[nodiscard]] std::string suggest_name(std::string_view name);
    Symbol& new_symbol(const std::string& name, Span span, SymbolKind kind);
    Scope* new_scope(Scope* parent);
    diagnostics::Diagnostic& report(const diagnostics::Rule& rule, Span span, std::vector<std::string> arguments);

    TypeStore& store_;
    BuiltinTypes& builtins_;
    diagnostics::Diagnostics* diagnostics_;
    std::unique_ptr<ResolvedScript> script_;
    std::deque<Scope> scopes_;
    Scope* scope_ = nullptr;
    bool timed_ = false;
    Declaration* current_ = nullptr;
    unsigned depth_ = 0;
};

}  // namespace robochart::cspm::types
