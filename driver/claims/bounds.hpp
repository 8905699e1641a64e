// SPDX-License-Identifier: Apache-2.0
// Finds the bounds of the finite instantiation that runs reach. At a bound, a value is clipped, a value is chosen, or a
// value does not belong to its type.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "checker/cspm/syntax/observed_call.hpp"
#include "driver/model/pipeline.hpp"
#include "driver/results/results.hpp"
#include "driver/settings/search_context.hpp"
#include "semantics/instantiate/sequence_limits.hpp"

namespace robochart::driver {

/// Observes the evaluation of one script.
class BoundWatch {
public:
    /// All arguments must outlive the object.
    BoundWatch(const Project& project, const csp_emit::Emission& emission, const ir::Instantiation& instantiation);

    [[nodiscard]] cspm::CallObserver observer();
    /// Returns the bounds observed so far, once for each function and place.
    [[nodiscard]] const std::vector<Ground>& met_bounds() const { return met_; }

private:
    void note_call(const cspm::ObservedCall& call);
    void add(diagnostics::Span span, std::string text, std::string remedy);

    const Project& project_;
    const csp_emit::Emission& emission_;
    const ir::Instantiation& instantiation_;
    std::vector<ir::SequenceLimit> sequence_limits_;
    std::set<std::pair<std::string, std::uint64_t>> known_;
    std::vector<Ground> met_;
};

/// Finds the bounds that runs of a claim's processes reach. The search for an answer explores each component alone,
/// with all its inputs. So that search also observes bounds that no run of the whole process reaches. Therefore this
/// class explores the states of the whole process again, up to a limit.
class ReachedBounds {
public:
    /// All arguments must outlive the object.
    ReachedBounds(const Project& project, const csp_emit::Emission& emission, const ir::Instantiation& instantiation,
                  const SearchContext& search)
        : project_(project), emission_(emission), instantiation_(instantiation), search_(search) {}

    /// Returns the basis of one claim. `met` contains the bounds that the searches for this claim and other claims
    /// observed.
    [[nodiscard]] Basis basis_of_claim(const csp_emit::Obligation& claim, const std::vector<Ground>& met);
    /// Returns an entry for a condition of the claim's machines if the condition may have outcomes that do not occur
    /// with the values of the carriers. A carrier contains a value beyond each literal with which a value is compared,
    /// but no value beyond other values. For example, with carriers 0..2, the condition x > y /\ y > z /\ z > 0 is
    /// never true. A condition may also have other outcomes if it reads values that are computed or converted from
    /// inputs (semantics/data/derived_values.hpp). Times may also be inputs: with x in 0..2, a wait for x is always
    /// short. The result is empty if the user chose the carriers (--range).
    [[nodiscard]] Basis comparisons_in(const csp_emit::Obligation& claim);
    /// Returns the basis for one process.
    [[nodiscard]] Basis basis_of_process(const cspm::ExprPtr& process, const std::vector<Ground>& met);

private:
    struct Visited {
        std::vector<Ground> reached;
        bool all = true;  ///< true if every state was explored
    };
    const Visited& visit_process(const cspm::ExprPtr& process);
    [[nodiscard]] bool is_part(const std::string& element, const cspm::ExprPtr& process) const;
    [[nodiscard]] const std::vector<Ground>& comparisons();

    const Project& project_;
    const csp_emit::Emission& emission_;
    const ir::Instantiation& instantiation_;
    SearchContext search_;
    std::map<std::string, Visited> visited_;  // key: the text of the process
    std::optional<std::vector<Ground>> comparisons_;
};

}  // namespace robochart::driver
