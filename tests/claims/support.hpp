// SPDX-License-Identifier: Apache-2.0
// Reads and checks claims about a small model for tests.
#pragma once

#include <memory>
#include <string>

#include "base/diagnostics/render.hpp"
#include "claims/checks/check.hpp"
#include "claims/syntax/reader.hpp"
#include "frontend/project/project.hpp"
#include "semantics/lower/lower.hpp"

namespace robochart::claims::testing {

/// A patrol robot with inputs obstacle, clear, arrived, estop and reset, and with operations goTo(nat), halt, reverse
/// and brake. It has an event `beep` in both directions, and an enumeration of colours.
inline const char* const patrol_model = R"(package small

enumeration Colour { red green }

interface Motion {
	goTo(waypoint : nat)
	show(colour : Colour, bright : boolean)
	halt()
	reverse()
	brake()
}

interface Sensors {
	event obstacle
	event clear
	event level : nat
	event beep
}

stm Patrol {
	const limit : nat = 3
	var retries : nat = 0
	var shade : Colour
	requires Motion
	uses Sensors
	initial i
	state Outer {
		initial k
		state Inner { }
		transition begin { from k to Inner }
	}
	transition out { from Held to Outer trigger level?retries }
	state Driving { entry goTo(1) }
	state Held { entry halt(); beep; show(Colour::red, true) }
	transition begin { from i to Driving }
	transition met { from Driving to Held trigger obstacle }
	transition rung { from Held to Held trigger beep }
	transition free { from Held to Driving trigger clear }
}
)";

/// Parsed claims with their findings.
struct Read {
    explicit Read(const std::string& text) {
        const auto model_source = sources.add("small.rct", patrol_model);
        const auto source = sources.add("small.claims", text);
        file = std::make_shared<const ClaimFile>(read(sources, source, diagnostics));
        if (!diagnostics.ok()) return;
        diagnostics::Diagnostics of_model;
        const auto model = frontend::load_texts(sources, {model_source}, of_model);
        system = ir::lower(*model, sources, of_model);
        if (of_model.ok()) checked = check_claims({file}, {system, {"small"}, {"Taken"}}, sources, diagnostics);
        model_ok = of_model.ok();
    }
    /// Returns codes with lines, in the order of the text: "CLM-P01:3 CLM-T02:7".
    [[nodiscard]] std::string findings() const {
        std::string text;
        for (const diagnostics::Diagnostic& finding : diagnostics.sorted_findings()) {
            if (!text.empty()) text += " ";
            text += finding.rule->code;
            text += ":" + std::to_string(sources.position(finding.span.source, finding.span.begin).line);
        }
        return text;
    }
    [[nodiscard]] std::string report() const { return diagnostics::render_text(sources, diagnostics); }

    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    std::shared_ptr<const ClaimFile> file;
    ir::System system;
    CheckedClaims checked;
    bool model_ok = true;
};

}  // namespace robochart::claims::testing
