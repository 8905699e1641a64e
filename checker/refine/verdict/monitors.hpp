// SPDX-License-Identifier: Apache-2.0
// Defines the monitors of the checks.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "checker/refine/search/monitor.hpp"
#include "checker/refine/verdict/normal_form.hpp"
#include "checker/refine/verdict/verdict.hpp"

namespace robochart::refine {

/// In F and FD, returns the fault of a state with this offer if the specification has these acceptances. Returns no
/// value if the state is unstable.
[[nodiscard]] std::optional<ViolationKind> refusal(const std::vector<process::EventSet>& acceptances,
                                                   const Offer& offer);

/// Checks specification [M= implementation. The monitor's nodes are the nodes of the specification's normal form.
class RefinementMonitor final : public Monitor {
public:
    RefinementMonitor(NormalForm& specification, Model model)
        : RefinementMonitor(specification, model, std::make_shared<std::mutex>()) {}
    Node start() override { return specification_.initial(); }
    Advance advance(Node node, process::Event event) override;
    std::optional<ViolationKind> examine(Node node, const Offer& offer) override;
    [[nodiscard]] bool includes(Node larger, Node smaller) const override {
        return specification_.includes(larger, smaller);
    }
    [[nodiscard]] std::unique_ptr<Monitor> clone_for_thread() override {
        return std::unique_ptr<Monitor>(new RefinementMonitor(specification_, model_, turn_));
    }

private:
    RefinementMonitor(NormalForm& specification, Model model, std::shared_ptr<std::mutex> turn)
        : specification_(specification), model_(model), turn_(std::move(turn)) {}
    const std::vector<process::EventSet>& acceptances(Node node);

    NormalForm& specification_;
    Model model_;
    std::shared_ptr<std::mutex> turn_;  // the owner of this lock may use `normal_`
    std::vector<const std::vector<process::EventSet>*> acceptances_;
};

/// Observes states and not runs. Two checks use this monitor: the check for deadlock (a state without transitions), and
/// the check for divergence alone.
class StateMonitor final : public Monitor {
public:
    explicit StateMonitor(bool forbid_deadlock) : forbid_deadlock_(forbid_deadlock) {}
    Node start() override { return 0; }
    Advance advance(Node node, process::Event /*event*/) override { return {Effect::follow, node}; }
    std::optional<ViolationKind> examine(Node node, const Offer& offer) override;
    [[nodiscard]] bool watches_states_only() const override { return true; }
    [[nodiscard]] std::unique_ptr<Monitor> clone_for_thread() override { return std::make_unique<StateMonitor>(*this); }

private:
    bool forbid_deadlock_;
};

/// Finds a state with a choice: a tau, two transitions with the same event, or termination and another event.
class ChoiceMonitor final : public Monitor {
public:
    Node start() override { return 0; }
    Advance advance(Node node, process::Event /*event*/) override { return {Effect::follow, node}; }
    std::optional<ViolationKind> examine(Node node, const Offer& offer) override;
    [[nodiscard]] std::unique_ptr<Monitor> clone_for_thread() override { return std::make_unique<ChoiceMonitor>(); }
};

/// Follows runs along a trace and finds a run with its first `goal` events. If `refused` is given, the run must end in
/// a state that can refuse this event.
class TraceMonitor final : public Monitor {
public:
    TraceMonitor(const std::vector<process::Event>& trace, std::size_t goal,
                 std::optional<process::Event> refused = std::nullopt)
        : trace_(trace), goal_(goal), refused_(refused) {}
    Node start() override { return 0; }
    Advance advance(Node node, process::Event event) override;
    std::optional<ViolationKind> examine(Node node, const Offer& offer) override;
    [[nodiscard]] std::size_t furthest_node() const { return furthest_; }

private:
    const std::vector<process::Event>& trace_;
    std::size_t goal_;
    std::optional<process::Event> refused_;
    std::size_t furthest_ = 0;
};

}  // namespace robochart::refine
