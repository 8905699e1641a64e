// SPDX-License-Identifier: Apache-2.0
// Binds names of the scenario to inputs and outputs of the controller and checks types; see plan.hpp.
#include "simulation/scenario/plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/diagnostics/spelling.hpp"
#include "simulation/scenario/rules.hpp"

namespace robochart::simulation {

using cpp_emit::Carried;
using cpp_emit::Port;

namespace {

constexpr std::uint32_t most_requests = 64;

std::string described(const Port& port) {
    if (port.arguments.empty()) return "no value";
    if (port.arguments.size() > 1) return "several values";
    switch (port.arguments.front()) {
        case Carried::boolean:
            return "a truth value";
        case Carried::whole:
            return "a whole number";
        case Carried::real:
            return "a real";
        case Carried::enumeration:
            break;
    }
    const std::vector<std::string>& literals = port.literals.front();
    constexpr std::size_t most = 8;
    if (literals.empty() || literals.size() > most) return fmt::format("a value of {}", port.types.front());
    return fmt::format("a literal of {} ({})", port.types.front(), fmt::join(literals, ", "));
}

/// True if a written name refers to this full name, because the full name ends with it: `NEAR` and `Zone::NEAR` refer
/// to `P::Zone::NEAR`.
bool refers_to(const std::string& written, const std::string& full) {
    return full == written || full.ends_with("::" + written);
}

const char* described(Carries carries) {
    switch (carries) {
        case Carries::signal:
            return "there or not";
        case Carries::boolean:
            return "a truth value";
        case Carries::whole:
            return "a whole number";
        case Carries::real:
            break;
    }
    return "a quantity";
}

std::string described(const Feed& feed) {
    return fmt::format("a reading that is {}", described(feed.carries));
}

bool accepts_value(Carries carries, const std::vector<Carried>& arguments) {
    if (carries == Carries::signal) return arguments.empty();
    Carried expected = Carried::real;
    if (carries == Carries::boolean) expected = Carried::boolean;
    if (carries == Carries::whole) expected = Carried::whole;
    return arguments.size() == 1 && arguments.front() == expected;
}

class Binder {
public:
    Binder(const Scenario& scenario, const Name& component, const cpp_emit::DriveEmission& emission,
           diagnostics::Diagnostics& diagnostics)
        : scenario_(scenario), component_(component), emission_(emission), diagnostics_(diagnostics) {
        plan_.scenario = &scenario;
        plan_.inputs = static_cast<std::uint32_t>(emission.inputs.size());
        plan_.effects.resize(emission.outputs.size());
        fed_.resize(emission.inputs.size());
        slots_.assign(emission.outputs.size(), no_slot);
        bits_.assign(emission.outputs.size(), no_slot);
    }

    /// Binds the inputs and outputs of a kind of robots. Events that the environment raises need no feed.
    Plan bind(const RobotKind& kind, const Emissions& all) {
        for (const Sensor& sensor : scenario_.sensors)
            plan_.messages.push_back(
                is_silent(sensor, all) ? no_slot : find_variable(sensor.message, Carries::whole).value_or(no_slot));
        for (const Feed& feed : kind.feeds) bind_feed(feed);
        for (const Stimulus& stimulus : kind.stimuli)
            plan_.stimuli.push_back(bind_raised_event(stimulus).value_or(BoundStimulus{}));
        std::erase_if(plan_.stimuli, [](const BoundStimulus& bound) { return bound.stimulus == nullptr; });
        for (std::uint32_t d = 0; d < kind.drives.size(); ++d) bind_drive(kind.drives[d], d);
        if (scenario_.environment)
            for (const WorldAct& act : scenario_.environment->acts)
                if (const auto fed = input_named(act.stimulus.event.text)) fed_[*fed] = true;
        report_unused(kind, plan_.effects);
        return std::move(plan_);
    }

    WorldPlan bind(const Environment& environment, const Emissions& all) {
        WorldPlan plan;
        plan.inputs = plan_.inputs;
        for (std::uint32_t f = 0; f < environment.feeds.size(); ++f) bind_world_feed(environment.feeds[f], f, plan);
        plan.acts.resize(emission_.outputs.size());
        for (const WorldAct& act : environment.acts) bind_act(act, all, plan);
        report_unused(environment, plan.acts);
        return plan;
    }

    /// Binds a raised event. Returns no value and reports a finding if the component has no such event.
    std::optional<BoundStimulus> bind_raised_event(const Stimulus& stimulus) {
        const auto found = find_input(stimulus.event);
        if (!found) return std::nullopt;
        fed_[*found] = true;
        const Port& port = emission_.inputs[*found];
        BoundStimulus bound{&stimulus, *found, port.arguments == std::vector{Carried::real}, 0};
        if (stimulus.named ? !take_named(*stimulus.named, port, bound.value) : !take_value(stimulus, port, bound.value))
            diagnostics_.report(rules::wrong_type, stimulus.event.span,
                                {stimulus.event.text, described(port), "this stimulus", "give"});
        return bound;
    }

    [[nodiscard]] std::optional<std::uint32_t> input_named(const std::string& name) const {
        for (std::uint32_t i = 0; i < emission_.inputs.size(); ++i)
            if (emission_.inputs[i].name == name) return i;
        return std::nullopt;
    }

private:
    /// True if robots of this kind do not send the variable of this sensor. If no kind sends the variable, this is
    /// reported only for the first kind.
    [[nodiscard]] bool is_silent(const Sensor& sensor, const Emissions& all) const {
        if (sensor.message.text.empty()) return true;
        const auto sends = [&](const cpp_emit::DriveEmission* emission) {
            return std::ranges::any_of(emission->outputs, [&](const Port& port) {
                return port.kind == Port::Kind::variable && port.name == sensor.message.text;
            });
        };
        return !sends(&emission_) && (&emission_ != all.kinds.front() || std::ranges::any_of(all.kinds, sends));
    }

    /// Reports events without a feed, and operations without an effect. `effects` contains the effects of each output.
    template <class Effects>
    void report_unused(const Controlled& controlled, const std::vector<Effects>& effects) {
        std::vector<Name> ignored = controlled.ignored;
        const auto report = [&](const diagnostics::Rule& rule, const std::string& name) {
            if (std::erase_if(ignored, [&](const Name& candidate) { return candidate.text == name; }) == 0)
                diagnostics_.report(rule, component_.span, {name, component_.text});
        };
        for (std::size_t i = 0; i < emission_.inputs.size(); ++i)
            if (!fed_[i] && emission_.inputs[i].kind == Port::Kind::event)
                report(rules::not_fed, emission_.inputs[i].name);
        for (std::size_t i = 0; i < emission_.outputs.size(); ++i)
            if (effects[i].empty() && emission_.outputs[i].kind == Port::Kind::call)
                report(rules::not_done, emission_.outputs[i].name);
        for (const Name& unused : ignored)
            report_unknown(unused, "event without a feed, or operation without an effect, named", {});
    }

    void bind_world_feed(const WorldFeed& feed, std::uint32_t number, WorldPlan& plan) {
        const auto found = find_input(feed.target);
        if (!found) return;
        fed_[*found] = true;
        const Port& port = emission_.inputs[*found];
        const bool boolean = port.arguments == std::vector{Carried::boolean};
        if (feed.condition ? !boolean && !port.arguments.empty() : port.arguments != std::vector{Carried::real})
            diagnostics_.report(
                rules::wrong_type, feed.target.span,
                {feed.target.text, described(port), feed.condition ? "a condition" : "a measure", "feed"});
        plan.feeds.push_back({&feed, number, *found, boolean});
    }

    void bind_act(const WorldAct& act, const Emissions& all, WorldPlan& plan) {
        const auto found = find_command(act.on);
        if (!found) return;
        const Port& port = emission_.outputs[*found];
        BoundAct bound{&act, {}};
        if (act.kind == WorldAct::Kind::light_move && !act.to &&
            port.arguments != std::vector{Carried::real, Carried::real})
            diagnostics_.report(rules::wrong_type, act.on.span,
                                {act.on.text, described(port), "'move'", "take for two coordinates"});
        if (act.kind == WorldAct::Kind::stimulus) bind_raised(act, port, all, bound);
        plan.acts[*found].push_back(std::move(bound));
    }

    /// Finds an operation of the environment's platform, or an event that the environment sends.
    std::optional<std::uint32_t> find_command(const Name& name) {
        const auto commands = [](const Port& port) { return port.kind != Port::Kind::variable; };
        for (std::uint32_t i = 0; i < emission_.outputs.size(); ++i)
            if (commands(emission_.outputs[i]) && emission_.outputs[i].name == name.text) return i;
        report_unknown(name, "operation or output named", port_names(emission_.outputs, commands));
        return std::nullopt;
    }

    /// Binds the event for every kind of robots that has it. If the event carries a value and the scenario gives none,
    /// the event takes the value of the command.
    void bind_raised(const WorldAct& act, const Port& from, const Emissions& all, BoundAct& bound) {
        const Stimulus& stimulus = act.stimulus;
        const bool valued = stimulus.value || stimulus.truth || stimulus.named;
        bool some = false;
        for (std::size_t kind = 0; kind < all.kinds.size(); ++kind) {
            Binder robots(scenario_, scenario_.kind_at(kind).component, *all.kinds[kind], diagnostics_);
            bound.raised.emplace_back();
            const auto found = robots.input_named(stimulus.event.text);
            if (!found) continue;
            some = true;
            const Port& to = all.kinds[kind]->inputs[*found];
            const bool argument = !valued && to.arguments.size() == 1 && to.arguments == from.arguments &&
                                  to.arguments.front() != Carried::enumeration;
            bound.raised.back() = argument
                                      ? BoundStimulus{&stimulus, *found, to.arguments.front() == Carried::real, 0, true}
                                      : robots.bind_raised_event(stimulus);
        }
        if (!some)
            (void)Binder(scenario_, scenario_.component, *all.kinds.front(), diagnostics_).find_input(stimulus.event);
    }

    std::optional<std::uint32_t> find_input(const Name& name) {
        if (const auto found = input_named(name.text)) return found;
        report_unknown(name, "event or variable to feed named",
                       port_names(emission_.inputs, [](const Port&) { return true; }));
        return std::nullopt;
    }

    std::optional<std::uint32_t> find_output(const Name& name, Port::Kind kind, const char* what) {
        for (std::uint32_t i = 0; i < emission_.outputs.size(); ++i)
            if (emission_.outputs[i].kind == kind && emission_.outputs[i].name == name.text) return i;
        report_unknown(name, what,
                       port_names(emission_.outputs, [kind](const Port& port) { return port.kind == kind; }));
        return std::nullopt;
    }

    template <class Accepts>
    static std::vector<std::string> port_names(const std::vector<Port>& ports, Accepts accepts) {
        std::vector<std::string> result;
        for (const Port& port : ports)
            if (accepts(port)) result.push_back(port.name);
        return result;
    }

    void report_unknown(const Name& name, const std::string& what, const std::vector<std::string>& known) {
        auto& finding = diagnostics_.report(rules::unknown_name, name.span, {component_.text, what, name.text});
        const std::string meant = diagnostics::nearest_spelling(name.text, known);
        if (!meant.empty()) finding.fixes.push_back({name.span, meant, diagnostics::suggestion_verb(false)});
        if (!known.empty()) finding.notes.push_back({{}, fmt::format("there is {}", fmt::join(known, ", "))});
    }

    void bind_feed(const Feed& feed) {
        BoundFeed bound;
        bound.feed = &feed;
        const auto found = find_input(feed.target);
        if (!found) return;
        bound.input = *found;
        fed_[*found] = true;
        const Port& port = emission_.inputs[*found];
        if (!accepts_value(feed.carries, port.arguments))
            diagnostics_.report(rules::wrong_type, feed.target.span,
                                {feed.target.text, described(port), described(feed), "feed"});
        for (std::uint32_t s = 0; s < scenario_.sensors.size(); ++s)
            if (scenario_.sensors[s].name.text == feed.part.text) bound.sensor = s;
        if (feed.argument && !feed.argument->variable.text.empty())
            bound.variable = find_variable(feed.argument->variable).value_or(0);
        if (feed.on) bound.request = request_bit(*feed.on);
        plan_.feeds.push_back(bound);
    }

    /// Returns the slot with the value that the controller last wrote to a shared variable.
    std::optional<std::uint32_t> find_variable(const Name& name, Carries carries = Carries::real) {
        const auto found = find_output(name, Port::Kind::variable, "shared variable that it writes named");
        if (!found) return std::nullopt;
        const Port& port = emission_.outputs[*found];
        if (!accepts_value(carries, port.arguments)) {
            diagnostics_.report(rules::wrong_type, name.span,
                                {name.text, described(port), carries == Carries::whole ? "a message" : "a quantity",
                                 carries == Carries::whole ? "send" : "follow"});
            return std::nullopt;
        }
        if (slots_[*found] == no_slot) {
            slots_[*found] = static_cast<std::uint32_t>(plan_.variables.size());
            plan_.variables.push_back(port.initial);
            plan_.effects[*found].push_back({Effect::Kind::store, carries == Carries::whole, slots_[*found]});
        }
        return slots_[*found];
    }

    std::uint32_t request_bit(const Name& operation) {
        const auto found = find_output(operation, Port::Kind::call, "operation of the platform named");
        if (!found) return no_slot;
        if (bits_[*found] == no_slot && plan_.requests < most_requests) {
            bits_[*found] = plan_.requests++;
            plan_.effects[*found].push_back({Effect::Kind::request, false, bits_[*found]});
        }
        return bits_[*found];
    }

    /// Determines the value of an event. Returns false if the event carries another type.
    static bool take_value(const Stimulus& stimulus, const Port& port, double& value) {
        value = stimulus.truth.value_or(false) ? 1 : 0;
        if (stimulus.value) value = stimulus.value->value;
        if (stimulus.value && port.arguments == std::vector{Carried::whole}) return value == std::floor(value);
        Carries carries = stimulus.value ? Carries::real : Carries::signal;
        if (stimulus.truth) carries = Carries::boolean;
        return accepts_value(carries, port.arguments);
    }

    /// Determines the value of a name: a literal of the event's enumeration, or a constant of the model. Returns false
    /// if the type differs. Reports a missing name.
    bool take_named(const Name& name, const Port& port, double& value) {
        if (port.arguments.size() != 1) return false;
        const std::string& type = port.types.front();
        const std::vector<std::string>& literals = port.literals.front();
        for (std::size_t i = 0; i < literals.size(); ++i)
            if (refers_to(name.text, type + "::" + literals[i])) {
                value = static_cast<double>(i);
                return true;
            }
        const cpp_emit::DriveConstant* const found = find_constant(name, port);
        if (found == nullptr) return true;
        value = found->value;
        const Carried expected = port.arguments.front();
        if (expected == Carried::real) return found->carried == Carried::real || found->carried == Carried::whole;
        return found->carried == expected && (expected != Carried::enumeration || found->type == type);
    }

    /// Returns the constant with this name. Returns null and reports a finding if there is no such constant, or if
    /// several machines define it differently.
    const cpp_emit::DriveConstant* find_constant(const Name& name, const Port& port) {
        const cpp_emit::DriveConstant* found = nullptr;
        std::vector<std::string> known = port.literals.front();
        for (const cpp_emit::DriveConstant& constant : emission_.constants) {
            known.push_back(constant.name);
            if (!refers_to(name.text, constant.owner + "::" + constant.name)) continue;
            if (found != nullptr && (found->value != constant.value || found->type != constant.type)) {
                diagnostics_.report(
                    rules::out_of_range, name.span,
                    {fmt::format("'{}' has different values in {} and {}: write the path of one of them", name.text,
                                 found->owner, constant.owner)});
                return nullptr;
            }
            found = &constant;
        }
        const bool literal = !port.literals.front().empty();
        if (found == nullptr)
            report_unknown(name, literal ? fmt::format("constant or literal of {}", port.types.front()) : "constant",
                           known);
        return found;
    }

    void bind_drive(const Drive& drive, std::uint32_t index) {
        if (drive.motion == Motion::speeds) {
            const auto linear = find_variable(drive.linear);
            const auto angular = find_variable(drive.angular);
            if (linear && angular) plan_.speeds = BoundSpeeds{&drive, *linear, *angular};
            return;
        }
        const auto found = find_output(*drive.on, Port::Kind::call, "operation of the platform named");
        if (!found) return;
        const Port& port = emission_.outputs[*found];
        if (drive.motion == Motion::turn && !accepts_value(Carries::real, port.arguments)) {
            diagnostics_.report(rules::wrong_type, drive.on->span,
                                {drive.on->text, described(port), "'turn'", "take for an angle"});
            return;
        }
        plan_.effects[*found].push_back({Effect::Kind::drive, false, index});
    }

    const Scenario& scenario_;
    const Name& component_;
    const cpp_emit::DriveEmission& emission_;
    diagnostics::Diagnostics& diagnostics_;
    Plan plan_;
    std::vector<bool> fed_;
    std::vector<std::uint32_t> slots_;  ///< by output: the slot, if it is a variable
    std::vector<std::uint32_t> bits_;   ///< by output: the bit, if it is an operation
};

}  // namespace

Plan bind_scenario(const Scenario& scenario, const Emissions& emissions, diagnostics::Diagnostics& diagnostics) {
    std::vector<Plan> plans;
    for (std::size_t kind = 0; kind < scenario.kind_count(); ++kind) {
        const RobotKind& robots = scenario.kind_at(kind);
        plans.push_back(
            Binder(scenario, robots.component, *emissions.kinds.at(kind), diagnostics).bind(robots, emissions));
    }
    Plan plan = std::move(plans.front());
    plan.others.assign(std::make_move_iterator(plans.begin() + 1), std::make_move_iterator(plans.end()));
    if (scenario.environment)
        plan.environment = Binder(scenario, scenario.environment->component, *emissions.environment, diagnostics)
                               .bind(*scenario.environment, emissions);
    return plan;
}

Plan bind_scenario(const Scenario& scenario, const cpp_emit::DriveEmission& emission,
                   diagnostics::Diagnostics& diagnostics) {
    return bind_scenario(scenario, Emissions{{&emission}, nullptr}, diagnostics);
}

}  // namespace robochart::simulation
