// SPDX-License-Identifier: Apache-2.0
// See process_names.hpp.
#include "prism/assertions/process/process_names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "prism/assertions/process/decision_process.hpp"
#include "prism/assertions/properties/names.hpp"
#include "prism/syntax/lexer.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::probability {
namespace {

using prism::ExprPtr;
using prism::Op;

[[noreturn]] void throw_absent(const std::string& what, const std::string& path) {
    throw NotExpressed(fmt::format("the process has no {} `{}`", what, path));
}

/// True if values of the type are numbers in PRISM.
bool is_number(const ir::System& system, ir::TypeId id) {
    const ir::Type& type = system.type(id);
    const bool plain = std::ranges::all_of(type.literal_args, [](const auto& arguments) { return arguments.empty(); });
    return type.kind == ir::TypeKind::nat || type.kind == ir::TypeKind::integer || type.kind == ir::TypeKind::real ||
           (type.kind == ir::TypeKind::enumeration && plain);
}

}  // namespace

ProcessNames::ProcessNames(const ir::System& system, const ir::ComponentRef& subject)
    : system_(system), subject_(subject), seats_(seats_in(system, subject)) {}

const Seat* ProcessNames::find_seat(const std::string& path) const {
    const auto found = std::ranges::find_if(seats_, [&](const Seat& seat) { return seat.path == path; });
    return found == seats_.end() ? nullptr : &*found;
}

bool ProcessNames::is_name_taken(const std::string& name) const {
    return name == units ||
           std::ranges::any_of(observables_, [&](const auto& observable) { return observable.name == name; }) ||
           std::ranges::any_of(constants_, [&](const auto& constant) { return constant.name == name; });
}

std::string ProcessNames::free_name(const std::string& path) const {
    std::string name = path;
    for (std::size_t at = name.find("::"); at != std::string::npos; at = name.find("::")) name.replace(at, 2, "_");
    while (prism::is_reserved(name) || is_name_taken(name)) name += "_";
    return name;
}

ExprPtr ProcessNames::observed(Observable observable) {
    for (const Observable& known : observables_)
        if (known.component == observable.component && known.variable == observable.variable &&
            known.state == observable.state)
            return name_expression(known.name);
    observables_.push_back(std::move(observable));
    return name_expression(observables_.back().name);
}

ExprPtr ProcessNames::variable_expression(const std::string& path) {
    const std::string name = last_of(path);
    const Seat* const where = find_seat(owner_of(path));
    if (where == nullptr) return shared_variable(path, name);
    const auto& variables = where->machine->variables;
    const auto found =
        std::ranges::find_if(variables, [&](const ir::Variable& variable) { return variable.name == name; });
    if (found == variables.end()) throw_absent("variable", path);
    const bool boolean = system_.type(found->type).kind == ir::TypeKind::boolean;
    if (!boolean && !is_number(system_, found->type))
        throw NotExpressed(
            fmt::format("`{}` has the type {}, but only numbers, truth values and plain literals are supported", path,
                        system_.type(found->type).name));
    const ExprPtr read = observed({free_name(path), where->component, name, "", boolean});
    if (system_.type(found->type).kind != ir::TypeKind::real) return read;
    return prism::make_expr(Op::divide, {}, {read, name_expression(units)});
}

/// Returns the value of a shared variable. Each machine that requires a variable of the platform or of a controller has
/// a copy of its value. If one machine requires the variable, its copy is the current value. If several do, some copies
/// may still be old.
ExprPtr ProcessNames::shared_variable(const std::string& path, const std::string& name) {
    const Seat* only = nullptr;
    for (const Seat& seat : seats_)
        for (const ir::Variable& variable : seat.machine->variables)
            if (variable.name == name && variable.scope == ir::VariableScope::required) {
                if (only != nullptr)
                    throw NotExpressed(
                        fmt::format("`{}` is shared by {} and {}, which may have different values of it: name the "
                                    "variable of a machine",
                                    path, only->path, seat.path));
                only = &seat;
            }
    if (only == nullptr) throw_absent("variable", path);
    return variable_expression(only->path + "::" + name);
}

ConstantHere ProcessNames::find_constant(const std::string& path) const {
    const std::string name = last_of(path);
    const std::string owner = owner_of(path);
    for (const Seat& seat : seats_) {
        // A constant that a module or controller provides is found in the machines that require it.
        const bool inside =
            seat.path == owner || seat.path.starts_with(owner + "::") || owner.starts_with(subject_.path);
        const auto& constants = seat.machine->constants;
        for (std::uint32_t i = 0; i < constants.size() && inside; ++i)
            if (constants[i].name == name && (seat.path == owner || constants[i].required))
                return {"", &seat, {i}, system_.type(constants[i].type).kind == ir::TypeKind::real};
    }
    throw_absent("constant", path);
}

ExprPtr ProcessNames::constant_expression(const std::string& path) {
    ConstantHere found = find_constant(path);
    for (const ConstantHere& known : constants_)
        if (known.seat == found.seat && known.id.index == found.id.index) return name_expression(known.name);
    found.name = free_name(path);
    constants_.push_back(found);
    return name_expression(found.name);
}

ExprPtr ProcessNames::in_state(const std::string& machine, const std::string& state) {
    const Seat* const where = find_seat(machine);
    if (where == nullptr) throw_absent("state machine", machine);
    for (const ir::Node& node : where->machine->nodes)
        if (node.path == state)
            return observed({free_name(machine + "::" + state), where->component, "", node.origin.element, true});
    throw_absent("state", machine + "::" + state);
}

/// Returns the index of an event. Its direction is that of the component that declares it. For the platform, `in` means
/// into the software, so out of the platform.
std::size_t ProcessNames::observed_event(const std::string& path, const std::string& direction, bool valued) {
    const std::string name = last_of(path);
    const ir::Event* event = nullptr;
    std::string component;
    bool inwards = direction == "in";
    const auto look = [&](const std::vector<ir::Event>& events, const std::string& of) {
        const auto found = std::ranges::find_if(events, [&](const auto& candidate) { return candidate.name == name; });
        if (found == events.end()) return;
        event = &*found;
        component = of;
    };
    if (const Seat* const where = find_seat(owner_of(path))) {
        look(where->machine->events, where->component);
    } else if (subject_.kind == ir::ComponentKind::module) {
        const ir::Platform& platform = system_.modules[subject_.definition].platform;
        if (owner_of(path) == subject_.path + "::" + platform.name) look(platform.events, ir::qualified_name(subject_));
        inwards = !inwards;
    }
    if (event == nullptr || !(inwards ? event->input : event->output)) throw_absent("event", path + "." + direction);
    if (valued && !event->type) throw NotExpressed(fmt::format("the value of `{}`, which has none", path));
    ObservedEvent observed_event;
    observed_event.component = component;
    observed_event.event = name + (inwards ? ".in" : ".out");
    observed_event.origin = event->origin;
    observed_event.valued = event->type.has_value();
    observed_event.module = find_seat(owner_of(path)) == nullptr;
    for (std::size_t i = 0; i < observed_.size(); ++i) {
        if (observed_[i].name() != observed_event.name()) continue;
        if (valued) observed_[i].type = *event->type;
        return i;
    }
    if (observed_.size() == most_observed)
        throw NotExpressed(fmt::format("more than {} events are observed", most_observed));
    if (valued) observed_event.type = *event->type;
    observed_.push_back(std::move(observed_event));
    return observed_.size() - 1;
}

std::string ProcessNames::event_action(const std::string& path, const std::string& direction) {
    return observed_action(EventSet{1} << observed_event(path, direction, false));
}

ExprPtr ProcessNames::event_value(const std::string& path, const std::string& direction) {
    const ObservedEvent& event = observed_[observed_event(path, direction, true)];
    const bool boolean = system_.type(event.type).kind == ir::TypeKind::boolean;
    if (!boolean && !is_number(system_, event.type))
        throw NotExpressed(fmt::format(
            "`{}` carries values of the type {}, but only numbers, truth values and plain literals are supported", path,
            system_.type(event.type).name));
    const bool real = system_.type(event.type).kind == ir::TypeKind::real;
    const ExprPtr read = observed({free_name(path + "_" + direction), event.name(), observed_value, "", boolean, true});
    return real ? prism::make_expr(Op::divide, {}, {read, name_expression(units)}) : read;
}

prism::RewardItem ProcessNames::of_state(prism::RewardItem item) {
    item.transition = true;
    item.action.text = tock_action;
    return item;
}

}  // namespace robochart::probability
