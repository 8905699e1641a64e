// SPDX-License-Identifier: Apache-2.0
// Collects the basis of answers to probabilistic assertions. The basis consists of the reached bounds of the finite
// instantiation for each set of constants, the constants with a chosen value, and the random paths.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "checker/cspm/session.hpp"
#include "csp_emit/base/emission.hpp"
#include "driver/claims/bounds.hpp"
#include "driver/model/pipeline.hpp"
#include "driver/results/basis.hpp"
#include "driver/settings/search_context.hpp"
#include "prism/assertions/experiments/experiment.hpp"
#include "semantics/ir/instantiation.hpp"

namespace robochart::driver {

/// Observes the exploration of one component's process.
class WatchedProcess {
public:
    /// All arguments must outlive the object, and the object must outlive every evaluation in the session.
    WatchedProcess(const Project&, const SearchContext&, const csp_emit::Emission&, const ir::Instantiation&,
                   cspm::Session&);

    /// Returns the bounds that runs of the component reach. If a limit ends the exploration of the component's states,
    /// returns all bounds that parts of the component reach, with a remark that runs of the whole component may not
    /// reach these bounds.
    [[nodiscard]] const Basis& reached_bounds(const std::string& component);
    [[nodiscard]] const ir::Instantiation& instantiation() const { return instantiation_; }

private:
    [[nodiscard]] Basis find_bounds(const std::string& component);

    const csp_emit::Emission& emission_;
    const ir::Instantiation& instantiation_;
    BoundWatch watch_;
    ReachedBounds reached_;
    std::optional<Basis> bounds_;
};

/// Combines the bases of the rows into the basis of an assertion. If only some rows have an entry, the entry names the
/// constants of these rows.
class RowBasis {
public:
    void add_row(const probability::Row& row, const Basis& basis);
    [[nodiscard]] Basis basis() const;

private:
    struct Entry {
        Ground ground;
        std::vector<std::string> rows;  ///< the constants of each row
    };
    std::vector<Entry> entries_;
    std::size_t rows_ = 0;
};

/// Returns entries for the constants of a component whose value was chosen, because neither the model, nor the
/// assertion, nor an option sets it. `component` is the path of the component. The row contains the constants that the
/// assertion sets.
[[nodiscard]] Basis chosen_constants(const Project&, const ir::Instantiation&, const std::string& component,
                                     const probability::Row&);

/// Returns an entry that describes the random paths. Returns an empty basis if all states were explored.
[[nodiscard]] Basis sampling_basis(const probability::Row&, std::uint64_t seed);

}  // namespace robochart::driver
