// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/types/type_check.hpp"

#include <algorithm>
#include <tuple>
#include <unordered_map>

#include "checker/cspm/types/builtin_types.hpp"
#include "checker/cspm/types/deep_stack.hpp"
#include "checker/cspm/types/infer.hpp"
#include "checker/cspm/types/names.hpp"
#include "checker/cspm/types/terms.hpp"

namespace robochart::cspm {

namespace {

std::vector<NamedType> named_types(const types::ResolvedScript& script, types::TypeStore& store) {
    std::vector<NamedType> result;
    for (const types::Symbol* symbol : script.shown) {
        if (symbol->failed) continue;
        types::TypeWriter writer(store);
        result.push_back({symbol->name, symbol->span, writer.with_constraints(symbol->scheme.type)});
    }
    return result;
}

/// Collects all places that refer to a symbol.
class NameTableMaker {
public:
    explicit NameTableMaker(types::TypeStore& store) : store_(store) {}

    NameTable run(const types::ResolvedScript& script) {
        for (const types::Symbol& symbol : script.symbols)
            if (symbol.span.is_known()) (void)number_of(symbol);
        for (const types::Term& term : script.terms) this->term(term);
        for (const types::DeclarationList& list : script.lists)
            for (const types::Declaration& declaration : list.items) this->declaration(declaration);
        const auto place = [](const NameUse& use) { return std::tuple(use.span.source, use.span.begin, use.span.end); };
        std::ranges::sort(table_.uses, {}, place);
        return std::move(table_);
    }

private:
    std::size_t number_of(const types::Symbol& symbol) {
        const auto [at, fresh] = numbers_.emplace(&symbol, table_.names.size());
        if (!fresh) return at->second;
        KnownName& known = table_.names.emplace_back();
        known.name = symbol.name;
        known.span = symbol.span;
        const bool typed =
            !symbol.failed && symbol.scheme.type != types::no_type && symbol.kind != types::SymbolKind::module;
        if (typed) known.type = types::TypeWriter(store_).with_constraints(symbol.scheme.type);
        return at->second;
    }
    void add_use(Span span, const types::Symbol* symbol) {
        if (symbol != nullptr && span.is_known()) table_.uses.push_back({span, number_of(*symbol)});
    }

    void pattern(const types::PatternTerm& pattern) {
        if (pattern.syntax != nullptr) add_use(pattern.syntax->span, pattern.symbol);
        for (const types::PatternTerm& argument : pattern.args) this->pattern(argument);
    }
    void clauses(const std::vector<types::ClauseTerm>& clauses) {
        for (const types::ClauseTerm& clause : clauses) pattern(clause.pattern);
    }
    void term(const types::Term& term) {
        if (term.syntax != nullptr) add_use(term.syntax->span, term.symbol);
        for (const types::FieldTerm& field : term.fields) pattern(field.pattern);
        for (const types::PatternTerm& parameter : term.patterns) pattern(parameter);
        clauses(term.clauses);
        clauses(term.link_clauses);
    }
    void declaration(const types::Declaration& declaration) {
        pattern(declaration.pattern);
        for (const types::EquationTerm& equation : declaration.equations) this->equation(equation, declaration);
        if (declaration.kind != DeclKind::subtype) return;
        for (const types::ConstructorTerm& constructor : declaration.constructors) this->constructor(constructor);
    }
    void equation(const types::EquationTerm& equation, const types::Declaration& function) {
        if (!function.binds.empty()) add_use(name_span(equation.span, *function.binds.front()), function.binds.front());
        for (const auto& group : equation.groups)
            for (const types::PatternTerm& parameter : group) pattern(parameter);
    }
    void constructor(const types::ConstructorTerm& constructor) {
        if (constructor.symbol != nullptr)
            add_use(name_span(constructor.span, *constructor.symbol), constructor.symbol);
    }
    /// Returns the span of the name at the beginning of a declaration or use.
    static Span name_span(Span span, const types::Symbol& symbol) {
        const std::size_t colons = symbol.name.rfind(':');
        const std::size_t length = symbol.name.size() - (colons == std::string::npos ? 0 : colons + 1);
        span.end = std::min(span.end, span.begin + static_cast<std::uint32_t>(length));
        return span;
    }

    types::TypeStore& store_;
    NameTable table_;
    std::unordered_map<const types::Symbol*, std::size_t> numbers_;
};

}  // namespace

std::vector<NamedType> check_types(const Script& script, diagnostics::Diagnostics& diagnostics, NameTable* table) {
    std::vector<NamedType> result;
    on_deep_stack([&] {
        types::TypeStore store;
        types::BuiltinTypes builtins(store);
        try {
            const auto resolved = types::NameResolver(store, builtins, diagnostics).run(script);
            types::Inference(*resolved, store, diagnostics).run();
            result = named_types(*resolved, store);
            if (table != nullptr) *table = NameTableMaker(store).run(*resolved);
        } catch (const types::TypeOverflow&) {  // the error has already been reported where it occurred
        }
    });
    return result;
}

}  // namespace robochart::cspm
