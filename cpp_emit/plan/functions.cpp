// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/plan/functions.hpp"

#include <memory>
#include <stdexcept>

#include "semantics/evaluate/carrier.hpp"
#include "semantics/evaluate/evaluate.hpp"

namespace robochart::cpp_emit {

namespace {

constexpr std::size_t most_arguments = 1U << 19U;
constexpr std::size_t most_rows = 4096;

/// Returns a call whose arguments are constants 0, 1, ... of the environment.
ir::Expr call_of(const ir::Function& function, ir::FunctionId id) {
    ir::Expr call;
    call.kind = ir::ExprKind::call;
    call.type = function.result;
    call.function = id;
    for (std::uint32_t i = 0; i < function.parameters.size(); ++i) {
        ir::Expr argument;
        argument.kind = ir::ExprKind::constant;
        argument.type = function.parameters[i];
        argument.constant = ir::ConstantId{i};
        call.args.push_back(std::make_shared<const ir::Expr>(std::move(argument)));
    }
    return call;
}

}  // namespace

std::vector<FunctionValue> values_of(const ir::System& system, const ir::Instantiation& inst, ir::FunctionId id) {
    const ir::Function& function = system.functions[id.index];
    const ir::Expr call = call_of(function, id);
    const ir::Value otherwise = ir::default_value(system, inst, function.result);
    std::vector<std::vector<ir::Value>> carriers;
    std::size_t combinations = 1;
    for (const ir::TypeId type : function.parameters) {
        carriers.push_back(ir::carrier_values(system, inst, type, most_arguments));
        combinations *= carriers.back().size();
        if (combinations > most_arguments) throw std::length_error("a function with too many arguments for a table");
    }
    std::vector<FunctionValue> rows;
    for (std::size_t number = 0; number < combinations; ++number) {
        ir::Environment environment;
        std::size_t rest = number;
        for (const auto& carrier : carriers) {
            environment.constants.push_back(carrier[rest % carrier.size()]);
            rest /= carrier.size();
        }
        try {
            ir::Value result = ir::evaluate_expression(system, inst, nullptr, environment, call);
            if (result != otherwise) rows.push_back({environment.constants, std::move(result)});
        } catch (const ir::EvaluationFault&) {
            continue;  // outside its precondition the function has no value, and the model blocks
        }
        if (rows.size() > most_rows) throw std::length_error("a function with too many values for a table");
    }
    return rows;
}

}  // namespace robochart::cpp_emit
