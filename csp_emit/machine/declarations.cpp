// SPDX-License-Identifier: Apache-2.0
// Writes the declarations of a machine's module, in the order in which they occur in the module.
#include "csp_emit/machine/declarations.hpp"

#include <set>
#include <string>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/base/registers.hpp"
#include "csp_emit/base/types.hpp"
#include "csp_emit/base/variants.hpp"
#include "csp_emit/machine/rules/shared_variables.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::DeclPtr;
using cspm::ExprPtr;
using ir::NodeKind;

std::vector<std::string> parameters_with(const MachineTables& tables, const std::vector<std::string>& constants) {
    std::vector<std::string> result{"id__"};
    for (const CellId cell : tables.frames.root_frame().variables)
        if (tables.cells[cell].parameter) result.push_back(tables.cells[cell].name);
    result.insert(result.end(), constants.begin(), constants.end());
    return result;
}

/// Returns the states and final states. Each has an event `entered`.
std::vector<ir::NodeId> ModuleDeclarations::entered_states() const {
    std::vector<ir::NodeId> result;
    for (std::uint32_t i = 0; i < tables_.machine().nodes.size(); ++i)
        if (tables_.machine().nodes[i].kind == NodeKind::state || tables_.machine().nodes[i].kind == NodeKind::final)
            result.push_back({i});
    return result;
}

DeclPtr ModuleDeclarations::make_module(const std::vector<DeclPtr>& points, const ExprPtr& initial) {
    std::vector<DeclPtr> decls;
    declare_channels(decls);
    declare_mentioned(decls);
    declare_clocks(decls);
    declare_calls(decls);
    declare_states(decls);
    declare_sets(decls);
    tables_.watch.declare(decls);
    if (!tables_.context.offered.empty())
        decls.push_back(b::channel({"inside__", "outside__", "refused__", "missed__"}));
    if (const std::size_t facts = tables_.context.shown.size(); facts > 0) {
        decls.push_back(b::channel({"shown__"}, b::dot(b::Exprs(facts, b::name("Bool")))));
        tables_.record_meaning("shown__", {MeaningKind::memory, "what a claim reads", {}, tables_.machine().origin});
    }
    decls.insert(decls.end(), points.begin(), points.end());
    declare_variants(decls, initial);
    const bool operation = tables_.machine().kind == ir::MachineKind::operation;
    return b::module_(tables_.context.name, {}, {}, decls,
                      (operation ? "operation " : "state machine ") + tables_.machine().origin.element);
}

void ModuleDeclarations::declare_channels(std::vector<DeclPtr>& decls) {
    if (tables_.machine().kind == ir::MachineKind::state_machine) decls.push_back(b::channel({"terminate"}));
    tables_.record_meaning(
        "terminate", {MeaningKind::terminate, tables_.machine().name + " terminates", {}, tables_.machine().origin});
    ChannelDeclarations channels(tables_.project(), tables_.context.path, tables_.provenance, decls);
    if (tables_.machine().robosim)
        declare_cycle_channels(decls);
    else
        for (const ir::Event& event : tables_.machine().events) channels.declare_event(event);
    for (std::size_t i = 0; i < tables_.machine().variables.size(); ++i) {
        const Cell& cell = tables_.cells[tables_.frames.root_frame().variables[i]];
        if (cell.shared)
            channels.declare_variable(cell.channel, cell.type, true, tables_.machine().variables[i].origin);
    }
    tables_.events.declare_channels(decls);
    for (DeclPtr& channel : memory_channels(remembered_)) decls.push_back(std::move(channel));
}

/// RoboSim: declares the registers, and the beginning and the end of the execution.
void ModuleDeclarations::declare_cycle_channels(std::vector<DeclPtr>& decls) {
    Registers registers = registers_of(tables_.machine());
    if (is_operation()) registers.inputs.clear();  // without a cycle, no inputs are read
    declare_registers(tables_.project(), tables_.context.path, registers, {}, tables_.provenance, decls);
    decls.push_back(b::channel({"endexec", "startexec"}));
    const auto& origin = tables_.machine().origin;
    tables_.record_meaning("endexec", {MeaningKind::cycle_end, "the execution ends", {}, origin});
    tables_.record_meaning("startexec", {MeaningKind::step, "the execution begins", {}, origin});
}

/// Declares channels of RoboTool that this encoding does not use or hides, if CSP blocks mention them (semantics 3.2).
void ModuleDeclarations::declare_mentioned(std::vector<DeclPtr>& decls) const {
    std::set<std::string> declared;
    for (const CellId cell : tables_.frames.root_frame().variables)
        if (tables_.cells[cell].shared)
            for (const char* prefix : {"set_", "set_EXT_"}) declared.insert(prefix + tables_.cells[cell].channel);
    for (const ir::Variable& variable : tables_.machine().variables)
        for (const char* prefix : {"get_", "set_", "set_EXT_", "setL_", "setR_"}) {
            const std::string channel = prefix + variable.name;
            if (tables_.project().blocks_mention(channel) && declared.insert(channel).second)
                decls.push_back(b::channel({channel}, type_set(tables_.project(), variable.type)));
        }
}

/// Declares three things: the clock resets that are events, the clocks that events read, and the values of clocks that
/// CSP blocks mention.
void ModuleDeclarations::declare_clocks(std::vector<DeclPtr>& decls) {
    if (!tables_.timed()) return;
    std::vector<cspm::Constructor> constructors;
    b::Exprs local;
    const Frame& root = tables_.frames.root_frame();
    for (std::uint32_t i = 0; i < tables_.machine().clocks.size(); ++i) {
        const ir::Clock& clock = tables_.machine().clocks[i];
        const std::string name = "CLID_" + flatten_name(clock.name);
        const std::string reading = "get_" + name;
        if (const std::string* reset = tables_.frames.reset_constructor(0, {i})) {
            constructors.push_back(b::constructor(*reset));
            const ExprPtr event = b::dot({b::name("clockReset"), b::name(*reset)});
            tables_.record_meaning("clockReset." + tables_.context.path + "::" + *reset,
                                   {MeaningKind::step, "reset of " + clock.name, {}, clock.origin});
            (is_callers(tables_.machine(), clock) ? clock_events_ : local).push_back(event);
        }
        const bool read = root.clocks[i] && !tables_.cells[*root.clocks[i]].reading.empty();
        if (read) {
            clock_events_.push_back(b::name(reading));
            tables_.record_meaning(reading, {MeaningKind::step, "since(" + clock.name + ") is read", {}, clock.origin});
        }
        if (read || tables_.project().blocks_mention(reading))
            decls.push_back(b::channel({reading}, b::name("core_clock_type")));
        if (!tables_.project().blocks_mention(name + "_clock_type")) continue;
        std::vector<std::string> parameters = tables_.calls.constants_inside();
        parameters.insert(parameters.begin(), "id__");
        const ExprPtr limit = root.clocks[i] ? tables_.cells[*root.clocks[i]].limit : b::number(1);
        decls.push_back(
            b::function_decl(name + "_clock_type", b::variables(parameters), b::set_range(b::number(0), limit)));
    }
    if (constructors.empty()) return;
    decls.push_back(b::datatype("ClockSet", constructors));
    decls.push_back(b::channel({"clockReset"}, b::name("ClockSet")));
    local_resets_ = !local.empty();
    if (local_resets_) decls.push_back(b::value("localClockResets", b::productions(local)));
}

void ModuleDeclarations::declare_calls(std::vector<DeclPtr>& decls) {
    ChannelDeclarations channels(tables_.project(), tables_.context.path, tables_.provenance, decls);
    for (const ir::OperationSignature& operation : tables_.machine().operations) {
        if (tables_.context.definitions.count(operation.name) != 0 || operation.output) continue;
        channels.declare_call(operation);
        calls_.push_back(operation.name);
    }
}

void ModuleDeclarations::declare_states(std::vector<DeclPtr>& decls) {
    for (const ir::NodeId node : tables_.machine().top)
        if (DeclPtr state = state_module(node)) decls.push_back(state);
}

/// Returns `module S exports channel entered ... endmodule`, with the modules of inner states inside.
DeclPtr ModuleDeclarations::state_module(ir::NodeId id) {
    const ir::Node& node = tables_.machine().nodes[id.index];
    if (node.kind != NodeKind::state && node.kind != NodeKind::final) return nullptr;
    std::vector<DeclPtr> decls{b::channel({"entered"})};
    tables_.record_meaning(node.path + "::entered", {MeaningKind::entered, "entered " + node.path, {}, node.origin});
    for (const ir::NodeId child : node.children)
        if (DeclPtr inner = state_module(child)) decls.push_back(inner);
    return b::module_(node.name, {}, {}, decls);
}

void ModuleDeclarations::declare_sets(std::vector<DeclPtr>& decls) {
    b::Exprs visible;
    b::Exprs entered;
    if (tables_.machine().kind == ir::MachineKind::state_machine) visible.push_back(b::name("terminate"));
    for (const CellId cell : tables_.frames.root_frame().variables) {
        if (!tables_.cells[cell].shared) continue;
        visible.push_back(b::name("set_EXT_" + tables_.cells[cell].channel));
        visible.push_back(b::name("set_" + tables_.cells[cell].channel));
    }
    if (tables_.machine().robosim)
        add_cycle_events(visible);
    else
        for (const ir::Event& event : tables_.machine().events) visible.push_back(b::name(event.name));
    for (const std::string& call : calls_) visible.push_back(b::name(call + "Call"));
    visible.insert(visible.end(), clock_events_.begin(), clock_events_.end());
    for (const ir::NodeId state : entered_states())
        entered.push_back(b::name(tables_.machine().nodes[state.index].path + "::entered"));
    for (const ExprPtr& channel : visible) {
        const bool register_channel = channel->text == "registerRead" || channel->text == "registerWrite";
        // The constructors of a register channel replace the channel.
        const bool replaced = tables_.machine().robosim && register_channel;
        if (channel->kind == cspm::ExprKind::name && !replaced) visible_.push_back(channel->text);
    }
    decls.push_back(b::value("sem__events", b::productions(visible)));
    decls.push_back(b::value("shared_variable_events", b::productions(external_write_events(tables_))));
    decls.push_back(b::value("enteredSS", b::productions(entered)));
    decls.push_back(b::value("internal_events", b::productions(tables_.events.declared_channels())));
}

/// RoboSim: adds the events of the cycle. A machine hides the event for the beginning of the execution. For an
/// operation that is checked separately, this event is visible.
void ModuleDeclarations::add_cycle_events(b::Exprs& visible) {
    Registers registers = registers_of(tables_.machine());
    if (is_operation()) registers.inputs.clear();
    visible.push_back(b::name("endexec"));
    if (is_operation()) visible.push_back(b::name("startexec"));
    if (!registers.inputs.empty()) visible.push_back(b::name("registerRead"));
    if (!registers.outputs.empty()) visible.push_back(b::name("registerWrite"));
    visible_ = visible_registers(registers);
}

/// RoboSim: returns the machine in parallel with the process of its cycles,
///     (Cycle__(c) [| registers, startexec, endexec, terminate, tock |] machine) \ {startexec}.
ExprPtr ModuleDeclarations::in_cycles(const ExprPtr& machine, std::vector<DeclPtr>& decls) const {
    const Registers registers = registers_of(tables_.machine());
    b::Exprs reads, shared;
    std::vector<std::vector<ExprPtr>> writes;
    for (const Register& input : registers.inputs)
        reads.push_back(b::prefix(register_read("i_" + input.name), {b::input("x__")}, b::skip()));
    for (const Register& output : registers.outputs) writes.push_back({register_write("o_" + output.name)});
    if (!registers.inputs.empty()) shared.push_back(b::name("registerRead"));
    if (!registers.outputs.empty()) shared.push_back(b::name("registerWrite"));
    for (const char* event : {"startexec", "endexec", "terminate", "tock"}) shared.push_back(b::name(event));
    const ExprPtr execution = b::prefix(b::name("startexec"), writes_of_cycle(writes));
    decls.push_back(cycle_definition("Cycle__", "cycle__", b::interleave(reads), execution));
    std::string length;
    for (const ConstantParameter& constant : tables_.calls.constants())
        if (constant.constant == ir::cycle_length && constant.owner == &tables_.machine()) length = constant.inside;
    const ExprPtr frame = b::call("Cycle__", {b::name(length)});
    return b::hide(b::parallel(frame, b::productions(shared), machine), b::productions({b::name("startexec")}));
}

/// Declares D__, O__, VS__, VS_O__, FVS__, HEXT__ and HUP__ (semantics 3.12).
void ModuleDeclarations::declare_variants(std::vector<DeclPtr>& decls, const ExprPtr& initial) const {
    const ExprPtr machine = with_memories(initial, remembered_, tables_.timed());
    const bool cycles = tables_.machine().robosim && !is_operation();
    const ExprPtr whole = cycles ? in_cycles(machine, decls) : machine;
    std::vector<std::string> constants;
    for (const ConstantParameter& constant : tables_.calls.constants()) constants.push_back(constant.parameter);
    const auto parameters = parameters_with(tables_, constants);
    const auto define = [&](const std::string& name, const ExprPtr& process) {
        decls.push_back(b::function_decl(name, b::variables(parameters), process));
    };
    const auto of = [&](const std::string& name) { return call_of(name, parameters); };
    const ExprPtr within = b::name("internal_events");
    const ExprPtr inside = local_resets_ ? b::call("union", {within, b::name("localClockResets")}) : within;
    decls.push_back(
        b::function_decl("STM__", b::variables(parameters_with(tables_, tables_.calls.constants_inside())), whole));
    if (tables_.project().blocks_mention("FVS_C__"))
        define("FVS_C__", maximal_progress(tables_.project(), b::hide(of("STM__"), within)));
    define("FVS__", maximal_progress(tables_.project(), b::hide(of("STM__"), inside)));
    define("D__",
           maximal_progress(tables_.project(), b::hide(of("STM__"), b::call("union", {inside, b::name("enteredSS")}))));
    define("O__", compress_process(tables_.project(), of("D__"), !remembered_.empty()));
    define("VS__", of("FVS__"));
    define("VS_O__", compress_process(tables_.project(), of("VS__"), !remembered_.empty()));
    define("HEXT__", b::parallel(of("O__"), b::name("shared_variable_events"), b::skip()));
    define("HUP__", of("O__"));
}

}  // namespace robochart::csp_emit
