// SPDX-License-Identifier: Apache-2.0
#include "prism/emit/channels.hpp"

#include <algorithm>
#include <utility>

#include "prism/emit/rules.hpp"
#include "prism/emit/tree.hpp"

namespace robochart::prism_emit {
namespace {

/// Limits the number of values of a platform input, which has a command for each value.
constexpr std::int64_t most_values = 100'000;

}  // namespace

std::string Channel::out_label() const {
    // R12: "Label RP__e_n platform-machine, OUT_BUF__e_n/IN_BUF__e_n around a buffer."
    if (kind == Kind::buffer) return "OUT_BUF__" + name;
    return (kind == Kind::platform ? "RP__" : "SYNC__") + name;
}

std::string Channel::in_label() const {
    return kind == Kind::buffer ? "IN_BUF__" + name : out_label();
}

std::string Channel::value_at(Direction end) const {
    return "EVT__" + (end == Direction::out ? out_label() : in_label());
}

std::string Channel::ready_at(Direction end) const {
    return "FIN__" + (end == Direction::out ? out_label() : in_label());
}

const ir::Controller& Channels::controller_at(std::uint32_t index) const {
    return context_.system.controller(context_.module.controllers[index].controller);
}

std::string Channels::describe_end(const End& end) const {
    const std::string module = context_.module.name;
    if (end.level == End::Level::platform) return module + "::" + context_.module.platform.name;
    const std::string inside = module + "::" + context_.module.controllers[end.seat.controller].name;
    if (end.level == End::Level::controller) return inside;
    return inside + "::" + controller_at(end.seat.controller).machines[end.seat.machine].name;
}

void Channels::add_hops(const std::vector<ir::Connection>& connections, const End& from, Direction direction,
                        const std::function<End(const ir::ConnectionEnd&)>& place, std::vector<Hop>& result) const {
    for (const ir::Connection& connection : connections) {
        const End first = place(connection.from);
        const End second = place(connection.to);
        const bool forwards = direction == Direction::out;
        // a connection with [mult] connects both directions
        if ((forwards || connection.multiple) && first == from) result.push_back({second, connection.async});
        if ((!forwards || connection.multiple) && second == from) result.push_back({first, connection.async});
    }
}

std::vector<Channels::Hop> Channels::next_hops(const End& from, Direction direction, bool inside) const {
    std::vector<Hop> result;
    const std::uint32_t at = from.seat.controller;
    if (inside) {
        const auto place = [at](const ir::ConnectionEnd& end) {
            return end.kind == ir::EndKind::self ? End{End::Level::controller, {at, 0}, end.event}
                                                 : End{End::Level::machine, {at, end.part}, end.event};
        };
        add_hops(controller_at(at).connections, from, direction, place, result);
    } else {
        const auto place = [](const ir::ConnectionEnd& end) {
            return end.kind == ir::EndKind::self ? End{End::Level::platform, {}, end.event}
                                                 : End{End::Level::controller, {end.part, 0}, end.event};
        };
        add_hops(context_.module.connections, from, direction, place, result);
    }
    return result;
}

/// Follows an event from a machine, out of its controller and through the module, to another machine or to the
/// platform. Each event on the path has one neighbour on each side, because communication between more than two ends is
/// not encoded.
std::optional<Channels::Route> Channels::follow_route(const End& from, Direction direction,
                                                      std::string& problem) const {
    const Direction back = direction == Direction::out ? Direction::in : Direction::out;
    Route route{from, false};
    bool inside = true;
    for (unsigned hop = 0; hop < 4; ++hop) {  // out of a controller, to the next controller, into it
        const std::vector<Hop> next = next_hops(route.end, direction, inside);
        if (next.empty()) {
            problem = "it is used, but not connected" +
                      (route.end.level == End::Level::machine ? "" : " beyond " + describe_end(route.end));
            return std::nullopt;
        }
        const End& to = next.front().to;
        const bool shared =
            next.size() > 1 || (to.level != End::Level::platform && next_hops(to, back, inside).size() > 1) ||
            (to.level == End::Level::platform && direction == Direction::in && next_hops(to, back, inside).size() > 1);
        if (shared) {
            problem = "more than two take part in it";
            return std::nullopt;
        }
        route.async = route.async || next.front().async;
        const bool entered = to.level == End::Level::controller && !inside;
        const bool left = to.level == End::Level::controller && inside;
        route.end = to;
        if (!entered && !left) return route;
        inside = entered;
    }
    problem = "its connections lead through more than two controllers";
    return std::nullopt;
}

Channel* Channels::find_channel(Seat seat, const ir::Event& event, Direction direction, diagnostics::Span span) {
    const End own{End::Level::machine, seat, event.name};
    const auto refuse = [&](const std::string& problem) -> Channel* {
        context_.diagnostics.report(rules::unsupported_event, span, {event.name, describe_end(own), problem});
        return nullptr;
    };
    if (event.broadcast) return refuse("it is broadcast");
    std::string problem;
    const std::optional<Route> route = follow_route(own, direction, problem);
    if (!route) return refuse(problem);
    const bool out = direction == Direction::out;
    const auto key = out ? std::tuple(own, route->end) : std::tuple(route->end, own);
    Channel*& channel = found_[key];
    if (channel == nullptr) {
        Channel made;
        made.kind = route->async ? Channel::Kind::buffer : Channel::Kind::joint;
        if (route->end.level == End::Level::platform) made.kind = Channel::Kind::platform;
        if (event.type) {
            made.carrier = context_.find_carrier(*event.type, describe_end(own) + "::" + event.name, span);
            if (made.kind == Channel::Kind::joint)
                return refuse("it carries a value over a synchronous connection between machines");
        }
        made.name = context_.numbered_name(std::get<0>(key).event);
        channels_.push_back(std::make_unique<Channel>(std::move(made)));
        channel = channels_.back().get();
    }
    if (!(out ? channel->sent : channel->received)) {
        const std::string label = out ? channel->out_label() : channel->in_label();
        context_.record_name("event", describe_end(own) + "::" + event.name + (out ? "::OUT" : "::IN"), label);
        if (channel->kind == Channel::Kind::platform)
            context_.record_name("event", describe_end(route->end) + "::" + route->end.event + (out ? "::IN" : "::OUT"),
                                 label);
    }
    (out ? channel->sent : channel->received) = true;
    return channel;
}

void Channels::emit_modules() {
    for (const auto& channel : channels_)
        if (channel->kind == Channel::Kind::buffer) emit_buffer(*channel);
    emit_platform();
}

/// Emits the module of a buffer. R12: "Untyped buffer: f:bool; OUT always possible (overwrites, loses), IN if full."
/// R13: "Buffer: OUT needs both FINs, clears f, then one unlabelled step copies EVT__IN'=EVT__OUT, fills." If no
/// machine uses an end, it has no command, so no step is possible at this end.
void Channels::emit_buffer(const Channel& channel) {
    prism::Module module;
    module.name.text = context_.unique_name("BUF_" + channel.name);
    const std::string full = context_.unique_name("BUF_" + channel.name + "_f");
    module.variables.push_back(tree::boolean(full, tree::truth(false)));
    if (channel.carrier) {
        const std::string value = channel.value_at(Direction::in);
        const std::string ready = channel.ready_at(Direction::out);
        module.variables.push_back(Context::declare_variable(value, *channel.carrier, nullptr));
        module.variables.push_back(tree::boolean(ready, tree::truth(true)));
        if (channel.sent) {
            const prism::ExprPtr taken = channel.received ? tree::is(channel.ready_at(Direction::in), true) : nullptr;
            module.commands.push_back(tree::command(channel.out_label(), tree::all_of({taken, tree::is(ready, true)}),
                                                    {tree::set(full, false), tree::set(ready, false)}));
            module.commands.push_back(tree::command(
                "", tree::is(ready, false),
                {tree::set(value, channel.value_at(Direction::out)), tree::set(ready, true), tree::set(full, true)}));
        }
    } else if (channel.sent) {
        module.commands.push_back(tree::command(channel.out_label(), tree::truth(true), {tree::set(full, true)}));
    }
    if (channel.received)
        module.commands.push_back(tree::command(channel.in_label(), tree::is(full, true), {tree::set(full, false)}));
    context_.emission.model.modules.push_back(std::move(module));
}

/// Emits the module of the platform. R12: "Platform input: [RP__e] true -> true."
/// R13: "Typed platform input: one command per value, so values are uniform."
void Channels::emit_platform() {
    prism::Module module;
    module.name.text = context_.unique_name(context_.module.name + "_" + context_.module.platform.name);
    for (const auto& channel : channels_) {
        // an event of two machines cannot happen if only one of them performs it, because its label needs both
        if (channel->kind == Channel::Kind::joint && channel->sent != channel->received)
            module.commands.push_back(tree::command(channel->out_label(), tree::truth(false), {}));
        if (channel->kind != Channel::Kind::platform) continue;
        if (!channel->received || !channel->carrier) {
            module.commands.push_back(tree::command(channel->out_label(), tree::truth(true), {}));
            continue;
        }
        const std::string value = channel->value_at(Direction::out);
        const Carrier& carrier = *channel->carrier;
        if (carrier.high - carrier.low >= most_values) {
            context_.diagnostics.report(rules::unsupported_event, {},
                                        {channel->name, module.name.text, "its type has too many values"});
            continue;
        }
        module.variables.push_back(Context::declare_variable(value, carrier, nullptr));
        for (std::int64_t number = carrier.low; number <= carrier.high; ++number) {
            context_.diagnostics.poll();
            const prism::ExprPtr written = carrier.boolean ? tree::truth(number != 0) : tree::number(number);
            module.commands.push_back(
                tree::command(channel->out_label(), tree::truth(true), {tree::set(value, written)}));
        }
    }
    context_.emission.model.modules.push_back(std::move(module));
}

}  // namespace robochart::prism_emit
