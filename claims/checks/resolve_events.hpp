// SPDX-License-Identifier: Apache-2.0
// Resolves sets of events and their conditions for one component.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "claims/checks/checked.hpp"

namespace robochart::claims {

/// Thrown after a finding about the claim.
struct ClaimError {};

/// Resolves the events of one claim; adds to its remembered channels.
class EventResolver {
public:
    EventResolver(const ir::System& system, CheckedClaim& claim, const diagnostics::SourceManager& sources,
                  diagnostics::Diagnostics& diagnostics)
        : system_(system), claim_(claim), sources_(sources), diagnostics_(diagnostics) {}

    [[nodiscard]] Events resolve(const EventSet& events);

private:
    /// The type of a part of a condition. `type` is valid for literals.
    enum class Sort : std::uint8_t { number, truth, literal };
    struct Typed {
        Condition condition;
        Sort sort = Sort::number;
        ir::TypeId type;
    };
    using Variables = std::map<std::string, std::size_t>;

    [[nodiscard]] EventMatch resolve_pattern(const Pattern& pattern);
    [[nodiscard]] EventMatch resolve_any(const Pattern& pattern);
    [[nodiscard]] std::size_t find_channel(const Name& name, Direction direction);
    [[noreturn]] void report_unknown(const Name& name);
    void add_arguments(const Pattern& pattern, const Channel& channel, Variables& variables,
                       std::vector<Condition>& conditions);
    [[nodiscard]] std::size_t remember(const Expr& expr);

    [[nodiscard]] Typed resolve_expr(const Expr& expr, const Channel& channel, const Variables& variables);
    [[nodiscard]] Typed resolve_operator(const Expr& expr, const Channel& channel, const Variables& variables);
    [[nodiscard]] Typed resolve_name(const Expr& expr, const Channel& channel, const Variables& variables);
    [[nodiscard]] std::optional<Typed> find_literal(const std::string& text) const;
    [[nodiscard]] Typed typed_operand(Condition condition, ir::TypeId type, Span span);
    [[noreturn]] void refuse(Span span, std::string text);
    [[nodiscard]] std::string written(Span span) const;

    const ir::System& system_;
    CheckedClaim& claim_;
    const diagnostics::SourceManager& sources_;
    diagnostics::Diagnostics& diagnostics_;
};

}  // namespace robochart::claims
