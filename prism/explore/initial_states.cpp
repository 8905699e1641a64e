// SPDX-License-Identifier: Apache-2.0
// Lists the initial states of a model. See list_initial_states in instance.hpp.
#include <fmt/format.h>

#include "prism/explore/instance.hpp"
#include "prism/explore/rules.hpp"

namespace robochart::prism {
namespace {

void conjuncts(const ExprPtr& expr, std::vector<ExprPtr>& result) {
    if (expr->op != Op::conjunction) return result.push_back(expr);
    for (const ExprPtr& part : expr->parts) conjuncts(part, result);
}

/// Lists initial states by assigning values to the variables one after the other.
class Lister {
public:
    Lister(const ExprPtr& expr, const Layout& layout, Code& code, diagnostics::Budget* budget,
           const std::function<void(const std::int32_t*)>& found)
        : layout_(layout),
          code_(code),
          budget_(budget),
          found_(found),
          decided_(layout.fields().size() + 1),
          values_(layout.fields().size()) {
        std::vector<ExprPtr> parts;
        conjuncts(expr, parts);
        for (const ExprPtr& part : parts) {
            const Code::Root root = code_.compile(part);
            const std::vector<std::uint32_t> variables = code_.variables(root);
            decided_[variables.empty() ? 0 : variables.back() + 1].push_back(root);
        }
    }

    void list(std::size_t variable) {
        if (budget_ != nullptr) budget_->poll();
        for (const Code::Root root : decided_[variable])
            if (!code_.holds(root, values_.data())) return;
        if (variable == values_.size()) return found_(values_.data());
        const Layout::Field& field = layout_.fields()[variable];
        for (std::int64_t value = field.low; value <= field.high; ++value) {
            values_[variable] = static_cast<std::int32_t>(value);
            list(variable + 1);
        }
    }

private:
    const Layout& layout_;
    Code& code_;
    diagnostics::Budget* budget_;
    const std::function<void(const std::int32_t*)>& found_;
    std::vector<std::vector<Code::Root>> decided_;  ///< conjuncts, by the number of variables that must have values
    std::vector<std::int32_t> values_;
};

/// Returns the initial values in the declarations.
std::vector<std::int32_t> declared_values(const Instance& instance, Code& code) {
    const auto& fields = instance.layout().fields();
    std::vector<std::int32_t> values(fields.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Variable& variable = instance.model().variables[i];
        const Layout::Field& field = fields[i];
        std::int64_t value = field.bounded ? field.low : 0;
        if (variable.initial) value = code.integer(code.compile(variable.initial), nullptr);
        if (value < field.low || value > field.high)
            throw EvaluationError(
                rules::out_of_range, variable.initial->span,
                {field.name, fmt::format("{}", value), fmt::format("[{}..{}]", field.low, field.high)});
        values[i] = static_cast<std::int32_t>(value);
    }
    return values;
}

}  // namespace

void list_initial_states(const Instance& instance, Code& code, diagnostics::Budget* budget,
                         const std::function<void(const std::int32_t*)>& found) {
    const ExprPtr& initial = instance.model().initial;
    if (!initial) return found(declared_values(instance, code).data());
    for (const Layout::Field& field : instance.layout().fields())
        if (!field.bounded)
            throw EvaluationError(rules::no_initial_state, initial->span,
                                  {fmt::format("init ... endinit needs a range for '{}'", field.name)});
    bool any = false;
    const std::function<void(const std::int32_t*)> note_state = [&](const std::int32_t* values) {
        any = true;
        found(values);
    };
    Lister(initial, instance.layout(), code, budget, note_state).list(0);
    if (!any) throw EvaluationError(rules::no_initial_state, initial->span, {"no state is initial"});
}

}  // namespace robochart::prism
