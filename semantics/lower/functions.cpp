// SPDX-License-Identifier: Apache-2.0
// Lowers the functions of the model. A statement that uses a function waits until its precondition is true (semantics
// 3.5). A function without a definition is constant (semantics 3.13).
#include <algorithm>
#include <utility>

#include "semantics/lower/expressions.hpp"
#include "semantics/lower/types.hpp"
#include "semantics/rules.hpp"

namespace robochart::ir {
namespace {

bool contains_variable(const frontend::TypePtr& type) {
    if (!type) return false;
    return type->form == frontend::TypeForm::variable || std::ranges::any_of(type->args, contains_variable);
}

/// True if typing has rejected the contract (RC-T36). The function then has no contract.
bool contract_is_wrong(const frontend::Function& source) {
    const auto wrong = [](const auto& condition) { return !condition->type; };
    return std::ranges::any_of(source.preconditions, wrong) || std::ranges::any_of(source.postconditions, wrong);
}

/// True if csp blocks that replace the instantiation define the function (semantics 3.13), in each of the timed and
/// untimed semantics that has assertions, or in both if there are no assertions.
bool defined_by_blocks(const Lowering& lowering, const Function& function) {
    std::string name = function.package.empty() ? function.name : function.package + "_" + function.name;
    while (name.find("::") != std::string::npos) name.replace(name.find("::"), 2, "_");  // as in scripts
    using Time = frontend::AssertionTime;
    bool timed = false, untimed = false, timed_claims = false, untimed_claims = false;
    for (const frontend::File* file : lowering.files) {
        for (const frontend::CspBlock& block : file->csp_blocks) {
            const bool replaces = block.name == "Instantiations" || block.name == "instantiations";
            if (!replaces || !frontend::defines_name(block, name)) continue;
            timed = timed || block.time != Time::untimed;
            untimed = untimed || block.time != Time::timed;
        }
        for (const frontend::Assertion& claim : file->assertions) {
            timed_claims = timed_claims || claim.time != Time::untimed;
            untimed_claims = untimed_claims || claim.time != Time::timed;
        }
    }
    if (!timed_claims && !untimed_claims) return timed && untimed;
    return (timed || !timed_claims) && (untimed || !untimed_claims);
}

/// Reports functions that the model does not define, with the values that are assumed for them.
void report_values(const Lowering& lowering, const frontend::Function& source, const Function& function) {
    if (defined_by_blocks(lowering, function)) return;
    const bool open = function.postconditions.empty();
    lowering.diagnostics.report(open ? rules::function_without_definition : rules::function_by_contract,
                                source.name_span, {source.name});
}

void lower_conditions(Lowering& lowering, const frontend::Function& source, Function& function) {
    if (contract_is_wrong(source)) return;
    Names names;
    for (const auto& condition : source.preconditions)
        function.preconditions.push_back(lower_expression(lowering, names, *condition, boolean_type));
    names.result = function.result;
    for (const auto& condition : source.postconditions)
        function.postconditions.push_back(lower_expression(lowering, names, *condition, boolean_type));
}

/// Adds a function with its signature. The conditions are lowered later, because they may call the function.
FunctionId declare_function(Lowering& lowering, const frontend::Function& source, std::string name,
                            std::vector<TypeId> parameters, TypeId result) {
    const FunctionId id{static_cast<std::uint32_t>(lowering.system.functions.size())};
    Function function;
    function.name = std::move(name);
    function.package = lowering.package_of(source);
    function.origin = origin_of(source.name, source.span);
    lowering.check_unique(pointers(source.parameters), source.name, "parameter");
    for (const auto& parameter : source.parameters) function.parameter_names.push_back(parameter->name);
    function.parameters = std::move(parameters);
    function.result = result;
    lowering.system.functions.push_back(std::move(function));
    return id;
}

void define_function(Lowering& lowering, const frontend::Function& source, FunctionId id) {
    Function function = lowering.system.functions[id.index];
    lower_conditions(lowering, source, function);
    report_values(lowering, source, function);
    lowering.system.functions[id.index] = std::move(function);
}

/// Returns a name that no other function of the package has: `f`, `f_2`, `f_3`.
std::string instance_name(const Lowering& lowering, const frontend::Function& source, std::size_t instances) {
    if (instances == 0) return source.name;
    const std::string package = lowering.package_of(source);
    const auto declared = [&](const std::string& name) {
        return std::ranges::any_of(lowering.home, [&](const auto& known) {
            return known.first->name == name && lowering.package_of(*known.first) == package;
        });
    };
    std::size_t number = instances + 1;
    while (declared(source.name + "_" + std::to_string(number))) number += 100;
    return source.name + "_" + std::to_string(number);
}

}  // namespace

bool is_generic(const frontend::Function& function) {
    const auto open = [](const auto& parameter) { return contains_variable(parameter->type); };
    return contains_variable(function.result) || std::ranges::any_of(function.parameters, open);
}

FunctionId lower_function(Lowering& lowering, const frontend::Function& source, diagnostics::Span where) {
    const auto known = lowering.functions.find(&source);
    if (known != lowering.functions.end()) return known->second;
    if (is_generic(source)) {
        lowering.report_unsupported("function " + source.name + " for all types as a value", where);
        return {};
    }
    std::vector<TypeId> parameters;
    for (const auto& parameter : source.parameters)
        parameters.push_back(lower_type(lowering, parameter->type, parameter->span));
    const TypeId result = lower_type(lowering, source.result, source.span);
    const FunctionId id = lowering.functions[&source] =
        declare_function(lowering, source, source.name, std::move(parameters), result);
    define_function(lowering, source, id);
    return id;
}

/// Returns the instance of a generic function for these types. The first instance has the name of the function, and the
/// name of each other instance ends in a number.
FunctionId lower_instance(Lowering& lowering, const frontend::Function& source, const std::vector<TypeId>& parameters,
                          TypeId result, std::map<std::string, TypeId> variables, diagnostics::Span where) {
    constexpr std::size_t most = 64;  // a contract may call the function for larger and larger types
    std::vector<FunctionId>& known = lowering.instances[&source];
    for (const FunctionId id : known) {
        const Function& instance = lowering.system.functions[id.index];
        if (instance.parameters == parameters && instance.result == result) return id;
    }
    if (known.size() == most) {
        lowering.report_unsupported(
            "function " + source.name + " used for more than " + std::to_string(most) + " types", where);
        return {};
    }
    const FunctionId id =
        declare_function(lowering, source, instance_name(lowering, source, known.size()), parameters, result);
    known.push_back(id);
    std::swap(lowering.type_variables, variables);
    define_function(lowering, source, id);
    std::swap(lowering.type_variables, variables);
    return id;
}

}  // namespace robochart::ir
