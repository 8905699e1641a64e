// SPDX-License-Identifier: Apache-2.0
// Finds conditions that read clocks. The untimed semantics assumes that the parts of a condition which read clocks are
// true. So conditions that read clocks belong to the basis of verdicts.
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

/// The conditions that read clocks, and their transitions, in one untimed script.
class TakenGuards {
public:
    /// For a timed script, the object has no conditions.
    TakenGuards(const Project&, const csp_emit::Emission&, csp_emit::Time);

    [[nodiscard]] bool has_guards() const { return !guards_.empty(); }
    /// Adds the conditions of the transitions in the run.
    void add_of_run(const runs::Run&, Basis&) const;
    /// Adds the conditions for an assertion without a run. Because of the assumption about clocks, a component has more
    /// behaviours in the untimed semantics. So if an assertion about traces holds, its basis contains only the
    /// conditions of the specification.
    void add_of_assertion(const cspm::Decl&, bool holds, Basis&) const;

private:
    using Key = std::pair<diagnostics::SourceId, std::uint32_t>;  ///< the place of the transition
    struct Guard {
        Ground ground;
        std::string element;   ///< name of the transition, as in runs
        bool trigger = false;  ///< true if the transition has a trigger
    };
    void add_of(const std::vector<cspm::ExprPtr>&, Basis&) const;
    void add_of_event(const runs::Event&, Basis&) const;

    const csp_emit::Emission& emission_;
    std::map<Key, Guard> guards_;
    std::map<std::string, std::set<Key>> inside_;  ///< key: the path of the component whose process contains the
                                                   ///< transition
    std::set<std::string> transitions_;            ///< all transitions
};

}  // namespace robochart::driver
