// SPDX-License-Identifier: Apache-2.0
// Converts a term to the transition system that runs it: component machines and rules if its operators allow it,
// otherwise the term itself.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "checker/machine/component.hpp"
#include "checker/machine/explicit_machine.hpp"
#include "checker/machine/skeleton.hpp"
#include "checker/machine/supercombinator_system.hpp"
#include "checker/process/bisimulation_compressor.hpp"
#include "checker/process/compressor.hpp"

namespace robochart::machine {

/// Limits of the compilation; beyond them the process stays a term.
struct Bounds {
    std::size_t component_states = 200'000;
    std::size_t rules = 2'000'000;
    /// Components up to this size are minimised by strong bisimilarity, which preserves every model (FDR does the
    /// same).
    std::size_t minimised_states = 50'000;
    /// An inner prioritise whose components together have fewer states than this is explored to one component: it does
    /// not offer most events of its operand, and otherwise every state of the whole process would repeat this
    /// computation.
    std::size_t region_states = 100'000;
    /// A compression whose operand has more states (without those that confluent taus leave, if the compression allows
    /// this) is left out: the process runs without it.
    std::size_t compressed_states = 2'000'000;
};

/// Stores the components of one store's terms, so that equal ones are explored once.
class Compiler {
public:
    explicit Compiler(process::OperationalSemantics& semantics, const Bounds& bounds = {});

    /// The compiled process. Null in these cases: there is no parallel operator to take apart, or only after many
    /// events and with few states in all; a component has too many states or cannot be explored on its own (an
    /// evaluation error that the whole process may never reach); or there are too many rules. `poll` is called
    /// regularly and may throw process::Interrupted, which is passed on.
    [[nodiscard]] std::unique_ptr<SupercombinatorSystem> compile(TermId term, const std::function<void()>& poll);
    /// The current or last exploration; for progress and for the description of a limit.
    struct Stage {
        std::optional<TermId> component;
        std::size_t number = 0, of = 0;  ///< counted from 1
        std::size_t states = 0;          ///< states of this component so far
    };
    [[nodiscard]] const Stage& stage() const { return stage_; }
    /// A machine that is equal to the compiled process up to the equivalence: with all of its states, or only those
    /// that remain after confluent taus (reduced_system.hpp). No value if compile returns null. Throws
    /// process::TooManyStates.
    [[nodiscard]] std::optional<process::Machine> explore(TermId term, lts::Equivalence up_to,
                                                          const std::function<void()>& poll);

private:
    bool is_small(TermId term, const std::function<void()>& poll);
    ComponentPtr component(TermId term, const std::function<void()>& poll);
    ComponentPtr explored(TermId term, const std::function<void()>& poll);
    ComponentPtr gate(const Node& node) const;
    std::optional<Skeleton> skeleton(TermId term, const std::set<TermId>& leaves, const std::function<void()>& poll);
    std::vector<ComponentPtr> components(const Skeleton& skeleton, const std::function<void()>& poll);
    std::set<TermId> small_regions(const Skeleton& skeleton, const std::vector<ComponentPtr>& components) const;
    ComponentPtr region(TermId term, const std::function<void()>& poll);
    ComponentPtr reduced(ExplicitMachine machine, const std::function<void()>& poll) const;
    bool prune(const Supercombinator& combined, std::vector<ComponentPtr>& components,
               const std::function<void()>& poll) const;

    process::OperationalSemantics& semantics_;
    Bounds bounds_;
    std::map<TermId, ComponentPtr> components_;
    Stage stage_;
};

/// Compresses what the compiler has explored. The semantics needs its compressor before the compiler can have the
/// semantics, so `use` connects them.
class MachineCompressor final : public process::Compressor {
public:
    void use(Compiler& compiler) { compiler_ = &compiler; }
    std::optional<process::Machine> explore(TermId operand, process::Compression kind,
                                            const std::function<void()>& poll) override;
    process::Machine compress(const process::Machine& explored, process::Compression kind,
                              const std::function<void()>& poll) override {
        return compressor_.compress(explored, kind, poll);
    }

private:
    Compiler* compiler_ = nullptr;
    process::BisimulationCompressor compressor_;
};

}  // namespace robochart::machine
