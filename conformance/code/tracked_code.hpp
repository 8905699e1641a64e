// SPDX-License-Identifier: Apache-2.0
// Code whose numbers know how they were made (cpp_emit/runtime/tracked.hpp): which values it is explored with, and what
// it compares (docs/conformance.md, "All values").
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "conformance/code/interface.hpp"
#include "cpp_emit/runtime/explore_abi.h"
#include "semantics/data/value_model.hpp"

namespace robochart::conformance {

class TrackedCode {
public:
    /// `types` are those of cpp_emit::tracked_types. The code must have `tracking` and outlive this object.
    TrackedCode(const rc_interface& code, const ir::System& system, std::vector<ir::TypeId> types)
        : code_(code), system_(system), types_(std::move(types)) {}

    /// Gives the code the values of the model. False if it has no place for them.
    [[nodiscard]] bool set_values(const ir::ValueModel& model) const;
    /// The comparisons that the code has made since, normalized and ascending.
    [[nodiscard]] std::vector<ir::Cut> comparisons(std::int64_t scale) const;
    /// The reason why the explored values do not stand for all: the code did more than to compare and copy its inputs.
    /// "": there is none.
    [[nodiscard]] std::string loss() const;
    /// True if numbers are wrong since some computation, so that a difference need not be one.
    [[nodiscard]] bool is_inexact() const { return (code_.tracking->losses() & RC_TRACKED_INEXACT) != 0; }

private:
    const rc_interface& code_;
    const ir::System& system_;
    std::vector<ir::TypeId> types_;
};

/// Gives registers of tracked types the values of their carriers. The interface is that of a value model.
void list_tracked_values(Interface& interface, const rc_interface& code);

}  // namespace robochart::conformance
