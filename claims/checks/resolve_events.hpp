// SPDX-License-Identifier: Apache-2.0
// Resolves sets of events and their conditions for one component.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "claims/checks/conditions.hpp"
#include "claims/checks/resolve_facts.hpp"

namespace robochart::claims {

/// Resolves the events of one claim. Adds the channels whose last values the claim reads to its remembered channels.
class EventResolver {
public:
    EventResolver(const ir::System& system, CheckedClaim& claim, const diagnostics::SourceManager& sources,
                  diagnostics::Diagnostics& diagnostics)
        : system_(system),
          claim_(claim),
          sources_(sources),
          diagnostics_(diagnostics),
          conditions_(system, diagnostics),
          facts_(system, claim, sources, diagnostics) {}

    [[nodiscard]] Events resolve(const EventSet& events);

private:
    using Variables = std::map<std::string, std::size_t>;

    [[nodiscard]] EventMatch resolve_pattern(const Pattern& pattern);
    [[nodiscard]] EventMatch resolve_any(const Pattern& pattern);
    [[nodiscard]] std::size_t find_channel(const Name& name, Direction direction);
    [[noreturn]] void report_unknown(const Name& name);
    void add_arguments(const Pattern& pattern, const Channel& channel, Variables& variables,
                       std::vector<Condition>& conditions);
    [[nodiscard]] std::size_t remember(const Expr& expr);

    [[nodiscard]] Typed resolve_leaf(const Expr& expr, const Channel& channel, const Variables& variables);
    [[nodiscard]] Typed resolve_name(const Expr& expr, const Channel& channel, const Variables& variables);
    [[nodiscard]] ConditionResolver::Leaf leaf_of(const Channel& channel, const Variables& variables);
    [[nodiscard]] EventMatch resolve_change(const Pattern& pattern);
    [[nodiscard]] std::string written(Span span) const;

    const ir::System& system_;
    CheckedClaim& claim_;
    const diagnostics::SourceManager& sources_;
    diagnostics::Diagnostics& diagnostics_;
    ConditionResolver conditions_;
    FactResolver facts_;
};

}  // namespace robochart::claims
