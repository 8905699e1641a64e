// Functions of the model (semantics 3.5: a statement that uses one waits for its precondition; 3.13: without a
// definition it is a constant).
#include <algorithm>
#include <utility>

#include "semantics/lower/expressions.hpp"
#include "semantics/lower/types.hpp"
#include "semantics/rules.hpp"

namespace robochart::ir {
namespace {

bool generic(const frontend::TypePtr& type) {
    if (!type) return false;
    return type->form == frontend::TypeForm::variable || std::any_of(type->args.begin(), type->args.end(), generic);
}

void lower_conditions(Lowering& lowering, const frontend::Function& source, Function& function) {
    Names names;
    for (const auto& condition : source.preconditions)
        function.preconditions.push_back(lower_expression(lowering, names, *condition, boolean_type));
    names.result = function.result;
    for (const auto& condition : source.postconditions)
        function.postconditions.push_back(lower_expression(lowering, names, *condition, boolean_type));
    if (function.postconditions.empty())
        lowering.diagnostics.report(rules::function_without_definition, source.name_span, {source.name});
    else
        lowering.diagnostics.report(rules::function_by_contract, source.name_span, {source.name});
}

/// Signature first: the conditions may call the function.
FunctionId add(Lowering& lowering, const frontend::Function& source, std::vector<TypeId> parameters, TypeId result) {
    const FunctionId id{static_cast<std::uint32_t>(lowering.system.functions.size())};
    lowering.functions[&source] = id;
    Function function;
    function.name = source.name;
    function.package = lowering.package_of(source);
    function.origin = origin_of(source.name, source.span);
    for (const auto& parameter : source.parameters) function.parameter_names.push_back(parameter->name);
    function.parameters = std::move(parameters);
    function.result = result;
    lowering.system.functions.push_back(function);
    lower_conditions(lowering, source, function);
    lowering.system.functions[id.index] = std::move(function);
    return id;
}

}  // namespace

bool is_generic(const frontend::Function& function) {
    const auto open = [](const auto& parameter) { return generic(parameter->type); };
    return generic(function.result) || std::any_of(function.parameters.begin(), function.parameters.end(), open);
}

FunctionId lower_function(Lowering& lowering, const frontend::Function& source, diagnostics::Span where) {
    const auto known = lowering.functions.find(&source);
    if (known != lowering.functions.end()) return known->second;
    if (is_generic(source)) {
        lowering.unsupported("function " + source.name + " for all types as a value", where);
        return {};
    }
    std::vector<TypeId> parameters;
    for (const auto& parameter : source.parameters)
        parameters.push_back(lower_type(lowering, parameter->type, parameter->span));
    return add(lowering, source, std::move(parameters), lower_type(lowering, source.result, source.span));
}

FunctionId lower_instance(Lowering& lowering, const frontend::Function& source, const std::vector<TypeId>& parameters,
                          TypeId result, std::map<std::string, TypeId> variables, diagnostics::Span where) {
    if (const auto known = lowering.functions.find(&source); known != lowering.functions.end()) {
        const Function& before = lowering.system.functions.at(known->second.index);
        if (before.parameters == parameters && before.result == result) return known->second;
        lowering.unsupported("function " + source.name + " used for several types", where);
        return {};
    }
    std::swap(lowering.type_variables, variables);
    const FunctionId id = add(lowering, source, parameters, result);
    std::swap(lowering.type_variables, variables);
    return id;
}

}  // namespace robochart::ir
