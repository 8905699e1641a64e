// SPDX-License-Identifier: Apache-2.0
// Resolves conditions on the states and variables of a component: `in Operating::Held and retries > 1`.
#pragma once

#include <string>
#include <vector>

#include "claims/checks/conditions.hpp"

namespace robochart::claims {

/// Resolves the conditions of one claim, and adds the facts that they read to the claim.
class FactResolver {
public:
    FactResolver(const ir::System& system, CheckedClaim& claim, const diagnostics::SourceManager& sources,
                 diagnostics::Diagnostics& diagnostics)
        : system_(system),
          claim_(claim),
          sources_(sources),
          diagnostics_(diagnostics),
          conditions_(system, diagnostics) {}

    /// Returns a condition whose operands are facts. If a part of it reads variables of only one machine and no state,
    /// the whole part becomes one fact.
    [[nodiscard]] Condition resolve(const Expr& expr);
    /// Returns the index of the fact that a machine is in the state.
    [[nodiscard]] std::size_t fact_of_state(const Name& name);
    /// Returns the text at a place.
    [[nodiscard]] std::string written(Span span) const {
        return std::string(sources_.source_text(span.source).substr(span.begin, span.end - span.begin));
    }
    /// True if some machine of the component has a state with this name or path.
    [[nodiscard]] bool has_state(const std::string& name) const;

private:
    /// A variable or a constant of a machine of the component.
    struct Found {
        std::size_t part = 0;  ///< the machine
        Operand operand = Operand::variable;
        std::size_t index = 0;
        ir::TypeId type;
    };
    [[nodiscard]] const std::vector<MachinePart>& parts() const { return claim_.component.machines; }
    [[nodiscard]] const ir::Machine& machine(std::size_t part) const { return system_.machine(parts()[part].machine); }
    /// True if `prefix` names the machine. It may be the machine's path, the end of this path, or the name of its
    /// declaration.
    [[nodiscard]] bool names_machine(std::size_t part, const std::string& prefix) const;
    [[nodiscard]] std::vector<Found> find_variables(const std::string& name) const;
    [[nodiscard]] Found find_variable(const Expr& name) const;
    /// Collects the machines whose variables the expression reads. Sets `state` if the expression reads a state.
    void collect_machines(const Expr& expr, std::vector<std::size_t>& machines, bool& state) const;
    [[nodiscard]] Condition fact_of_variables(const Expr& expr, const std::vector<std::size_t>& machines);
    [[nodiscard]] std::size_t add(Fact fact);
    [[noreturn]] void report_unknown(const Name& name, bool state) const;
    [[noreturn]] void ask_whose(const Name& name, const std::vector<std::size_t>& parts) const;

    const ir::System& system_;
    CheckedClaim& claim_;
    const diagnostics::SourceManager& sources_;
    diagnostics::Diagnostics& diagnostics_;
    ConditionResolver conditions_;
};

}  // namespace robochart::claims
