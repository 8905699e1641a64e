// SPDX-License-Identifier: Apache-2.0
// Defines compositions with RoboTool's structure: ((parts \ connections) [| memory |] Memory) \ memory [| {|terminate|}
// |> SKIP.
#include "csp_emit/compose/composition.hpp"

#include <algorithm>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/base/types.hpp"
#include "csp_emit/base/variants.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::DeclPtr;
using cspm::ExprPtr;

namespace {

ExprPtr receiving_end(const std::string& channel) {
    return b::dot({b::name(channel), b::name("in")});
}
ExprPtr sending_end(const std::string& channel) {
    return b::dot({b::name(channel), b::name("out")});
}

/// The writes to the composition's own variables that a variant leaves visible.
enum class Writes { none, provided, all };

class Definer {
public:
    Definer(const Composition& composition, std::vector<DeclPtr>& decls) : c_(composition), decls_(decls) {}
    void define_all();

private:
    bool timed() const { return c_.project->is_timed(); }
    std::string channel_of_part(std::size_t part, const std::string& event) const {
        return c_.parts[part].name + "::" + event;
    }
    bool has_variable(std::size_t part, const std::string& name) const;
    ExprPtr allow_tock(const ExprPtr& branches, const ExprPtr& self) const;
    ExprPtr with_tock(b::Exprs events) const;
    ExprPtr part_process(std::size_t part, const std::string& variant) const;
    ExprPtr parts_process(const std::string& variant) const;
    b::Exprs joined_events() const;
    void define_propagation(const SharedVariable& variable);
    void define_memory();
    ExprPtr first_propagation(const SharedVariable& variable, const ExprPtr& value) const;
    void define_buffers();
    ExprPtr with_memory(const ExprPtr& process) const;
    ExprPtr with_buffers(const ExprPtr& process) const;
    b::Exprs memory_sync() const;
    ExprPtr hidden_writes(Writes shown) const;
    ExprPtr visible_writes() const;
    ExprPtr variant_process(const std::string& part_variant, Writes shown) const;

    const Composition& c_;
    std::vector<DeclPtr>& decls_;
};

bool Definer::has_variable(std::size_t part, const std::string& name) const {
    const auto& names = c_.parts[part].variables;
    return std::ranges::find(names, name) != names.end();
}

/// In the timed semantics, returns `branches [] tock -> self`, so that a waiting process lets time pass.
ExprPtr Definer::allow_tock(const ExprPtr& branches, const ExprPtr& self) const {
    return timed() ? b::choice({branches, b::prefix(b::name("tock"), self)}) : branches;
}

/// Adds tock to the event set of a parallel operator, so that all parts share the same time.
ExprPtr Definer::with_tock(b::Exprs events) const {
    if (timed()) events.push_back(b::name("tock"));
    return b::productions(events);
}

/// Semantics 3.9: `Part::V(...)[[own <- target]] \ {unconnected}`. Each event of the part is renamed to the channel of
/// its connection (in and out are swapped at the receiving end). Events without any connection are hidden.
ExprPtr Definer::part_process(std::size_t index, const std::string& variant) const {
    const Part& part = c_.parts[index];
    b::Exprs arguments{b::name("id__")};
    for (const std::string& argument : part.arguments) arguments.push_back(b::name(argument));
    std::vector<cspm::Link> links{{b::name(part.name + "::terminate"), b::name("terminate")}};
    b::Exprs unconnected;
    for (const std::string& event : part.events) {
        const auto found = c_.targets.find({index, event});
        const std::string own = channel_of_part(index, event);
        if (found == c_.targets.end()) {
            unconnected.push_back(b::name(own));
            continue;
        }
        const auto& targets = found->second;
        if (targets.size() == 1 && targets[0].channel == own) continue;
        for (const auto& target : targets) {
            if (target.swapped) {
                links.push_back({receiving_end(own), sending_end(target.channel)});
                links.push_back({sending_end(own), receiving_end(target.channel)});
            } else {
                links.push_back({b::name(own), b::name(target.channel)});
            }
        }
    }
    for (const SharedVariable& variable : c_.variables)
        if (has_variable(index, variable.name))
            links.push_back({b::name(channel_of_part(index, "set_" + variable.name)), b::name("set_" + variable.name)});
    for (const std::string& call : part.calls)
        links.push_back({b::name(channel_of_part(index, call + "Call")), b::name(call + "Call")});
    const ExprPtr renamed = b::rename(b::call(part.name + "::" + variant, arguments), links);
    return unconnected.empty() ? renamed : b::hide(renamed, b::productions(unconnected));
}

b::Exprs Definer::joined_events() const {
    b::Exprs result;
    std::set<std::string> seen;
    for (const auto& [first, second, name] : c_.joined)
        if (seen.insert(name).second) result.push_back(b::name(name));
    return result;
}

/// Semantics 3.9: `(P1 [| {terminate} u C1 |] (P2 [| {terminate} u C2 |] ...)) \ C`. All parts synchronise on terminate
/// (and on tock). Pi synchronises with the later parts on the events Ci of connections between them. C is the union of
/// the Ci.
ExprPtr Definer::parts_process(const std::string& variant) const {
    ExprPtr result = part_process(c_.parts.size() - 1, variant);
    for (std::size_t i = c_.parts.size() - 1; i-- > 0;) {
        b::Exprs sync{b::name("terminate")};
        std::set<std::string> seen;
        for (const auto& [first, second, name] : c_.joined)
            if (std::min(first, second) == i && seen.insert(name).second) sync.push_back(b::name(name));
        result = b::parallel(part_process(i, variant), with_tock(sync), result);
    }
    const b::Exprs joined = joined_events();
    return joined.empty() ? result : b::hide(result, b::productions(joined));
}

/// Semantics 3.7, propagation: `Relay_x_i(v) = part_i::set_EXT_x!v -> Relay_x_i+1(v)`, and the last of these processes
/// continues as Memory. A write of x is passed on to all parts that have x, one after the other, including the writer.
void Definer::define_propagation(const SharedVariable& variable) {
    std::vector<std::size_t> readers;
    for (std::size_t i = 0; i < c_.parts.size(); ++i)
        if (has_variable(i, variable.name)) readers.push_back(i);
    for (std::size_t i = 0; i < readers.size(); ++i) {
        const std::string name = "Relay_" + variable.name + "_" + std::to_string(i) + "__";
        const bool last = i + 1 == readers.size();
        const std::string next = last ? "Memory" : "Relay_" + variable.name + "_" + std::to_string(i + 1) + "__";
        b::Exprs arguments{b::name("id__")};
        if (!last) arguments.push_back(b::name("x__"));
        const ExprPtr event = b::name(channel_of_part(readers[i], "set_EXT_" + variable.name));
        const ExprPtr step = b::prefix(event, {b::output(b::name("x__"))}, b::call(next, arguments));
        const ExprPtr self = b::call(name, {b::name("id__"), b::name("x__")});
        decls_.push_back(b::function_decl(name, b::variables({"id__", "x__"}), allow_tock(step, self)));
    }
}

ExprPtr Definer::first_propagation(const SharedVariable& variable, const ExprPtr& value) const {
    for (std::size_t i = 0; i < c_.parts.size(); ++i)
        if (has_variable(i, variable.name)) return b::call("Relay_" + variable.name + "_0__", {b::name("id__"), value});
    return b::call("Memory", {b::name("id__")});
}

/// Semantics 3.7: `Memory = [] x @ set_x?v -> Relay_x_0(v)`. There is one process for all variables, so that the next
/// write waits until the last one has been propagated to every part.
void Definer::define_memory() {
    if (c_.variables.empty()) return;
    b::Exprs branches;
    for (const SharedVariable& variable : c_.variables) {
        define_propagation(variable);
        const std::string event = (variable.required ? "set_EXT_" : "set_") + variable.name;
        branches.push_back(b::prefix(b::name(event), {b::input("x__")}, first_propagation(variable, b::name("x__"))));
    }
    const ExprPtr self = b::call("Memory", {b::name("id__")});
    decls_.push_back(b::function_decl("Memory", b::variables({"id__"}), allow_tock(b::choice(branches), self)));
    // Initial values that the model declares for platform variables are propagated like writes at the start (semantics
    // 3.7).
    ExprPtr next = self;
    std::vector<std::pair<std::string, ExprPtr>> chain;
    for (const SharedVariable& variable : c_.variables)
        for (std::size_t i = 0; variable.pushed && i < c_.parts.size(); ++i)
            if (has_variable(i, variable.name))
                chain.emplace_back(channel_of_part(i, "set_EXT_" + variable.name), variable.pushed);
    for (std::size_t i = chain.size(); i-- > 0;) {
        const std::string name = "Start_" + std::to_string(i) + "__";
        const ExprPtr push = b::prefix(b::name(chain[i].first), {b::output(chain[i].second)}, next);
        next = b::call(name, {b::name("id__")});
        decls_.push_back(b::function_decl(name, b::variables({"id__"}), allow_tock(push, next)));
    }
    decls_.push_back(b::function_decl("MemoryStart__", b::variables({"id__"}), next));
}

/// Semantics 3.9, asynchronous connections:
///     Buffer_empty   = from.out?y -> Buffer_full(y)
///     Buffer_full(x) = from.out?y -> Buffer_full(y) [] to.in!x -> Buffer_empty
/// The writer never waits, the newest value replaces the older one, and reading consumes it.
void Definer::define_buffers() {
    for (std::size_t i = 0; i < c_.buffers.size(); ++i) {
        const Buffer& buffer = c_.buffers[i];
        const std::string empty = "Buffer" + std::to_string(i) + "_empty__";
        const std::string full = "Buffer" + std::to_string(i) + "_full__";
        const bool valued = buffer.type.is_valid();
        const ExprPtr written = sending_end(channel_of_part(buffer.from, buffer.from_event));
        const ExprPtr read = receiving_end(channel_of_part(buffer.to, buffer.to_event));
        const b::Exprs value = valued ? b::Exprs{b::name("x__")} : b::Exprs{};
        const ExprPtr write = valued ? b::prefix(written, {b::input("y__")}, b::call(full, {b::name("y__")}))
                                     : b::prefix(written, b::call(full));
        const ExprPtr take =
            valued ? b::prefix(read, {b::output(b::name("x__"))}, b::call(empty)) : b::prefix(read, b::call(empty));
        decls_.push_back(b::function_decl(empty, {}, allow_tock(write, b::call(empty))));
        decls_.push_back(
            b::function_decl(full, b::variables(valued ? std::vector<std::string>{"x__"} : std::vector<std::string>{}),
                             allow_tock(b::choice({write, take}), b::call(full, value))));
    }
}

b::Exprs Definer::memory_sync() const {
    b::Exprs result;
    for (const SharedVariable& variable : c_.variables) {
        if (!variable.required) result.push_back(b::name("set_" + variable.name));
        for (std::size_t i = 0; i < c_.parts.size(); ++i)
            if (has_variable(i, variable.name))
                result.push_back(b::name(channel_of_part(i, "set_EXT_" + variable.name)));
    }
    return result;
}

/// Returns the propagation events and the writes that this variant hides.
ExprPtr Definer::hidden_writes(Writes shown) const {
    b::Exprs result;
    for (const SharedVariable& variable : c_.variables) {
        const bool visible = shown == Writes::all || (shown == Writes::provided && variable.visible);
        if (!visible) result.push_back(b::name("set_" + variable.name));
        for (std::size_t i = 0; i < c_.parts.size(); ++i)
            if (has_variable(i, variable.name))
                result.push_back(b::name(channel_of_part(i, "set_EXT_" + variable.name)));
    }
    return b::productions(result);
}

ExprPtr Definer::visible_writes() const {
    b::Exprs result;
    for (const SharedVariable& variable : c_.variables)
        if (variable.visible) result.push_back(b::name("set_" + variable.name));
    return b::productions(result);
}

/// Returns `P [| writes and propagation events |] MemoryStart__`.
ExprPtr Definer::with_memory(const ExprPtr& process) const {
    if (c_.variables.empty()) return process;
    return b::parallel(process, with_tock(memory_sync()), b::call("MemoryStart__", {b::name("id__")}));
}

/// Returns `(P [| {from.out, to.in} |] Buffer_empty ...) \ {from, to}`, with one buffer for each asynchronous
/// connection.
ExprPtr Definer::with_buffers(const ExprPtr& process) const {
    ExprPtr result = process;
    for (std::size_t i = 0; i < c_.buffers.size(); ++i) {
        const Buffer& buffer = c_.buffers[i];
        const ExprPtr ends = with_tock({sending_end(channel_of_part(buffer.from, buffer.from_event)),
                                        receiving_end(channel_of_part(buffer.to, buffer.to_event))});
        result = b::parallel(result, ends, b::call("Buffer" + std::to_string(i) + "_empty__"));
    }
    b::Exprs ends;
    for (const Buffer& buffer : c_.buffers) {
        ends.push_back(b::name(channel_of_part(buffer.from, buffer.from_event)));
        ends.push_back(b::name(channel_of_part(buffer.to, buffer.to_event)));
    }
    return ends.empty() ? result : b::hide(result, b::productions(ends));
}

/// Semantics 3.9 and 3.12: `((parts with buffers and memory) \ hidden writes) [| {terminate} |> SKIP`, so that the
/// composition ends when its parts terminate together. A module hides `terminate`. In the timed semantics, hidden
/// events have priority over tock (semantics 3.10), and therefore propagation does, too.
ExprPtr Definer::variant_process(const std::string& part_variant, Writes shown) const {
    const ExprPtr inside = b::hide(with_memory(with_buffers(parts_process(part_variant))), hidden_writes(shown));
    const ExprPtr terminate = b::productions({b::name("terminate")});
    ExprPtr process = b::exception(inside, terminate, b::skip());
    if (c_.hides_termination) process = b::hide(process, terminate);
    return maximal_progress(*c_.project, process, visible_writes());
}

void Definer::define_all() {
    define_memory();
    define_buffers();
    std::vector<std::string> parameters{"id__"};
    for (const ConstantParameter& constant : c_.constants) parameters.push_back(constant.parameter);
    b::Exprs arguments;
    for (const std::string& parameter : parameters) arguments.push_back(b::name(parameter));
    const auto define = [&](const std::string& name, const ExprPtr& process) {
        decls_.push_back(b::function_decl(name, b::variables(parameters), process));
    };
    // RoboTool's optimised module shows writes of the platform's variables in AS_O__ only.
    const Writes optimised = c_.hides_termination ? Writes::none : Writes::provided;
    define("D__", variant_process(is_large(c_) ? "O__" : "D__", Writes::provided));
    define("VS__", variant_process("VS__", Writes::provided));
    // A large controller is not compressed if it is checked separately, because its environment may write at any time.
    // A large module is compressed, because its other controllers restrict the writes, and because the process of a
    // claim multiplies the remaining states.
    define("O__",
           compress_process(*c_.project, variant_process("O__", optimised), is_large(c_) && !c_.hides_termination));
    for (const char* name : {"FVS__", "FVS_C__"})
        if (c_.project->blocks_mention(name)) define(name, variant_process(name, Writes::provided));
    if (c_.project->blocks_mention("HUP__")) define("HUP__", b::call("O__", arguments));
    define("VS_O__", compress_process(*c_.project, variant_process("VS_O__", Writes::provided), is_large(c_)));
    if (c_.hides_termination) {
        define("AS_O__", compress_process(*c_.project, variant_process("O__", Writes::all)));
        return;
    }
    const ExprPtr closed = b::parallel(b::call("O__", arguments), b::name("shared_variable_events"), b::skip());
    define("HEXT__", closed);
    define("HEXT", closed);
}

}  // namespace

bool is_large(const Composition& composition) {
    return std::ranges::any_of(composition.parts, [](const Part& part) { return part.emission.large; });
}

void connect_ends(Composition& composition, std::optional<std::size_t> from, const std::string& from_event,
                  std::optional<std::size_t> to, const std::string& to_event) {
    const auto add = [&](std::size_t part, const std::string& event, Composition::Target target) {
        composition.targets[{part, event}].push_back(std::move(target));
    };
    if (from && to) {
        const std::string shared = composition.parts[*from].name + "::" + from_event;
        add(*from, from_event, {shared, false});
        add(*to, to_event, {shared, true});
        composition.joined.emplace_back(*from, *to, shared);
    } else if (from) {
        add(*from, from_event, {to_event, false});
    } else if (to) {
        add(*to, to_event, {from_event, false});
    }
}

void define_composition(const Composition& composition, std::vector<DeclPtr>& decls) {
    Definer(composition, decls).define_all();
}

}  // namespace robochart::csp_emit
