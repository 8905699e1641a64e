// SPDX-License-Identifier: Apache-2.0
// Names the events of model and code for the conformance check (docs/conformance.md, "From reactive model to cycles").
#include "conformance/code/interface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <optional>
#include <set>

#include "semantics/ir/numbers.hpp"

namespace robochart::conformance {

namespace {

bool starts_with(std::string_view text, std::string_view prefix) {
    return text.substr(0, prefix.size()) == prefix;
}

/// Returns the text after `prefix`, such as ".1.2" or "". Returns no value unless a dot or the end of `name` follows
/// the prefix.
std::optional<std::string_view> arguments_after(std::string_view name, std::string_view prefix) {
    if (!starts_with(name, prefix)) return std::nullopt;
    const std::string_view rest = name.substr(prefix.size());
    if (!rest.empty() && rest.front() != '.') return std::nullopt;
    return rest;
}

/// Converts "seeRobot.in" to "seeRobot". Characters that an identifier cannot contain become "__". The name is made
/// unique among `taken`.
std::string constructor_name(std::string_view name, std::set<std::string>& taken) {
    for (const std::string_view direction : {".in", ".out"}) {
        if (name.size() > direction.size() && name.substr(name.size() - direction.size()) == direction)
            name.remove_suffix(direction.size());
    }
    std::string plain;
    for (const char c : name) {
        if (c == ':' || c == '.')
            plain += '_';
        else
            plain += c;
    }
    std::string unique = plain;
    for (unsigned n = 2; !taken.insert(unique).second; ++n) unique = fmt::format("{}__{}", plain, n);
    return unique;
}

/// Returns the length of the carrier's value at the beginning of `text`. Literals with arguments contain dots
/// themselves.
std::size_t length_of_value(const Carrier& carrier, std::string_view text) {
    std::size_t length = 0;
    for (const std::string& name : carrier.names)
        if (name.size() > length && arguments_after(text, name)) length = name.size();
    return length > 0 ? length : std::min(text.find('.'), text.size());
}

/// Splits ".1.<2, 3>" into "1" and "<2, 3>".
std::vector<std::string> split_arguments(std::string_view text, const std::vector<Carrier>& carriers) {
    static const Carrier numbers;
    std::vector<std::string> parts;
    while (!text.empty()) {
        text.remove_prefix(1);
        const Carrier& carrier = parts.size() < carriers.size() ? carriers[parts.size()] : numbers;
        const std::size_t length = length_of_value(carrier, text);
        parts.emplace_back(text.substr(0, length));
        text.remove_prefix(length);
    }
    return parts;
}

/// Returns the number for CSPM text, or no value if the carrier does not contain it.
std::optional<std::int64_t> number_of(const Carrier& carrier, const std::string& text) {
    if (carrier.kind == Carrier::Kind::boolean) return text == "true" ? 1 : 0;
    if (carrier.kind == Carrier::Kind::enumeration) {
        const auto found = std::ranges::find(carrier.names, text);
        if (found == carrier.names.end()) return std::nullopt;
        return found - carrier.names.begin();
    }
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// Shortens a name: "MoveCall" becomes "Move", "out.out" becomes "out", "set_x" is unchanged.
std::string short_name(std::string_view name) {
    for (const std::string_view ending : {"Call", ".out", ".in"}) {
        if (name.size() > ending.size() && name.substr(name.size() - ending.size()) == ending)
            return std::string(name.substr(0, name.size() - ending.size()));
    }
    return std::string(name);
}

}  // namespace

void drop_raised(std::vector<bool>& raised, const std::vector<DroppedInput>& drops) {
    for (const DroppedInput& drop : drops)
        if (raised[drop.event]) raised[drop.dropped] = false;
}

std::vector<DroppedInput> dropped_inputs([[maybe_unused]] const Interface& interface,
                                         const cpp_emit::EventOrder& order) {
    std::vector<DroppedInput> result;
    for (const cpp_emit::EventOrder::Drop& drop : order.drops) {
        assert(drop.event_input < interface.inputs.size() && drop.dropped_input < interface.inputs.size());
        result.push_back({drop.event_input, drop.dropped_input});
    }
    return result;
}

std::string input_name(const Register& input) {
    constexpr std::string_view written = "set_EXT_";
    return starts_with(input.name, written) ? input.name.substr(written.size()) : short_name(input.name);
}

std::string output_name(const Output& output) {
    return starts_with(output.name, "set_") ? output.name.substr(4) : short_name(output.name);
}

std::string cspm_text(const Carrier& carrier, std::int64_t value) {
    if (carrier.kind == Carrier::Kind::boolean) return value != 0 ? "true" : "false";
    if (carrier.kind == Carrier::Kind::enumeration && value >= 0 &&
        static_cast<std::uint64_t>(value) < carrier.names.size())
        return carrier.names[static_cast<std::size_t>(value)];
    return fmt::format("{}", value);
}

std::string people_text(const Carrier& carrier, std::int64_t value, std::int64_t scale) {
    if (carrier.kind == Carrier::Kind::real) return ir::decimal_text(value, scale);
    if (carrier.kind == Carrier::Kind::enumeration && value >= 0 &&
        static_cast<std::uint64_t>(value) < carrier.literals.size())
        return carrier.literals[static_cast<std::size_t>(value)];
    return cspm_text(carrier, value);
}

Alphabet::Alphabet(Interface interface, process::EventTable& events)
    : interface_(std::move(interface)), events_(&events), tock_(events.intern("tock")) {
    std::set<std::string> inputs;
    std::set<std::string> outputs;
    for (const Register& input : interface_.inputs) {
        if (input.values.size() != input.texts.size())
            throw AlphabetError(fmt::format("register {} has values without text", input.name));
        input_names_.push_back(constructor_name(input.name, inputs));
        std::vector<process::Event>& reads = reads_.emplace_back();
        reads.push_back(events.intern(fmt::format("registerRead.absent__{}", input_names_.back())));
        const std::string present = fmt::format("registerRead.present__{}", input_names_.back());
        if (input.texts.empty()) reads.push_back(events.intern(present));
        for (const std::string& text : input.texts) reads.push_back(events.intern(fmt::format("{}.{}", present, text)));
    }
    for (const Output& output : interface_.outputs) output_names_.push_back(constructor_name(output.name, outputs));
}

process::Event Alphabet::write_event(std::uint32_t output, const std::vector<std::int64_t>& arguments) const {
    std::string name = fmt::format("registerWrite.wrote__{}", output_names_[output]);
    const std::vector<Carrier>& carriers = interface_.outputs[output].arguments;
    for (std::size_t i = 0; i < arguments.size(); ++i)
        name += fmt::format(".{}", cspm_text(i < carriers.size() ? carriers[i] : Carrier{}, arguments[i]));
    return events_->intern(name);
}

ModelRole Alphabet::model_role(process::Event event) const {
    if (event == process::tau) return {ModelRole::Kind::tau};
    if (event == process::tick) return {ModelRole::Kind::tick};
    if (event == tock_) return {ModelRole::Kind::tock};
    return find_role(events_->name(event));
}

ModelRole Alphabet::find_role(const std::string& name) const {
    const std::string prefix = interface_.component + "::";
    if (!starts_with(name, prefix)) return {ModelRole::Kind::foreign};
    const std::string_view local = std::string_view(name).substr(prefix.size());
    if (local == "terminate") return {ModelRole::Kind::terminate};
    if (interface_.robosim) {
        const ModelRole role = register_role(local);
        if (role.kind != ModelRole::Kind::foreign) return role;
    }
    for (std::uint32_t i = 0; i < interface_.inputs.size(); ++i) {
        const Register& input = interface_.inputs[i];
        const auto rest = arguments_after(local, input.name);
        if (!rest) continue;
        if (input.texts.empty() && rest->empty()) return {ModelRole::Kind::input, i, 1};
        const auto found = std::ranges::find(input.texts, rest->empty() ? *rest : rest->substr(1));
        if (found == input.texts.end()) return {ModelRole::Kind::foreign};
        return {ModelRole::Kind::input, i, 1 + static_cast<std::uint32_t>(found - input.texts.begin())};
    }
    for (std::uint32_t o = 0; o < interface_.outputs.size(); ++o) {
        const auto rest = arguments_after(local, interface_.outputs[o].name);
        if (rest) return output_role(o, *rest);
    }
    for (const std::string& channel : interface_.blocked) {
        if (arguments_after(local, channel)) return {ModelRole::Kind::blocked};
    }
    return {ModelRole::Kind::foreign};
}

/// Parses RoboSim's events: registerRead.P::S::i_e.true.v, registerWrite.P::S::o_e.v, endexec (docs/robosim.md,
/// "Names").
ModelRole Alphabet::register_role(std::string_view local) const {
    if (local == "endexec") return {ModelRole::Kind::hidden};
    const std::string read = "registerRead." + interface_.component + "::i_";
    const std::string write = "registerWrite." + interface_.component + "::o_";
    if (starts_with(local, read))
        for (std::uint32_t i = 0; i < interface_.inputs.size(); ++i)
            if (const auto rest = arguments_after(local.substr(read.size()), input_name(interface_.inputs[i])))
                return read_role(i, *rest);
    if (starts_with(local, write))
        for (std::uint32_t o = 0; o < interface_.outputs.size(); ++o)
            if (const auto rest = arguments_after(local.substr(write.size()), output_name(interface_.outputs[o])))
                return output_role(o, *rest);
    return {ModelRole::Kind::foreign};
}

/// Parses a read. The content of an event's register is `.true.v`, or `.false.v` with any v; that of a variable's
/// register is `.v`.
ModelRole Alphabet::read_role(std::uint32_t input, std::string_view content) const {
    const Register& read = interface_.inputs[input];
    if (read.kept == 0) {
        if (arguments_after(content, ".false")) return {ModelRole::Kind::read, input, 0};
        const auto value = arguments_after(content, ".true");
        if (!value) return {ModelRole::Kind::foreign};
        if (value->empty()) return {ModelRole::Kind::read, input, 1};
        content = *value;
    }
    const auto found = std::ranges::find(read.texts, content.empty() ? content : content.substr(1));
    if (found == read.texts.end()) return {ModelRole::Kind::foreign};
    return {ModelRole::Kind::read, input, 1 + static_cast<std::uint32_t>(found - read.texts.begin())};
}

ModelRole Alphabet::output_role(std::uint32_t output, std::string_view arguments) const {
    const process::Event write =
        events_->intern(fmt::format("registerWrite.wrote__{}{}", output_names_[output], arguments));
    return {ModelRole::Kind::output, output, 0, write};
}

CycleRole Alphabet::cycle_role(process::Event event) const {
    if (event == process::tick) return {CycleRole::Kind::tick};
    if (event == tock_) return {CycleRole::Kind::tock};
    for (std::uint32_t i = 0; i < reads_.size(); ++i) {
        const auto found = std::ranges::find(reads_[i], event);
        if (found != reads_[i].end())
            return {CycleRole::Kind::read, i, static_cast<std::uint32_t>(found - reads_[i].begin())};
    }
    for (std::uint32_t o = 0; o < output_names_.size(); ++o) {
        if (arguments_after(events_->name(event), "registerWrite.wrote__" + output_names_[o]))
            return {CycleRole::Kind::write, o};
    }
    return {CycleRole::Kind::other};
}

std::vector<std::string> Alphabet::written_arguments(process::Event write) const {
    const std::uint32_t output = cycle_role(write).index;
    const std::size_t prefix = std::string_view("registerWrite.wrote__").size() + output_names_[output].size();
    return split_arguments(std::string_view(events_->name(write)).substr(prefix), interface_.outputs[output].arguments);
}

std::string Alphabet::describe_write(std::uint32_t output, process::Event write) const {
    const Output& shown = interface_.outputs[output];
    const std::vector<std::string> parts = written_arguments(write);
    std::string texts;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Carrier carrier = i < shown.arguments.size() ? shown.arguments[i] : Carrier{};
        const auto value = number_of(carrier, parts[i]);
        std::string text = value ? people_text(carrier, *value, interface_.scale) : parts[i];
        if (carrier.kind == Carrier::Kind::enumeration && parts[i] == "-1") text = "another value";
        texts += (i == 0 ? "" : ", ") + text;
    }
    if (starts_with(shown.name, "set_")) return fmt::format("{} = {}", shown.name.substr(4), texts);
    return fmt::format("{}({})", short_name(shown.name), texts);
}

std::string Alphabet::describe_event(process::Event event) const {
    const CycleRole role = cycle_role(event);
    switch (role.kind) {
        case CycleRole::Kind::tock:
            return "end of cycle";
        case CycleRole::Kind::tick:
            return "termination";
        case CycleRole::Kind::write:
            return describe_write(role.index, event);
        case CycleRole::Kind::other:
            return events_->name(event);
        case CycleRole::Kind::read:
            break;
    }
    const Register& input = interface_.inputs[role.index];
    const std::string name = input_name(input);
    if (role.reading == 0) return "no " + name;
    if (input.values.empty()) return name;
    return fmt::format("{} = {}", name, people_text(input.carrier, input.values[role.reading - 1], interface_.scale));
}

}  // namespace robochart::conformance
