// SPDX-License-Identifier: Apache-2.0
// Defines the data that the whole emitter uses: the model, its finite instantiation, the diagnostics.
#pragma once

#include <string>

#include "csp_emit/base/emission.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::csp_emit {

struct Project {
    const ir::System& system;
    const ir::Instantiation& instantiation;
    Time time;
    const Options& options;
    diagnostics::SourceManager& sources;
    diagnostics::Diagnostics& diagnostics;

    [[nodiscard]] bool is_timed() const { return time == Time::timed; }
    /// True if a CSP block applies to this semantics (untimed or timed).
    [[nodiscard]] bool block_applies(const ir::CspBlock& block) const {
        return is_timed() ? block.timed : block.untimed;
    }
    /// Returns true if a CSP block replaces the generated carriers, constants and functions (semantics 3.13).
    /// RoboTool's documents call such a block `Instantiations`; some models call it `instantiations`.
    [[nodiscard]] bool replaces_instantiations(const ir::CspBlock& block) const {
        return ir::is_instantiations(block) && block_applies(block);
    }
    /// True if some CSP block replaces the generated instantiations.
    [[nodiscard]] bool instantiations_replaced() const;
    /// Reports RC-C01 and names the unsupported construct.
    void report_unsupported(const std::string& construct, diagnostics::Span span) const;
    /// Returns how often the applicable CSP blocks mention the name as a whole: alone, or as a part of a longer
    /// qualified name such as `NAME::x` or `x::NAME`.
    [[nodiscard]] std::size_t count_in_blocks(const std::string& name) const;
    /// True if the applicable CSP blocks mention the name.
    [[nodiscard]] bool blocks_mention(const std::string& name) const;
    /// True if an applicable CSP block or assertion mentions the component with this qualified CSPM name.
    [[nodiscard]] bool mentions_component(const std::string& path) const;
    /// Returns the text of the model at a place, or "" if the place is unknown. Replaces each sequence of blanks by one
    /// blank, and cuts the text at 80 characters.
    [[nodiscard]] std::string model_text(diagnostics::Span span) const;
};

}  // namespace robochart::csp_emit
