// From a term to the transition system that runs it: component machines and rules where its operators allow it, the
// term itself otherwise.
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

/// What compilation may cost before the process stays a term.
struct Bounds {
    std::size_t component_states = 200'000;
    std::size_t rules = 2'000'000;
    /// Components up to this size are minimised by strong bisimilarity, which keeps every model (FDR does the same).
    std::size_t minimised_states = 50'000;
    /// A prioritise inside whose components have fewer states together than this is explored to one component: most of
    /// what its operand offers it does not, and every state of the whole would have to find that out again.
    std::size_t region_states = 100'000;
    /// A compression whose operand has more states, without those that confluent taus lead on from where the
    /// compression allows it, is left out: the process is run without it.
    std::size_t compressed_states = 2'000'000;
};

/// Keeps the components of one store's terms, so that equal ones are explored once.
class Compiler {
public:
    explicit Compiler(process::OperationalSemantics& semantics, const Bounds& bounds = {});

    /// The compiled process; null where it has no parallel operator to take apart, or only behind many events and few
    /// states in all, a component has too many states or
    /// cannot be explored on its own (an error of evaluation that the whole may never meet), or the rules are too many.
    /// `poll` is called now and then and may throw process::Interrupted, which passes.
    [[nodiscard]] std::unique_ptr<SupercombinatorSystem> compile(TermId term, const std::function<void()>& poll);
    /// What is being explored now, or was last; for progress and for the account of a limit.
    struct Stage {
        std::optional<TermId> component;
        std::size_t number = 0, of = 0;  ///< from 1
        std::size_t states = 0;          ///< of this component, so far
    };
    [[nodiscard]] const Stage& stage() const { return stage_; }
    /// A machine that is equal to the compiled process up to the equivalence: all of its states, or those alone that
    /// confluent taus leave (reduced_system.hpp). None where compile gives none. Throws process::TooManyStates.
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
/// semantics: connect them by `use`.
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
