// SPDX-License-Identifier: Apache-2.0
// Animates a component, and owns the objects that this needs.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "checker/cspm/session.hpp"
#include "counterexample/stepper.hpp"
#include "tests/csp_emit/fixture.hpp"

namespace robochart::runs::testing {

struct Animation {
    Animation(std::unique_ptr<csp_emit::testing::Model> read, csp_emit::Time time, const std::string& path)
        : model(std::move(read)), emission(model->emit(time)), session(emission.script) {
        for (const csp_emit::ComponentProcesses& component : emission.components)
            if (component.path == path || path.empty()) process = component.process;
        stepper.emplace(reader, session.process(process));
    }

    std::unique_ptr<csp_emit::testing::Model> model;
    csp_emit::Emission emission;
    cspm::Session session;
    Context context{emission.provenance, model->system, model->instantiation, model->sources, session};
    StepReader reader{context};
    cspm::ExprPtr process;
    std::optional<Stepper> stepper;
};

}  // namespace robochart::runs::testing
