// SPDX-License-Identifier: Apache-2.0
// Infers types of modules with parameters and of instances. The names of an instance have the types of the module,
// except that the types of the arguments replace those of the parameters, and that the instance has new datatypes.
#include <algorithm>
#include <set>

#include "checker/cspm/types/infer.hpp"
#include "checker/cspm/types/rules.hpp"

namespace robochart::cspm::types {

// Checks a module with parameters. The tuple of the types of its parameters is the type of the module. Types inside the
// module may depend on these types, so they stay open.
void Inference::check_module(const Declaration& declaration) {
    terms_.bind_locals(declaration.parameters);
    if (declaration.inside != nullptr) check_list(*declaration.inside, ListKind::module);
    std::vector<TypeId> types;
    for (const Symbol* parameter : declaration.parameters)
        types.push_back(unifier_.evaluate_dots(parameter->scheme.type));
    const TypeId type = store_.make_type(TypeKind::tuple, types);
    (void)terms_.unify(declaration.span, declaration.module->symbol->scheme.type, type);
}

void Inference::check_instance(const Declaration& declaration) {
    const Module* original = declaration.module->original;
    if (original == nullptr || original->symbol->failed) {
        for (Symbol* symbol : declaration.binds) symbol->failed = true;
        for (const Term* argument : declaration.arguments) (void)terms_.infer(*argument);
        return;
    }
    const Scheme& scheme = original->symbol->scheme;
    std::vector<std::pair<TypeId, TypeId>> parameters;
    for (const TypeId variable : scheme.quantified)
        parameters.emplace_back(variable, store_.fresh_variable(store_.node(variable).constraints));
    std::ranges::sort(parameters);
    const TypeId type = store_.head(unifier_.copy_type(scheme.type, parameters, {}));
    const std::vector<TypeId> expected =
        store_.node(type).kind == TypeKind::tuple ? store_.arguments(type) : std::vector<TypeId>{};
    if (expected.size() != declaration.arguments.size()) {
        const auto count = [](std::size_t n) { return std::to_string(n) + (n == 1 ? " argument" : " arguments"); };
        throw TypeFault{&rules::module_arguments,
                        {original->name, count(expected.size()), count(declaration.arguments.size())},
                        {},
                        declaration.span};
    }
    for (std::size_t i = 0; i < expected.size(); ++i) {
        (void)terms_.expect_type(*declaration.arguments[i], expected[i], "the module uses its parameter so");
    }
    (void)terms_.unify(declaration.span, declaration.module->symbol->scheme.type, type);
    copy_types(declaration, parameters);
    find_comparable(declaration);
}

// Copies the types of a module for an instance. If the types of several names contain the same variable (for example,
// the parameter of an enclosing module), then their copies contain the same new variable.
void Inference::copy_types(const Declaration& instance, std::vector<std::pair<TypeId, TypeId>> variables) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> datatypes;
    std::set<TypeId> known;
    for (const auto& [variable, copy] : variables) known.insert(variable);
    for (const Copy& copied : instance.copies) {
        if (copied.original->kind == SymbolKind::datatype)
            datatypes.emplace_back(copied.original->datatype, copied.copy->datatype);
        for (const TypeId open : copied.original->scheme.quantified) {
            if (!known.insert(open).second) continue;
            variables.emplace_back(open, store_.fresh_variable(store_.node(open).constraints));
        }
    }
    std::ranges::sort(variables);
    std::ranges::sort(datatypes);
    for (const Copy& copied : instance.copies) {
        if (copied.original->failed) {
            copied.copy->failed = true;
            continue;
        }
        const TypeId type = unifier_.copy_type(copied.original->scheme.type, variables, datatypes);
        (void)terms_.unify(instance.span, copied.copy->scheme.type, type);
    }
}

// Determines which datatypes of an instance have values that can be compared. Assumes this of all of them until a
// constructor has a field that cannot be compared.
void Inference::find_comparable(const Declaration& instance) {
    for (const Copy& copied : instance.copies) {
        if (copied.copy->kind == SymbolKind::datatype) store_.set_comparable(copied.copy->datatype, true);
    }
    for (bool changed = true; changed;) {
        changed = false;
        for (const Copy& copied : instance.copies) {
            if (copied.copy->kind != SymbolKind::constructor || copied.copy->failed) continue;
            std::vector<TypeId> parts;
            const TypeId end = store_.head(store_.split(copied.copy->scheme.type, parts));
            if (store_.node(end).kind != TypeKind::datatype || !store_.is_comparable(store_.node(end).first)) continue;
            try {
                for (const TypeId part : parts) unifier_.constrain(can_equal, part);
            } catch (const TypeFault&) {
                store_.set_comparable(store_.node(end).first, false);
                changed = true;
            }
        }
    }
}

}  // namespace robochart::cspm::types
