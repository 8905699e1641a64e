// SPDX-License-Identifier: Apache-2.0
// Translates names of the script to terms of the model. It translates names of events, and names of the definitions
// that a process currently executes.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/source.hpp"
#include "counterexample/run.hpp"
#include "csp_emit/emit.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::runs {

/// A definition with its arguments, from the checker's description of a process: "P::S::A__(0,1)". Before an internal
/// choice between several definitions, it contains what these definitions have in common.
struct Call {
    std::shared_ptr<const csp_emit::DefinitionMeaning> definition;
    std::vector<std::string> arguments;
};

class Meanings {
public:
    Meanings(const csp_emit::Provenance& provenance, const ir::System& system, const ir::Instantiation& instantiation,
             const diagnostics::SourceManager& sources)
        : provenance_(provenance), system_(system), instantiation_(instantiation), sources_(sources) {}

    /// Returns true if the provenance contains the event.
    [[nodiscard]] bool knows_event(const std::string& name) const;
    /// Returns true if the event connects a machine with the process that stores one of its variables.
    [[nodiscard]] bool is_memory(const std::string& name) const;
    /// Returns the event with this full name. An unknown event keeps its name and has Kind::event.
    [[nodiscard]] Event event_of(const std::string& name) const;
    /// Returns the event as it is performed in the definition `before`. The transition or statement that causes it is
    /// added if only one is possible.
    [[nodiscard]] Event event_of(const std::string& name, const Call& before, const std::vector<Call>& after) const;
    /// Returns the transitions and statements that may cause the event. There are several if the definitions do not
    /// determine the cause.
    [[nodiscard]] std::vector<std::string> elements_of(const std::string& name, const Call& before,
                                                       const std::vector<Call>& after) const;
    /// Returns the known definitions in the description of a process.
    [[nodiscard]] std::vector<Call> calls_in(const std::string& description) const;
    /// Returns the machine to which this definition belongs.
    [[nodiscard]] Machine machine_of(const Call&) const;
    [[nodiscard]] std::vector<Variable> variables_of(const Call&) const;
    [[nodiscard]] std::optional<Place> place_of(diagnostics::Span) const;

private:
    [[nodiscard]] const csp_emit::EventMeaning* meaning_of(const std::string& name, std::string& arguments) const;
    [[nodiscard]] std::optional<Call> call_of(std::string_view text) const;
    using Offers = std::vector<const csp_emit::OfferMeaning*>;
    /// Returns the transitions and statements that may cause the event.
    [[nodiscard]] static Offers possible_offers(const std::string& name, const Call& before,
                                                const std::vector<Call>& after);

    const csp_emit::Provenance& provenance_;
    const ir::System& system_;
    const ir::Instantiation& instantiation_;
    const diagnostics::SourceManager& sources_;
};

}  // namespace robochart::runs
