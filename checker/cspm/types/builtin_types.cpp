// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/types/builtin_types.hpp"

#include <array>
#include <utility>

#include "checker/cspm/types/builtins.hpp"
#include "checker/cspm/types/written_type.hpp"

namespace robochart::cspm::types {

namespace {

struct Row {
    std::string_view name;
    std::string_view type;
};

// A script may build sets of processes but not examine them. So operations that compare elements require Eq. The others
// require only Set.
constexpr std::array rows{
    Row{"true", "Bool"},
    Row{"false", "Bool"},
    Row{"True", "Bool"},
    Row{"False", "Bool"},
    Row{"Bool", "{Bool}"},
    Row{"Int", "{Int}"},
    Row{"Char", "{Char}"},
    Row{"Proc", "{Proc}"},
    Row{"Events", "{Event}"},
    Row{"union", "Set a => ({a}, {a}) -> {a}"},
    Row{"inter", "Set a => ({a}, {a}) -> {a}"},
    Row{"diff", "Set a => ({a}, {a}) -> {a}"},
    Row{"Union", "Set a => ({{a}}) -> {a}"},
    Row{"Inter", "Set a => ({{a}}) -> {a}"},
    Row{"member", "Eq a => (a, {a}) -> Bool"},
    Row{"card", "Eq a => ({a}) -> Int"},
    Row{"empty", "Eq a => ({a}) -> Bool"},
    Row{"set", "Set a => (<a>) -> {a}"},
    Row{"Set", "Set a => ({a}) -> {{a}}"},
    Row{"Seq", "Set a => ({a}) -> {<a>}"},
    Row{"seq", "Eq a => ({a}) -> <a>"},
    Row{"length", "(<a>) -> Int"},
    Row{"null", "(<a>) -> Bool"},
    Row{"head", "(<a>) -> a"},
    Row{"tail", "(<a>) -> <a>"},
    Row{"concat", "(<<a>>) -> <a>"},
    Row{"elem", "Eq a => (a, <a>) -> Bool"},
    Row{"emptyMap", "Set k => (| k => v |)"},
    Row{"mapFromList", "Set k => (<(k, v)>) -> (| k => v |)"},
    Row{"mapLookup", "Set k => ((| k => v |), k) -> v"},
    Row{"mapMember", "Set k => ((| k => v |), k) -> Bool"},
    Row{"mapToList", "Set k => ((| k => v |)) -> <(k, v)>"},
    Row{"mapUpdate", "Set k => ((| k => v |), k, v) -> (| k => v |)"},
    Row{"mapUpdateMultiple", "Set k => ((| k => v |), <(k, v)>) -> (| k => v |)"},
    Row{"mapDelete", "Set k => ((| k => v |), k) -> (| k => v |)"},
    Row{"Map", "(Set k, Set v) => ({k}, {v}) -> {(| k => v |)}"},
    Row{"extensions", "Yieldable b => (a => b) -> {a}"},
    Row{"productions", "Yieldable a => (b =>* a) -> {a}"},
    Row{"error", "(<Char>) -> a"},
    Row{"show", "(a) -> <Char>"},
    Row{"STOP", "Proc"},
    Row{"SKIP", "Proc"},
    Row{"DIV", "Proc"},
    Row{"CHAOS", "({Event}) -> Proc"},
    Row{"RUN", "({Event}) -> Proc"},
    Row{"WAIT", "(Int) -> Proc"},
    Row{"timed_priority", "(Proc) -> Proc"},
    Row{"BUFFER", "(Int, {(Event, Event)}) -> Proc"},
    Row{"WEAK_BUFFER", "(Int, Event, {(Event, Event)}) -> Proc"},
    Row{"SIGNAL_BUFFER", "(Int, Event, Event, {(Event, Event)}) -> Proc"},
    Row{"chase", "(Proc) -> Proc"},
    Row{"chase_nocache", "(Proc) -> Proc"},
    Row{"deter", "(Proc) -> Proc"},
    Row{"failure_watchdog", "(Proc, {Event}, Event) -> Proc"},
    Row{"loop", "(Proc) -> Proc"},
    Row{"prioritise", "(Proc, <{Event}>) -> Proc"},
    Row{"prioritise_nocache", "(Proc, <{Event}>) -> Proc"},
    Row{"prioritisepo", "(Proc, {Event}, {(Event, Event)}, {Event}) -> Proc"},
    Row{"trace_watchdog", "(Proc, {Event}, Event) -> Proc"},
    Row{"mtransclose", "Eq a => ({(a, a)}, {a}) -> {(a, a)}"},
    Row{"relational_image", "(Eq a, Set b) => ({(a, b)}) -> (a) -> {b}"},
    Row{"relational_inverse_image", "(Set a, Eq b) => ({(a, b)}) -> (b) -> {a}"},
    Row{"transpose", "(Set a, Set b) => ({(a, b)}) -> {(b, a)}"},
    Row{"explicate", "(Proc) -> Proc"},
    Row{"lazyenumerate", "(Proc) -> Proc"},
    Row{"diamond", "(Proc) -> Proc"},
    Row{"normal", "(Proc) -> Proc"},
    Row{"lazynorm", "(Proc) -> Proc"},
    Row{"sbisim", "(Proc) -> Proc"},
    Row{"tau_loop_factor", "(Proc) -> Proc"},
    Row{"model_compress", "(Proc) -> Proc"},
    Row{"wbisim", "(Proc) -> Proc"},
    Row{"dbisim", "(Proc) -> Proc"},
};

// Builds a closed type. All its variables become quantified.
class Builder {
public:
    Builder(TypeStore& store, const WrittenScheme& scheme) : store_(store), scheme_(scheme) {}

    Scheme build() {
        Scheme result;
        result.type = type(scheme_.type);
        for (const auto& [name, variable] : variables_) result.quantified.push_back(variable);
        return result;
    }

private:
    TypeId type(const WrittenType& written) {
        if (written.kind == TypeKind::variable) return name(written.name);
        std::vector<TypeId> args;
        for (const WrittenType& argument : written.args) args.push_back(type(argument));
        if (written.kind == TypeKind::extendable) std::swap(args[0], args[1]);
        return store_.make_type(written.kind, args);
    }

    TypeId name(const std::string& name) {
        if (const TypeKind kind = primitive_kind(name); kind != TypeKind::variable) return store_.atom(kind);
        for (const auto& [known, variable] : variables_) {
            if (known == name) return variable;
        }
        Constraints constraints = 0;
        for (const auto& [constraint, variable] : scheme_.constraints) {
            if (variable == name) constraints |= constraint;
        }
        variables_.emplace_back(name, store_.fresh_variable(constraints));
        return variables_.back().second;
    }

    TypeStore& store_;
    const WrittenScheme& scheme_;
    std::vector<std::pair<std::string, TypeId>> variables_;
};

bool is_allowed(Visibility visibility, BuiltinTypes::Where where) {
    using enum BuiltinTypes::Where;
    switch (visibility) {
        case Visibility::always:
            return where == script || where == timed_section;
        case Visibility::timed_sections:
            return where == timed_section;
        case Visibility::transparent:
            return where == transparent_line;
        case Visibility::external:
            return where == external_line;
        case Visibility::transparent_or_external:
            return where == transparent_line || where == external_line;
    }
    return false;
}

}  // namespace

Symbol* BuiltinTypes::find(std::string_view name, Where where) {
    const BuiltinName* builtin = find_builtin(name);
    if (builtin == nullptr || !is_allowed(builtin->visibility, where)) return nullptr;
    const auto [place, fresh] = made_.try_emplace(builtin->name);
    Symbol& symbol = place->second;
    if (!fresh) return &symbol;
    symbol.name = name;
    symbol.kind = SymbolKind::builtin;
    for (const Row& row : rows) {
        if (row.name == name) symbol.scheme = Builder(store_, read_type(row.type)).build();
    }
    return &symbol;
}

std::string_view BuiltinTypes::hint(std::string_view name) {
    const BuiltinName* builtin = find_builtin(name);
    if (builtin == nullptr || builtin->visibility == Visibility::always) return "";
    if (builtin->visibility == Visibility::timed_sections) return "timed";
    return builtin->visibility == Visibility::external ? "external" : "transparent";
}

}  // namespace robochart::cspm::types
