// SPDX-License-Identifier: Apache-2.0
// See labels.hpp.
#include "prism/session/labels.hpp"

namespace robochart::prism {

LabelResolver::LabelResolver(const CheckedModel& model, const CheckedProperties& properties) {
    for (const Definition& label : model.labels) bodies_.emplace(label.name.text, label.body);
    for (const Definition& label : properties.labels) bodies_.emplace(label.name.text, label.body);
    for (const Property& property : properties.properties)
        if (!property.name.text.empty()) bodies_.emplace(property.name.text, property.expression);
}

ExprPtr LabelResolver::operator()(const ExprPtr& expr) {
    if (!expr) return expr;
    if (const auto known = done_.find(expr.get()); known != done_.end()) return known->second;
    ExprPtr result = replace_labels(expr);
    done_.emplace(expr.get(), result);
    return result;
}

ExprPtr LabelResolver::replace_labels(const ExprPtr& expr) {
    if (expr->op == Op::label) {
        const auto found = bodies_.find(expr->text);
        return found == bodies_.end() ? expr : (*this)(found->second);
    }
    if (expr->parts.empty()) return expr;
    Expr copy = *expr;
    for (ExprPtr& part : copy.parts) part = (*this)(part);
    return make_expr(std::move(copy));
}

}  // namespace robochart::prism
