// The machine's module: RoboTool's channels, event sets and process variants (semantics 3.2, 3.12) around our points.
#include <algorithm>
#include <set>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/machine/machine.hpp"
#include "csp_emit/base/types.hpp"
#include "csp_emit/base/variants.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::DeclPtr;
using cspm::ExprPtr;
using ir::NodeKind;

void MachineEmitter::mean(const std::string& event, EventMeaning meaning) {
    meaning.component = context_.path;
    emitted_.provenance.events[context_.path + "::" + event] = std::move(meaning);
}

/// `id__`, the operation's parameters, then the constants in order of declaration (semantics 3.12), given by name.
std::vector<std::string> MachineEmitter::parameters_with(const std::vector<std::string>& constants) const {
    std::vector<std::string> result{"id__"};
    for (const CellId cell : frames_[0].variables)
        if (cells_[cell].parameter) result.push_back(cells_[cell].name);
    result.insert(result.end(), constants.begin(), constants.end());
    return result;
}

std::vector<std::string> MachineEmitter::constants_inside() const {
    std::vector<std::string> result;
    for (const ConstantParameter& constant : constants_) result.push_back(constant.inside);
    return result;
}

ExprPtr MachineEmitter::call_of(const std::string& name, const std::vector<std::string>& parameters) {
    b::Exprs arguments;
    for (const std::string& parameter : parameters) arguments.push_back(b::name(parameter));
    return b::call(name, arguments);
}

/// States and final states, whose `entered` is an event.
std::vector<ir::NodeId> MachineEmitter::states() const {
    std::vector<ir::NodeId> result;
    for (std::uint32_t i = 0; i < machine().nodes.size(); ++i)
        if (machine().nodes[i].kind == NodeKind::state || machine().nodes[i].kind == NodeKind::final)
            result.push_back({i});
    return result;
}

DeclPtr MachineEmitter::module(std::vector<DeclPtr> points, const ExprPtr& initial) {
    std::vector<DeclPtr> decls;
    declare_channels(decls);
    declare_mentioned(decls);
    declare_clocks(decls);
    declare_calls(decls);
    declare_states(decls);
    declare_sets(decls);
    declare_watch(decls);
    decls.insert(decls.end(), points.begin(), points.end());
    declare_variants(decls, initial);
    const bool operation = machine().kind == ir::MachineKind::operation;
    return b::module_(context_.name, {}, {}, decls,
                      (operation ? "operation " : "state machine ") + machine().origin.element);
}

void MachineEmitter::declare_channels(std::vector<DeclPtr>& decls) {
    if (machine().kind == ir::MachineKind::state_machine) decls.push_back(b::channel({"terminate"}));
    mean("terminate", {MeaningKind::terminate, machine().name + " terminates", {}, machine().origin});
    ChannelDeclarations channels(project(), context_.path, emitted_.provenance, decls);
    for (const ir::Event& event : machine().events) channels.event(event);
    for (std::size_t i = 0; i < machine().variables.size(); ++i) {
        const Cell& cell = cells_[frames_[0].variables[i]];
        if (cell.shared) channels.variable(cell.channel, cell.type, true, machine().variables[i].origin);
    }
    if (!transition_of_.empty()) {
        std::vector<cspm::Constructor> constructors;
        for (const auto& [place, name] : transition_of_) constructors.push_back(b::constructor(name));
        decls.push_back(b::datatype("TIDS", constructors, "transitions without trigger"));
        decls.push_back(b::channel({"internal__"}, b::name("TIDS")));
    }
    if (!step_of_.empty()) {
        const auto last = static_cast<std::int64_t>(step_of_.size()) - 1;
        decls.push_back(b::channel({"step__"}, b::set_range(b::number(0), b::number(last)), "steps of actions"));
    }
    for (DeclPtr& channel : memory_channels(remembered_)) decls.push_back(std::move(channel));
}

/// Channels of RoboTool's that are nothing here, private or plumbing, but that CSP blocks may name (semantics 3.2).
void MachineEmitter::declare_mentioned(std::vector<DeclPtr>& decls) {
    for (std::size_t i = 0; i < machine().variables.size(); ++i) {
        const ir::Variable& variable = machine().variables[i];
        const bool shared = cells_[frames_[0].variables[i]].shared;
        for (const char* prefix : {"get_", "set_", "set_EXT_", "setL_", "setR_"}) {
            const bool declared = shared && (std::string(prefix) == "set_" || std::string(prefix) == "set_EXT_");
            if (declared || !project().mentions(prefix + variable.name)) continue;
            decls.push_back(b::channel({prefix + variable.name}, type_set(project(), variable.type)));
        }
    }
}

/// Resets that are events, clocks that are asked for, and the values of clocks where CSP blocks name them.
void MachineEmitter::declare_clocks(std::vector<DeclPtr>& decls) {
    if (!timed()) return;
    std::vector<cspm::Constructor> constructors;
    b::Exprs local;
    const Frame& root = frames_[0];
    for (std::uint32_t i = 0; i < machine().clocks.size(); ++i) {
        const ir::Clock& clock = machine().clocks[i];
        const std::string name = "CLID_" + flatten(clock.name);
        const std::string reading = "get_" + name;
        if (const std::string* reset = announced(0, {i})) {
            constructors.push_back(b::constructor(*reset));
            const ExprPtr event = b::dot({b::name("clockReset"), b::name(*reset)});
            mean("clockReset." + context_.path + "::" + *reset,
                 {MeaningKind::step, "reset of " + clock.name, {}, clock.origin});
            (is_callers(clock) ? clock_events_ : local).push_back(event);
        }
        const bool read = root.clocks[i] && !cells_[*root.clocks[i]].reading.empty();
        if (read) {
            clock_events_.push_back(b::name(reading));
            mean(reading, {MeaningKind::step, "since(" + clock.name + ") is read", {}, clock.origin});
        }
        if (read || project().mentions(reading)) decls.push_back(b::channel({reading}, b::name("core_clock_type")));
        if (!project().mentions(name + "_clock_type")) continue;
        std::vector<std::string> parameters{"id__"};
        for (const ConstantParameter& constant : constants_) parameters.push_back(constant.inside);
        const ExprPtr limit = root.clocks[i] ? cells_[*root.clocks[i]].limit : b::number(1);
        decls.push_back(
            b::function_decl(name + "_clock_type", b::variables(parameters), b::set_range(b::number(0), limit)));
    }
    if (constructors.empty()) return;
    decls.push_back(b::datatype("ClockSet", constructors));
    decls.push_back(b::channel({"clockReset"}, b::name("ClockSet")));
    local_resets_ = !local.empty();
    if (local_resets_) decls.push_back(b::value("localClockResets", b::productions(local)));
}

void MachineEmitter::declare_calls(std::vector<DeclPtr>& decls) {
    ChannelDeclarations channels(project(), context_.path, emitted_.provenance, decls);
    for (const ir::OperationSignature& operation : machine().operations) {
        if (context_.definitions.count(operation.name) != 0) continue;
        channels.call(operation);
        calls_.push_back(operation.name);
    }
}

void MachineEmitter::declare_states(std::vector<DeclPtr>& decls) {
    for (const ir::NodeId node : machine().top)
        if (DeclPtr state = state_module(node)) decls.push_back(state);
}

/// `module S exports channel entered ... endmodule`, inner states inside.
DeclPtr MachineEmitter::state_module(ir::NodeId id) {
    const ir::Node& node = machine().nodes[id.index];
    if (node.kind != NodeKind::state && node.kind != NodeKind::final) return nullptr;
    std::vector<DeclPtr> decls{b::channel({"entered"})};
    mean(node.path + "::entered", {MeaningKind::entered, "entered " + node.path, {}, node.origin});
    for (const ir::NodeId child : node.children)
        if (DeclPtr inner = state_module(child)) decls.push_back(inner);
    return b::module_(node.name, {}, {}, decls);
}

void MachineEmitter::declare_sets(std::vector<DeclPtr>& decls) {
    b::Exprs visible;
    b::Exprs entered;
    if (machine().kind == ir::MachineKind::state_machine) visible.push_back(b::name("terminate"));
    for (const CellId cell : frames_[0].variables) {
        if (!cells_[cell].shared) continue;
        visible.push_back(b::name("set_EXT_" + cells_[cell].channel));
        visible.push_back(b::name("set_" + cells_[cell].channel));
    }
    for (const ir::Event& event : machine().events) visible.push_back(b::name(event.name));
    for (const std::string& call : calls_) visible.push_back(b::name(call + "Call"));
    visible.insert(visible.end(), clock_events_.begin(), clock_events_.end());
    for (const ir::NodeId state : states()) entered.push_back(b::name(machine().nodes[state.index].path + "::entered"));
    b::Exprs hidden;
    if (!transition_of_.empty()) hidden.push_back(b::name("internal__"));
    if (!step_of_.empty()) hidden.push_back(b::name("step__"));
    for (const ExprPtr& channel : visible)
        if (channel->kind == cspm::ExprKind::name) visible_.push_back(channel->text);
    decls.push_back(b::value("sem__events", b::productions(visible)));
    decls.push_back(b::value("shared_variable_events", b::productions(external_write_events())));
    decls.push_back(b::value("enteredSS", b::productions(entered)));
    decls.push_back(b::value("internal_events", b::productions(hidden)));
}

/// D__, O__, VS__, VS_O__, FVS__, HEXT__, HUP__ (semantics 3.12).
void MachineEmitter::declare_variants(std::vector<DeclPtr>& decls, const ExprPtr& initial) {
    std::vector<std::string> constants;
    for (const ConstantParameter& constant : constants_) constants.push_back(constant.parameter);
    const auto parameters = parameters_with(constants);
    const auto define = [&](const std::string& name, const ExprPtr& process) {
        decls.push_back(b::function_decl(name, b::variables(parameters), process));
    };
    const auto of = [&](const std::string& name) { return call_of(name, parameters); };
    const ExprPtr within = b::name("internal_events");
    const ExprPtr inside = local_resets_ ? b::call("union", {within, b::name("localClockResets")}) : within;
    decls.push_back(b::function_decl("STM__", b::variables(parameters_with(constants_inside())),
                                     with_memories(initial, remembered_, timed())));
    if (project().mentions("FVS_C__")) define("FVS_C__", maximal_progress(project(), b::hide(of("STM__"), within)));
    define("FVS__", maximal_progress(project(), b::hide(of("STM__"), inside)));
    define("D__", maximal_progress(project(), b::hide(of("STM__"), b::call("union", {inside, b::name("enteredSS")}))));
    define("O__", compressed(project(), of("D__"), !remembered_.empty()));
    define("VS__", of("FVS__"));
    define("VS_O__", compressed(project(), of("VS__"), !remembered_.empty()));
    define("HEXT__", b::parallel(of("O__"), b::name("shared_variable_events"), b::skip()));
    define("HUP__", of("O__"));
}

}  // namespace robochart::csp_emit
