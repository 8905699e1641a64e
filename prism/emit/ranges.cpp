// SPDX-License-Identifier: Apache-2.0
#include "prism/emit/ranges.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <string>

#include "prism/emit/tree.hpp"

namespace robochart::prism_emit {
namespace {

using prism::Expr;
using prism::ExprPtr;
using prism::Op;

struct Bounds {
    std::int64_t low = 0, high = 0;
};
using Known = std::optional<Bounds>;

class RangeKeeper {
public:
    explicit RangeKeeper(prism::ModelFile& model) : model_(model) {
        for (const prism::Constant& constant : model.constants)
            if (constant.value) constants_[constant.name.text] = constant.value;
        for (const prism::Variable& variable : model.globals) add_variable(variable);
        for (const prism::Module& module : model.modules)
            for (const prism::Variable& variable : module.variables) add_variable(variable);
    }

    void operator()() {
        ExprPtr left_out;
        for (std::size_t i = 0; i < model_.modules.size(); ++i)
            for (prism::Command& command : model_.modules[i].commands) {
                const ExprPtr inside = stays_inside(command);
                if (tree::is_true(inside)) continue;
                const ExprPtr here = tree::all_of(
                    {command.guard, others_take_part(i, command.action.text), tree::apply(Op::negation, {inside})});
                left_out = left_out ? tree::apply(Op::disjunction, {left_out, here}) : here;
                guards_.emplace_back(&command, tree::all_of({command.guard, inside}));
            }
        for (const auto& [command, guard] : guards_) command->guard = guard;
        if (left_out) model_.labels.push_back({{left_out_label, {}}, left_out});
    }

private:
    void add_variable(const prism::Variable& variable) {
        if (!variable.low) return;
        const Known low = bounds_of(*variable.low);
        const Known high = bounds_of(*variable.high);
        if (low && high) ranges_[variable.name.text] = {low->low, high->high};
    }

    /// Returns the condition that every possible branch writes values within the ranges of its variables. The condition
    /// is `true` if this always holds.
    ExprPtr stays_inside(const prism::Command& command) const {
        std::vector<ExprPtr> all;
        for (const prism::Branch& branch : command.branches) {
            std::vector<ExprPtr> of_branch;
            for (const prism::Assignment& assignment : branch.assignments) stays_inside(assignment, of_branch);
            if (of_branch.empty()) continue;
            const ExprPtr fits = tree::all_of(of_branch);
            all.push_back(branch.probability
                              ? tree::apply(Op::disjunction,
                                            {tree::apply(Op::equal, {branch.probability, tree::number(0)}), fits})
                              : fits);
        }
        return tree::all_of(all);
    }

    void stays_inside(const prism::Assignment& assignment, std::vector<ExprPtr>& conditions) const {
        const auto range = ranges_.find(assignment.variable.text);
        if (range == ranges_.end()) return;
        const Known value = bounds_of(*assignment.value);
        if (!value || value->low < range->second.low)
            conditions.push_back(tree::apply(Op::greater_equal, {assignment.value, tree::number(range->second.low)}));
        if (!value || value->high > range->second.high)
            conditions.push_back(tree::apply(Op::less_equal, {assignment.value, tree::number(range->second.high)}));
    }

    /// Returns the condition that all other modules with this action can take part.
    ExprPtr others_take_part(std::size_t module, const std::string& action) const {
        std::vector<ExprPtr> all;
        for (std::size_t i = 0; i < model_.modules.size() && !action.empty(); ++i) {
            ExprPtr any;
            for (const prism::Command& command : model_.modules[i].commands)
                if (i != module && command.action.text == action)
                    any = any ? tree::apply(Op::disjunction, {any, command.guard}) : command.guard;
            all.push_back(any);
        }
        return tree::all_of(all);
    }

    /// Returns the least and the greatest value of an integer, or no value if they are unknown.
    Known bounds_of(const Expr& expr) const {
        constexpr std::int64_t most = std::int64_t{1} << 40U;
        const Known result = compute_bounds(expr);
        return result && result->low >= -most && result->high <= most ? result : std::nullopt;
    }

    Known compute_bounds(const Expr& expr) const {
        switch (expr.op) {
            case Op::integer: {
                std::int64_t value = 0;
                std::from_chars(expr.text.data(), expr.text.data() + expr.text.size(), value);
                return Bounds{value, value};
            }
            case Op::name:
                return bounds_of_name(expr.text);
            case Op::minus:
                if (const Known a = bounds_of(*expr.parts[0])) return Bounds{-a->high, -a->low};
                return std::nullopt;
            case Op::add:
            case Op::subtract:
            case Op::conditional:
                return bounds_of_operation(expr);
            default:
                return std::nullopt;
        }
    }

    Known bounds_of_name(const std::string& name) const {
        if (const auto range = ranges_.find(name); range != ranges_.end()) return range->second;
        const auto constant = constants_.find(name);
        return constant == constants_.end() ? std::nullopt : bounds_of(*constant->second);
    }

    Known bounds_of_operation(const Expr& expr) const {
        const Known a = bounds_of(*expr.parts[expr.parts.size() - 2]);
        const Known b = bounds_of(*expr.parts.back());
        if (!a || !b) return std::nullopt;
        if (expr.op == Op::add) return Bounds{a->low + b->low, a->high + b->high};
        if (expr.op == Op::subtract) return Bounds{a->low - b->high, a->high - b->low};
        return Bounds{std::min(a->low, b->low), std::max(a->high, b->high)};
    }

    prism::ModelFile& model_;
    std::map<std::string, ExprPtr> constants_;
    std::map<std::string, Bounds> ranges_;
    std::vector<std::pair<prism::Command*, ExprPtr>> guards_;
};

}  // namespace

prism::ModelFile in_ranges(prism::ModelFile model) {
    RangeKeeper keep(model);
    keep();
    return model;
}

}  // namespace robochart::prism_emit
