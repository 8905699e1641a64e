// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/packed/loaded_script.hpp"

#include "checker/cspm/resolve/unread_parameters.hpp"
#include "checker/cspm/types/deep_stack.hpp"

namespace robochart::cspm {

LoadedScript::LoadedScript(const Script& script, process::Compressor* compressor, diagnostics::Budget* budget,
                           bool whole_states)
    : terms(events), semantics(terms, compressor), resolver(program, store), evaluator(program, store, events, terms) {
    resolver.set_budget(diagnostics::or_unlimited(budget));
    on_deep_stack([&] {
        resolver.compile_script(script);
        if (!whole_states) find_unread_parameters(program);
    });
    resolver.set_budget(diagnostics::unlimited);
}

LoadedScript::Ready LoadedScript::compile_expression(const ExprPtr& expr, const Decl* place) {
    Unit* unit = nullptr;
    const Code* code = nullptr;
    on_deep_stack([&] { code = resolver.compile_expression(expr, place, unit); });
    return {code, unit};
}

LoadedScript::Side LoadedScript::compile_side(const ExprPtr& expr, const Decl& assertion) {
    Side result{compile_expression(expr, &assertion), std::nullopt};
    if (assertion.assertion.tau_priority)
        result.tau_priority = compile_expression(assertion.assertion.tau_priority, &assertion);
    return result;
}

process::TermId LoadedScript::term_of(const Side& side) {
    const process::TermId term = evaluator.process(*side.process.code, *side.process.unit);
    if (!side.tau_priority) return term;
    return evaluator.tau_priority(term, evaluator.event_set(*side.tau_priority->code, *side.tau_priority->unit));
}

/// Returns the place of the definition of the first call in the term.
Span LoadedScript::place_of(process::TermId term) {
    const process::Term& at = terms[term];
    if (at.op == process::Op::call) return evaluator.place_of_call(at.payload);
    for (const process::TermId child : at.children)
        if (const Span place = place_of(child); place.is_known()) return place;
    return {};
}

}  // namespace robochart::cspm
