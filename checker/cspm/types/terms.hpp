// SPDX-License-Identifier: Apache-2.0
// Represents a script with resolved names, from which types are inferred. Every name refers to its symbol, and every
// list of declarations contains its dependencies. names.hpp creates this representation and infer.hpp uses it.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"
#include "checker/cspm/types/type.hpp"

namespace robochart::cspm::types {

struct Declaration;
struct DeclarationList;
struct Module;
struct Term;

enum class SymbolKind : std::uint8_t { variable, constructor, channel, datatype, module, builtin };

/// A declared name. Before the inference sets `scheme`, the name has any type. An ill-typed name keeps any type.
struct Symbol {
    std::string name;  ///< qualified, as printed
    Span span;
    std::size_t number = 0;
    SymbolKind kind = SymbolKind::variable;
    Declaration* owner = nullptr;  ///< null for parameters, variables of patterns and built-ins
    Scheme scheme;
    bool failed = false;
    std::uint32_t datatype = 0;  ///< for datatypes: the number in the type store
    [[nodiscard]] bool label() const { return kind == SymbolKind::constructor || kind == SymbolKind::channel; }
};

/// A type variable in an annotation. It can be used in the annotations below it.
struct TypeVariable {
    std::string name;
    Constraints constraints = 0;
    TypeId type = no_type;  ///< the rigid variable that represents it while the declaration is checked
};

/// A resolved type from an annotation.
struct TypeTerm {
    /// Extendable: `args` contains the variable and then the type. Function: the last of `args` is the result.
    TypeKind kind = TypeKind::integer;
    std::vector<TypeTerm> args;
    TypeVariable* variable = nullptr;  ///< kind variable
    Symbol* datatype = nullptr;        ///< kind datatype
};
struct Annotation {
    TypeTerm type;
    std::vector<TypeVariable*> binds;  ///< variables that this annotation adds to the scope
    Span span;
};

struct PatternTerm {
    const Pattern* syntax = nullptr;
    Symbol* symbol = nullptr;  ///< for names: the bound variable, or the matched constructor or channel
    std::vector<PatternTerm> args;
};

struct FieldTerm {
    FieldKind kind = FieldKind::output;
    Span span;
    const Term* value = nullptr;
    PatternTerm pattern;
};
struct ClauseTerm {
    bool generator = false;
    PatternTerm pattern;
    const Term* value = nullptr;
};
struct LinkTerm {
    const Term* from = nullptr;
    const Term* to = nullptr;
};

struct Term {
    const Expr* syntax = nullptr;
    Symbol* symbol = nullptr;  ///< of a name; null if the name is not in scope
    std::vector<const Term*> args;
    std::vector<FieldTerm> fields;
    std::vector<ClauseTerm> clauses;
    std::vector<ClauseTerm> link_clauses;  ///< replicated linked parallel: the clauses of the links
    std::vector<LinkTerm> links;
    std::vector<PatternTerm> patterns;
    std::vector<Symbol*> binds;  ///< variables of its patterns, clauses and fields
    DeclarationList* decls = nullptr;
};

/// One equation of a function: its parameters by groups, and its body.
struct EquationTerm {
    std::vector<std::vector<PatternTerm>> groups;
    std::vector<Symbol*> binds;
    const Term* body = nullptr;
    Span span;
};

struct ConstructorTerm {
    Symbol* symbol = nullptr;
    const Term* fields = nullptr;
    const Annotation* annotation = nullptr;
    Span span;
};

/// A name of an instance, and the name of the module from which it was copied.
struct Copy {
    Symbol* original = nullptr;
    Symbol* copy = nullptr;
    bool checked = true;  ///< false inside a module with parameters, where the types of fields may be unknown
};

/// A declaration in a list. All clauses of a function are one declaration. Modules without parameters are flattened
/// into their list.
struct Declaration {
    DeclKind kind = DeclKind::value;
    Span span;
    std::vector<Symbol*> binds;
    std::vector<Symbol*> uses;  ///< declared names that it uses
    std::vector<EquationTerm> equations;
    PatternTerm pattern;         ///< value
    const Term* body = nullptr;  ///< value, channel, nametype; timed: the duration function
    const Annotation* annotation = nullptr;
    std::vector<ConstructorTerm> constructors;
    Symbol* tock = nullptr;                ///< timed
    const Module* module = nullptr;        ///< module, instance
    std::vector<Symbol*> parameters;       ///< module
    DeclarationList* inside = nullptr;     ///< module with parameters
    std::vector<const Term*> arguments;    ///< instance
    std::vector<Copy> copies;              ///< instance
    const Assertion* assertion = nullptr;  ///< assertion: kind and options
    const Term* specification = nullptr;
    const Term* implementation = nullptr;
    const Term* tau_priority = nullptr;
    DeclarationList* list = nullptr;
    std::size_t index = 0;
    Declaration* enclosing = nullptr;  ///< the declaration whose body or module contains it
};

struct DeclarationList {
    std::deque<Declaration> items;
};

/// The meaning of a name in a scope.
struct Entry {
    Symbol* symbol = nullptr;
    Module* module = nullptr;
};
using Names = std::map<std::string, Entry, std::less<>>;

struct Module {
    std::string name;
    Span span;
    Symbol* symbol = nullptr;  ///< for a module with parameters: its type is the tuple of their types
    bool parametrised = false;
    std::size_t parameters = 0;
    const Module* outer = nullptr;     ///< the module that contains this module
    const Module* original = nullptr;  ///< for instances and copies: the module that was copied
    Names exported;
    Names hidden;
};

/// A resolved script. It owns all of the objects above.
struct ResolvedScript {
    std::deque<Symbol> symbols;
    std::deque<Term> terms;
    std::deque<Module> modules;
    std::deque<Annotation> annotations;
    std::deque<TypeVariable> type_variables;
    std::deque<DeclarationList> lists;
    DeclarationList* top = nullptr;
    std::vector<Symbol*> shown;  ///< the names to print with their types, in order
    bool names_missing = false;  ///< whether some name was not in scope; types may then stay open
};

}  // namespace robochart::cspm::types
