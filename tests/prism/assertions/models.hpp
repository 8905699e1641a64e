// SPDX-License-Identifier: Apache-2.0
// Loads models with probabilistic assertions, and decides these assertions.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "prism/assertions/experiments/experiment.hpp"
#include "prism/assertions/process/process_encoding.hpp"
#include "prism/assertions/properties/translate.hpp"
#include "prism/assertions/robotool/robotool_encoding.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::probability::testing {

/// A project that is given by paths and texts of its files. It is resolved and lowered.
struct Loaded {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    frontend::Model model;
    ir::System system;

    [[nodiscard]] std::string report() const;
};

[[nodiscard]] std::unique_ptr<Loaded> load(const std::map<std::string, std::string>& files);

/// Returns the only module, or the first controller or machine if there is none.
[[nodiscard]] ir::ComponentRef whole_component(const ir::System&);

/// An assertion and its file. The assertion is found by its name.
struct Claim {
    const frontend::File* file = nullptr;
    const frontend::ProbabilisticAssertion* assertion = nullptr;
};
[[nodiscard]] Claim find_claim(const Loaded&, const std::string& name);

/// Returns options with the ranges 0..2 for nat, int and real, for a dtmc.
[[nodiscard]] RoboToolOptions small_ranges();

/// Returns the rows of an assertion in RoboTool's encoding of the only module. If a row is undecided, its error states
/// the reason.
[[nodiscard]] std::vector<Row> robotool_rows(const Loaded&, const std::string& assertion,
                                             const RoboToolOptions& options = small_ranges(), const Deciding& how = {});

/// Returns the rows of an assertion on the decision process of the whole component. `compared` is the number of states
/// that were compared with the process that is checked for refinement.
[[nodiscard]] std::vector<Row> process_rows(Loaded&, const std::string& assertion, Scheduler scheduler = Scheduler::any,
                                            std::uint64_t* compared = nullptr, std::uint64_t most_states = 100'000,
                                            bool exact = true);

/// Returns "k=1: 0.5": the constants, followed by the value, the truth value or the error.
[[nodiscard]] std::string rows_text(const Row& row);
/// Returns one line for each row.
[[nodiscard]] std::string rows_text(const std::vector<Row>& rows);

}  // namespace robochart::probability::testing
