// From a counterexample of the checker to a run in the words of the model. What a step means is read off what each
// sequential component does in it, under the name that the event has there: renaming, hiding and priority around a
// component (of a check, a composition or a CSP block) change nothing.
#pragma once

#include "checker/cspm/session.hpp"
#include "csp_emit/emit.hpp"
#include "diagnostics/source.hpp"
#include "runs/run.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::runs {

/// What runs are read with; all of it outlives the interpreter.
struct Context {
    const csp_emit::Provenance& provenance;
    const ir::System& system;
    const ir::Instantiation& instantiation;
    const diagnostics::SourceManager& sources;
    cspm::Session& session;
};

/// The run of a counterexample to one of the obligation's assertions, and what is wrong at its end.
[[nodiscard]] Run interpret(const Context&, const csp_emit::Obligation&, const refine::Counterexample&);

}  // namespace robochart::runs
