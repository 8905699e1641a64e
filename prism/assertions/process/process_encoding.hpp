// SPDX-License-Identifier: Apache-2.0
// Encodes the timed CSP semantics of a component as a Markov decision process. The encoding does not resolve
// nondeterministic choices of the model, and bounds count time units.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "base/diagnostics/source.hpp"
#include "prism/assertions/experiments/encoding.hpp"
#include "prism/assertions/process/decision_process.hpp"
#include "prism/assertions/process/explored_process.hpp"
#include "prism/assertions/process/process_names.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::probability {

struct ProcessOptions {
    Scheduler scheduler = Scheduler::any;
    /// The user's options. Values that an assertion gives to constants are added.
    ir::InstantiationOptions instantiation;
    std::uint64_t max_states = 500'000'000;
    /// If the process has at most this many states, two comparisons check it: the process is compared with the process
    /// of the refinement checks, and the urgent scheduler with all schedulers.
    std::uint64_t compared_states = 1'000'000;
    bool exact = false;
    diagnostics::Budget* budget = nullptr;
    /// Called for each set of values of the constants, before the states of its process are explored. The arguments are
    /// valid until the next call.
    SessionObserver on_session = {};
};

class ProcessEncoding final : public Encoding {
public:
    /// All arguments must outlive the object. `subject` is a module, a controller or a machine.
    ProcessEncoding(const ir::System& system, const ir::ComponentRef& subject, diagnostics::SourceManager& sources,
                    ProcessOptions options);
    ~ProcessEncoding() override;

    [[nodiscard]] Elements& elements() override;
    [[nodiscard]] prism::Constant prism_constant(const std::string& path) override;
    [[nodiscard]] const prism::StateSpace& explore_space(const Question&, const prism::Values&) override;
    /// Throws NotExpressed, because random paths would depend on a scheduler.
    [[nodiscard]] Unexplored unexplored_model(const Question&, const prism::Values&) override;
    [[nodiscard]] bool one_value() const override { return options_.scheduler == Scheduler::uniform; }
    /// Returns the number of states that were compared with the process for refinement checks; 0 if they were not
    /// compared.
    [[nodiscard]] std::uint64_t compared_state_count() const;

private:
    struct Explored;
    struct Answered;

    const Explored& find_explored(const prism::Values&);
    [[nodiscard]] prism::ModelFile model_declarations(const Explored& found, const Question& question,
                                                      const std::vector<EventSet>& happening) const;
    [[nodiscard]] std::int32_t value_in(const Explored& found, lts::StateIndex state,
                                        const Observable& observable) const;
    [[nodiscard]] DecisionProcess make_decision_process(const Explored& found) const;
    [[nodiscard]] prism::GivenSpace make_space(const Explored& found, DecisionProcess process) const;

    const ir::System& system_;
    const ir::ComponentRef& subject_;
    diagnostics::SourceManager& sources_;
    ProcessOptions options_;
    std::unique_ptr<ProcessNames> names_;
    std::unique_ptr<Explored> explored_;  ///< the latest process; questions about one model come together
    std::unique_ptr<Answered> answered_;
};

}  // namespace robochart::probability
