// SPDX-License-Identifier: Apache-2.0
// Rules about errors in a log of a run that are detected before the log is compared with the model (docs/traces.md).
// Also contains the rules about models that cannot be run in control cycles, or only by some robots
// (docs/conformance.md, "Why a model is not schedulable").
#pragma once

#include <span>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::conformance::rules {

extern const diagnostics::Rule log_syntax;    ///< RC-L01
extern const diagnostics::Rule log_name;      ///< RC-L02
extern const diagnostics::Rule log_value;     ///< RC-L03
extern const diagnostics::Rule log_of_other;  ///< RC-L04

extern const diagnostics::Rule endless_steps;        ///< RC-K01
extern const diagnostics::Rule endless_outputs;      ///< RC-K02
extern const diagnostics::Rule time_stops;           ///< RC-K03
extern const diagnostics::Rule output_in_mid_cycle;  ///< RC-K04
extern const diagnostics::Rule end_in_mid_cycle;     ///< RC-K05
extern const diagnostics::Rule input_in_mid_cycle;   ///< RC-K06
extern const diagnostics::Rule output_made_twice;    ///< RC-K07
extern const diagnostics::Rule input_not_in_time;    ///< RC-K08
extern const diagnostics::Rule event_missed;         ///< RC-K09
extern const diagnostics::Rule event_overtaken;      ///< RC-K10
extern const diagnostics::Rule precondition_false;   ///< RC-K11

/// Every rule, for `explain` and for the tests.
[[nodiscard]] std::span<const diagnostics::Rule* const> all();

}  // namespace robochart::conformance::rules
