// Names of the script in the words of the model: events, and the definitions that a process is in.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "csp_emit/emit.hpp"
#include "diagnostics/source.hpp"
#include "runs/run.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::runs {

/// A definition with its arguments, as the checker describes a process: "P::S::A__(0,1)". In front of an internal
/// choice between several it is what they have in common.
struct Call {
    std::shared_ptr<const csp_emit::DefinitionMeaning> definition;
    std::vector<std::string> arguments;
};

class Meanings {
public:
    Meanings(const csp_emit::Provenance& provenance, const ir::System& system, const ir::Instantiation& instantiation,
             const diagnostics::SourceManager& sources)
        : provenance_(provenance), system_(system), instantiation_(instantiation), sources_(sources) {}

    /// Whether the provenance knows the event.
    [[nodiscard]] bool knows(const std::string& name) const;
    /// Whether it is between a machine and the process that holds one of its variables.
    [[nodiscard]] bool is_memory(const std::string& name) const;
    /// The event by its whole name; one that is not known keeps it, as Kind::event.
    [[nodiscard]] Event event(const std::string& name) const;
    /// The same, done where the process is in this definition: which transition or statement does it, if one alone can.
    [[nodiscard]] Event event(const std::string& name, const Call& before, const std::vector<Call>& after) const;
    /// The elements, transitions and statements, one of which makes the event happen there; more than one where the
    /// definitions do not tell.
    [[nodiscard]] std::vector<std::string> elements(const std::string& name, const Call& before,
                                                    const std::vector<Call>& after) const;
    /// The known definitions in a process's description.
    [[nodiscard]] std::vector<Call> calls(const std::string& description) const;
    /// The machine that is in this definition.
    [[nodiscard]] Machine machine(const Call&) const;
    [[nodiscard]] std::vector<Variable> variables(const Call&) const;
    [[nodiscard]] std::optional<Place> place(diagnostics::Span) const;

private:
    [[nodiscard]] const csp_emit::EventMeaning* meaning(const std::string& name, std::string& arguments) const;
    [[nodiscard]] std::optional<Call> call(std::string_view text) const;
    using Offers = std::vector<const csp_emit::OfferMeaning*>;
    /// The transitions and statements there that may be behind the event.
    [[nodiscard]] static Offers possible(const std::string& name, const Call& before, const std::vector<Call>& after);

    const csp_emit::Provenance& provenance_;
    const ir::System& system_;
    const ir::Instantiation& instantiation_;
    const diagnostics::SourceManager& sources_;
};

}  // namespace robochart::runs
