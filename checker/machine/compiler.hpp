// SPDX-License-Identifier: Apache-2.0
// Compiles a term to component machines and rules if the operators of the term allow this. Otherwise the states of the
// search are terms.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>

#include "base/diagnostics/pollable.hpp"
#include "checker/machine/component.hpp"
#include "checker/machine/explicit_machine.hpp"
#include "checker/machine/skeleton.hpp"
#include "checker/machine/supercombinator_system.hpp"
#include "checker/process/bisimulation_compressor.hpp"
#include "checker/process/compressor.hpp"

namespace robochart::machine {

/// Limits of the compilation. A process that exceeds a limit is not compiled, and its search visits terms.
struct Bounds {
    std::size_t component_states = 200'000;
    std::size_t rules = 2'000'000;
    /// Components with at most this many states are minimised. Strong bisimilarity preserves every model. (FDR does the
    /// same.)
    std::size_t minimised_states = 50'000;
    /// A prioritise inside the process becomes one component if its components together have at most this many states.
    /// Otherwise the prevented events would be computed again for every state of the process.
    std::size_t region_states = 100'000;
    /// A compression is omitted if its operand has more states than this. If confluent taus may be followed in the
    /// operand, only the states that remain are counted.
    std::size_t compressed_states = 2'000'000;
    /// Whether to compress the operands of parallel operators that hide events, before they are combined (inductive
    /// compression; docs/search.md, "Compressed parts"). Preserves T, F and FD, but not the steps of a run.
    bool compress_parts = false;
    /// The maximal total number of states of all parts, if `compress_parts` is true.
    std::size_t part_states = 200'000;
};

/// Compiles processes, which are terms of one store. Keeps all components, so that a term is explored only once even if
/// several processes contain the term.
class Compiler {
public:
    explicit Compiler(process::OperationalSemantics& semantics, const Bounds& bounds = {});

    /// Returns the compiled process, or null in four cases. (1) The process has no parallel operator, or reaches a
    /// parallel operator only after many events and has few states. (2) A component has too many states. (3) A
    /// component cannot be explored alone, because an evaluation fails that the whole process may never need. (4) There
    /// are too many rules. The compiler must outlive every result of make_finer_system of the returned system. Polls
    /// the budget. Throws process::Interrupted.
    [[nodiscard]] std::unique_ptr<SupercombinatorSystem> compile(TermId term, diagnostics::Pollable& budget);
    /// Copies the components that another compiler of the same store has explored, but no compiled processes.
    void add_components_of(const Compiler& other);
    /// Compresses the parts of the process now; compile() would do it later. Requires Bounds::compress_parts. Polls the
    /// budget.
    void compress_parts(TermId term, diagnostics::Pollable& budget);
    /// Returns true if a part of some compiled process was compressed (Bounds::compress_parts).
    [[nodiscard]] bool has_compressed_parts() const;
    /// Returns how much smaller the compression makes the process: the product, over all compressed parts, of the
    /// number of states before the compression divided by the number after it.
    [[nodiscard]] double shrinkage() const { return shrinkage_; }
    /// The component that the compiler explores, or has explored last, for progress and for messages about limits.
    struct Stage {
        std::optional<TermId> component;
        std::size_t number = 0, of = 0;  ///< counted from 1
        std::size_t states = 0;          ///< states of this component found so far
    };
    [[nodiscard]] const Stage& current_stage() const { return stage_; }
    /// Returns a machine that is equivalent to the compiled process up to `up_to`. The machine may omit states from
    /// which confluent taus are followed (reduced_system.hpp). Returns no value if the process cannot be compiled.
    /// Throws process::TooManyStates.
    [[nodiscard]] std::optional<process::Machine> explore(TermId term, lts::Equivalence up_to,
                                                          diagnostics::Pollable& budget);
    /// Explores the operand of a compression. If the operand contains another compression that would not remove states
    /// of the operand, this inner compression is omitted, because the outer compression gives the same result.
    [[nodiscard]] std::optional<process::Machine> explore_operand(TermId term, lts::Equivalence up_to,
                                                                  diagnostics::Pollable& budget);

private:
    bool is_small(TermId term, diagnostics::Pollable& budget);
    ComponentPtr component(TermId term, diagnostics::Pollable& budget);
    ComponentPtr explore_component(TermId term, diagnostics::Pollable& budget);
    ComponentPtr make_gate(const Node& node) const;
    std::optional<Skeleton> skeleton(TermId term, const std::set<TermId>& leaves, diagnostics::Pollable& budget);
    bool has_independent_parts(TermId compressed, diagnostics::Pollable& budget);
    std::vector<ComponentPtr> components(const Skeleton& skeleton, diagnostics::Pollable& budget);
    std::set<TermId> small_regions(const Skeleton& skeleton, const std::vector<ComponentPtr>& components) const;
    ComponentPtr region(TermId term, diagnostics::Pollable& budget);
    void find_parts(TermId term, std::set<TermId>& parts, diagnostics::Pollable& budget);
    bool compress_part(TermId term, diagnostics::Pollable& budget);
    std::unique_ptr<SupercombinatorSystem> combine_components(Skeleton skeleton, std::vector<ComponentPtr> components,
                                                              diagnostics::Pollable& budget);
    ComponentPtr unminimised_component(const Node& node, diagnostics::Pollable& budget);
    std::unique_ptr<lts::FinerSystem> finer_system(const Skeleton& skeleton,
                                                   const std::shared_ptr<const Supercombinator>& minimised,
                                                   diagnostics::Pollable& budget);
    ComponentPtr minimise_component(ExplicitMachine machine, diagnostics::Pollable& budget) const;
    bool prune_unused_edges(const Supercombinator& combined, std::vector<ComponentPtr>& components,
                            diagnostics::Pollable& budget) const;

    process::OperationalSemantics& semantics_;
    Bounds bounds_;
    std::map<TermId, ComponentPtr> components_;
    std::set<TermId> regions_;         ///< terms of compiled processes that are now components
    std::map<TermId, bool> parts_;     ///< for each part that was tried: whether it was compressed
    std::size_t states_of_parts_ = 0;  ///< number of states of all parts before their compression
    std::size_t depth_of_parts_ = 0;
    std::size_t operands_ = 0;     ///< number of compressions whose operands are being explored
    std::set<TermId> judged_;      ///< compressed terms inside them whose parts were examined
    std::set<TermId> kept_apart_;  ///< compressed terms whose parts are kept apart
    double shrinkage_ = 1;
    Stage stage_;
};

/// Compresses machines that the compiler has explored. The semantics needs its compressor before the compiler exists,
/// because the compiler needs the semantics. So the compiler is set later.
class MachineCompressor final : public process::Compressor {
public:
    void set_compiler(Compiler& compiler) { compiler_ = &compiler; }
    std::optional<process::Machine> explore(TermId operand, process::Compression kind,
                                            diagnostics::Pollable& budget) override;
    process::Machine compress(const process::Machine& explored, process::Compression kind,
                              diagnostics::Pollable& budget) override {
        return compressor_.compress(explored, kind, budget);
    }

private:
    Compiler* compiler_ = nullptr;
    process::BisimulationCompressor compressor_;
};

}  // namespace robochart::machine
