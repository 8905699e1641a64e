// SPDX-License-Identifier: Apache-2.0
// Explores the processes of a decided claim again, to find entries of the claim's basis that the search for a violation
// misses. Skips large processes.
#pragma once

#include <map>
#include <set>
#include <string>

#include "checker/cspm/session.hpp"
#include "driver/model/pipeline.hpp"
#include "driver/results/results.hpp"
#include "driver/settings/search_context.hpp"

namespace robochart::driver {

/// Processes with more states than this are skipped.
inline constexpr std::size_t most_states_for_second_look = 50'000;

/// Explores the processes of one script.
class SecondLook {
public:
    SecondLook(const Project&, const csp_emit::Emission&, cspm::Session&, const SearchContext&);

    /// Adds entries to the basis of a claim that holds or fails.
    void add_to(const csp_emit::Obligation&, AssertionReport&);

private:
    /// The facts found by exploring all states of a process.
    struct Seen {
        bool whole = false;        ///< all states were explored; otherwise nothing else is known
        bool ends = false;         ///< the process can terminate
        bool diverges = false;     ///< the process has an infinite sequence of internal steps
        bool time_passes = false;  ///< time passes in some run
        bool time_stops = false;   ///< time stops in a stable state
        std::set<std::string> events;
    };

    const Seen& seen_of(const cspm::ExprPtr&);
    Seen find_seen(const cspm::ExprPtr&);
    [[nodiscard]] cspm::ExprPtr with_outputs_taken(const cspm::ExprPtr&) const;
    [[nodiscard]] bool runs_in_cycles(const cspm::ExprPtr&) const;
    [[nodiscard]] cspm::ExprPtr subject_of(const csp_emit::Obligation&, const std::string& variant) const;
    [[nodiscard]] std::string name_of_specification(const csp_emit::Obligation&, std::size_t place) const;
    void add_of_refinement(const csp_emit::Obligation&, std::size_t place, AssertionReport&);
    void add_no_time(const cspm::Assertion&, const std::string& specification, AssertionReport&);
    void note_unreached_events(const cspm::Assertion&, AssertionReport&);
    void add_of_deadlock(const csp_emit::Obligation&, AssertionReport&);
    void add_of_missed_event(const csp_emit::Obligation&, AssertionReport&);
    void add_time_stops(const cspm::ExprPtr&, AssertionReport&);

    const Project& project_;
    const csp_emit::Emission& emission_;
    cspm::Session& session_;
    SearchContext search_;
    std::map<std::string, Seen> seen_;  ///< key: the text of the process
};

}  // namespace robochart::driver
