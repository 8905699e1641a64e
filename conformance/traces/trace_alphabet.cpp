// SPDX-License-Identifier: Apache-2.0
// Maps names and values of a log to events of NF_c(M). The names are the model's names. If two elements share a name,
// the names of the generated interface are used.
#include "conformance/traces/trace_alphabet.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "conformance/model/rules.hpp"
#include "cpp_emit/files/trace_names.hpp"

namespace robochart::conformance {

namespace {

template <class Channel>
std::vector<std::string> full_names(const std::vector<Channel>& channels) {
    std::vector<std::string> names;
    for (const Channel& channel : channels) names.push_back(channel.name);
    return names;
}

/// Returns the index of each name, under its full and its short form.
std::unordered_map<std::string, std::uint32_t> number_names(const std::vector<std::string>& full,
                                                            const std::vector<std::string>& shown) {
    std::unordered_map<std::string, std::uint32_t> ids;
    for (std::uint32_t i = 0; i < full.size(); ++i) ids.emplace(shown[i], i);
    for (std::uint32_t i = 0; i < full.size(); ++i) ids.emplace(full[i], i);
    return ids;
}

/// Splits a text at every `!` outside brackets and quotes.
std::vector<std::string_view> split_at_marks(std::string_view text) {
    std::vector<std::string_view> parts;
    int depth = 0;
    bool quoted = false;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"') quoted = !quoted;
        if (quoted) continue;
        if (c == '(' || c == '{' || c == '<') ++depth;
        if (c == ')' || c == '}' || c == '>') --depth;
        if (c != '!' || depth > 0) continue;
        parts.push_back(text.substr(begin, i - begin));
        begin = i + 1;
    }
    parts.push_back(text.substr(begin));
    return parts;
}

std::string list_names(const std::vector<std::string>& names) {
    return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

bool LoggedEvent::is_inside() const {
    return std::ranges::all_of(values, [](const LoggedValue& v) { return v.number.has_value(); });
}

TraceAlphabet::TraceAlphabet(const CyclicModel& model, const NumberCodes& codes) : model_(&model) {
    const Interface& interface = model.outside_interface();
    inputs_ = cpp_emit::trace_names(full_names(interface.inputs));
    outputs_ = cpp_emit::trace_names(full_names(interface.outputs));
    input_ids_ = number_names(full_names(interface.inputs), inputs_);
    output_ids_ = number_names(full_names(interface.outputs), outputs_);
    const ModelInterface& boundary = model.boundary();
    TestedNumbers numbers = boundary.numbers;
    numbers.codes = codes;
    const auto values = [&](ir::TypeId type, NumberReading reading) {
        return ValueReader(model.system(), model.instantiation(), type, numbers, reading);
    };
    for (const std::optional<ir::TypeId>& type : boundary.input_types) {
        input_values_.emplace_back();
        if (type) input_values_.back() = values(*type, NumberReading::exact);
    }
    for (const std::vector<ir::TypeId>& types : boundary.output_types) {
        output_values_.emplace_back();
        rounded_values_.emplace_back();
        for (const ir::TypeId type : types) {
            output_values_.back().push_back(values(type, NumberReading::exact));
            rounded_values_.back().push_back(values(type, NumberReading::rounded));
        }
    }
}

LoggedEvent TraceAlphabet::parse_kind(const TraceToken& token) const {
    const std::size_t mark = token.text.find_first_of("?!");
    if (mark == std::string_view::npos)
        throw TraceFault{
            &rules::log_syntax,
            {"an input `NAME?`, an output `NAME!`, `tock` or `terminate`", fmt::format("`{}`", token.text)},
            token.column,
            static_cast<std::uint32_t>(token.text.size())};
    LoggedEvent event;
    event.kind = token.text[mark] == '?' ? LoggedEvent::Kind::read : LoggedEvent::Kind::write;
    const bool input = event.kind == LoggedEvent::Kind::read;
    const auto& ids = input ? input_ids_ : output_ids_;
    const auto found = ids.find(std::string(token.text.substr(0, mark)));
    if (found == ids.end())
        throw TraceFault{&rules::log_name,
                         {model_->interface().component, input ? "input" : "output",
                          std::string(token.text.substr(0, mark)), list_names(input ? inputs_ : outputs_)},
                         token.column,
                         static_cast<std::uint32_t>(mark)};
    event.index = found->second;
    return event;
}

LoggedValue TraceAlphabet::parse_value(const ValueReader& reader, std::string_view text, const TraceToken& token,
                                       std::string_view name) {
    try {
        return reader.read_value(text);
    } catch (const ValueFault& fault) {
        const auto begin = static_cast<std::size_t>(text.data() - token.text.data()) + fault.begin;
        throw TraceFault{
            &rules::log_value,
            {std::string(name), fault.expected, fmt::format("`{}`", text.substr(fault.begin, fault.length))},
            token.column + static_cast<std::uint32_t>(begin),
            static_cast<std::uint32_t>(std::max<std::size_t>(fault.length, 1))};
    }
}

LoggedEvent TraceAlphabet::parse_event(const TraceToken& token, NumberReading reading) const {
    LoggedEvent event = parse_kind(token);
    const std::size_t mark = token.text.find_first_of("?!");
    const std::string_view name = token.text.substr(0, mark);
    const std::string_view rest = token.text.substr(mark + 1);
    std::vector<const ValueReader*> readers;
    if (event.kind == LoggedEvent::Kind::read) {
        if (input_values_[event.index]) readers.push_back(&*input_values_[event.index]);
    } else {
        const auto& values = reading == NumberReading::exact ? output_values_ : rounded_values_;
        for (const ValueReader& reader : values[event.index]) readers.push_back(&reader);
    }
    const auto parts = rest.empty() ? std::vector<std::string_view>{} : split_at_marks(rest);
    if (parts.size() != readers.size())
        throw TraceFault{&rules::log_value,
                         {std::string(name), fmt::format("{} value{}", readers.size(), readers.size() == 1 ? "" : "s"),
                          fmt::format("{}", parts.size())},
                         token.column,
                         static_cast<std::uint32_t>(token.text.size())};
    for (std::size_t i = 0; i < parts.size(); ++i)
        event.values.push_back(parse_value(*readers[i], parts[i], token, name));
    if (event.is_inside()) event.event = replacement_event(event, 0);
    return event;
}

const LoggedEvent& TraceAlphabet::read_event(const TraceToken& token) {
    constexpr std::size_t most_known = 1U << 14U;
    const auto found = known_.find(std::string(token.text));
    if (found != known_.end()) return found->second;
    last_ = parse_event(token, NumberReading::exact);
    if (last_.kind == LoggedEvent::Kind::write && !last_.is_inside())
        last_.rounded = parse_event(token, NumberReading::rounded).event;
    if (known_.size() >= most_known || !last_.is_inside()) return last_;
    return known_.emplace(std::string(token.text), last_).first->second;
}

process::Event TraceAlphabet::replacement_event(const LoggedEvent& event, std::uint64_t salt) const {
    const Alphabet& alphabet = model_->alphabet();
    if (event.kind == LoggedEvent::Kind::read) {
        if (event.values.empty()) return alphabet.read_event(event.index, 1);
        const std::int64_t number = input_values_[event.index]->replacement_index(event.values.front(), salt);
        const auto& values = model_->interface().inputs[event.index].values;
        const auto place = std::ranges::find(values, number);
        return alphabet.read_event(event.index, 1 + static_cast<std::uint32_t>(place - values.begin()));
    }
    std::vector<std::int64_t> numbers;
    for (std::size_t i = 0; i < event.values.size(); ++i)
        numbers.push_back(output_values_[event.index][i].replacement_index(event.values[i], salt));
    return alphabet.write_event(event.index, numbers);
}

}  // namespace robochart::conformance
