// SPDX-License-Identifier: Apache-2.0
#include "prism/emit/machine.hpp"

#include <algorithm>
#include <utility>

#include "prism/emit/rules.hpp"
#include "prism/emit/tree.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::prism_emit {
namespace {

using ir::NodeKind;
using prism::ExprPtr;

constexpr auto none = "Exit_NONE";
constexpr auto act_parent = "Exit_ACT_Parent";
constexpr auto act_trans = "Exit_ACT_Trans";
constexpr auto exited = "Exit_EXITED";
constexpr auto sub_act = "Exit_Sub_ACT";
constexpr auto waiting = "Exit_Sub_ACT_Waiting";
constexpr auto sub_exited = "Exit_Sub_EXITED";

std::string join_path(std::string path) {
    for (std::size_t at = path.find("::"); at != std::string::npos; at = path.find("::")) path.replace(at, 2, "_");
    return path;
}

/// Joins two groups of assignments, where the second follows the first. For each variable, only the last assignment is
/// kept.
std::vector<prism::Assignment> combine_assignments(std::vector<prism::Assignment> first,
                                                   const std::vector<prism::Assignment>& second) {
    for (const prism::Assignment& assignment : second) {
        std::erase_if(first, [&](const auto& other) { return other.variable.text == assignment.variable.text; });
        first.push_back(assignment);
    }
    return first;
}

}  // namespace

MachineEmitter::MachineEmitter(Context& context, Channels& channels, const std::map<std::string, std::string>& globals,
                               std::map<std::string, std::string>& constants, Seat seat)
    : context_(context),
      channels_(channels),
      globals_(globals),
      constants_(constants),
      seat_(seat),
      controller_(context.system.controller(context.module.controllers[seat.controller].controller)),
      instance_(controller_.machines[seat.machine]) {}

/// Emits the module of the machine. R2: "One module per machine. Composite states and operations are variables inside
/// their machine's module."
void MachineEmitter::operator()() {
    Part& part = part_of(instance_.machine, instance_.name, false);
    module_.name.text = part.stem;
    emit_part(part);
    context_.emission.model.modules.push_back(std::move(module_));
}

void MachineEmitter::emit_part(Part& part) {
    emit_entries(part);
    emit_steps(part);
    emit_exits(part);
    declare_counters(part);
}

// ---------------------------------------------------------------- names and variables

/// Finds or adds a part. R1: "Qualified name with _. References, not types, name the instances: a machine used twice
/// gives two modules."
Part& MachineEmitter::part_of(ir::MachineId machine, const std::string& name, bool operation) {
    std::unique_ptr<Part>& part = parts_[machine.index];
    part = std::make_unique<Part>();
    part->machine = &context_.system.machine(machine);
    const std::string controller = context_.module.controllers[seat_.controller].name;
    part->element = context_.module.name + "::" + controller + "::" + instance_.name;
    if (operation) part->element += "::" + name;
    part->stem = context_.unique_name(join_path(part->element));
    if (!operation) context_.record_name("STM", part->element, part->stem);
    part->chart = normal_form(context_, *part->machine, part->element);
    name_variables(*part);
    name_constants(*part);
    name_places(*part);
    declare_variables(*part);
    return *part;
}

/// Names the variables of a part. R3: "Variables provided by the platform become global; a machine's own (also those
/// its operations require) are local."
void MachineEmitter::name_variables(Part& part) {
    const Part* const host = parts_.at(instance_.machine.index).get();
    for (const ir::Variable& variable : part.machine->variables) {
        std::string name;
        if (variable.scope != ir::VariableScope::required) {
            name = context_.unique_name(part.stem + "_" + variable.name);
            context_.record_name(variable, part.element + "::" + variable.name, name);
        } else if (host != &part) {
            const auto& known = host->machine->variables;
            const auto own =
                std::ranges::find_if(known, [&](const auto& other) { return other.name == variable.name; });
            if (own != known.end()) name = host->variables[static_cast<std::size_t>(own - known.begin())];
        }
        if (name.empty()) {
            const auto& shared = controller_.variables;
            const bool of_controller = std::ranges::any_of(shared, [&](const ir::Variable& other) {
                return other.name == variable.name && other.scope == ir::VariableScope::local;
            });
            const auto global = globals_.find(variable.name);
            if (of_controller || global == globals_.end())
                context_.diagnostics.report(
                    rules::unsupported_construct, variable.origin.span,
                    {"the shared variable '" + variable.name + "' that the platform does not provide", part.element});
            else
                name = global->second;
        }
        part.variables.push_back(name);
    }
}

void MachineEmitter::name_constants(Part& part) {
    for (std::uint32_t i = 0; i < part.machine->constants.size(); ++i)
        part.constants.push_back(constant_name(part, {i}));
}

/// Names a constant. R3: "`const` without value: undefined `const double|int`."
std::string MachineEmitter::constant_name(Part& part, ir::ConstantId id) {
    const ir::Constant& declared = part.machine->constants[id.index];
    const ir::ConstantSource source = ir::constant_source(context_.system, &context_.module, &controller_,
                                                          name_in_controller(part), *part.machine, id);
    const bool own = source.constant == nullptr || source.constant == &declared;
    const ir::Constant& given = own ? declared : *source.constant;
    const std::string element = (own ? part.element : context_.module.name) + "::" + given.name;
    const std::string key = own ? element : source.name;
    const auto found = constants_.find(key);
    if (found != constants_.end()) return found->second;
    const std::string name = context_.unique_name(join_path(element));
    const std::optional<Carrier> carrier = context_.find_carrier(given.type, element, given.origin.span);
    const bool real = context_.system.type(given.type).kind == ir::TypeKind::real;
    prism::Constant made{real ? prism::Type::real : prism::Type::integer, {name, {}}, nullptr};
    if (carrier && carrier->boolean) made.type = prism::Type::boolean;
    if (given.value) {
        Scope scope;
        scope.element = element;
        if (own) scope.constant = [&](ir::ConstantId other) { return constant_name(part, other); };
        made.value = translate_expression(context_, scope, *given.value);
    }
    context_.emission.model.constants.push_back(std::move(made));
    context_.record_name("constant", element, name);
    constants_[key] = name;
    return name;
}

/// Returns the name of the controller's reference to the machine or operation.
std::string MachineEmitter::name_in_controller(const Part& part) const {
    for (std::size_t i = 0; i < controller_.definitions.size(); ++i)
        if (&context_.system.machine(controller_.definitions[i]) == part.machine)
            return controller_.definition_names[i];
    return instance_.name;
}

Region MachineEmitter::make_region(Part& part, std::optional<std::size_t> owner) {
    Region result;
    result.owner = owner;
    result.stem = owner ? part.stem + "_" + join_path(part.chart.places[*owner].path) : part.stem;
    result.pc = context_.unique_name(result.stem + "_scpc_8");
    result.exit = context_.unique_name(result.stem + "_exit_9");
    result.inactive = context_.unique_name(result.stem + "_INACTIVE_10");
    const std::string element = owner ? part.element + "::" + part.chart.places[*owner].path : part.element;
    context_.record_name("variable", element + "::scpc_8", result.pc);
    context_.record_name("variable", element + "::exit_9", result.exit);
    context_.emission.model.constants.push_back(tree::constant(result.inactive, 0));
    return result;
}

std::string MachineEmitter::add_point(Region& region, const std::string& name) {
    context_.emission.model.constants.push_back(tree::constant(name, ++region.points));
    return name;
}

/// Names the program points. R4: "Each state; X_entering iff X has an entry action; Action_n for each further
/// statement; e_n after a typed communication; junctions; i0; final states."
void MachineEmitter::name_places(Part& part) {
    part.lock = context_.unique_name(part.stem + "_lock_7");
    part.free = context_.unique_name(part.stem + "_LOCK_FREE");
    context_.record_name("variable", part.element + "::lock_7", part.lock);
    context_.emission.model.constants.push_back(tree::constant(part.free, 0));
    part.regions.push_back(make_region(part, std::nullopt));
    part.region_of[std::nullopt] = 0;
    for (std::size_t i = 0; i < part.chart.places.size(); ++i) {
        if (!part.chart.places[i].composite) continue;
        part.region_of[i] = part.regions.size();
        part.regions.push_back(make_region(part, i));
    }
    std::vector<std::string> finals;
    for (std::size_t i = 0; i < part.chart.places.size(); ++i) {
        const Place& place = part.chart.places[i];
        if (place.dropped) {
            part.points.emplace_back();
            part.entering.emplace_back();
            continue;
        }
        Region& around = region_at(part, i);
        const std::string name = context_.unique_name(part.stem + "_" + join_path(place.path));
        part.points.push_back(add_point(around, name));
        part.entering.push_back(place.entry.empty() ? "" : add_point(around, context_.unique_name(name + "_entering")));
        context_.record_name("node", part.element + "::" + place.path, name);
        if (place.kind == NodeKind::final && !place.parent) finals.push_back(name);
    }
    part.terminated = context_.unique_name(part.stem + "_TERMINATED_11");
    if (finals.size() > 1)
        context_.diagnostics.report(rules::unsupported_operation, part.machine->origin.span,
                                    {part.machine->name, part.element, "it has several final states"});
    if (!part.machine->preconditions.empty() || !part.machine->postconditions.empty())
        context_.diagnostics.report(rules::unsupported_operation, part.machine->origin.span,
                                    {part.machine->name, part.element, "it has conditions"});
    if (!part.machine->initial.is_valid())
        context_.diagnostics.report(rules::unsupported_construct, part.machine->origin.span,
                                    {"no initial node", part.element});
    if (finals.size() == 1)
        // R14: "TERMINATED is its final state."
        context_.emission.model.constants.push_back(
            {prism::Type::integer, {part.terminated, {}}, tree::name(finals.front())});
}

std::string MachineEmitter::add_lock(Part& part, const Step& step) {
    const Place& source = part.chart.places[step.source];
    const std::string stem = part.regions[part.region_of.at(source.parent)].stem;
    const std::string name = context_.unique_name(stem + "_" + step.name);
    context_.emission.model.constants.push_back(tree::constant(name, ++part.locks));
    const std::string path = source.parent ? "::" + part.chart.places[*source.parent].path : "";
    context_.record_name("transition", part.element + path + "::" + step.name, name);
    return name;
}

void MachineEmitter::declare_variables(Part& part) {
    for (std::size_t i = 0; i < part.machine->variables.size(); ++i) {
        const ir::Variable& variable = part.machine->variables[i];
        if (variable.scope == ir::VariableScope::required) continue;
        const auto carrier =
            context_.find_carrier(variable.type, part.element + "::" + variable.name, variable.origin.span);
        if (!carrier) continue;
        // R3: "Initial value absent: no `init`, so the least."
        ExprPtr initial;
        if (variable.initial)
            initial = whole_value(context_, make_scope(part, part.element + "::" + variable.name), *variable.initial);
        module_.variables.push_back(Context::declare_variable(part.variables[i], *carrier, initial));
    }
}

/// Declares the counters. R3: "Per machine and composite state: scpc : [0..k] init i0 (machine) or init INACTIVE (=0);
/// exit : [0..6] init Exit_NONE. Per machine and operation: lock : [0..n] init LOCK_FREE (=0)."
void MachineEmitter::declare_counters(const Part& part) {
    const bool machine = part.machine->kind == ir::MachineKind::state_machine;
    for (const Region& region : part.regions) {
        const bool starts = machine && !region.owner && part.machine->initial.is_valid();
        const std::string initial = starts ? part.points[part.machine->initial.index] : region.inactive;
        module_.variables.push_back(tree::range(region.pc, 0, region.points, tree::name(initial)));
        module_.variables.push_back(tree::range(region.exit, 0, 6, tree::name(none)));
    }
    module_.variables.push_back(tree::range(part.lock, 0, part.locks, tree::name(part.free)));
    const auto& known = context_.emission.model.constants;
    const bool given =
        std::ranges::any_of(known, [&](const auto& constant) { return constant.name.text == part.terminated; });
    if (!given)
        context_.emission.model.constants.push_back(tree::constant(part.terminated, part.regions.front().points + 1));
}

Scope MachineEmitter::make_scope(const Part& part, const std::string& where) const {
    Scope result;
    result.element = where;
    result.variable = [&part](ir::VariableId id) { return part.variables[id.index]; };
    result.constant = [&part](ir::ConstantId id) { return part.constants[id.index]; };
    return result;
}

// ---------------------------------------------------------------- places

Region& MachineEmitter::region_at(Part& part, std::size_t place) {
    return part.regions[part.region_of.at(part.chart.places[place].parent)];
}

/// Returns the conditions that a composite state is active. R6: "Substates add parentscpc=P for every ancestor."
std::vector<ExprPtr> MachineEmitter::active_conditions(const Part& part, std::optional<std::size_t> composite) const {
    std::vector<ExprPtr> result;
    for (; composite; composite = part.chart.places[*composite].parent) {
        const Region& around = part.regions[part.region_of.at(part.chart.places[*composite].parent)];
        result.insert(result.begin(), tree::is(around.pc, part.points[*composite]));
    }
    return result;
}

ExprPtr MachineEmitter::at_point(Part& part, std::size_t place, const std::string& point) const {
    const std::optional<std::size_t> parent = part.chart.places[place].parent;
    std::vector<ExprPtr> result = active_conditions(part, parent);
    result.push_back(tree::is(part.regions[part.region_of.at(parent)].pc, point));
    return tree::all_of(result);
}

/// Returns the assignments that begin to enter a place. R6: "junction, else Y_entering, else Y (with lock'=FREE in the
/// same step)". R9: a composite state begins with its child's "scpc'=i0 (the lock stays)".
MachineEmitter::Assignments MachineEmitter::arrive_at(Part& part, std::size_t place) {
    const Place& target = part.chart.places[place];
    if (!target.entry.empty()) return {tree::set(region_at(part, place).pc, part.entering[place])};
    if (target.kind == NodeKind::state || target.kind == NodeKind::final) return enter_place(part, place);
    return {tree::set(region_at(part, place).pc, part.points[place])};
}

/// Returns the assignments that enter a place. R9: "the last statement sets scpc'=X, then unlock (simple) or child
/// scpc'=i0 (composite; the lock stays)."
MachineEmitter::Assignments MachineEmitter::enter_place(Part& part, std::size_t place) {
    Assignments result{tree::set(region_at(part, place).pc, part.points[place])};
    const Place& target = part.chart.places[place];
    if (!target.composite)
        result.push_back(tree::set(part.lock, part.free));
    else if (target.initial)
        result.push_back(tree::set(part.regions[part.region_of.at(place)].pc, part.points[*target.initial]));
    return result;
}

bool MachineEmitter::releases_lock(const Part& part, const Assignments& assignments) const {
    return std::ranges::any_of(assignments,
                               [&](const auto& assignment) { return assignment.variable.text == part.lock; });
}

// ---------------------------------------------------------------- steps

/// Emits entry actions. R9: "Entry actions start at X_entering."
void MachineEmitter::emit_entries(Part& part) {
    for (std::size_t i = 0; i < part.chart.places.size(); ++i) {
        const Place& place = part.chart.places[i];
        if (!place.entry.empty())
            run_statements(part, i, part.entering[i], place.entry, enter_place(part, i),
                           part.element + "::" + place.path);
    }
}

void MachineEmitter::emit_steps(Part& part) {
    std::set<std::size_t> junctions;
    for (const Step& step : part.chart.steps) {
        context_.diagnostics.poll();
        switch (part.chart.places[step.source].kind) {
            case NodeKind::initial:
                from_initial(part, step);
                break;
            case NodeKind::state:
                from_state(part, step);
                break;
            case NodeKind::junction:
                from_junction(part, step);
                break;
            case NodeKind::probabilistic:
                if (junctions.insert(step.source).second) from_probabilistic(part, step.source);
                break;
            case NodeKind::final:
                break;
        }
    }
}

/// Returns the assignments that begin the action of a step or, without an action, enter its target.
MachineEmitter::Assignments MachineEmitter::go_on(Part& part, const Step& step) {
    if (step.action.empty()) return arrive_at(part, step.target);
    const std::string first = context_.numbered_name("Action");
    Region& around = region_at(part, step.source);
    add_point(around, first);
    run_statements(part, step.target, first, step.action, arrive_at(part, step.target),
                   part.element + "::" + step.name);
    return {tree::set(region_at(part, step.source).pc, first)};
}

/// Emits the step from an initial junction. R5: "[] scpc=i0 -> scpc'=target (a step of its own; plus unlock if the
/// target is a simple state without entry action)." A transition with an action takes the lock. So does a transition to
/// a composite state, because its substates are not entered yet (R6: the lock is "free when the innermost entry is
/// complete").
void MachineEmitter::from_initial(Part& part, const Step& step) {
    const std::string lock = add_lock(part, step);
    Assignments then = go_on(part, step);
    if (!step.action.empty() || part.chart.places[step.target].composite) then.push_back(tree::set(part.lock, lock));
    add_command(tree::command("", at_point(part, step.source, part.points[step.source]), then));
}

std::vector<ExprPtr> MachineEmitter::step_guards(Part& part, const Step& step, const std::string& received) {
    Scope inner = make_scope(part, part.element + "::" + step.name);
    inner.received = received;
    std::vector<ExprPtr> result;
    for (const ir::ExprPtr& guard : step.guards) result.push_back(translate_condition(context_, inner, *guard));
    return result;
}

bool MachineEmitter::trigger_fits(const Part& part, const Step& step, const Channel& channel) {
    const ir::Communication& trigger = *step.trigger;
    const bool fits = channel.carrier ? trigger.kind == ir::CommKind::input && trigger.variable.is_valid()
                                      : trigger.kind == ir::CommKind::simple;
    if (!fits || trigger.predicate)
        context_.diagnostics.report(rules::unsupported_construct, step.span,
                                    {"a trigger of this form", part.element + "::" + step.name});
    return fits;
}

/// Emits a step from a state. R6: "[event] scpc=X & lock=FREE & guard -> scpc'=next & lock'=t. No trigger: unlabelled.
/// No priority between a composite state's and its substates' transitions; only the lock."
void MachineEmitter::from_state(Part& part, const Step& step) {
    const std::string lock = add_lock(part, step);
    Channel* found = nullptr;
    if (step.trigger != nullptr) {
        found = channel_of(part, step.trigger->event, Direction::in, step.span);
        if (found == nullptr || !trigger_fits(part, step, *found)) return;
    }
    std::vector<ExprPtr> guard{at_point(part, step.source, part.points[step.source]), tree::is(part.lock, part.free)};
    // R13: "A guard on the received value reads EVT__... in the first command."
    for (ExprPtr& condition : step_guards(part, step, found != nullptr ? found->value_at(Direction::in) : ""))
        guard.push_back(std::move(condition));
    if (part.chart.places[step.source].composite)
        from_composite(part, step, lock, found, std::move(guard));
    else
        from_simple(part, step, lock, found, std::move(guard));
}

void MachineEmitter::from_simple(Part& part, const Step& step, const std::string& lock, Channel* channel,
                                 std::vector<ExprPtr> guard) {
    Assignments then = go_on(part, step);
    const std::string label = channel != nullptr ? channel->in_label() : "";
    if (channel == nullptr || !channel->carrier) {
        if (!releases_lock(part, then)) then.push_back(tree::set(part.lock, lock));
        add_command(tree::command(label, tree::all_of(guard), then));
        return;
    }
    // R13: "Receiver: [IN_...] ... & FIN=true -> FIN'=false & scpc'=e_n, then x'=EVT & FIN'=true."
    declare_value(*channel, Direction::in);
    const std::string ready = channel->ready_at(Direction::in);
    const std::string name = context_.numbered_name(part.machine->events[step.trigger->event.index].name);
    const std::string point = add_point(region_at(part, step.source), name);
    guard.push_back(tree::is(ready, true));
    add_command(tree::command(
        label, tree::all_of(guard),
        {tree::set(ready, false), tree::set(region_at(part, step.source).pc, point), tree::set(part.lock, lock)}));
    const Assignments read{tree::set(part.variables[step.trigger->variable.index], channel->value_at(Direction::in)),
                           tree::set(ready, true)};
    add_command(tree::command("", at_point(part, step.source, point), combine_assignments(read, then)));
}

/// Emits a step from a composite state. R10: "(1) lock'=t & exit'=ACT_Trans; (7) EXITED & lock=t -> NONE and on to
/// action/target."
void MachineEmitter::from_composite(Part& part, const Step& step, const std::string& lock, Channel* channel,
                                    std::vector<ExprPtr> guard) {
    if (channel != nullptr && channel->carrier) {
        context_.diagnostics.report(
            rules::unsupported_construct, step.span,
            {"a transition with a received value that leaves a composite state", part.element + "::" + step.name});
        return;
    }
    const std::string exit = part.regions[part.region_of.at(step.source)].exit;
    add_command(tree::command(channel != nullptr ? channel->in_label() : "", tree::all_of(guard),
                              {tree::set(part.lock, lock), tree::set(exit, act_trans)}));
    const Assignments then = go_on(part, step);
    add_command(tree::command("",
                              tree::all_of({at_point(part, step.source, part.points[step.source]),
                                            tree::is(part.lock, lock), tree::is(exit, exited)}),
                              combine_assignments({tree::set(exit, none)}, then)));
}

/// Emits a step from a junction. R8: "Junction: one unlabelled command per outgoing guard."
void MachineEmitter::from_junction(Part& part, const Step& step) {
    std::vector<ExprPtr> guard{at_point(part, step.source, part.points[step.source])};
    for (ExprPtr& condition : step_guards(part, step, "")) guard.push_back(std::move(condition));
    add_command(tree::command("", tree::all_of(guard), go_on(part, step)));
}

/// Emits a probabilistic step. R8: "Probabilistic junction: one unlabelled command p1:(scpc'=...) + p2:(...); lock
/// stays."
void MachineEmitter::from_probabilistic(Part& part, std::size_t junction) {
    prism::Command command = tree::command("", at_point(part, junction, part.points[junction]), {});
    command.branches.clear();
    for (const Step& step : part.chart.steps) {
        if (step.source != junction) continue;
        prism::Branch branch;
        if (step.probability)
            branch.probability =
                translate_expression(context_, make_scope(part, part.element + "::" + step.name), *step.probability);
        branch.assignments = go_on(part, step);
        command.branches.push_back(std::move(branch));
    }
    if (command.branches.size() > 1)
        for (prism::Branch& branch : command.branches)
            if (!branch.probability) branch.probability = tree::number(1);
    add_command(std::move(command));
}

// ---------------------------------------------------------------- exits

/// Emits the exits of states. R10: "(4/2) simple substate current: Sub_ACT -> Sub_EXITED". These steps "are emitted
/// (dead code)" even if there is no composite state.
void MachineEmitter::emit_exits(Part& part) {
    for (std::size_t i = 0; i < part.chart.places.size(); ++i) {
        const Place& place = part.chart.places[i];
        if (place.kind != NodeKind::state && place.kind != NodeKind::final) continue;
        if (place.composite) {
            emit_composite_exit(part, i);
            continue;
        }
        const std::string exit = region_at(part, i).exit;
        add_command(tree::command("", tree::all_of({at_point(part, i, part.points[i]), tree::is(exit, sub_act)}),
                                  {tree::set(exit, sub_exited)}));
    }
}

/// Emits the exit of a composite state. R10: "(2) ACT_* -> Sub_ACT; (3) composite substate: Sub_ACT -> Sub_ACT_Waiting
/// & its exit'=ACT_Parent; (5) Sub_EXITED -> EXITED & scpc'=INACTIVE; (6) child EXITED & parent Waiting -> child NONE &
/// parent Sub_EXITED", one unlabelled step each.
void MachineEmitter::emit_composite_exit(Part& part, std::size_t place) {
    const Region& inner = part.regions[part.region_of.at(place)];
    const std::string outer = region_at(part, place).exit;
    const ExprPtr here = at_point(part, place, part.points[place]);
    const ExprPtr requested =
        tree::apply(prism::Op::disjunction, {tree::is(inner.exit, act_parent), tree::is(inner.exit, act_trans)});
    add_command(tree::command("", tree::all_of({here, requested}), {tree::set(inner.exit, sub_act)}));
    add_command(tree::command("", tree::all_of({here, tree::is(outer, sub_act)}),
                              {tree::set(outer, waiting), tree::set(inner.exit, act_parent)}));
    add_command(tree::command("", tree::all_of({here, tree::is(inner.exit, sub_exited)}),
                              {tree::set(inner.exit, exited), tree::set(inner.pc, inner.inactive)}));
    add_command(tree::command("", tree::all_of({here, tree::is(inner.exit, exited), tree::is(outer, waiting)}),
                              {tree::set(inner.exit, none), tree::set(outer, sub_exited)}));
}

}  // namespace robochart::prism_emit
