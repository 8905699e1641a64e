// SPDX-License-Identifier: Apache-2.0
// The basis of answers to probabilistic assertions: bounds of the finite instantiation for each set of constants,
// constants that nothing gives a value, and random paths.
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
    /// Project, emission, instantiation and session must outlive the object. The object must outlive each evaluation in
    /// the session.
    WatchedProcess(const Project&, const SearchContext&, const csp_emit::Emission&, const ir::Instantiation&,
                   cspm::Session&);

    /// The bounds that runs of the component reach. If a limit ends the visit of its states: all bounds that its parts
    /// met, with the remark that it is not known whether a run reaches them.
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

/// The basis of an assertion, from its rows. An entry that some rows do not have names the constants of those that have
/// it.
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

/// The constants of a component that have a chosen value, because neither the model, nor the assertion, nor an option
/// gives them one. `component`: the path of the component; the row names the constants that the assertion sets.
[[nodiscard]] Basis chosen_constants(const Project&, const ir::Instantiation&, const std::string& component,
                                     const probability::Row&);

/// How random paths were made; empty if all states were explored.
[[nodiscard]] Basis sampling_basis(const probability::Row&, std::uint64_t seed);

}  // namespace robochart::driver
