// SPDX-License-Identifier: Apache-2.0
// Factors branches of a choice with equal continuations into one branch over the union of their events.
#include "csp_emit/passes/choice_factoring.hpp"

#include <algorithm>

#include "checker/cspm/syntax/build.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::Expr;
using cspm::ExprPtr;

namespace {

bool mentions_name(const Expr& expr, const std::string& name) {
    bool found = expr.kind == cspm::ExprKind::name && expr.text == name;
    for_each_part(expr, [&](const Expr& part) { found = found || mentions_name(part, name); });
    return found;
}

/// True if the branch is `c -> P`, or `c?x -> P` with a P that does not use x.
bool only_event_matters(const Expr& branch) {
    if (branch.kind != cspm::ExprKind::prefix || branch.args[0]->kind != cspm::ExprKind::name) return false;
    if (branch.fields.empty()) return true;
    const cspm::Field& field = branch.fields.front();
    const bool plain = branch.fields.size() == 1 && field.kind == cspm::FieldKind::input && !field.value &&
                       field.pattern->kind == cspm::PatternKind::name;
    return plain && !mentions_name(*branch.args[1], field.pattern->text);
}

void collect_operands(const ExprPtr& expr, b::Exprs& out) {
    if (expr->kind != cspm::ExprKind::external_choice) return out.push_back(expr);
    for (const ExprPtr& operand : expr->args) collect_operands(operand, out);
}

class Gatherer {
public:
    Gatherer(NameManager& names, std::vector<NamedSet>& known)
        : names_(names), known_(known), event_(names.unique_name("e__")) {}

    ExprPtr rewrite(const ExprPtr& expr) {
        if (!expr) return expr;
        if (expr->kind == cspm::ExprKind::external_choice) return rewrite_choice(expr);
        if (expr->kind == cspm::ExprKind::apply || expr->args.empty()) return expr;
        return with_parts(expr, [&](const ExprPtr& part) { return rewrite(part); });
    }

private:
    ExprPtr rewrite_choice(const ExprPtr& expr) {
        b::Exprs branches;
        collect_operands(expr, branches);
        b::Exprs result;
        for (std::size_t i = 0; i < branches.size(); ++i) {
            if (!branches[i]) continue;  // already merged into another branch
            b::Exprs events;
            if (only_event_matters(*branches[i])) events = take_alike_branches(branches, i);
            const ExprPtr single = rewrite(branches[i]);
            result.push_back(events.size() < 2 ? single : offer_events(events, single->args[1]));
        }
        return b::choice(result);
    }

    /// Returns the events of branch `first` and of later branches with the same continuation. Removes the later
    /// branches.
    static b::Exprs take_alike_branches(b::Exprs& branches, std::size_t first) {
        const ExprPtr& model = branches[first];
        b::Exprs result{model->args[0]};
        for (std::size_t i = first + 1; i < branches.size(); ++i) {
            ExprPtr& other = branches[i];
            if (!other || !only_event_matters(*other) || !cspm::equal(other->args[1], model->args[1])) continue;
            result.push_back(other->args[0]);
            other = nullptr;
        }
        return result;
    }

    ExprPtr offer_events(const b::Exprs& events, const ExprPtr& next) {
        return b::replicated(cspm::ExprKind::replicated_external,
                             {b::generator(event_, named_set(b::productions(events)))},
                             b::prefix(b::name(event_), next));
    }

    ExprPtr named_set(const ExprPtr& events) {
        const auto same =
            std::ranges::find_if(known_, [&](const NamedSet& known) { return cspm::equal(known.events, events); });
        if (same != known_.end()) return b::name(same->name);
        known_.push_back({names_.unique_name("alike__"), events});
        return b::name(known_.back().name);
    }

    NameManager& names_;
    std::vector<NamedSet>& known_;
    std::string event_;
};

}  // namespace

void gather_alike_branches(std::vector<Function>& functions, NameManager& names, std::vector<NamedSet>& known) {
    Gatherer gatherer(names, known);
    for (Function& function : functions) function.body = gatherer.rewrite(function.body);
}

}  // namespace robochart::csp_emit
