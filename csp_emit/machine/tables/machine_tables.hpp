// SPDX-License-Identifier: Apache-2.0
// Contains all data about a machine during its emission. Each table owns its data and refers only to tables before it.
// The rules (../rules) read all of them and add entries on first use.
#pragma once

#include "csp_emit/machine/tables/activation_records.hpp"
#include "csp_emit/machine/tables/call_graph.hpp"
#include "csp_emit/machine/tables/call_sharing.hpp"
#include "csp_emit/machine/tables/clock_initialisation.hpp"
#include "csp_emit/machine/tables/clock_limits.hpp"
#include "csp_emit/machine/tables/default_values.hpp"
#include "csp_emit/machine/tables/hidden_events.hpp"
#include "csp_emit/machine/tables/machine_context.hpp"
#include "csp_emit/machine/tables/parameters.hpp"
#include "csp_emit/machine/tables/point_table.hpp"

namespace robochart::csp_emit {

struct MachineTables {
    MachineTables(MachineContext of, Provenance& meanings) : context(std::move(of)), provenance(meanings) {}
    MachineTables(const MachineTables&) = delete;  // the tables refer to each other
    MachineTables& operator=(const MachineTables&) = delete;

    [[nodiscard]] const ir::Machine& machine() const { return *context.machine; }
    [[nodiscard]] const Project& project() const { return *context.project; }
    [[nodiscard]] bool timed() const { return project().is_timed(); }
    /// Records the meaning of an event of the machine.
    void record_meaning(const std::string& event, EventMeaning meaning) {
        csp_emit::mean(provenance, context.path, event, std::move(meaning));
    }

    MachineContext context;
    Provenance& provenance;
    FamilyCalls family_calls;  ///< the calls between the points
    CallGraph calls{context};
    ParameterTable cells{context.names};
    DefaultValues defaults{project()};
    ClockLimits limits{project(), calls, context.names};
    ActivationRecords frames{context, calls, cells, limits};
    HiddenEvents events{context, frames, cells, provenance};
    ClockWatch watch{context, frames, cells, provenance};
    PointTable points{context, frames};
    CallSharing sharing{cells, points, family_calls};
};

}  // namespace robochart::csp_emit
