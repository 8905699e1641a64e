// SPDX-License-Identifier: Apache-2.0
// The IR as text.
#pragma once

#include <string>

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// The IR as text, for `--print ir`: stable, one declaration a line, programs indented.
[[nodiscard]] std::string dump_text(const System&);
/// One expression on one line, fully bracketed, with the names of the machine (may be null).
[[nodiscard]] std::string dump_text(const System&, const Machine*, const Expr&);

}  // namespace robochart::ir
