// SPDX-License-Identifier: Apache-2.0
// Loads a script for evaluation: its code, its values, its events and its terms.
#pragma once

#include <functional>

#include "base/diagnostics/budget.hpp"
#include "checker/cspm/eval/evaluator.hpp"
#include "checker/cspm/resolve/resolver.hpp"
#include "checker/cspm/syntax/syntax.hpp"
#include "checker/process/operational_semantics.hpp"

namespace robochart::cspm {

/// Owns the code of a script, its values and its terms. If the same script is loaded again and the same expressions are
/// compiled in the same order, every definition gets the same number.
class LoadedScript {
public:
    /// Compiles the script. Polls the budget while it does so. Session explains `whole_states`.
    LoadedScript(const Script& script, process::Compressor* compressor, diagnostics::Budget* budget, bool whole_states);
    LoadedScript(const LoadedScript&) = delete;
    LoadedScript& operator=(const LoadedScript&) = delete;

    /// A compiled expression. Its names are resolved in the scope of the script or of an assertion.
    struct Ready {
        const Code* code = nullptr;
        const Unit* unit = nullptr;
    };
    [[nodiscard]] Ready compile_expression(const ExprPtr& expr, const Decl* place = nullptr);
    /// One side of an assertion.
    struct Side {
        Ready process;
        std::optional<Ready> tau_priority;  ///< events over which taus have priority
    };
    [[nodiscard]] Side compile_side(const ExprPtr& expr, const Decl& assertion);
    [[nodiscard]] process::TermId term_of(const Side& side);
    /// Calls a function and converts errors of the firing rules to evaluation errors, so that callers handle one
    /// exception. The error is reported at the definition that causes it if this is known, and otherwise at `span`.
    template <class Work>
    auto evaluated_at(Span span, const Work& work) {
        try {
            return work();
        } catch (const process::SemanticsError& error) {
            const Span place = error.term ? place_of(*error.term) : Span{};
            throw EvaluationError(error.what(), place.is_known() ? place : span, {});
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
