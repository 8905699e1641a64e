// Nodes and transitions of random models: every node is reached and left as the rules ask. See behaviour.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "random_models/behaviour.hpp"

namespace robochart::random_models {

std::string Behaviour::trigger() {
    std::vector<Port> inputs;
    for (const Port& port : around_.ports)
        if (port.receives || port.both_ways) inputs.push_back(port);
    if (inputs.empty()) return {};
    const Port port = random_.pick(inputs);
    const std::string accepted = filter(port, "from");
    if (port.type == nullptr) return port.name + accepted;
    const std::string variable = stored(port);
    return variable.empty() ? "" : port.name + accepted + "?" + variable;
}

/// A condition over variables, clocks and states of the container (TE4, TE5).
std::string Behaviour::condition(const Nodes& nodes) {
    const std::vector<std::string> orders = {"<", "<=", ">", ">=", "=="};
    if (!shape_.time || random_.chance(60)) return expressions_.of(*types_.boolean());
    const std::string order = random_.pick(orders);
    if (!around_.clocks.empty() && random_.chance(70)) {
        const std::string clock = random_.pick(around_.clocks);
        return fmt::format("since({}) {} {}", clock, order, expressions_.number());
    }
    const bool qualified = shape_.qualified_names && !inside_.empty() && random_.chance(40);
    const std::string state = (qualified ? inside_ + "::" : "") + random_.pick(nodes.states);
    return fmt::format("sinceEntry({}) {} {}", state, order, expressions_.number());
}

std::string Behaviour::target(const Nodes& nodes) {
    if (!nodes.finals.empty() && random_.chance(15)) return random_.pick(nodes.finals);
    return random_.pick(nodes.states);
}

/// A junction splits one way into two; a probabilistic one by chance.
void Behaviour::plan_junctions(Nodes& nodes) {
    const auto split = [&](const std::string& name, const std::vector<std::string>& ways, bool by_chance) {
        Step in{random_.pick(nodes.states), name, {}, {}, {}, {}, true};
        nodes.steps.push_back(std::move(in));
        for (const std::string& way : ways) {
            Step out{name, target(nodes), {}, {}, {}, {}, false};
            (by_chance ? out.probability : out.condition) = way;
            nodes.steps.push_back(std::move(out));
        }
    };
    if (shape_.junctions && random_.chance(40)) {
        nodes.junctions.push_back(names_.fresh("j"));
        const std::string guard = expressions_.operand(*types_.boolean(), 4);
        const bool otherwise = shape_.else_conditions && random_.chance(50);
        split(nodes.junctions.back(), {guard, otherwise ? "else" : "not (" + guard + ")"}, false);
    }
    if (shape_.probabilistic && random_.chance(15)) {
        nodes.probabilistic.push_back(names_.fresh("pj"));
        split(nodes.probabilistic.back(), {"0.25", "0.75"}, true);
    }
}

Behaviour::Nodes Behaviour::plan(bool must_end) {
    Nodes nodes;
    nodes.initial = names_.fresh("i");
    for (std::size_t i = random_.between(std::max<std::size_t>(1, shape_.states.low), shape_.states.high); i > 0; --i)
        nodes.states.push_back(names_.fresh("S"));
    if (must_end || (shape_.final_states && random_.chance(30))) nodes.finals.push_back(names_.fresh("f"));
    nodes.steps.push_back({nodes.initial, nodes.states[0], {}, {}, {}, {}, false});
    for (std::size_t i = 1; i < nodes.states.size(); ++i)
        nodes.steps.push_back({nodes.states[random_.below(i)], nodes.states[i], {}, {}, {}, {}, true});
    for (const std::string& end : nodes.finals)
        nodes.steps.push_back({random_.pick(nodes.states), end, {}, {}, {}, {}, true});
    for (std::size_t i = random_.between(shape_.transitions.low, shape_.transitions.high); i > 0; --i) {
        const std::string from = random_.pick(nodes.states);
        const std::string to = target(nodes);
        nodes.steps.push_back({from, to, {}, {}, {}, {}, true});
    }
    plan_junctions(nodes);
    return nodes;
}

void Behaviour::container(Lines& out, std::size_t depth, bool must_end) {
    const Nodes nodes = plan(must_end);
    out.line("initial " + nodes.initial);
    for (const std::string& name : nodes.states) state(out, name, depth);
    for (const std::string& name : nodes.junctions) out.line("junction " + name);
    for (const std::string& name : nodes.probabilistic) out.line("probabilistic " + name);
    for (const std::string& name : nodes.finals) out.line("final " + name);
    for (const Step& each : nodes.steps) step(out, nodes, each);
}

void Behaviour::state(Lines& out, const std::string& name, std::size_t depth) {
    const bool composite = shape_.composite_states && depth > 0 && random_.chance(shape_.composites);
    const bool entry = random_.chance(40);
    const bool during = shape_.during_actions && random_.chance(15);
    const bool exit = shape_.exit_actions && random_.chance(15);
    if (!shape_.paced && !composite && !entry && !during && !exit && random_.chance(70))
        return out.line("state " + name + " {}");
    out.open("state " + name);
    if (entry) out.line("entry " + action());
    if (shape_.paced && !entry) out.line("entry wait(1)");
    if (composite) {
        const std::string outer = std::exchange(inside_, name);
        container(out, depth - 1, false);
        inside_ = outer;
    }
    if (during) out.line("during " + action());
    if (exit) out.line("exit " + action());
    out.close();
}

/// Clauses in the order of the grammar. A way out of a state waits for an event or for time where that is possible.
void Behaviour::step(Lines& out, const Nodes& nodes, const Step& step) {
    out.open("transition " + names_.fresh("t"));
    out.line("from " + step.from + " to " + step.to);
    const std::string event = step.triggered && random_.chance(85) ? trigger() : "";
    if (!event.empty()) out.line("trigger " + event);
    if (!step.probability.empty()) out.line("probability " + step.probability);
    if (shape_.time && step.triggered && !around_.clocks.empty() && random_.chance(20))
        out.line("#" + random_.pick(around_.clocks));
    if (shape_.time && !event.empty() && random_.chance(15)) out.line("<{ " + expressions_.number() + " }");
    if (!step.condition.empty()) out.line("condition " + step.condition);
    const bool guarded = step.condition.empty() && step.triggered && (event.empty() || random_.chance(30));
    if (guarded) out.line("condition " + condition(nodes));
    if (random_.chance(35)) out.line("action " + action());
    out.close();
}

}  // namespace robochart::random_models
