// SPDX-License-Identifier: Apache-2.0
// Explores the timed process of a component completely, and makes the objects that read its states.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "base/diagnostics/budget.hpp"
#include "base/diagnostics/source.hpp"
#include "checker/cspm/session.hpp"
#include "counterexample/step_reader.hpp"
#include "csp_emit/base/emission.hpp"
#include "prism/assertions/process/exploration.hpp"
#include "prism/assertions/process/observers.hpp"
#include "prism/assertions/process/state_reader.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::probability {

struct ExploredProcess {
    ir::Instantiation instantiation;
    csp_emit::Emission emission;
    std::unique_ptr<cspm::Session> session;
    std::unique_ptr<lts::TransitionSystem> system;
    std::unique_ptr<Exploration> exploration;
    std::unique_ptr<runs::Context> context;
    std::unique_ptr<runs::StepReader> steps;
    std::unique_ptr<StateReader> reader;
    std::uint64_t compared = 0;  ///< number of states in the comparison; 0 if there was none
};

/// Receives the script of a process, its instantiation, and the session that is going to explore it.
using SessionObserver = std::function<void(const csp_emit::Emission&, const ir::Instantiation&, cspm::Session&)>;

struct ExploreLimits {
    std::uint64_t most_states = 500'000'000;
    /// If the process has at most this many states, it is compared (by branching bisimulation) with the process of the
    /// refinement checks.
    std::uint64_t compared_states = 1'000'000;
    diagnostics::Budget* budget = nullptr;
    /// Called before anything is evaluated. The emission and the instantiation live as long as the result.
    SessionObserver on_session = {};
};

/// Explores the process of the component. The system and the sources must outlive the result. Throws Wrong if there is
/// no such process, and diagnostics::LimitReached.
[[nodiscard]] std::unique_ptr<ExploredProcess> explore_process(const ir::System&, const ir::ComponentRef& subject,
                                                               ir::Instantiation,
                                                               const std::vector<ObservedEvent>& observed,
                                                               diagnostics::SourceManager&, const ExploreLimits&);

}  // namespace robochart::probability
