// See list_states in explorer.hpp.
#include <functional>

#include "checker/prism/explore/explorer.hpp"

namespace robochart::prism {
namespace {

void conjuncts(const ExprPtr& expr, std::vector<ExprPtr>& result) {
    if (expr->op != Op::conjunction) return result.push_back(expr);
    for (const ExprPtr& part : expr->parts) conjuncts(part, result);
}

/// Gives the variables values in their order.
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
    std::vector<std::vector<Code::Root>> decided_;  ///< conjuncts, by how many variables have values then
    std::vector<std::int32_t> values_;
};

}  // namespace

void list_states(const ExprPtr& expr, const Layout& layout, Code& code, diagnostics::Budget* budget,
                 const std::function<void(const std::int32_t*)>& found) {
    Lister(expr, layout, code, budget, found).list(0);
}

}  // namespace robochart::prism
