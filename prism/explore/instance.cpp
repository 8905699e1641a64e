// SPDX-License-Identifier: Apache-2.0
// See instance.hpp.
#include "prism/explore/instance.hpp"

#include <map>

#include "prism/explore/constants.hpp"

namespace robochart::prism {
namespace {

Values values_of(const std::vector<Constant>& constants, const Values& given) {
    Values known;
    evaluate_constants(constants, given, known);
    return known;
}

Code code_for(const CheckedModel& model, const Values& constants) {
    std::map<std::string, std::uint32_t, std::less<>> variables;
    std::vector<Type> types;
    const auto add = [&](const std::string& name, Type type) {
        variables.emplace(name, static_cast<std::uint32_t>(types.size()));
        types.push_back(type);
    };
    for (const Variable& variable : model.variables) add(variable.name.text, variable.type);
    add(Instance::deadlock_name, Type::boolean);
    add(Instance::initial_name, Type::boolean);
    return {std::move(variables), std::move(types), constants};
}

Layout layout_of(const CheckedModel& model, const Values& constants) {
    Code code = code_for(model, constants);
    return {model.variables, code};
}

}  // namespace

Instance::Instance(const CheckedModel& model, const Values& constants)
    : model_(model), constants_(values_of(model.constants, constants)), layout_(layout_of(model, constants_)) {}

Code Instance::code(const Values& more) const {
    Values all = constants_;
    for (const auto& [name, value] : more) all.insert_or_assign(name, value);
    return code_for(model_, all);
}

}  // namespace robochart::prism
