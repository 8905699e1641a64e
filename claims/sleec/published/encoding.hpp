// SPDX-License-Identifier: Apache-2.0
// Encodes rules in SLEEC-TK's semantics, as processes of tock-CSP (arXiv 2307.03697; docs/rules-language.md, "The
// semantics of SLEEC-TK"). The encoding includes the faults of this semantics: an active rule refuses its trigger, `>=`
// on a scale is `>`, defeaters inside defeaters are dropped, and the measures are constant during the search for
// conflicts.
#pragma once

#include <string>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"
#include "claims/sleec/obligations/samples.hpp"

namespace robochart::sleec {

/// Prefixes and suffixes of names in the script.
struct EncodingNames {
    std::string prefix = "e_";  ///< the prefix of names of events and measures
    std::string suffix;         ///< the suffix of names of processes
};

/// Encodes rules as a script. Throws NotDecided for constructs that SLEEC-TK rejects.
class Encoding {
public:
    explicit Encoding(const CheckedRules& rules, EncodingNames names = {});

    /// Returns the channels of events, measures and time.
    [[nodiscard]] std::vector<cspm::DeclPtr> channel_declarations() const;
    /// Returns the timing operators, and the process of each of these rules.
    [[nodiscard]] std::vector<cspm::DeclPtr> process_declarations(const std::vector<std::size_t>& rule_numbers) const;
    /// Returns the name of a rule's process, in which events have priority over time.
    [[nodiscard]] std::string process_name(std::size_t rule) const;

    /// True if two rules have a name in common. SLEEC-TK compares only such rules.
    [[nodiscard]] bool are_related(std::size_t first, std::size_t second) const;
    /// Returns the declarations for a pair, with four assertions in this order: there is no missed deadline; there is
    /// no state in which only time passes; the second rule makes the first redundant; the first makes the second
    /// redundant.
    [[nodiscard]] std::vector<cspm::DeclPtr> pair_declarations(std::size_t first, std::size_t second) const;
    /// Returns the whole script for these pairs.
    [[nodiscard]] cspm::Script make_script(const std::vector<std::pair<std::size_t, std::size_t>>& pairs) const;

    /// Returns the values of a measure: truth values, indices, or the constants with which it is compared and their
    /// neighbours.
    [[nodiscard]] const std::vector<std::int64_t>& measure_values(std::size_t measure) const {
        return values_[measure];
    }

private:
    /// Throws NotDecided if the rule has an extension that SLEEC-TK does not have.
    void require_published(std::size_t rule) const;
    [[nodiscard]] std::string event_name(std::size_t event) const;
    [[nodiscard]] std::string measure_name(std::size_t measure) const;
    [[nodiscard]] std::string name(const std::string& text) const { return text + names_.suffix; }

    [[nodiscard]] cspm::ExprPtr condition_expression(const Condition& condition) const;
    [[nodiscard]] bool on_scale(const Condition& condition) const;
    [[nodiscard]] cspm::ExprPtr read_measures(const std::vector<const Condition*>& conditions,
                                              cspm::ExprPtr then) const;
    [[nodiscard]] cspm::ExprPtr trigger_process(const CheckedRule& rule, const std::string& self) const;
    [[nodiscard]] cspm::ExprPtr monitoring_process(const CheckedRule& rule) const;
    [[nodiscard]] cspm::ExprPtr response_process(const DutyPtr& duty) const;

    [[nodiscard]] std::vector<std::size_t> events_of(std::size_t rule) const;
    [[nodiscard]] std::vector<std::size_t> measures_of_pair(std::size_t first, std::size_t second) const;
    [[nodiscard]] cspm::ExprPtr measure_events(const std::vector<std::size_t>& measures) const;
    [[nodiscard]] cspm::ExprPtr event_set(const std::vector<std::size_t>& events) const;
    [[nodiscard]] std::vector<cspm::DeclPtr> conflict_declarations(std::size_t first, std::size_t second) const;
    [[nodiscard]] std::vector<cspm::DeclPtr> memory_declarations(std::size_t first, std::size_t second,
                                                                 const std::string& called) const;
    [[nodiscard]] cspm::DeclPtr with_memory(std::size_t rule, std::size_t other, const std::string& memory,
                                            const std::string& called) const;

    const CheckedRules& rules_;
    EncodingNames names_;
    std::vector<std::vector<std::int64_t>> values_;
};

}  // namespace robochart::sleec
