// SPDX-License-Identifier: Apache-2.0
// Declares the errors of the evaluation of expressions, and the values of constants.
#pragma once

#include <cstdint>
#include <exception>
#include <map>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "prism/explore/real.hpp"
#include "prism/syntax/syntax.hpp"

namespace robochart::prism {

/// A violation of a rule in explore/rules.hpp, with its place in the text and, if known, the state.
class EvaluationError : public std::exception {
public:
    EvaluationError(const diagnostics::Rule& rule, Span span, std::vector<std::string> arguments)
        : rule_(&rule), span_(span), arguments_(std::move(arguments)) {}
    [[nodiscard]] const char* what() const noexcept override { return rule_->code.data(); }
    /// For example "in the state x=1, y=false".
    std::string state;
    [[nodiscard]] bool is(const diagnostics::Rule& rule) const { return rule_ == &rule; }
    diagnostics::Diagnostic& report(diagnostics::Diagnostics& diagnostics) const {
        diagnostics::Diagnostic& finding = diagnostics.report(*rule_, span_, arguments_);
        if (!state.empty()) finding.notes.push_back({{}, "in the state " + state});
        return finding;
    }

private:
    const diagnostics::Rule* rule_;
    Span span_;
    std::vector<std::string> arguments_;
};

/// The value of a constant.
struct Value {
    Type type = Type::integer;
    std::int64_t integer = 0;  ///< also for a bool: 0 or 1
    Real real;                 ///< for a double

    [[nodiscard]] Real number() const { return type == Type::real ? real : Real(integer); }
    [[nodiscard]] std::string text() const;
};

using Values = std::map<std::string, Value, std::less<>>;

}  // namespace robochart::prism
