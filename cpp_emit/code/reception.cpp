// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/code/reception.hpp"

#include <fmt/format.h>

#include "cpp_emit/code/assignment.hpp"
#include "cpp_emit/expressions/expression.hpp"
#include "cpp_emit/plan/types.hpp"
#include "semantics/evaluate/carrier.hpp"

namespace robochart::cpp_emit {

namespace {

/// The sender of a connection from which the event is received. With Fault::wrong_sender, another sender of the same
/// type.
const EventUse& heard(const Generation& generation, const EventUse& sender) {
    for (const Part& part : generation.component.parts) {
        for (const EventUse& use : part.events) {
            if (&use == &sender || use.channel.empty() || use.type != sender.type || use.channel == sender.channel)
                continue;
            return generation.mutation.hits(Fault::wrong_sender) ? use : sender;
        }
    }
    return sender;
}

/// Replaces the last field of `variable` by that of a value and keeps the other fields.
std::string last_field(const Generation& generation, const Unit& unit, ir::VariableId variable,
                       const std::string& value, const std::string& field) {
    const std::string place = ExpressionWriter(generation, unit).variable(variable);
    if (place.empty()) return {};
    return fmt::format("{{ auto partly = {}; partly.{} = {}.{}; {} }}", place, field, value, field,
                       store(generation, unit, variable, "partly"));
}

class Reception {
public:
    Reception(const Generation& generation, const Unit& unit, const ir::Communication& communication, CodeWriter& out,
              const Condition& condition, const std::function<void()>& then)
        : generation_(generation),
          unit_(unit),
          communication_(communication),
          use_(generation.component.event(unit, communication.event)),
          out_(out),
          condition_(condition),
          then_(then) {}

    bool write() {
        for (const std::size_t port : use_.ports) from_port(generation_.component.events[port]);
        for (const std::size_t buffer : use_.emptied) from_buffer(generation_.component.buffers[buffer]);
        for (const Peer& peer : use_.peers) {
            const EventUse* const sender = generation_.component.event(peer);
            if (sender != nullptr && sender->sent) from_peer(*sender);
        }
        return use_.spontaneous() && by_itself();
    }

private:
    [[nodiscard]] CppExpr condition(const std::string& incoming) const {
        const CppExpr free = may_write(generation_, unit_, communication_.variable);
        return conjunction(conjunction(free, predicate(generation_, unit_, communication_, incoming)),
                           condition_(incoming));
    }

    /// The condition that the event is present and its value satisfies the predicate.
    [[nodiscard]] std::string wanted(const std::string& there, const std::string& incoming) const {
        return conjunction(CppExpr(there), condition(incoming)).whole();
    }

    [[nodiscard]] std::string stores(const std::string& incoming) const {
        return received(generation_, unit_, communication_, incoming);
    }

    void take(const std::string& consume, const std::string& stored) {
        if (!consume.empty()) out_.line(consume);
        if (!stored.empty()) out_.line(stored);
        then_();
    }

    void from_port(const EventPort& port) {
        const std::string input = "inputs_." + port.input;
        out_.open(fmt::format("if ({}) {{", wanted(input + ".present", input + ".value")));
        take(consume(port), stores(input + ".value"));
        out_.close();
    }

    /// Reads and empties the buffer (semantics 3.9).
    void from_buffer(const Buffer& buffer) {
        const std::string place = "state_." + buffer.field;
        out_.open(fmt::format("if ({}) {{", wanted(place + ".full()", place + ".value")));
        const std::string stored = stores("incoming");
        if (!stored.empty())
            out_.line(fmt::format("const {} incoming = {}.value;", cpp_type(generation_.system, *use_.type), place));
        take(place + " = {};", stored);
        out_.close();
    }

    /// Rendezvous: the sender waits at one of its sites, and the receiver advances it.
    void from_peer(const EventUse& sender) {
        const std::string& channel = heard(generation_, sender).channel;
        out_.open(fmt::format("for (std::uint32_t site = 0; site != sites_{}; ++site) {{", channel));
        if (use_.type) out_.line(fmt::format("{} incoming{{}};", cpp_type(generation_.system, *use_.type)));
        const CppExpr guard = condition("incoming");
        out_.line(fmt::format("if (!offers_{}(site{}){}) continue;", channel, use_.type ? ", incoming" : "",
                              guard.empty() ? "" : " || !(" + guard.whole() + ")"));
        take(fmt::format("accept_{}(site);", channel), stores("incoming"));
        out_.close();
    }

    /// For an event that is not connected: it happens spontaneously as soon as it is possible, with an arbitrary value
    /// (semantics 3.9).
    bool by_itself() {
        const CppExpr guard = condition("");
        const std::string value = use_.type ? default_text(generation_, *use_.type) : "";
        out_.when(guard, [&] { take("", stores(value)); });
        return guard.empty();
    }

    const Generation& generation_;
    const Unit& unit_;
    const ir::Communication& communication_;
    const EventUse& use_;
    CodeWriter& out_;
    const Condition& condition_;
    const std::function<void()>& then_;
};

}  // namespace

std::string consume(const EventPort& port) {
    return fmt::format("inputs_.{}.present = false;", port.input);
}

std::string received(const Generation& generation, const Unit& unit, const ir::Communication& communication,
                     const std::string& value) {
    if (!communication.variable.valid()) return {};
    const ir::Type& type = generation.system.type(unit.machine->variables[communication.variable.index].type);
    const bool fields = type.kind == ir::TypeKind::record || type.kind == ir::TypeKind::product;
    const std::string stored = as_variable(generation, unit, communication, value);
    if (fields && generation.mutation.hits(Fault::fields_lost))
        return last_field(generation, unit, communication.variable, stored, members(type).back().name);
    return store(generation, unit, communication.variable, stored);
}

std::string as_variable(const Generation& generation, const Unit& unit, const ir::Communication& communication,
                        const std::string& value) {
    const std::optional<ir::TypeId> carried = unit.machine->events[communication.event.index].type;
    if (value.empty() || !carried || !communication.variable.valid()) return value;
    const ir::TypeId wanted = unit.machine->variables[communication.variable.index].type;
    const std::string type = cpp_type(generation.system, wanted);
    if (type == cpp_type(generation.system, *carried)) return value;
    if (numeric(generation.system.type(wanted).kind)) return fmt::format("{}({})", type, value);
    return fmt::format("robochart::convert<{}>({})", type, value);
}

std::string default_text(const Generation& generation, ir::TypeId type) {
    return cpp_value(generation.system, generation.inst, type,
                     ir::default_value(generation.system, generation.inst, type));
}

bool receive(const Generation& generation, const Unit& unit, const ir::Communication& communication, CodeWriter& out,
             const Condition& condition, const std::function<void()>& then) {
    return Reception(generation, unit, communication, out, condition, then).write();
}

CppExpr predicate(const Generation& generation, const Unit& unit, const ir::Communication& communication,
                  const std::string& incoming) {
    if (!communication.predicate) return {};
    ExpressionWriter expressions(generation, unit);
    expressions.set_incoming(as_variable(generation, unit, communication, incoming));
    return expressions.expression_asked(*communication.predicate).enclosed();
}

bool from_register(const EventUse& use) {
    return use.ports.size() == 1 && use.peers.empty() && use.emptied.empty();
}

}  // namespace robochart::cpp_emit
