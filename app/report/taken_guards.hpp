// Conditions that the untimed semantics has taken for true as far as they read clocks, for the verdicts that rest on
// them.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/command/pipeline.hpp"
#include "app/report/basis.hpp"
#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::app {

/// Knows the conditions of one untimed script.
class TakenGuards {
public:
    /// Of a timed script there are none.
    TakenGuards(const Project&, const csp_emit::Emission&, csp_emit::Time);

    [[nodiscard]] bool any() const { return !guards_.empty(); }
    /// Of the transitions in the run.
    void add_of_run(const runs::Run&, Basis&) const;
    /// Of an assertion without a run. Without time a component does more, so an assertion about traces that is true
    /// rests on the conditions of its specification alone.
    void add_of_assertion(const cspm::Decl&, bool holds, Basis&) const;

private:
    using Key = std::pair<diagnostics::SourceId, std::uint32_t>;  ///< where the transition stands
    struct Guard {
        Ground ground;
        std::string element;   ///< of the transition, as runs have it
        bool trigger = false;  ///< it has one
    };
    void add_of(const std::vector<cspm::ExprPtr>&, Basis&) const;
    void add_of_event(const runs::Event&, Basis&) const;

    const csp_emit::Emission& emission_;
    std::map<Key, Guard> guards_;
    std::map<std::string, std::set<Key>> inside_;  ///< by the path of the component whose process has the transition
    std::set<std::string> transitions_;            ///< all elements that are transitions
};

}  // namespace robochart::app
