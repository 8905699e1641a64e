// See session.hpp.
#include "checker/prism/session.hpp"

#include <map>
#include <unordered_map>

#include "checker/prism/evaluator.hpp"
#include "checker/prism/explore/constants.hpp"
#include "checker/prism/explore/rules.hpp"

namespace robochart::prism {
namespace {

/// Models of that many states are solved with fractions where enclosures do not decide.
constexpr std::size_t few_states = 300;

/// Labels by what they stand for; names of properties by the properties.
class LabelResolver {
public:
    LabelResolver(const CheckedModel& model, const CheckedProperties& properties) {
        for (const Definition& each : model.labels) bodies_.emplace(each.name.text, each.body);
        for (const Definition& each : properties.labels) bodies_.emplace(each.name.text, each.body);
        for (const Property& each : properties.properties)
            if (!each.name.text.empty()) bodies_.emplace(each.name.text, each.expression);
    }

    ExprPtr operator()(const ExprPtr& expr) {
        if (!expr) return expr;
        if (const auto known = done_.find(expr.get()); known != done_.end()) return known->second;
        ExprPtr result = replaced(expr);
        done_.emplace(expr.get(), result);
        return result;
    }

private:
    ExprPtr replaced(const ExprPtr& expr) {
        if (expr->op == Op::label) {
            const auto found = bodies_.find(expr->text);
            return found == bodies_.end() ? expr : (*this)(found->second);
        }
        if (expr->parts.empty()) return expr;
        Expr copy = *expr;
        for (ExprPtr& part : copy.parts) part = (*this)(part);
        return make_expr(std::move(copy));
    }

    std::map<std::string, ExprPtr, std::less<>> bodies_;
    std::unordered_map<const Expr*, ExprPtr> done_;
};

}  // namespace

Session::Session(const StateSpace& space, const CheckedProperties& properties, const SessionOptions& options)
    : space_(space), properties_(properties), options_(options) {}

ExprPtr Session::resolved(const ExprPtr& expr) {
    return LabelResolver(space_.model(), properties_)(expr);
}

Result Session::attempt(const ExprPtr& expr, const Values& constants, double relative, bool exact) {
    Code code = space_.code(constants);
    Evaluator evaluator(space_, code, {relative, exact, options_.budget});
    try {
        return evaluator.answer(expr);
    } catch (const Undecided& why) {
        Result result;
        result.reason = why.what();
        return result;
    } catch (const markov::Unsupported& why) {
        Result result;
        result.reason = why.what();
        return result;
    }
}

Result Session::check(std::size_t property, const Values& constants) {
    Values known = space_.constants();
    evaluate_constants(properties_.constants, constants, known, true);
    const ExprPtr expr = resolved(properties_.properties[property].expression);
    Result result = attempt(expr, known, options_.relative, options_.exact);
    if (result.kind != Result::Kind::unknown || options_.exact) return result;
    const auto decided = [](const Result& each) { return each.kind != Result::Kind::unknown; };
    for (const double relative : {1e-9, 1e-13}) {
        if (relative >= options_.relative) continue;
        Result narrower = attempt(expr, known, relative, false);
        if (decided(narrower) || narrower.reason == result.reason) {
            if (decided(narrower)) return narrower;
            break;
        }
        result = std::move(narrower);
    }
    if (space_.chain().states() > few_states || space_.chain().exact.empty()) return result;
    try {
        Result exact = attempt(expr, known, options_.relative, true);
        if (decided(exact)) return exact;
    } catch (const EvaluationError& error) {
        if (!error.is(rules::not_exact)) throw;
    }
    return result;
}

}  // namespace robochart::prism
