// SPDX-License-Identifier: Apache-2.0
// Rules about the settings, and about the files that they name.
#pragma once

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::driver::rules {

extern const diagnostics::Rule bad_option;  ///< the value of a setting does not fit the model
extern const diagnostics::Rule left_out;    ///< an assertion file with errors was ignored, because only the model is
                                            ///< needed

}  // namespace robochart::driver::rules
