// SPDX-License-Identifier: Apache-2.0
// Resolves the types, operators and literals of conditions. The caller defines the meaning of names.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "base/diagnostics/diagnostic.hpp"
#include "claims/checks/checked.hpp"

namespace robochart::claims {

/// Thrown after a finding about the claim has been reported.
struct ClaimError {};

/// The type of a part of a condition.
enum class Sort : std::uint8_t { number, truth, literal };

/// A part of a condition with its type; `type` is valid for literals.
struct Typed {
    Condition condition;
    Sort sort = Sort::number;
    ir::TypeId type;
};

[[nodiscard]] Condition operand_of(Operand operand, std::size_t index);
[[nodiscard]] Condition constant_of(Fraction value);
[[nodiscard]] Condition operation(Op op, std::vector<Condition> parts);

/// Resolves conditions of one model.
class ConditionResolver {
public:
    ConditionResolver(const ir::System& system, diagnostics::Diagnostics& diagnostics)
        : system_(system), diagnostics_(diagnostics) {}

    /// Resolves a name, a last value or a state. `resolve` calls this function for everything except numbers, truth
    /// values and operators.
    using Leaf = std::function<Typed(const Expr&)>;
    [[nodiscard]] Typed resolve(const Expr& expr, const Leaf& leaf) const;
    /// Like `resolve`, but reports an error if the expression is not a truth value.
    [[nodiscard]] Condition resolve_truth(const Expr& expr, const Leaf& leaf) const;
    [[nodiscard]] std::optional<Typed> find_literal(const std::string& text) const;
    /// Returns an operand of the model's type. Reports an error if conditions cannot compare values of this type.
    [[nodiscard]] Typed typed_operand(Condition condition, ir::TypeId type, Span span) const;
    [[noreturn]] void refuse(Span span, std::string text) const;

private:
    [[nodiscard]] Typed resolve_operator(const Expr& expr, const Leaf& leaf) const;

    const ir::System& system_;
    diagnostics::Diagnostics& diagnostics_;
};

}  // namespace robochart::claims
