// SPDX-License-Identifier: Apache-2.0
// Extends the carrier of real for a log. Logged numbers outside the carrier are replaced by numbers of the carrier for
// which the model's comparisons with constants give the same answers (conformance/model/logged_value.hpp). If a few
// numbers are between each two constants, different logged numbers rarely get the same replacement.
#pragma once

#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// The instantiation with further reals between, below and above the constants with which the component compares reals.
/// The scale is finer, so that there are numbers between them. The instantiation itself if the component does not
/// compare reals with constants, or if the numbers would not fit.
[[nodiscard]] ir::Instantiation with_more_numbers(const ir::System&, const ir::Instantiation&, const ir::ComponentRef&);

}  // namespace robochart::conformance
