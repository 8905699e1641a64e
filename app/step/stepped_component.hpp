// SPDX-License-Identifier: Apache-2.0
// Prepares a component of a model for stepping.
#pragma once

#include <string>

#include "app/command/options.hpp"
#include "checker/cspm/session.hpp"
#include "counterexample/stepper.hpp"
#include "driver/model/pipeline.hpp"

namespace robochart::app {

/// The process of a component in one semantics, with all data that its stepper refers to. The project must outlive it.
class SteppedComponent {
public:
    /// `name` must be qualified. Throws UsageError if the component has no process, and the exceptions of
    /// cspm::Session.
    SteppedComponent(driver::Project& project, const std::string& name, csp_emit::Time time, const Options& options);
    SteppedComponent(const SteppedComponent&) = delete;
    SteppedComponent& operator=(const SteppedComponent&) = delete;

    [[nodiscard]] runs::Stepper& stepper() { return stepper_; }

private:
    const csp_emit::Emission& emission_;
    cspm::Session session_;
    runs::Context context_;
    runs::StepReader reader_;
    runs::Stepper stepper_;
};

}  // namespace robochart::app
