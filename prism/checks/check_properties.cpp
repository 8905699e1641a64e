// SPDX-License-Identifier: Apache-2.0
// Checks properties. See check.hpp.
#include <set>

#include "prism/checks/check.hpp"
#include "prism/checks/definitions.hpp"
#include "prism/checks/rules.hpp"
#include "prism/checks/scope.hpp"

namespace robochart::prism {
namespace {

/// Collects the labels in an expression. They may be names of properties.
void collect_labels(const ExprPtr& expr, std::set<std::string>& labels, std::set<const Expr*>& seen) {
    if (!expr || !seen.insert(expr.get()).second) return;
    if (expr->op == Op::label) labels.insert(expr->text);
    for (const ExprPtr& part : expr->parts) collect_labels(part, labels, seen);
}

class PropertyChecker {
public:
    PropertyChecker(const CheckedModel& model, const PropertyFile& file, diagnostics::Diagnostics& diagnostics)
        : model_(model), file_(file), diagnostics_(diagnostics) {}

    CheckedProperties operator()() {
        diagnostics::Diagnostics of_the_model;  // not shown, because they have been reported already
        declare_names(model_, scope_, of_the_model);
        for (const Definition& formula : model_.formulas)
            formulas_.expressions.emplace(formula.name.text, formula.body);
        scope_.labels = {"deadlock", "init"};
        for (const Definition& label : model_.labels) scope_.labels.insert(label.name.text);
        for (const RewardStructure& structure : model_.rewards) scope_.rewards.push_back(structure.name.text);
        constants();
        labels();
        scope_.properties = true;
        properties();
        return std::move(result_);
    }

private:
    ExprPtr expand_if_manageable(const ExprPtr& expr) {
        ExprPtr result = formulas_(expr);
        if (result && !is_manageable(result, expr->span, diagnostics_)) return expr;
        return result;
    }

    void constants() {
        std::vector<Defined> defined;
        for (const Constant& written : file_.constants) {
            if (formulas_.expressions.contains(written.name.text))
                diagnostics_.report(rules::declared_twice, written.name.span, {written.name.text});
            declare_constant(written, scope_, diagnostics_);
            Constant constant = written;
            constant.value = expand_if_manageable(written.value);
            defined.push_back({constant.name, constant.value});
            result_.constants.push_back(std::move(constant));
        }
        (void)definition_order(defined, diagnostics_);
        TypeChecker types(scope_, diagnostics_);
        for (const Constant& constant : result_.constants)
            types.expect_type(constant.value, constant.type, true, "a constant");
    }

    void labels() {
        TypeChecker types(scope_, diagnostics_);
        for (const Definition& written : file_.labels) {
            if (written.name.text == "deadlock" || written.name.text == "init")
                diagnostics_.report(rules::own_label, written.name.span, {written.name.text});
            else if (!scope_.labels.insert(written.name.text).second)
                diagnostics_.report(rules::declared_twice, written.name.span, {written.name.text});
            Definition label{written.name, expand_if_manageable(written.body)};
            types.expect_type(label.body, Type::boolean);
            result_.labels.push_back(std::move(label));
        }
    }

    /// Checks all properties. A property is checked after the properties that it refers to.
    void properties() {
        std::vector<Defined> defined;
        for (const Property& property : file_.properties) {
            result_.properties.push_back({property.name, expand_if_manageable(property.expression)});
            if (!property.name.text.empty() &&
                (scope_.labels.contains(property.name.text) || !names_.insert(property.name.text).second))
                diagnostics_.report(rules::declared_twice, property.name.span, {property.name.text});
            defined.push_back({property.name, references(result_.properties.back().expression)});
        }
        result_.types.assign(file_.properties.size(), Type::boolean);
        for (const std::size_t i : definition_order(defined, diagnostics_)) {
            TypeChecker types(scope_, diagnostics_);
            const std::optional<Type> type = types.type(result_.properties[i].expression);
            if (type) result_.types[i] = *type;
            if (!result_.properties[i].name.text.empty()) scope_.named.emplace(result_.properties[i].name.text, type);
        }
    }

    /// Returns the labels of an expression as names, for sorting.
    static ExprPtr references(const ExprPtr& expr) {
        std::set<std::string> labels;
        std::set<const Expr*> seen;
        collect_labels(expr, labels, seen);
        std::vector<ExprPtr> names;
        for (const std::string& label : labels) names.push_back(make_expr(Op::name, expr->span, {}, label));
        return make_expr(Op::call, expr->span, std::move(names));
    }

    const CheckedModel& model_;
    const PropertyFile& file_;
    diagnostics::Diagnostics& diagnostics_;
    Scope scope_;
    Rewriter formulas_;
    std::set<std::string> names_;
    CheckedProperties result_;
};

}  // namespace

CheckedProperties check_properties(const CheckedModel& model, const PropertyFile& file,
                                   diagnostics::Diagnostics& diagnostics) {
    return PropertyChecker(model, file, diagnostics)();
}

}  // namespace robochart::prism
