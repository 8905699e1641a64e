// SPDX-License-Identifier: Apache-2.0
#include "prism/emit/chart.hpp"

#include <algorithm>
#include <cassert>
#include <set>
#include <utility>

#include "prism/emit/rules.hpp"

namespace robochart::prism_emit {
namespace {

using ir::NodeKind;

class Normaliser {
public:
    Normaliser(Context& context, const ir::Machine& machine, std::string element)
        : context_(context), machine_(machine), element_(std::move(element)) {}

    Chart operator()() {
        for (const ir::Node& node : machine_.nodes) add(node);
        for (const ir::Transition& transition : machine_.transitions) add(transition);
        compose_chains();
        split_triggers();
        close_dead_ends();
        return std::move(chart_);
    }

private:
    void report_unsupported(const std::string& what, const std::string& where, diagnostics::Span span) {
        context_.diagnostics.report(rules::unsupported_construct, span, {what, element_ + "::" + where});
    }

    /// Flattens a statement. Statements that only reset clocks vanish (R15: "deadlines vanish, clocks are not
    /// emitted").
    void flatten_statement(const ir::StmtPtr& stmt, const std::string& where, std::vector<ir::StmtPtr>& result) {
        if (!stmt) return;
        switch (stmt->kind) {
            case ir::StmtKind::sequence:
            case ir::StmtKind::deadline:
                for (const ir::StmtPtr& child : stmt->body) flatten_statement(child, where, result);
                return;
            case ir::StmtKind::clock_reset:
                return;
            case ir::StmtKind::if_then_else:
                return report_unsupported("a conditional statement", where, stmt->origin.span);
            case ir::StmtKind::wait:
            case ir::StmtKind::wait_interval:
                return report_unsupported("`wait`", where, stmt->origin.span);
            case ir::StmtKind::skip:
            case ir::StmtKind::assign:
            case ir::StmtKind::communicate:
            case ir::StmtKind::call:
                result.push_back(stmt);
                return;
            case ir::StmtKind::exec:    // RoboSim, which is not encoded
            case ir::StmtKind::choose:  // only in models for the CSP checker
                assert(false);
                return;
        }
    }

    void add(const ir::Node& node) {
        Place place{node.kind, node.name, node.path, {}, {}, {}, node.is_composite()};
        if (node.parent.is_valid()) place.parent = node.parent.index;
        if (node.initial.is_valid()) place.initial = node.initial.index;
        flatten_statement(node.entry, node.path, place.entry);
        if (node.during) report_unsupported("a during action", node.path, node.origin.span);
        if (node.exit) report_unsupported("an exit action", node.path, node.origin.span);
        if (node.kind == NodeKind::final && machine_.kind == ir::MachineKind::state_machine && !place.parent)
            report_unsupported("a final state of a state machine", node.path, node.origin.span);
        if (place.composite && !place.initial) report_unsupported("no initial node", node.path, node.origin.span);
        chart_.places.push_back(std::move(place));
    }

    void add(const ir::Transition& transition) {
        Step step{transition.name,
                  transition.source.index,
                  transition.target.index,
                  nullptr,
                  {},
                  transition.probability,
                  {},
                  transition.origin.span};
        if (transition.trigger) step.trigger = &*transition.trigger;
        if (transition.guard) step.guards.push_back(transition.guard);
        flatten_statement(transition.action, transition.name, step.action);
        const Place& source = chart_.places[step.source];
        if (source.parent != chart_.places[step.target].parent)
            report_unsupported("a transition between levels", transition.name, step.span);
        if (step.trigger != nullptr && source.kind != NodeKind::state)
            report_unsupported("a trigger of a transition from a junction", transition.name, step.span);
        if (source.kind == NodeKind::probabilistic && transition.guard)
            report_unsupported("a condition beside a probability", transition.name, step.span);
        if (source.kind == NodeKind::initial && transition.guard)
            report_unsupported("a condition of an initial transition", transition.name, step.span);
        chart_.steps.push_back(std::move(step));
    }

    /// Composes chains. R7: "Chains through a junction after a trigger are composed." Removes the junctions that become
    /// unreachable.
    void compose_chains() {
        std::vector<Step> done;
        for (Step& step : chart_.steps)
            if (step.trigger != nullptr)
                follow_junctions(std::move(step), 0, done);
            else
                done.push_back(std::move(step));
        chart_.steps = std::move(done);
        drop_unreached_junctions();
    }

    void follow_junctions(Step step, unsigned depth, std::vector<Step>& done) {
        context_.diagnostics.poll();
        if (chart_.places[step.target].kind != NodeKind::junction) {
            done.push_back(std::move(step));
            return;
        }
        if (depth == 100 || done.size() > 10'000)
            return report_unsupported("a trigger that leads to too many paths through junctions", step.name, step.span);
        const std::size_t junction = step.target;
        for (const ir::TransitionId id : machine_.nodes[junction].outgoing) {
            const ir::Transition& next = machine_.transitions[id.index];
            if (next.guard && !step.action.empty())
                report_unsupported("a condition after an action", next.name, next.origin.span);
            Step longer = step;
            longer.name += "_" + next.name;
            longer.target = next.target.index;
            if (next.guard) longer.guards.push_back(next.guard);
            std::vector<ir::StmtPtr> action;
            flatten_statement(next.action, next.name, action);
            longer.action.insert(longer.action.end(), action.begin(), action.end());
            follow_junctions(std::move(longer), depth + 1, done);
        }
    }

    void drop_unreached_junctions() {
        for (bool again = true; again;) {
            std::set<std::size_t> reached;
            for (const Step& step : chart_.steps) reached.insert(step.target);
            const auto idle = [&](const Step& step) {
                return chart_.places[step.source].kind == NodeKind::junction && !reached.contains(step.source);
            };
            again = std::erase_if(chart_.steps, idle) > 0;
            for (std::size_t i = 0; i < chart_.places.size(); ++i)
                if (chart_.places[i].kind == NodeKind::junction) chart_.places[i].dropped = !reached.contains(i);
        }
    }

    /// Splits transitions. R7: "a transition with trigger and action is split at a fresh probabilistic junction: sp1_k
    /// (trigger, guard) to sp_pj_j, sp2_l (action) on."
    void split_triggers() {
        std::vector<Step> done;
        for (Step& step : chart_.steps) {
            if (step.trigger == nullptr || step.action.empty()) {
                done.push_back(std::move(step));
                continue;
            }
            const std::size_t junction = add_place(NodeKind::probabilistic, "sp_pj", chart_.places[step.source].parent);
            Step first = step;
            first.name = context_.added_name("sp1");
            first.target = junction;
            first.action.clear();
            Step second = std::move(step);
            second.name = context_.added_name("sp2");
            second.source = junction;
            second.trigger = nullptr;
            second.guards.clear();
            done.push_back(std::move(first));
            done.push_back(std::move(second));
        }
        chart_.steps = std::move(done);
    }

    /// Adds loops. R11: "a substate without outgoing transition gets to_loop_k to a fresh state loop_j with
    /// loop_self_i."
    void close_dead_ends() {
        std::set<std::size_t> left;
        for (const Step& step : chart_.steps) left.insert(step.source);
        const std::size_t count = chart_.places.size();
        for (std::size_t place = 0; place < count; ++place) {
            const Place& candidate = chart_.places[place];
            if (candidate.kind != NodeKind::state || !candidate.parent || candidate.composite || left.contains(place))
                continue;
            const std::size_t loop = add_place(NodeKind::state, "loop", candidate.parent);
            chart_.steps.push_back(plain_step(context_.added_name("loop_self"), loop, loop));
            chart_.steps.push_back(plain_step(context_.added_name("to_loop"), place, loop));
        }
    }

    static Step plain_step(std::string name, std::size_t source, std::size_t target) {
        Step step;
        step.name = std::move(name);
        step.source = source;
        step.target = target;
        return step;
    }

    std::size_t add_place(NodeKind kind, const std::string& stem, std::optional<std::size_t> parent) {
        Place place;
        place.kind = kind;
        place.name = context_.added_name(stem);
        place.path = parent ? chart_.places[*parent].path + "::" + place.name : place.name;
        place.parent = parent;
        chart_.places.push_back(std::move(place));
        return chart_.places.size() - 1;
    }

    Context& context_;
    const ir::Machine& machine_;
    std::string element_;
    Chart chart_;
};

}  // namespace

Chart normal_form(Context& context, const ir::Machine& machine, const std::string& element) {
    return Normaliser(context, machine, element)();
}

}  // namespace robochart::prism_emit
