// SPDX-License-Identifier: Apache-2.0
#include "driver/settings/rules.hpp"

namespace robochart::driver::rules {

using diagnostics::Severity;

const diagnostics::Rule bad_option{
    "RC-A01", Severity::error, "{}",
    "The value of a command-line option is wrong. --const takes NAME=VALUE. --range takes TYPE=LOW..HIGH, where LOW is "
    "at most HIGH, for example --range nat=0..4. --component and --assertion take names from the model."};
const diagnostics::Rule left_out{
    "RC-A05", Severity::warning, "the assertions of this file are ignored, because the file has errors",
    "Generated code, diagrams and simulations depend only on the model, so errors in assertion files do not prevent "
    "them. `validate` and `check` report these errors. With --deny-warnings, the run fails."};

}  // namespace robochart::driver::rules
