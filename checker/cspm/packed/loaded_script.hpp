// SPDX-License-Identifier: Apache-2.0
// A script made ready to run, with all that its evaluation makes and keeps.
#pragma once

#include <functional>

#include "checker/cspm/eval/evaluator.hpp"
#include "checker/cspm/resolve/resolver.hpp"
#include "checker/cspm/syntax/syntax.hpp"
#include "checker/process/operational_semantics.hpp"
#include "base/diagnostics/budget.hpp"

namespace robochart::cspm {

/// Owns the program of a script, its values and its terms. Loaded twice from the same script, definitions have the same
/// numbers as long as the same expressions are made ready in the same order.
class LoadedScript {
public:
    /// The budget is polled while the script is made ready. `whole_states`: see Session.
    LoadedScript(const Script& script, process::Compressor* compressor, diagnostics::Budget* budget, bool whole_states);
    LoadedScript(const LoadedScript&) = delete;
    LoadedScript& operator=(const LoadedScript&) = delete;

    /// An expression of the script's global scope, or of the scope of an assertion.
    struct Ready {
        const Code* code = nullptr;
        const Unit* unit = nullptr;
    };
    [[nodiscard]] Ready ready(const ExprPtr& expr, const Decl* place = nullptr);
    /// One side of an assertion.
    struct Side {
        Ready process;
        std::optional<Ready> tau_priority;  ///< the events over which taus have priority
    };
    [[nodiscard]] Side side(const ExprPtr& expr, const Decl& assertion);
    [[nodiscard]] process::TermId term_of(const Side& side);
    /// What the firing rules object to becomes an error of evaluation, so that users of a session see one kind: at the
    /// definition at fault, if that is known, or else at `span`.
    template <class Work>
    auto evaluated_at(Span span, const Work& work) {
        try {
            return work();
        } catch (const process::SemanticsError& error) {
            const Span place = error.term ? place_of(*error.term) : Span{};
            throw EvaluationError(error.what(), place.known() ? place : span, {});
        }
    }

    Program program;
    ValueStore store;
    process::EventTable events;
    process::TermStore terms;
    process::OperationalSemantics semantics;
    Resolver resolver;
    Evaluator evaluator;

private:
    [[nodiscard]] Span place_of(process::TermId term);
};

}  // namespace robochart::cspm
