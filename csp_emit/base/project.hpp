// What every part of the emitter works with: the model, its finite instantiation, where to report.
#pragma once

#include <string>

#include "csp_emit/base/emission.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

struct Project {
    const ir::System& system;
    const ir::Instantiation& instantiation;
    Time time;
    const Options& options;
    diagnostics::SourceManager& sources;
    diagnostics::Diagnostics& diagnostics;

    [[nodiscard]] bool timed() const { return time == Time::timed; }
    /// Whether a CSP block is for this time.
    [[nodiscard]] bool applies(const ir::CspBlock& block) const { return timed() ? block.timed : block.untimed; }
    /// Whether a CSP block is there instead of the generated carriers, constants and functions (semantics 3.13).
    /// RoboTool's documents write `Instantiations`, some models `instantiations`.
    [[nodiscard]] bool replaces_instantiations(const ir::CspBlock& block) const {
        return (block.name == "Instantiations" || block.name == "instantiations") && applies(block);
    }
    /// Whether some block is.
    [[nodiscard]] bool instantiations_replaced() const;
    /// Reports RC-C01: the construct is named and refused.
    void refuse(const std::string& construct, diagnostics::Span span) const;
    /// How often the CSP blocks of this time name it: a qualified or plain name, or its end behind `::`.
    [[nodiscard]] std::size_t occurrences(const std::string& name) const;
    /// Whether they do.
    [[nodiscard]] bool mentions(const std::string& name) const;
    /// Whether a CSP block or an assertion of this time speaks of the component of this qualified CSPM name.
    [[nodiscard]] bool speaks_of(const std::string& path) const;
    /// The model's text at a place, blanks folded, at most 80 characters; "" if the place is unknown.
    [[nodiscard]] std::string text(diagnostics::Span span) const;
};

}  // namespace robochart::csp_emit
