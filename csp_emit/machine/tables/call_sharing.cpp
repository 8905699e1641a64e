// SPDX-License-Identifier: Apache-2.0
// Represents the stack of calls as a parameter, and selects functions by its top.
#include "csp_emit/machine/tables/call_sharing.hpp"

#include <algorithm>
#include <functional>

#include "checker/cspm/syntax/build.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;

namespace {

const char* const top_of_stack = "return_place__";
const char* const rest_of_stack = "outer_places__";

ExprPtr push_number(std::int64_t number, const ExprPtr& outer) {
    if (outer->kind == cspm::ExprKind::sequence) return b::sequence({b::number(number)});
    return b::binary(cspm::ExprKind::concat, b::sequence({b::number(number)}), outer);
}

}  // namespace

void CallSharing::push_return(std::uint32_t frame, const Activation& returned, const Values& values, Values& inside) {
    if (!return_stack_) {
        Cell cell;
        cell.name = "places__";
        cell.kind = CellKind::frozen;
        return_stack_ = cells_.add_cell(std::move(cell));
    }
    Returns& known = returns_[frame];
    const auto [found, added] = known.number.try_emplace(activation_key(returned), known.continuations.size());
    if (added) {
        known.continuations.push_back(continuations_.size());
        continuations_.push_back({frame, returned, "return " + std::to_string(continuations_.size())});
    }
    const bool first = returned.frame == 0;
    pending_.push_back({frame, std::make_shared<cspm::Expr>(), found->second,
                        first ? b::sequence({}) : cells_.current_value(*return_stack_, values)});
    inside[*return_stack_] = pending_.back().value;
}

ExprPtr CallSharing::return_from(std::uint32_t frame, const Values& values, bool after_tock) {
    const std::string& end = points_.end_of(frame).name;
    return returns_[frame].calls.emplace_back(calls_.add_call(end, cells_.to_arguments(values), after_tock));
}

Values CallSharing::stack_after_call(const Continuation& continuation) {
    if (continuation.config.frame == 0) return {};
    pending_.push_back({continuation.frame, std::make_shared<cspm::Expr>(), std::nullopt, nullptr});
    return {{*return_stack_, pending_.back().value}};
}

ExprPtr CallSharing::select_continuation(std::uint32_t frame) {
    const std::vector<std::size_t>& all = returns_.at(frame).continuations;
    const ExprPtr front = b::call(top_of_stack, {cells_.parameter_name(*return_stack_)});
    ExprPtr result = calls_.add_call(continuations_[all.back()].name, {});
    for (std::size_t i = all.size() - 1; i-- > 0;)
        result = b::if_(b::binary(cspm::ExprKind::equal, front, b::number(static_cast<std::int64_t>(i))),
                        calls_.add_call(continuations_[all[i]].name, {}), result);
    return result;
}

void CallSharing::fill_values() {
    for (const Pending& pending : pending_) {
        const bool one = returns_.at(pending.frame).continuations.size() == 1;
        const ExprPtr stack = cells_.parameter_name(*return_stack_);
        ExprPtr value;
        if (!pending.pushed)
            value = one ? stack : b::call(rest_of_stack, {stack});
        else if (one)
            value = pending.outer;
        else
            value = push_number(static_cast<std::int64_t>(*pending.pushed), pending.outer);
        *pending.value = *value;
    }
}

void CallSharing::skip_returns(std::vector<Function>& functions, const std::vector<Function>& behind) {
    std::map<std::string, std::string> skipped;
    for (const auto& [frame, returns] : returns_)
        if (returns.continuations.size() == 1 && !returns.calls.empty())
            if (const std::string* next = calls_.only_calls(*behind[returns.continuations[0]].body))
                skipped[points_.end_of(frame).name] = *next;
    for (const auto& [frame, returns] : returns_)
        for (const auto& call : returns.calls) {
            auto next = skipped.find(calls_.find_call(*call)->function);
            for (; next != skipped.end(); next = skipped.find(next->second)) calls_.redirect_call(*call, next->second);
        }
    std::erase_if(functions, [&](const Function& function) { return skipped.count(function.name) != 0; });
    points_.erase_points([&](const std::string& name) { return skipped.count(name) != 0; });
}

void CallSharing::describe_stack(Candidates& candidates) const {
    if (return_stack_) candidates.returns = cells_[*return_stack_].name;
    for (const Pending& pending : pending_)
        if (pending.pushed)
            candidates.entries[pending.value.get()] = {
                continuations_[returns_.at(pending.frame).continuations[*pending.pushed]].name, pending.outer};
}

void CallSharing::declare_functions(std::vector<cspm::DeclPtr>& decls) const {
    if (std::ranges::none_of(returns_, [](const auto& returns) { return returns.second.continuations.size() > 1; }))
        return;
    using cspm::PatternKind;
    const auto pattern = [](PatternKind kind, const std::string& text, std::vector<cspm::PatternPtr> parts) {
        cspm::Pattern result;
        result.kind = kind;
        result.text = text;
        result.args = std::move(parts);
        return std::make_shared<const cspm::Pattern>(std::move(result));
    };
    const auto add = [&](const char* name, const std::string& front, const std::string& rest,
                         const std::string& value) {
        const auto variable = [&](const std::string& text) {
            return pattern(text.empty() ? PatternKind::wildcard : PatternKind::name, text, {});
        };
        const auto one = pattern(PatternKind::sequence, "", {variable(front)});
        decls.push_back(
            b::function_decl(name, {pattern(PatternKind::concat, "", {one, variable(rest)})}, b::name(value)));
    };
    add(top_of_stack, "x__", "", "x__");
    add(rest_of_stack, "", "y__", "y__");
}

void inline_continuations(std::vector<Function>& functions, std::size_t first) {
    std::map<std::string, ExprPtr> bodies;
    for (std::size_t i = first; i < functions.size(); ++i) bodies[functions[i].name] = functions[i].body;
    const std::function<ExprPtr(const ExprPtr&)> put = [&](const ExprPtr& expr) -> ExprPtr {
        const bool applied = expr->kind == cspm::ExprKind::apply;
        const ExprPtr& name = applied ? expr->args[0] : expr;
        if (name->kind == cspm::ExprKind::name)
            if (const auto found = bodies.find(name->text); found != bodies.end()) return found->second;
        if (expr->kind != cspm::ExprKind::if_then_else) return expr;
        auto result = std::make_shared<cspm::Expr>(*expr);
        for (std::size_t i = 1; i < result->args.size(); ++i) result->args[i] = put(result->args[i]);
        return result;
    };
    functions.resize(first);
    for (Function& function : functions) function.body = put(function.body);
}

}  // namespace robochart::csp_emit
