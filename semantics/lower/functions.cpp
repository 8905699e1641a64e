// Functions of the model (semantics 3.5: a statement that uses one waits for its precondition; 3.13: without a
// definition it is a constant).
#include <algorithm>
#include <array>

#include "semantics/lower/expressions.hpp"
#include "semantics/lower/types.hpp"
#include "semantics/rules.hpp"

namespace robochart::ir {
namespace {

constexpr std::array toolkits{"set_toolkit", "relation_toolkit", "function_toolkit", "sequence_toolkit", "core"};

bool is_library(const std::string& package) {
    return std::find(toolkits.begin(), toolkits.end(), package) != toolkits.end();
}

}  // namespace

FunctionId lower_function(Lowering& lowering, const frontend::Function& source, diagnostics::Span where) {
    const std::string package = lowering.package_of(source);
    if (is_library(package))
        return lowering.unsupported("function " + source.name + " of " + package, where), FunctionId{};
    const auto known = lowering.functions.find(&source);
    if (known != lowering.functions.end()) return known->second;
    const FunctionId id{static_cast<std::uint32_t>(lowering.system.functions.size())};
    lowering.functions[&source] = id;
    lowering.system.functions.emplace_back();
    Function function;
    function.name = source.name;
    function.package = package;
    function.origin = origin_of(source.name, source.span);
    for (const auto& parameter : source.parameters) {
        function.parameter_names.push_back(parameter->name);
        function.parameters.push_back(lower_type(lowering, parameter->type, parameter->span));
    }
    function.result = lower_type(lowering, source.result, source.span);
    for (const auto& condition : source.preconditions)
        function.preconditions.push_back(lower_expression(lowering, {}, *condition, boolean_type));
    lowering.diagnostics.report(rules::function_without_definition, source.name_span, {source.name});
    lowering.system.functions[id.index] = std::move(function);
    return id;
}

}  // namespace robochart::ir
