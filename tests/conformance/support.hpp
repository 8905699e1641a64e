// SPDX-License-Identifier: Apache-2.0
// Provides models that are written as graphs, and controllers that are written by hand, for the conformance tests.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "checker/lts/transition_system.hpp"
#include "conformance/code/interface.hpp"
#include "conformance/code/shared_object.hpp"

namespace robochart::conformance::test {

/// An edge of a model. "tau" is the invisible event, and "tick" is termination. State 0 is the initial state.
struct Edge {
    unsigned from;
    std::string event;
    unsigned to;
};

class GraphSystem : public lts::TransitionSystem {
public:
    GraphSystem(std::vector<Edge> edges, process::EventTable& events);
    [[nodiscard]] std::size_t width() const override { return 1; }
    void initial(std::span<lts::Word> state) override { state[0] = 0; }
    void successors(lts::StateView state, lts::SuccessorSink& sink) override;
    [[nodiscard]] const process::EventTable& events() const override { return *events_; }
    [[nodiscard]] std::string describe(lts::StateView state) const override;

private:
    struct Numbered {
        unsigned from;
        process::Event event;
        unsigned to;
    };
    std::vector<Numbered> edges_;
    process::EventTable* events_;
};

/// Returns the model of objects/turner.cpp, component "T". If `waits`, each operation takes one time unit.
[[nodiscard]] std::vector<Edge> turner_model(bool waits = true);
/// Returns the interface of turner.cpp. Its names have the component's prefix.
[[nodiscard]] Interface turner_interface();

/// Compiles objects/NAME.cpp with -DFAULT=fault.
[[nodiscard]] std::unique_ptr<SharedObject> hand_made(const std::string& name, int fault, std::string& error);

/// Compiles generated code as `conform` does, but without warnings, because a seeded fault may make variables unused.
[[nodiscard]] std::unique_ptr<SharedObject> compile_quietly(const cpp_emit::Emission& code, std::string& error);

}  // namespace robochart::conformance::test
