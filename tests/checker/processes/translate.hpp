// SPDX-License-Identifier: Apache-2.0
// Translates test processes into terms of the checker.
#pragma once

#include <vector>

#include "checker/process/bisimulation_compressor.hpp"
#include "checker/process/term_system.hpp"
#include "process_tree.hpp"
#include "tests/checker/process/scripted.hpp"

namespace robochart::refine {

/// A script, translated into its own term store.
class Translation {
public:
    /// If `compressing` is set, compressions are carried out. Otherwise they are replaced by their operands.
    explicit Translation(const naive::Script& script, bool compressing = false);
    process::TermSystem system(const naive::Process& process) { return {semantics_, term(process)}; }
    process::TermId term(const naive::Process& process);
    process::Event event(naive::Letter letter);
    process::Scripted& scripted() { return scripted_; }
    process::OperationalSemantics& semantics() { return semantics_; }

private:
    process::TermId leaf_or_choice(const naive::Tree& tree, std::vector<process::TermId> operands);
    process::TermId composite(const naive::Tree& tree, std::vector<process::TermId> operands);
    process::TermId linked(const naive::Tree& tree, const std::vector<process::TermId>& operands);
    std::uint32_t set_of(const std::set<naive::Letter>& letters);
    process::EventSet events_of(const std::set<naive::Letter>& letters);

    process::Scripted scripted_;
    process::BisimulationCompressor compressor_;
    process::OperationalSemantics semantics_;
    std::vector<process::TermId> names_;
};

}  // namespace robochart::refine
