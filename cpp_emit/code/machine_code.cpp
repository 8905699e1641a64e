// Puts a machine's code together: threads as switches, the loop around them, time, the struct of its state.
#include "cpp_emit/code/machine_code.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cpp_emit/code/dispatch.hpp"
#include "cpp_emit/code/fault_injection.hpp"
#include "cpp_emit/code/machine_writer.hpp"
#include "cpp_emit/code/suspension.hpp"
#include "cpp_emit/expressions/expression.hpp"
#include "cpp_emit/plan/types.hpp"
#include "semantics/instantiate/instantiate.hpp"

namespace robochart::cpp_emit {

using ir::NodeId;

namespace {

std::set<std::string> taken_fields(const Generation& generation, const Unit& unit) {
    std::set<std::string> taken = never_members(generation.system, generation.component);
    taken.insert(unit.clock_fields.begin(), unit.clock_fields.end());
    taken.insert(unit.variable_fields.begin(), unit.variable_fields.end());
    if (!unit.root) return taken;
    for (const auto& variable : generation.component.variables) taken.insert(variable.field);
    for (const auto& buffer : generation.component.buffers) taken.insert(buffer.field);
    return taken;
}

/// Enumerations have one byte up to 256 values.
std::size_t enumeration_size(std::size_t values) {
    return values <= 256 ? 1 : 2;
}

}  // namespace

MachineWriter::MachineWriter(const Generation& generation, const Unit& unit, const Layouts& done, NameScope& type_names)
    : generation_(generation),
      unit_(unit),
      done_(done),
      plan_(generation, unit),
      fields_(taken_fields(generation, unit)) {
    const std::string& prefix = unit.prefix;
    control_.variable = "f.at";
    control_.enumeration = unit.points;
    control_.wait = "f.wait";
    control_.labels = &plan_.place_labels();
    control_.fields = &fields_;
    proceeds_.resize(unit.machine->transitions.size());
    leaving_ = plan_.has_noted_leaving() ? type_names.unique(prefix + "Leaving") : "";
    for (std::uint32_t index = 0; index < unit.machine->transitions.size(); ++index) {
        const ir::Transition& transition = unit.machine->transitions[index];
        const bool state = plan_.node(transition.source).kind == ir::NodeKind::state;
        if (transition.deadline && state)
            watches_.push_back(
                {ir::TransitionId{index}, transition.source, fields_.unique("deadline_of_" + transition.name)});
    }
    std::size_t durings = 0;
    for (const auto& node : unit.machine->nodes) durings += node.during ? 1U : 0U;
    during_.reserve(durings);  // threads point at their own labels
    for (std::uint32_t index = 0; index < unit.machine->nodes.size(); ++index) {
        const NodeId id{index};
        if (!plan_.node(id).during || runs_on_entry(id)) continue;
        DuringThread& during = during_.emplace_back();
        during.state = id;
        during.suffix = plan_.label(id);
        during.labels = NameScope(std::set<std::string>{"idle", "start"});
        during.thread.variable = "f.during_" + during.suffix;
        during.thread.enumeration = type_names.unique(prefix + "During_" + during.suffix);
        during.thread.wait = "f.wait_" + during.suffix;
        during.thread.prefix = during.suffix + "_";
        during.thread.labels = &during.labels;
        during.thread.fields = &fields_;
    }
}

std::string MachineWriter::signature(const std::string& name) const {
    return fmt::format("{}({}) noexcept {{", name, frame_parameters(generation_.component, unit_));
}

std::string MachineWriter::call(const std::string& name) const {
    return fmt::format("{}({})", name, frame_arguments(generation_.component, unit_));
}

MachineCode MachineWriter::write(const std::vector<Field>& more) {
    if (!plan_.machine().initial.valid()) return {enumerations(), layout(more), {}, {}, {}, {}};
    during_places();
    control_places();
    thread_function(control_, "control",
                    "Actions and junctions of " + unit_.machine->name + ", until it settles or has to wait.", true);
    during_functions();
    transition_functions();
    begin_exits_function();
    watch_function();
    advance_function();
    run_function();
    MachineCode code;
    code.methods = out_.text();
    if (direct() && !input_events(generation_.component).empty()) {
        out_ = CodeWriter(1);
        dispatch_function();
        code.dispatch = out_.text();
    }
    code.enumerations = enumerations();
    code.layout = layout(more);
    const auto collect = [&](const Thread& thread) {
        code.sites.insert(code.sites.end(), thread.sites.begin(), thread.sites.end());
        code.calls.insert(code.calls.end(), thread.calls.begin(), thread.calls.end());
    };
    collect(control_);
    for (const DuringThread& during : during_) collect(during.thread);
    return code;
}

void MachineWriter::thread_function(const Thread& thread, const std::string& name,
                                    const diagnostics::ForeignText& comment, bool control) {
    out_.gap();
    out_.doc(comment);
    out_.open(signature("bool " + name));
    out_.line("bool moved = false;");
    out_.open("for (;;) {");
    out_.open(fmt::format("switch ({}) {{", thread.variable));
    if (!control) out_.line(fmt::format("case {}: return moved;", thread.at("idle")));
    for (std::uint32_t index = 0; control && index < plan_.machine().nodes.size(); ++index)
        if (plan_.settles(NodeId{index}))
            out_.line(fmt::format("case {}: return moved;", thread.at(plan_.label(NodeId{index}))));
    for (const Place& place : thread.places) {
        out_.comment(place.comment);
        out_.line(fmt::format("case {}:", thread.at(place.label)));
        out_.raw(place.code.text());
    }
    out_.close();
    out_.line("moved = true;");
    if (!bound_test(generation_).empty()) out_.line("if (!spend()) return true;");
    out_.close();
    out_.close();
    if (!thread.helpers.empty()) {
        out_.gap();
        out_.raw(thread.helpers.text());
    }
}

void MachineWriter::during_functions() {
    if (during_.empty()) return;
    for (const DuringThread& during : during_) {
        const diagnostics::ForeignText place = generation_.place(plan_.node(during.state).origin);
        thread_function(during.thread, "during_" + during.suffix,
                        "During action of " + place + ": once an entry, as far as it gets.", false);
        out_.gap();
        out_.doc("The state is left: what remains of its during action is cut.");
        out_.open(fmt::format("static void cut_{}({}& f) noexcept {{", during.suffix, frame_type()));
        out_.line(during.thread.go("idle"));
        if (during.thread.waits) out_.line(during.thread.wait + " = 0;");
        for (const std::string& deadline : during.thread.deadlines) out_.line(fmt::format("f.{} = 0;", deadline));
        for (const CallFrame& call : during.thread.calls) out_.line(fmt::format("f.{} = {{}};", call.field));
        out_.close();
    }
    out_.gap();
    out_.doc("During actions of the active states, outer states first.");
    out_.open(signature("bool during"));
    out_.line("bool moved = false;");
    for (const DuringThread& during : during_)
        out_.line(fmt::format("moved = {} || moved;", call("during_" + during.suffix)));
    out_.line("return moved;");
    out_.close();
}

/// Where the exits begin: at the innermost active state.
void MachineWriter::begin_exits_function() {
    const auto composite_exit = [&](NodeId id) { return plan_.shared_exit(id) && plan_.node(id).composite(); };
    std::vector<NodeId> leaves;
    for (const NodeId top : plan_.machine().top) {
        for (const NodeId leaf : plan_.leaves(top)) {
            const std::vector<NodeId> around = plan_.ancestors(leaf);
            if (std::any_of(around.begin(), around.end(), composite_exit)) leaves.push_back(leaf);
        }
    }
    if (leaves.empty()) return;
    out_.gap();
    out_.doc("Begins the exits of a composite state at the innermost active state.");
    out_.open(fmt::format("static void leave({}& f) noexcept {{", frame_type()));
    out_.open("switch (f.at) {");
    for (const NodeId leaf : leaves) {
        const NodeId first = plan_.node(leaf).kind == ir::NodeKind::final ? plan_.node(leaf).parent : leaf;
        out_.line(
            fmt::format("case {}: {} return;", control_.at(plan_.label(leaf)), control_.go(plan_.exit_label(first))));
    }
    out_.line("default: return;");
    out_.close();
    out_.close();
}

bool MachineWriter::timed() const {
    const auto& read = unit_.clock_read;
    const auto timed_calls = [&](const Thread& thread) {
        return thread.waits || !thread.deadlines.empty() ||
               std::any_of(thread.calls.begin(), thread.calls.end(),
                           [&](const CallFrame& call) { return done_.at(call.operation).timed; });
    };
    return std::find(read.begin(), read.end(), true) != read.end() || !watches_.empty() || timed_calls(control_) ||
           std::any_of(during_.begin(), during_.end(),
                       [&](const DuringThread& during) { return timed_calls(during.thread); });
}

void MachineWriter::advance_function() {
    if (!timed()) return;
    out_.gap();
    out_.doc("Time passes: clocks, waits and deadlines.");
    out_.open(signature("void advance"));
    for (const Watch& watch : watches_) advance_watch(watch);
    for (std::uint32_t index = 0; index < unit_.clock_fields.size(); ++index) {
        if (!unit_.clock_read[index]) continue;
        const std::int64_t saturation =
            std::min(generation_.inst.clock_bound,
                     ir::clock_saturation(generation_.system, generation_.inst, *unit_.machine, ir::ClockId{index}));
        advance_clock(unit_.clock_fields[index], saturation);
    }
    advance_thread(control_);
    for (const DuringThread& during : during_) advance_thread(during.thread);
    if (guards_deadlines(*unit_.machine)) out_.line(call("watch") + ";");
    out_.close();
}

void MachineWriter::advance_clock(const std::string& clock, std::int64_t saturation) {
    out_.line(fmt::format("advance_clock(f.{}, cycle_length, {});", clock, saturation));
}

void MachineWriter::advance_thread(const Thread& thread) {
    if (thread.waits) out_.line(fmt::format("advance_wait({}, cycle_length);", thread.wait));
    for (const std::string& deadline : thread.deadlines)
        out_.line(fmt::format("advance_deadline(f.{}, cycle_length);", deadline));
    for (const CallFrame& call : thread.calls) {
        if (!done_.at(call.operation).timed) continue;
        std::vector<std::string> running;
        for (const auto& label : call.live)
            running.push_back(fmt::format("{} == {}", thread.variable, thread.at(label)));
        const Unit& operation = generation_.component.unit(call.operation);
        out_.line(fmt::format("if ({}) advance({});", fmt::join(running, " || "),
                              frame_arguments(generation_.component, operation, unit_, "f." + call.field)));
    }
}

std::string MachineWriter::holds(const ir::Transition& transition) const {
    ExpressionWriter expressions(generation_, unit_);
    const bool stores = transition.trigger && transition.trigger->variable.valid();
    if (stores) expressions.set_incoming(expressions.variable(transition.trigger->variable));
    return expressions.expression_asked(*transition.guard).whole();
}

/// The guard is looked at wherever the model could be found waiting: after each step, before what others see, and
/// when clocks have gone on.
void MachineWriter::watch_function() {
    if (!guards_deadlines(*unit_.machine)) return;
    out_.gap();
    out_.doc("A deadline begins anew while its guard does not hold.");
    out_.open(signature("void watch"));
    for (const Watch& watch : watches_) {
        const ir::Transition& transition = plan_.machine().transitions[watch.transition.index];
        if (!transition.guard) continue;
        const std::string anew = start_of(watch);
        out_.line(fmt::format("if (f.{} > 0 && !({})) {}", watch.field, holds(transition), anew));
    }
    out_.close();
}

void MachineWriter::advance_watch(const Watch& watch) {
    const ir::Transition& transition = plan_.machine().transitions[watch.transition.index];
    const std::string advance = fmt::format("advance_deadline(f.{}, cycle_length);", watch.field);
    out_.line(transition.guard ? fmt::format("if ({}) {}", holds(transition), advance) : advance);
}

std::string MachineWriter::start_of(const Watch& watch) const {
    const ir::Transition& transition = plan_.machine().transitions[watch.transition.index];
    return watch_from(generation_, unit_, watch.field, *transition.deadline);
}

std::string MachineWriter::finished(const std::string& frame) const {
    std::vector<std::string> places;
    for (const NodeId id : plan_.finals())
        places.push_back(fmt::format("{}.at == {}", frame, control_.at(plan_.label(id))));
    return places.empty() ? "false" : fmt::format("{}", fmt::join(places, " || "));
}

void MachineWriter::run_function() {
    out_.gap();
    const std::string during = during_.empty() ? "" : " || " + call("during");
    const std::string parts = fmt::format("{}{} || {}", call("control"), during, call("transition"));
    const bool watches = guards_deadlines(*unit_.machine);
    if (unit_.root) {
        if (generation_.component.composed()) {
            out_.doc(fmt::format("One round of {}: as far as it gets without the others.", unit_.machine->name));
            out_.open(signature("bool round"));
            if (watches) out_.line(call("watch") + ";");
            out_.line(fmt::format("return {};", parts));
        } else {
            run_alone(parts, watches);
        }
        out_.close();
        out_.gap();
        out_.open(
            fmt::format("[[nodiscard]] static bool finished([[maybe_unused]] const {}& f) noexcept {{", frame_type()));
        out_.line(fmt::format("return {};", finished("f")));
        return out_.close();
    }
    out_.doc(fmt::format("Runs operation {}; true when it has finished.", unit_.machine->name));
    out_.open(fmt::format("bool run({}, bool& moved) noexcept {{", frame_parameters(generation_.component, unit_)));
    if (watches) out_.line(call("watch") + ";");
    out_.open(fmt::format("while ({}({})) {{", bound_test(generation_), parts));
    if (watches) out_.line(call("watch") + ";");
    out_.line("moved = true;");
    out_.close();
    out_.line(fmt::format("return {};", finished("f")));
    out_.close();
}

void MachineWriter::run_alone(const std::string& parts, bool watches) {
    out_.doc("Everything that can happen in this cycle.");
    out_.open(signature("void run"));
    if (watches) out_.line(call("watch") + ";");
    out_.open(fmt::format("while ({}({})) {{", bound_test(generation_), parts));
    if (watches) out_.line(call("watch") + ";");
    out_.close();
}

std::vector<Field> MachineWriter::variable_fields() const {
    std::vector<Field> fields;
    const auto add = [&](const std::string& name, const ir::Variable& variable, const ir::Value& initial) {
        const Extent extent = cpp_extent(generation_.system, generation_.inst, variable.type);
        fields.push_back({cpp_type(generation_.system, variable.type), name,
                          cpp_value(generation_.system, generation_.inst, variable.type, initial),
                          generation_.place(variable.origin), extent.size, extent.alignment});
    };
    const std::size_t home = generation_.component.composed() ? unit_.part : no_part;
    for (const auto& stored : generation_.component.variables)
        if (unit_.root && stored.stored() && stored.home == home) add(stored.field, *stored.variable, stored.initial);
    for (std::size_t index = 0; index < unit_.variable_fields.size(); ++index) {
        if (unit_.variable_fields[index].empty()) continue;
        add(unit_.variable_fields[index], unit_.machine->variables[index], unit_.initials[index]);
    }
    return fields;
}

void MachineWriter::thread_field(std::vector<Field>& fields, const Thread& thread, const std::string& wait) const {
    if (thread.waits) fields.push_back({"std::uint32_t", wait, "0", "time units left to wait", 4, 4});
    for (const std::string& deadline : thread.deadlines)
        fields.push_back({"std::uint32_t", deadline, "0", "time left plus one, 0: none", 4, 4});
    for (const CallFrame& call : thread.calls) {
        const FrameLayout& inner = done_.at(call.operation);
        fields.push_back({generation_.component.unit(call.operation).frame + "<Types>", call.field, "", "", inner.size,
                          inner.alignment});
    }
}

std::vector<Field> MachineWriter::thread_fields() const {
    std::vector<Field> fields;
    const std::size_t size = enumeration_size(points().values.size());
    const ir::NodeId initial = plan_.machine().initial;
    const std::string first = control_.at(initial.valid() ? plan_.label(initial) : "idle");
    fields.push_back({unit_.points, "at", first, "", size, size});
    thread_field(fields, control_, "wait");
    for (const Watch& watch : watches_)
        fields.push_back({"std::uint32_t", watch.field, "0", "time left plus one, 0: not active", 4, 4});
    if (!leaving_.empty())
        fields.push_back({leaving_, "leaving", leaving_ + "::nothing", "transition being taken", 1, 1});
    for (const DuringThread& during : during_) {
        fields.push_back({during.thread.enumeration, "during_" + during.suffix, during.thread.at("idle"), "", 1, 1});
        thread_field(fields, during.thread, "wait_" + during.suffix);
    }
    for (std::uint32_t index = 0; index < plan_.machine().nodes.size(); ++index) {
        const NodeId id{index};
        if (plan_.node(id).composite() && plan_.notes_entry(id))
            fields.push_back(
                {"bool", "entering_" + plan_.label(id), "false", "its first child is still to be entered", 1, 1});
    }
    for (const NodeId id : histories_)
        fields.push_back({unit_.points, "history_" + plan_.label(id), first, "", size, size});
    return fields;
}

FrameLayout MachineWriter::layout(const std::vector<Field>& more) {
    std::vector<Field> fields = variable_fields();
    fields.insert(fields.end(), more.begin(), more.end());
    for (std::size_t index = 0; index < unit_.clock_fields.size(); ++index)
        if (unit_.clock_read[index])
            fields.push_back({"std::uint32_t", unit_.clock_fields[index], "0",
                              "clock " + generation_.place(unit_.machine->clocks[index].origin), 4, 4});
    const std::vector<Field> threads = thread_fields();
    fields.insert(fields.end(), threads.begin(), threads.end());
    return arrange(std::move(fields), timed());
}

/// The values of Frame::at: nodes in which control rests, places of programs that may wait.
Enumeration MachineWriter::points() const {
    Enumeration at{
        unit_.points, fmt::format("Where {} is: in a node, or in the middle of a program.", unit_.machine->name), {}};
    const NodeId initial = plan_.machine().initial;
    if (!initial.valid()) {
        at.values.push_back({"idle", "no body", {}});
        return at;
    }
    const auto is_place = [&](const std::string& label) {
        return std::any_of(control_.places.begin(), control_.places.end(),
                           [&](const Place& place) { return place.label == label; });
    };
    const auto node_value = [&](NodeId id) {
        const bool state = plan_.node(id).kind == ir::NodeKind::state;
        at.values.push_back(
            {plan_.label(id), generation_.place(plan_.node(id).origin), state ? id : plan_.node(id).parent});
    };
    node_value(initial);  // zero: where a fresh state struct stands
    for (std::uint32_t index = 0; index < plan_.machine().nodes.size(); ++index) {
        const NodeId id{index};
        if (id != initial && (plan_.settles(id) || is_place(plan_.label(id)))) node_value(id);
    }
    const std::size_t nodes = at.values.size();
    const auto is_node = [&](const std::string& label) {
        return std::any_of(at.values.begin(), at.values.begin() + static_cast<std::ptrdiff_t>(nodes),
                           [&](const Enumerator& value) { return value.name == label; });
    };
    for (const Place& place : control_.places)
        if (!is_node(place.label)) at.values.push_back({place.label, place.comment, place.state});
    return at;
}

std::vector<Enumeration> MachineWriter::enumerations() const {
    const Enumeration at = points();
    if (!plan_.machine().initial.valid()) return {at};
    std::vector<Enumeration> result = {at};
    for (const DuringThread& during : during_) {
        Enumeration each{
            during.thread.enumeration, "How far the during action of " + during.suffix + " is.", {{"idle", "", {}}}};
        for (const Place& place : during.thread.places)
            each.values.push_back({place.label, place.comment, place.state});
        result.push_back(std::move(each));
    }
    if (leaving_.empty()) return result;
    Enumeration leaving{leaving_, "The transition whose exits are running.", {{"nothing", "", {}}}};
    for (std::uint32_t index = 0; index < plan_.machine().transitions.size(); ++index) {
        const ir::Transition& transition = plan_.machine().transitions[index];
        if (plan_.notes_leaving(transition.source))
            leaving.values.push_back(
                {plan_.take_label(ir::TransitionId{index}), generation_.place(transition.origin), {}});
    }
    result.push_back(std::move(leaving));
    return result;
}

FrameLayout arrange(std::vector<Field> fields, bool timed) {
    std::stable_sort(fields.begin(), fields.end(),
                     [](const Field& a, const Field& b) { return a.alignment > b.alignment; });
    FrameLayout layout;
    layout.timed = timed;
    for (const Field& field : fields) {
        layout.size += field.size;
        layout.alignment = std::max(layout.alignment, field.alignment);
    }
    if (const std::size_t rest = layout.size % layout.alignment; rest != 0) {
        const std::size_t filler = layout.alignment - rest;
        fields.push_back(
            {"std::uint8_t", fmt::format("filler[{}]", filler), "{}", "keeps the bytes canonical", filler, 1});
        layout.size += filler;
    }
    layout.fields = std::move(fields);
    return layout;
}

MachineCode generate(const Generation& generation, const Unit& unit, const Layouts& done, NameScope& type_names,
                     const std::vector<Field>& more) {
    return MachineWriter(generation, unit, done, type_names).write(more);
}

}  // namespace robochart::cpp_emit
