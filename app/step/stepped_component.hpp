// A component of a model made ready to be stepped through.
#pragma once

#include <string>

#include "app/command/pipeline.hpp"
#include "checker/cspm/session.hpp"
#include "runs/stepper.hpp"

namespace robochart::app {

/// The process of a component in one time with all that its stepper refers to. The project outlives it.
class SteppedComponent {
public:
    /// `name`: qualified. Throws UsageError where the component has no process of its own, and what cspm::Session
    /// throws.
    SteppedComponent(Project& project, const std::string& name, csp_emit::Time time, const Options& options);
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
