// SPDX-License-Identifier: Apache-2.0
#include "driver/settings/rules.hpp"

namespace robochart::driver::rules {

using diagnostics::Severity;

const diagnostics::Rule bad_option{
    "RC-A01", Severity::error, "{}",
    "The value given for an option of the command line does not fit: --const takes NAME=VALUE, "
    "--range takes TYPE=LOW..HIGH with LOW at most HIGH, for example --range nat=0..4; "
    "--component and --assertion name what the model has."};
const diagnostics::Rule left_out{
    "RC-A05", Severity::warning, "the assertions of this file are left out, for its errors",
    "Generated code, diagrams and simulations follow from the model alone, so errors in assertion files do not keep "
    "them back. `validate` and `check` report these errors; with --deny-warnings they count."};

}  // namespace robochart::driver::rules
