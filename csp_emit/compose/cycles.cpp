// SPDX-License-Identifier: Apache-2.0
#include "csp_emit/compose/cycles.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/base/types.hpp"
#include "csp_emit/base/variants.hpp"
#include "csp_emit/expressions/expressions.hpp"
#include "semantics/instantiate/instantiate.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::DeclPtr;
using cspm::ExprPtr;
using ir::VariableScope;

namespace {

const Register* find_register(const std::vector<Register>& list, const std::string& name, MeaningKind kind) {
    const auto found =
        std::ranges::find_if(list, [&](const Register& one) { return one.name == name && one.kind == kind; });
    return found == list.end() ? nullptr : &*found;
}

/// Returns the input event with this name. (Inputs that are variables have only one type.)
const Register* find_input_event(const Registers& registers, const std::string& name) {
    const Register* found = find_register(registers.inputs, name, MeaningKind::trigger);
    return found != nullptr && found->event ? found : nullptr;
}

const Register* find_input_variable(const Registers& registers, const std::string& name) {
    const Register* found = find_register(registers.inputs, name, MeaningKind::trigger);
    return found != nullptr && !found->event ? found : nullptr;
}

/// Finds the links of one composition.
class Linker {
public:
    Linker(const Project& project, std::string name) : project_(project), name_(std::move(name)) {}

    void add_part(Registers registers) { links_.parts.push_back(std::move(registers)); }

    void add_connection(const ir::Connection& connection, const std::vector<ir::Event>& own) {
        const auto from = part_of(connection.from), to = part_of(connection.to);
        if (from && to) return join(connection);
        if (!from && !to) return;
        const RegisterOfPart part{from ? *from : *to, from ? connection.from.event : connection.to.event};
        const std::string& event = from ? connection.to.event : connection.from.event;
        const auto declared = std::ranges::find(own, event, &ir::Event::name);
        if (declared == own.end()) return;
        connected_.insert(event);
        // The contexts of the part determine the direction. If both have the event, the direction of the connection
        // determines it.
        const Register* input = find_input_event(links_.parts[part.part], part.name);
        const bool output = find_register(links_.parts[part.part].outputs, part.name, MeaningKind::output) != nullptr;
        if (input != nullptr && (to || !output)) return add_input(*declared, part);
        if (output) add_output(*declared, part, connection.origin.span);
    }

    /// Adds reads of events without a connection. Such an event is read if a part has an input with the same name.
    void add_loose_inputs(const std::vector<ir::Event>& own) {
        for (const ir::Event& event : own) {
            const auto has_input = [&](const Registers& part) { return find_input_event(part, event.name) != nullptr; };
            if (connected_.contains(event.name) || !std::ranges::any_of(links_.parts, has_input)) continue;
            add_register(links_.registers.inputs, input_event(event.name, type_of(event), event.origin));
        }
    }

    /// Adds a variable of the composition. Its register is outside the composition if the variable is required, and
    /// inside otherwise.
    void add_variable(const ir::Variable& variable, bool required, bool shown) {
        std::vector<RegisterOfPart> readers, writers;
        for (std::size_t i = 0; i < links_.parts.size(); ++i) {
            if (find_input_variable(links_.parts[i], variable.name) != nullptr) readers.push_back({i, variable.name});
            if (find_register(links_.parts[i].outputs, variable.name, MeaningKind::assignment) != nullptr)
                writers.push_back({i, variable.name});
        }
        if (required) {
            add_register(links_.registers.inputs, input_variable(variable.name, variable.type, variable.origin));
            links_.inputs[variable.name] = readers;
        }
        if (!writers.empty() && (required || shown)) {
            add_register(links_.registers.outputs, output_variable(variable.name, variable.type, variable.origin));
            links_.outputs[variable.name] = writers;
        }
        if (!required)
            links_.inner.push_back({variable.name, false, variable.type, initial_of(variable), writers, readers});
    }

    void add_calls() {
        for (std::size_t i = 0; i < links_.parts.size(); ++i)
            for (const Register& output : links_.parts[i].outputs) {
                if (output.kind != MeaningKind::call) continue;
                add_register(links_.registers.outputs, output);
                links_.outputs[output.name].push_back({i, output.name});
            }
    }

    void name_outputs(const std::vector<ir::Event>& events, const std::vector<ir::OperationSignature>& operations) {
        for (const ir::Event& event : events) links_.also_named.push_back(output_event(event));
        for (const auto& operation : operations) links_.also_named.push_back(output_call(operation));
    }

    CycleLinks take_links() { return std::move(links_); }

private:
    static std::optional<std::size_t> part_of(const ir::ConnectionEnd& end) {
        return end.kind == ir::EndKind::part ? std::optional<std::size_t>(end.part) : std::nullopt;
    }
    static ir::TypeId type_of(const ir::Event& event) { return event.type.value_or(ir::TypeId{}); }

    void add_input(const ir::Event& event, const RegisterOfPart& part) {
        if (reader_of(part) != nullptr) return refuse_two_sources(part, event.origin.span);
        for (const auto& [name, readers] : links_.inputs)
            for (const RegisterOfPart& known : readers)
                if (known.part == part.part && known.name == part.name && name != event.name)
                    return refuse_two_sources(part, event.origin.span);
        add_register(links_.registers.inputs, input_event(event.name, type_of(event), event.origin));
        links_.inputs[event.name].push_back(part);
    }

    void add_output(const ir::Event& event, const RegisterOfPart& part, diagnostics::Span span) {
        for (const auto& [name, writers] : links_.outputs)
            for (const RegisterOfPart& known : writers)
                if (known.part == part.part && known.name == part.name) {
                    if (name != event.name)
                        project_.report_unsupported(
                            "output " + part.name + " of a part of " + name_ + " that leads to two outputs", span);
                    return;
                }
        add_register(links_.registers.outputs, output_event(event));
        links_.outputs[event.name].push_back(part);
    }

    void refuse_two_sources(const RegisterOfPart& part, diagnostics::Span span) {
        project_.report_unsupported("input " + part.name + " of a part of " + name_ + " with two sources", span);
    }

    InnerRegister* reader_of(const RegisterOfPart& part) {
        for (InnerRegister& inner : links_.inner)
            for (const RegisterOfPart& reader : inner.readers)
                if (inner.event && reader.part == part.part && reader.name == part.name) return &inner;
        return nullptr;
    }

    /// Adds an event from one part to another. Each input has one register, which several outputs may fill.
    void join(const ir::Connection& connection) {
        RegisterOfPart from{connection.from.part, connection.from.event};
        RegisterOfPart to{connection.to.part, connection.to.event};
        const auto writes = [&](const RegisterOfPart& end) {
            return find_register(links_.parts[end.part].outputs, end.name, MeaningKind::output) != nullptr;
        };
        const auto reads = [&](const RegisterOfPart& end) {
            return find_input_event(links_.parts[end.part], end.name) != nullptr;
        };
        if (!(writes(from) && reads(to))) std::swap(from, to);
        if (!(writes(from) && reads(to))) return;
        if (InnerRegister* known = reader_of(to)) {
            known->writers.push_back(from);
            return;
        }
        for (const auto& [name, readers] : links_.inputs)
            for (const RegisterOfPart& reader : readers)
                if (reader.part == to.part && reader.name == to.name)
                    return refuse_two_sources(to, connection.origin.span);
        const Register* input = find_input_event(links_.parts[to.part], to.name);
        const ir::TypeId type = input->types.size() > 1 ? input->types[1] : ir::TypeId{};
        links_.inner.push_back({to.name, true, type, nullptr, {from}, {to}});
    }

    /// Returns the declared initial value, or the default value of the type.
    ExprPtr initial_of(const ir::Variable& variable) const {
        if (!variable.initial) return default_literal(project_, variable.type);
        const auto value = ir::evaluate_constant(project_.system, project_.instantiation, nullptr, *variable.initial);
        if (value) return value_literal(project_, variable.type, *value);
        project_.report_unsupported("the initial value of " + variable.name, variable.origin.span);
        return default_literal(project_, variable.type);
    }

    const Project& project_;
    std::string name_;
    CycleLinks links_;
    std::set<std::string> connected_;  ///< own events that some connection names
};

/// Builds the processes of a composition.
class CycleDefiner {
public:
    CycleDefiner(const Composition& composition, const CycleLinks& links, std::vector<DeclPtr>& decls)
        : c_(composition), links_(links), decls_(decls) {
        for (const auto& [name, readers] : links.inputs)
            for (const RegisterOfPart& reader : readers) reads_.push_back(read(reader));
        for (const auto& [name, writers] : links.outputs)
            for (const RegisterOfPart& writer : writers) add_write(writer, name);
        for (const InnerRegister& inner : links.inner) {
            for (const RegisterOfPart& reader : inner.readers) reads_.push_back(read(reader));
            for (const RegisterOfPart& writer : inner.writers) add_write(writer, "");
        }
    }

    void define_all();

private:
    struct Write {
        RegisterOfPart writer;
        std::string output;  ///< the own output; "" if the write remains inside
    };
    const std::string& name_of(std::size_t part) const { return c_.parts[part].name; }
    ExprPtr read(const RegisterOfPart& one) const { return register_read("i_" + one.name, name_of(one.part)); }
    ExprPtr write(const RegisterOfPart& one) const { return register_write("o_" + one.name, name_of(one.part)); }
    bool has_values(const RegisterOfPart& writer) const;
    void add_write(const RegisterOfPart& writer, const std::string& output);
    bool has_event() const {
        return std::ranges::any_of(links_.inner, [](const InnerRegister& inner) { return inner.event; });
    }
    ExprPtr reads_of_cycle() const;
    ExprPtr execution() const;
    void define_passing();
    void define_inner(std::size_t number);
    b::Exprs events_of_inner() const;
    b::Exprs events_of_parts() const;
    ExprPtr part_process(std::size_t part, const std::string& variant) const;
    ExprPtr parts_process(const std::string& variant) const;
    ExprPtr whole(const std::string& variant) const;

    const Composition& c_;
    const CycleLinks& links_;
    std::vector<DeclPtr>& decls_;
    std::vector<ExprPtr> reads_;  ///< reads of parts from a register outside or inside
    std::vector<Write> writes_;
};

bool CycleDefiner::has_values(const RegisterOfPart& writer) const {
    const auto& outputs = links_.parts[writer.part].outputs;
    const auto found = std::ranges::find(outputs, writer.name, &Register::name);
    return found != outputs.end() && !found->types.empty();
}

void CycleDefiner::add_write(const RegisterOfPart& writer, const std::string& output) {
    for (Write& known : writes_)
        if (known.writer.part == writer.part && known.writer.name == writer.name) {
            if (known.output.empty()) known.output = output;
            return;
        }
    writes_.push_back({writer, output});
}

/// Returns `||| own input i : registerRead.i?x -> (each part) part::registerRead.i!x -> SKIP`, in parallel with the
/// reads of inner registers. Then the registers of events between parts are emptied.
ExprPtr CycleDefiner::reads_of_cycle() const {
    b::Exprs all;
    for (const Register& input : links_.registers.inputs) {
        ExprPtr rest = b::skip();
        if (const auto readers = links_.inputs.find(input.name); readers != links_.inputs.end())
            for (auto reader = readers->second.rbegin(); reader != readers->second.rend(); ++reader)
                rest = b::prefix(read(*reader), {b::output(b::name("x__"))}, rest);
        all.push_back(b::prefix(register_read("i_" + input.name), {b::input("x__")}, rest));
    }
    for (const InnerRegister& inner : links_.inner)
        for (const RegisterOfPart& reader : inner.readers)
            all.push_back(b::prefix(read(reader), {b::input("x__")}, b::skip()));
    if (!has_event()) return b::interleave(all);
    return b::sequential({b::interleave(all), b::prefix(b::name("emptied__"), b::skip())});
}

/// Returns `P = part::registerWrite.o?x -> registerWrite.o'!x -> P [] endexec -> SKIP`: a write is passed on before the
/// next one is accepted. The limit of one write applies to the outputs of the composition, for all parts together. The
/// execution ends when the executions of all parts have ended.
ExprPtr CycleDefiner::execution() const {
    std::vector<std::vector<ExprPtr>> limited;
    b::Exprs taken{b::name("endexec")};
    for (const auto& [output, writers] : links_.outputs) {
        limited.emplace_back();
        for (const RegisterOfPart& writer : writers) {
            limited.back().push_back(write(writer));
            taken.push_back(write(writer));
        }
    }
    b::Exprs ends;
    for (std::size_t i = 0; i < c_.parts.size(); ++i)
        ends.push_back(b::prefix(b::name(name_of(i) + "::endexec"), b::skip()));
    const ExprPtr monitor = b::sequential({b::interleave(ends), b::prefix(b::name("endexec"), b::skip())});
    const ExprPtr once = b::parallel(b::call("PassOn__"), b::productions(taken), writes_of_cycle(limited));
    return b::parallel(once, b::productions({b::name("endexec")}), monitor);
}

void CycleDefiner::define_passing() {
    b::Exprs ways;
    for (const Write& one : writes_) {
        const bool valued = has_values(one.writer);
        ExprPtr next = b::call("PassOn__");
        if (!one.output.empty()) {
            const ExprPtr own = register_write("o_" + one.output);
            next = valued ? b::prefix(own, {b::output(b::name("x__"))}, next) : b::prefix(own, next);
        }
        ways.push_back(valued ? b::prefix(write(one.writer), {b::input("x__")}, next)
                              : b::prefix(write(one.writer), next));
    }
    ways.push_back(b::prefix(b::name("endexec"), b::skip()));
    decls_.push_back(
        b::function_decl("PassOn__", {}, b::choice(ways), "a write is passed on before the next is taken"));
}

/// Defines the process of an inner register. A variable: `V(x) = write?y -> V(y) [] read!x -> V(x)`. An event has any
/// value while its register is empty (E), and the last value while it is full (F):
///     E = write?y -> F(y) [] read.false?_ -> E [] emptied -> E
///     F(x) = write?y -> F(y) [] read.true!x -> F(x) [] emptied -> E
void CycleDefiner::define_inner(std::size_t number) {
    const InnerRegister& inner = links_.inner[number];
    const std::string name = "Register_" + std::to_string(number) + "__";
    const std::string empty = "Empty_" + std::to_string(number) + "__";
    const bool valued = inner.type.is_valid();
    const auto now = [&](const char* value) { return b::call(name, valued ? b::Exprs{b::name(value)} : b::Exprs{}); };
    b::Exprs of_full, of_empty;
    for (const RegisterOfPart& writer : inner.writers) {
        const ExprPtr step =
            valued ? b::prefix(write(writer), {b::input("y__")}, now("y__")) : b::prefix(write(writer), now(""));
        of_full.push_back(step);
        of_empty.push_back(step);
    }
    for (const RegisterOfPart& reader : inner.readers) {
        if (!inner.event) {
            of_full.push_back(b::prefix(read(reader), {b::output(b::name("x__"))}, now("x__")));
            continue;
        }
        std::vector<cspm::Field> full{b::output(b::boolean(true))}, none{b::output(b::boolean(false))};
        if (valued) full.push_back(b::output(b::name("x__")));
        if (valued) none.push_back(b::input("y__"));
        of_full.push_back(b::prefix(read(reader), full, now("x__")));
        of_empty.push_back(b::prefix(read(reader), none, b::call(empty)));
    }
    const auto parameters = valued ? std::vector<std::string>{"x__"} : std::vector<std::string>{};
    if (inner.event)
        for (auto* ways : {&of_full, &of_empty}) ways->push_back(b::prefix(b::name("emptied__"), b::call(empty)));
    decls_.push_back(b::function_decl(name, b::variables(parameters), b::choice(of_full), "register " + inner.name));
    if (inner.event) decls_.push_back(b::function_decl(empty, {}, b::choice(of_empty)));
}

b::Exprs CycleDefiner::events_of_inner() const {
    b::Exprs result;
    for (const InnerRegister& inner : links_.inner) {
        for (const RegisterOfPart& writer : inner.writers) result.push_back(write(writer));
        for (const RegisterOfPart& reader : inner.readers) result.push_back(read(reader));
    }
    return result;
}

/// Returns all events of parts that the composition hides.
b::Exprs CycleDefiner::events_of_parts() const {
    b::Exprs result;
    for (std::size_t i = 0; i < c_.parts.size(); ++i) {
        result.push_back(b::name(name_of(i) + "::endexec"));
        if (!links_.parts[i].inputs.empty()) result.push_back(b::name(name_of(i) + "::registerRead"));
        if (!links_.parts[i].outputs.empty()) result.push_back(b::name(name_of(i) + "::registerWrite"));
    }
    return result;
}

ExprPtr CycleDefiner::part_process(std::size_t index, const std::string& variant) const {
    const Part& part = c_.parts[index];
    b::Exprs arguments{b::name("id__")};
    for (const std::string& argument : part.arguments) arguments.push_back(b::name(argument));
    return b::rename(b::call(part.name + "::" + variant, arguments),
                     {{b::name(part.name + "::terminate"), b::name("terminate")}});
}

/// Returns the parts in parallel. They synchronise on tock and on their end.
ExprPtr CycleDefiner::parts_process(const std::string& variant) const {
    ExprPtr result = part_process(c_.parts.size() - 1, variant);
    for (std::size_t i = c_.parts.size() - 1; i-- > 0;)
        result = b::parallel(part_process(i, variant), b::productions({b::name("terminate"), b::name("tock")}), result);
    return result;
}

/// Returns `((parts [| their registers, endexec, terminate, tock |] Cycle) [| inner registers |] ...) \ parts' events`,
/// which ends with `terminate`.
ExprPtr CycleDefiner::whole(const std::string& variant) const {
    b::Exprs shared{b::name("terminate"), b::name("tock")};
    shared.insert(shared.end(), reads_.begin(), reads_.end());
    for (const Write& one : writes_) shared.push_back(write(one.writer));
    for (std::size_t i = 0; i < c_.parts.size(); ++i) shared.push_back(b::name(name_of(i) + "::endexec"));
    const ExprPtr frame = b::call("Cycle__", {b::name(c_.constants.front().parameter)});
    ExprPtr process = c_.parts.empty() ? frame : b::parallel(parts_process(variant), b::productions(shared), frame);
    b::Exprs hidden = events_of_parts();
    if (!links_.inner.empty()) {
        b::Exprs memories, sync = events_of_inner();
        for (std::size_t i = 0; i < links_.inner.size(); ++i) {
            const InnerRegister& inner = links_.inner[i];
            const std::string number = std::to_string(i) + "__";
            memories.push_back(inner.event ? b::call("Empty_" + number)
                                           : b::call("Register_" + number, {inner.initial}));
        }
        if (has_event()) {
            sync.push_back(b::name("emptied__"));
            hidden.push_back(b::name("emptied__"));
        }
        // the registers of all events between parts are emptied at once
        ExprPtr memory = memories.back();
        for (std::size_t i = memories.size() - 1; i-- > 0;) {
            const bool both =
                links_.inner[i].event && std::ranges::any_of(links_.inner.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                                             links_.inner.end(), &InnerRegister::event);
            b::Exprs common;
            if (both) common.push_back(b::name("emptied__"));
            for (const RegisterOfPart& writer : links_.inner[i].writers)  // one output may fill several registers
                for (std::size_t k = i + 1; k < links_.inner.size(); ++k)
                    for (const RegisterOfPart& other : links_.inner[k].writers)
                        if (other.part == writer.part && other.name == writer.name) common.push_back(write(writer));
            memory = b::parallel(memories[i], b::productions(common), memory);
        }
        process = b::parallel(process, b::productions(sync), memory);
    }
    const ExprPtr end = b::productions({b::name("terminate")});
    process = b::exception(hidden.empty() ? process : b::hide(process, b::productions(hidden)), end, b::skip());
    if (c_.hides_termination) process = b::hide(process, b::productions({b::name("terminate"), b::name("endexec")}));
    return maximal_progress(*c_.project, process);
}

void CycleDefiner::define_all() {
    define_passing();
    for (std::size_t i = 0; i < links_.inner.size(); ++i) define_inner(i);
    if (has_event()) decls_.push_back(b::channel({"emptied__"}));
    decls_.push_back(cycle_definition("Cycle__", "cycle__", reads_of_cycle(), execution()));
    std::vector<std::string> parameters{"id__"};
    for (const ConstantParameter& constant : c_.constants) parameters.push_back(constant.parameter);
    const auto define = [&](const std::string& name, const ExprPtr& process) {
        decls_.push_back(b::function_decl(name, b::variables(parameters), process));
    };
    define("D__", whole(is_large(c_) ? "O__" : "D__"));
    define("O__", compress_process(*c_.project, call_of("D__", parameters), false));
    define("VS__", whole("VS__"));
    define("VS_O__", compress_process(*c_.project, call_of("VS__", parameters), false));
}

}  // namespace

CycleLinks cycle_links(const Project& project, const ir::Controller& controller) {
    Linker linker(project, controller.name);
    for (const ir::MachineInstance& part : controller.machines)
        linker.add_part(registers_of(project.system.machine(part.machine)));
    for (const ir::Connection& connection : controller.connections)
        linker.add_connection(connection, controller.events);
    linker.add_loose_inputs(controller.events);
    for (const ir::Variable& variable : controller.variables)
        linker.add_variable(variable, variable.scope == VariableScope::required, false);
    linker.add_calls();
    linker.name_outputs(controller.events, controller.operations);
    return linker.take_links();
}

CycleLinks cycle_links(const Project& project, const ir::Module& module) {
    Linker linker(project, module.name);
    for (const ir::ControllerInstance& part : module.controllers)
        linker.add_part(cycle_links(project, project.system.controller(part.controller)).registers);
    const ir::Platform& platform = module.platform;
    for (const ir::Connection& connection : module.connections) linker.add_connection(connection, platform.events);
    linker.add_loose_inputs(platform.events);
    for (const ir::Variable& variable : platform.variables) linker.add_variable(variable, false, true);
    linker.add_calls();
    linker.name_outputs({}, platform.operations);
    return linker.take_links();
}

std::vector<std::string> declare_cycle_channels(const Project& project, const std::string& path,
                                                const CycleLinks& links, const ir::Origin& origin, bool module,
                                                Provenance& provenance, std::vector<DeclPtr>& decls) {
    decls.push_back(b::channel({"endexec", "terminate"}));
    mean(provenance, path, "endexec", {MeaningKind::cycle_end, "the execution ends", {}, origin});
    mean(provenance, path, "terminate", {MeaningKind::terminate, origin.element + " terminates", {}, origin});
    declare_registers(project, path, links.registers, links.also_named, provenance, decls);
    std::vector<std::string> visible = visible_registers(links.registers);
    b::Exprs events;
    if (!module)
        for (const char* event : {"endexec", "terminate"}) {
            visible.emplace_back(event);
            events.push_back(b::name(event));
        }
    if (!links.registers.inputs.empty()) events.push_back(b::name("registerRead"));
    if (!links.registers.outputs.empty()) events.push_back(b::name("registerWrite"));
    decls.push_back(b::value("sem__events", b::productions(events)));
    return visible;
}

void define_cycles(const Composition& composition, const CycleLinks& links, std::vector<DeclPtr>& decls) {
    CycleDefiner(composition, links, decls).define_all();
}

}  // namespace robochart::csp_emit
