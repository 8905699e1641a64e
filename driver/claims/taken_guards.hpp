// SPDX-License-Identifier: Apache-2.0
// Conditions whose clock-reading parts the untimed semantics has taken as true; verdicts are based on them.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"
#include "driver/model/pipeline.hpp"
#include "driver/results/basis.hpp"

namespace robochart::driver {

/// The conditions of one untimed script.
class TakenGuards {
public:
    /// A timed script has no such conditions.
    TakenGuards(const Project&, const csp_emit::Emission&, csp_emit::Time);

    [[nodiscard]] bool has_guards() const { return !guards_.empty(); }
    /// Adds the conditions of the transitions in the run.
    void add_of_run(const runs::Run&, Basis&) const;
    /// Adds the conditions for an assertion without a run. Without time, a component has more behaviours, so a true
    /// assertion about traces depends only on the conditions of its specification.
    void add_of_assertion(const cspm::Decl&, bool holds, Basis&) const;

private:
    using Key = std::pair<diagnostics::SourceId, std::uint32_t>;  ///< the place of the transition
    struct Guard {
        Ground ground;
        std::string element;   ///< the transition, as in runs
        bool trigger = false;  ///< it has a trigger
    };
    void add_of(const std::vector<cspm::ExprPtr>&, Basis&) const;
    void add_of_event(const runs::Event&, Basis&) const;

    const csp_emit::Emission& emission_;
    std::map<Key, Guard> guards_;
    std::map<std::string, std::set<Key>> inside_;  ///< by the path of the component whose process contains the
                                                   ///< transition
    std::set<std::string> transitions_;            ///< all transitions
};

}  // namespace robochart::driver
