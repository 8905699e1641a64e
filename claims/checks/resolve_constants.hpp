// SPDX-License-Identifier: Apache-2.0
// Resolves the constants that a claim sets: `with constant patience of Patrol set to 3 s`.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "base/durations/time_unit.hpp"
#include "claims/checks/checked.hpp"

namespace robochart::claims {

/// Resolves the constants of one claim. Each function throws ClaimError after it has reported an error.
class ConstantResolver {
public:
    /// `components`: all components of the system. `unit`: the declared time unit.
    ConstantResolver(const ir::System& system, const std::vector<Component>& components, durations::Unit unit,
                     diagnostics::Diagnostics& diagnostics)
        : system_(system), components_(components), unit_(unit), diagnostics_(diagnostics) {}

    /// Adds the setting to the claim. `of` is the component that it names. A setting that cannot affect the claim's
    /// component is an error.
    void add(const SetConstant& setting, const Component& of, CheckedClaim& claim) const;

private:
    [[nodiscard]] const ComponentConstant& find_constant(const Name& name, const Component& of) const;
    [[nodiscard]] ir::ExprPtr value_of(const SetConstant& setting, const ComponentConstant& constant,
                                       std::string& text) const;
    [[nodiscard]] std::string time_text(const SetConstant& setting, const ComponentConstant& constant) const;
    void require_effect(const SetConstant& setting, const ComponentConstant& constant, const Component& of,
                        const CheckedClaim& claim) const;
    [[noreturn]] void refuse(const diagnostics::Rule& rule, Span span, std::string text) const;

    const ir::System& system_;
    const std::vector<Component>& components_;
    durations::Unit unit_;
    diagnostics::Diagnostics& diagnostics_;
};

}  // namespace robochart::claims
