// SPDX-License-Identifier: Apache-2.0
// Controls code that computes with tracked numbers (cpp_emit/runtime/tracked.hpp). Sets the values with which the code
// is explored, and reads which comparisons it has made (docs/conformance.md, "All values").
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "conformance/code/interface.hpp"
#include "cpp_emit/runtime/explore_abi.h"
#include "semantics/data/value_model.hpp"

namespace robochart::conformance {

/// The tracking interface of loaded code, with the types of the model.
class TrackedCode {
public:
    /// `types` are those of cpp_emit::tracked_types. The code must have `tracking` and outlive this object.
    TrackedCode(const rc_interface& code, const ir::System& system, std::vector<ir::TypeId> types)
        : code_(code), system_(system), types_(std::move(types)) {}

    /// Gives the code the values of the model. Returns false if the code has no capacity for them.
    [[nodiscard]] bool set_values(const ir::ValueModel& model) const;
    /// Returns the comparisons that the code has made since set_values, normalised and ascending. `scale` is the number
    /// of units in one real. Returns no value if a comparison reads both whole and real numbers, or a number that does
    /// not fit.
    [[nodiscard]] std::optional<std::vector<ir::Cut>> comparisons(std::int64_t scale) const;
    /// Returns the reason why the explored values do not represent all values; "" if the code only compared and copied
    /// its inputs.
    [[nodiscard]] std::string loss() const;
    /// Returns true if the code has computed a number inexactly. A difference may then be caused by this number.
    [[nodiscard]] bool is_inexact() const { return (code_.tracking->losses() & RC_TRACKED_INEXACT) != 0; }

private:
    const rc_interface& code_;
    const ir::System& system_;
    std::vector<ir::TypeId> types_;
};

/// Gives registers of tracked types the values of their carriers. The interface must be that of a value model.
void list_tracked_values(Interface& interface, const rc_interface& code);

}  // namespace robochart::conformance
