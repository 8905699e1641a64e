// SPDX-License-Identifier: Apache-2.0
// See session.hpp.
#include "prism/session/session.hpp"

#include "prism/explore/constants.hpp"
#include "prism/explore/rules.hpp"
#include "prism/session/evaluator.hpp"
#include "prism/session/labels.hpp"

namespace robochart::prism {
namespace {

/// The largest number of states of a model that is solved with fractions if enclosures do not decide.
constexpr std::size_t few_states = 300;

}  // namespace

Session::Session(const StateSpace& space, const CheckedProperties& properties, const SessionOptions& options)
    : space_(space), properties_(properties), options_(options) {}

Session::Question Session::question(std::size_t property, const Values& constants) const {
    Question result;
    result.constants = space_.constants();
    evaluate_constants(properties_.constants, constants, result.constants, true);
    result.expr = LabelResolver(space_.model(), properties_)(properties_.properties[property].expression);
    return result;
}

Result Session::answer_with_precision(const Question& question, double relative, bool exact) const {
    Code code = space_.code(question.constants);
    Evaluator evaluator(space_, code, {relative, exact, options_.budget});
    try {
        return evaluator.answer_question(question.expr);
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

Result Session::check(std::size_t property, const Values& constants) const {
    const Question resolved = question(property, constants);
    Result result = answer_with_precision(resolved, options_.relative, options_.exact);
    if (result.kind != Result::Kind::unknown || options_.exact) return result;
    const auto decided = [](const Result& candidate) { return candidate.kind != Result::Kind::unknown; };
    for (const double relative : {1e-9, 1e-13}) {
        if (relative >= options_.relative) continue;
        Result narrower = answer_with_precision(resolved, relative, false);
        if (decided(narrower) || narrower.reason == result.reason) {
            if (decided(narrower)) return narrower;
            break;
        }
        result = std::move(narrower);
    }
    if (space_.chain().states() > few_states || space_.chain().exact.empty()) return result;
    try {
        Result exact = answer_with_precision(resolved, options_.relative, true);
        if (decided(exact)) return exact;
    } catch (const EvaluationError& error) {
        if (!error.is(rules::not_exact)) throw;
    }
    return result;
}

std::optional<Counterexample> Session::counterexample(std::size_t property, const Values& constants) const {
    const Question resolved = question(property, constants);
    Code code = space_.code(resolved.constants);
    return prism::counterexample(space_, code, resolved.expr, {options_.relative, false, options_.budget});
}

std::vector<std::uint32_t> Session::best_choices(std::size_t property, const Values& constants) const {
    const Question resolved = question(property, constants);
    Code code = space_.code(resolved.constants);
    return prism::best_choices(space_, code, resolved.expr, {options_.relative, false, options_.budget});
}

}  // namespace robochart::prism
