// SPDX-License-Identifier: Apache-2.0
// See constants.hpp.
#include "prism/explore/constants.hpp"

#include "prism/checks/definitions.hpp"
#include "prism/explore/code.hpp"
#include "prism/explore/rules.hpp"

namespace robochart::prism {

void evaluate_constants(const std::vector<Constant>& constants, const Values& given, Values& known, bool optional) {
    diagnostics::Diagnostics reported_before;
    std::vector<Defined> defined;
    for (const Constant& constant : constants) defined.push_back({constant.name, constant.value});
    for (const std::size_t i : definition_order(defined, reported_before)) {
        const Constant& constant = constants[i];
        const auto found = given.find(constant.name.text);
        Value value;
        if (constant.value) {
            Code code({}, {}, known);
            try {
                value = code.value(code.compile(constant.value), nullptr);
            } catch (const EvaluationError& error) {
                if (optional && error.is(rules::constant_open)) continue;
                throw;
            }
        } else if (found != given.end()) {
            value = found->second;
        } else if (optional) {
            continue;
        } else {
            throw EvaluationError(rules::constant_open, constant.name.span, {constant.name.text});
        }
        if (constant.type == Type::real && value.type == Type::integer) value = {Type::real, 0, Real(value.integer)};
        known[constant.name.text] = std::move(value);
    }
}

}  // namespace robochart::prism
