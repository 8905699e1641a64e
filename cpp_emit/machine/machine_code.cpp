// SPDX-License-Identifier: Apache-2.0
// Assembles a machine's code: threads as switches, the loop around them, time, and the struct of its state.
#include "cpp_emit/machine/machine_code.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cpp_emit/code/dispatch.hpp"
#include "cpp_emit/code/suspension.hpp"
#include "cpp_emit/expressions/expression.hpp"
#include "cpp_emit/machine/control_code.hpp"
#include "cpp_emit/machine/dispatch_code.hpp"
#include "cpp_emit/machine/propagation_code.hpp"
#include "cpp_emit/machine/transition_code.hpp"

namespace robochart::cpp_emit {

using ir::NodeId;

namespace {

class MachineWriter : private MachineCodePart {
public:
    explicit MachineWriter(MachineContext& context)
        : MachineCodePart(context),
          faults_(context),
          steps_(context, faults_),
          control_code_(context, faults_, steps_),
          transition_code_(context, faults_, steps_),
          time_(context, steps_),
          propagation_(context),
          frame_(context, time_),
          dispatch_code_(context, steps_, time_, frame_) {}

    [[nodiscard]] MachineCode write_machine(const std::vector<Field>& more);

private:
    void thread_function(const Thread&, const std::string& name, const diagnostics::ForeignText& comment, bool control);
    void during_functions();
    void begin_exits_function();
    void run_function();
    void run_alone(const std::string& parts, bool watches);
    [[nodiscard]] std::string finished_condition(const std::string& frame) const;

    OrderFaults faults_;
    ControlSteps steps_;
    ControlCode control_code_;
    TransitionCode transition_code_;
    TimeCode time_;
    PropagationCode propagation_;
    FrameCode frame_;
    DispatchCode dispatch_code_;
};

MachineCode MachineWriter::write_machine(const std::vector<Field>& more) {
    if (!plan_.machine().initial.is_valid()) {
        MachineCode nothing;
        nothing.enumerations = frame_.all_enumerations();
        nothing.layout = frame_.make_layout(more);
        return nothing;
    }
    control_code_.during_places();
    control_code_.control_places();
    thread_function(control_, "control",
                    "Actions and junctions of " + unit_.machine->name + ", until it settles or has to wait.", true);
    during_functions();
    transition_code_.transition_functions();
    begin_exits_function();
    time_.watch_function();
    propagation_.prompt_function();
    propagation_.holds_up_function();
    time_.advance_function();
    run_function();
    MachineCode code;
    code.methods = out_.text();
    code.leads = unit_.root && generation_.component.is_composed() && transition_code_.has_first_events();
    if (dispatch_code_.is_direct() && !input_events(generation_.component).empty()) {
        out_ = CodeWriter(1);
        dispatch_code_.dispatch_function();
        code.dispatch = out_.text();
    }
    code.enumerations = frame_.all_enumerations();
    code.layout = frame_.make_layout(more);
    code.layout.prompt = propagation_.has_prompt_steps();
    code.layout.holds = propagation_.holds_writes();
    const auto collect = [&](const Thread& thread) {
        code.sites.insert(code.sites.end(), thread.sites.begin(), thread.sites.end());
        code.calls.insert(code.calls.end(), thread.calls.begin(), thread.calls.end());
        code.violations.insert(code.violations.end(), thread.violations.begin(), thread.violations.end());
    };
    collect(control_);
    for (const DuringThread& during : during_) collect(during.thread);
    return code;
}

void MachineWriter::thread_function(const Thread& thread, const std::string& name,
                                    const diagnostics::ForeignText& comment, bool control) {
    out_.open_declaration(comment, function_head("bool " + name));
    out_.line("bool moved = false;");
    out_.open("for (;;) {");
    out_.open(fmt::format("switch ({}) {{", thread.variable));
    if (!control) out_.line(fmt::format("case {}: return moved;", thread.qualified_label("idle")));
    for (std::uint32_t index = 0; control && index < plan_.machine().nodes.size(); ++index)
        if (plan_.is_resting_place(NodeId{index}))
            out_.line(fmt::format("case {}: return moved;", thread.qualified_label(plan_.label_of(NodeId{index}))));
    for (const Place& place : thread.places) {
        out_.comment(place.comment);
        out_.line(fmt::format("case {}:", thread.qualified_label(place.label)));
        out_.write_raw(place.code.text());
    }
    out_.close();
    out_.line("moved = true;");
    if (!generation_.bound_test().empty()) out_.line("if (!spend()) return true;");
    out_.close();
    out_.close();
    if (!thread.helpers.empty()) {
        out_.gap();
        out_.write_raw(thread.helpers.text());
    }
}

void MachineWriter::during_functions() {
    if (during_.empty()) return;
    for (const DuringThread& during : during_) {
        const diagnostics::ForeignText place = generation_.place_text(plan_.node(during.state).origin);
        thread_function(during.thread, "during_" + during.suffix,
                        "During action of " + place + ": once an entry, as far as it gets.", false);
        out_.open_declaration("The state is left: what remains of its during action is cut.",
                              fmt::format("static void cut_{}({}& f) noexcept {{", during.suffix, frame_type()));
        out_.line(during.thread.go_statement("idle"));
        if (during.thread.waits) out_.line(during.thread.wait + " = 0;");
        for (const std::string& deadline : during.thread.deadlines) out_.line(fmt::format("f.{} = 0;", deadline));
        for (const CallFrame& call : during.thread.calls) out_.line(fmt::format("f.{} = {{}};", call.field));
        out_.close();
    }
    out_.open_declaration("During actions of the active states, outer states first.", function_head("bool during"));
    if (propagation_.has_prompt_steps()) out_.line(function_call("prompt") + ";");
    out_.line("bool moved = false;");
    const bool stops = std::ranges::any_of(generation_.component.units,
                                           [](const Unit& unit) { return !unit.machine->preconditions.empty(); });
    for (const DuringThread& during : during_) {
        out_.line(fmt::format("moved = {} || moved;", function_call("during_" + during.suffix)));
        if (stops && &during != &during_.back()) out_.line("if (violated()) return true;");
    }
    out_.line("return moved;");
    out_.close();
}

/// Writes the function that begins the exits with the exit of the innermost active state.
void MachineWriter::begin_exits_function() {
    const auto composite_exit = [&](NodeId id) { return plan_.shared_exit(id) && plan_.node(id).is_composite(); };
    std::vector<NodeId> leaves;
    for (const NodeId top : plan_.machine().top) {
        for (const NodeId leaf : plan_.resting_leaves(top)) {
            const std::vector<NodeId> around = plan_.ancestors(leaf);
            if (std::ranges::any_of(around, composite_exit)) leaves.push_back(leaf);
        }
    }
    if (leaves.empty()) return;
    out_.open_declaration("Begins the exits of a composite state at the innermost active state.",
                          fmt::format("static void leave({}& f) noexcept {{", frame_type()));
    out_.open("switch (f.at) {");
    for (const NodeId leaf : leaves) {
        const NodeId first = plan_.node(leaf).kind == ir::NodeKind::final ? plan_.node(leaf).parent : leaf;
        out_.line(fmt::format("case {}: {} return;", control_.qualified_label(plan_.label_of(leaf)),
                              control_.go_statement(plan_.exit_label(first))));
    }
    out_.line("default: return;");
    out_.close();
    out_.close();
}

std::string MachineWriter::finished_condition(const std::string& frame) const {
    std::vector<std::string> places;
    for (const NodeId id : plan_.final_nodes())
        places.push_back(fmt::format("{}.at == {}", frame, control_.qualified_label(plan_.label_of(id))));
    return places.empty() ? "false" : fmt::format("{}", fmt::join(places, " || "));
}

void MachineWriter::run_function() {
    out_.gap();
    const std::string during = during_.empty() ? "" : " || " + function_call("during");
    std::string transitions = function_call("transition");
    if (transition_code_.has_first_events()) {
        const bool ignored = generation_.mutation.hits(Fault::order_ignored);
        transitions = fmt::format("{} || {}", function_call(ignored ? "transition" : "first"),
                                  function_call(ignored ? "first" : "transition"));
    }
    const std::string parts = fmt::format("{}{} || {}", function_call("control"), during, transitions);
    const bool watches = guards_deadlines(*unit_.machine);
    if (unit_.root) {
        if (generation_.component.is_composed()) {
            if (transition_code_.has_first_events()) {
                out_.doc(fmt::format("What comes before all machines: actions of {}, and its first events.",
                                     unit_.machine->name));
                out_.open(function_head("bool lead"));
                if (watches) out_.line(function_call("watch") + ";");
                out_.line(fmt::format("return {} || {};", function_call("control"), function_call("first")));
                out_.close();
            }
            out_.doc(fmt::format("One round of {}: as far as it gets without the others.", unit_.machine->name));
            out_.open(function_head("bool round"));
            if (watches) out_.line(function_call("watch") + ";");
            out_.line(fmt::format("return {};", parts));
        } else {
            run_alone(parts, watches);
        }
        out_.close();
        out_.gap();
        out_.open(
            fmt::format("[[nodiscard]] static bool finished([[maybe_unused]] const {}& f) noexcept {{", frame_type()));
        out_.line(fmt::format("return {};", finished_condition("f")));
        return out_.close();
    }
    out_.doc(fmt::format("Runs operation {}; true when it has finished.", unit_.machine->name));
    out_.open(fmt::format("bool run({}, bool& moved) noexcept {{", frame_parameters(generation_.component, unit_)));
    if (watches) out_.line(function_call("watch") + ";");
    out_.open(fmt::format("while ({}({})) {{", generation_.bound_test(), parts));
    if (watches) out_.line(function_call("watch") + ";");
    out_.line("moved = true;");
    out_.close();
    out_.line(fmt::format("return {};", finished_condition("f")));
    out_.close();
}

void MachineWriter::run_alone(const std::string& parts, bool watches) {
    out_.doc("Everything that can happen in this cycle.");
    out_.open(function_head("void run"));
    if (propagation_.has_prompt_steps()) out_.line(function_call("prompt") + ";");
    if (watches) out_.line(function_call("watch") + ";");
    out_.open(fmt::format("while ({}({})) {{", generation_.round_test(), parts));
    if (watches) out_.line(function_call("watch") + ";");
    out_.close();
}

}  // namespace

MachineCode generate_machine(const Generation& generation, const Unit& unit, const Layouts& done, NameScope& type_names,
                             const std::vector<Field>& more) {
    MachineContext context(generation, unit, done, type_names);
    return MachineWriter(context).write_machine(more);
}

}  // namespace robochart::cpp_emit
