// See trace_alphabet.hpp.
#include "conformance/trace_alphabet.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "conformance/rules.hpp"
#include "cpp_emit/trace_names.hpp"
#include "cpp_emit/types.hpp"

namespace robochart::conformance {

namespace {

template <class Channel>
std::vector<std::string> full_names(const std::vector<Channel>& channels) {
    std::vector<std::string> names;
    for (const Channel& channel : channels) names.push_back(channel.name);
    return names;
}

/// By both names.
std::unordered_map<std::string, std::uint32_t> numbered(const std::vector<std::string>& full,
                                                        const std::vector<std::string>& shown) {
    std::unordered_map<std::string, std::uint32_t> ids;
    for (std::uint32_t i = 0; i < full.size(); ++i) ids.emplace(shown[i], i);
    for (std::uint32_t i = 0; i < full.size(); ++i) ids.emplace(full[i], i);
    return ids;
}

std::string without_blanks(std::string_view text) {
    std::string result;
    for (const char c : text)
        if (c != ' ' && c != '\t') result += c;
    return result;
}

/// At `!` outside of brackets and quotes.
std::vector<std::string_view> arguments(std::string_view text) {
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

std::optional<double> decimal(std::string_view text) {
    double value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::string listed(const std::vector<std::string>& names) {
    return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

std::uint64_t mixed(std::string_view text, std::uint64_t salt) {
    std::uint64_t hash = 0xcbf29ce484222325ULL ^ (salt * 0x9E3779B97F4A7C15ULL);
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    return (hash ^ hash >> 32U) * 0x9E3779B97F4A7C15ULL >> 16U;
}

}  // namespace

bool LoggedEvent::inside() const {
    return std::all_of(values.begin(), values.end(), [](const LoggedValue& v) { return v.number.has_value(); });
}

TraceAlphabet::TraceAlphabet(const CyclicModel& model) : model_(&model) {
    const Interface& interface = model.interface();
    inputs_ = cpp_emit::trace_names(full_names(interface.inputs));
    outputs_ = cpp_emit::trace_names(full_names(interface.outputs));
    input_ids_ = numbered(full_names(interface.inputs), inputs_);
    output_ids_ = numbered(full_names(interface.outputs), outputs_);
    const Boundary& boundary = model.boundary();
    for (std::size_t i = 0; i < interface.inputs.size(); ++i) {
        input_domains_.emplace_back();
        if (boundary.input_types[i])
            input_domains_.back() = domain(*boundary.input_types[i], interface.inputs[i].carrier);
    }
    for (std::size_t o = 0; o < interface.outputs.size(); ++o) {
        output_domains_.emplace_back();
        for (std::size_t a = 0; a < boundary.output_types[o].size(); ++a)
            output_domains_.back().push_back(domain(boundary.output_types[o][a], interface.outputs[o].arguments[a]));
    }
}

TraceAlphabet::Domain TraceAlphabet::domain(ir::TypeId type, const Carrier& carrier) const {
    Domain result;
    result.carrier = carrier;
    result.kind = model_->system().type(type).kind;
    const bool whole = cpp_emit::composed(model_->system().type(type));
    for (const ir::Value& value : ir::carrier(model_->system(), model_->instantiation(), type))
        result.values.push_back(whole ? static_cast<std::int64_t>(result.values.size()) : value.number);
    if (carrier.kind == Carrier::Kind::enumeration) {
        for (const std::vector<std::string>* names : {&carrier.literals, &carrier.names})
            for (std::size_t i = 0; i < names->size(); ++i)
                result.texts.emplace(without_blanks((*names)[i]), static_cast<std::int64_t>(i));
    }
    return result;
}

LoggedEvent TraceAlphabet::kind(const TraceToken& token) const {
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
                          std::string(token.text.substr(0, mark)), listed(input ? inputs_ : outputs_)},
                         token.column,
                         static_cast<std::uint32_t>(mark)};
    event.index = found->second;
    return event;
}

LoggedValue TraceAlphabet::value(const Domain& domain, std::string_view text, const TraceToken& token,
                                 std::string_view name) const {
    const auto fault = [&](const char* wanted) {
        return TraceFault{&rules::log_value,
                          {std::string(name), wanted, fmt::format("`{}`", text)},
                          token.column,
                          static_cast<std::uint32_t>(token.text.size())};
    };
    LoggedValue result;
    if (domain.carrier.kind == Carrier::Kind::boolean) {
        if (text != "true" && text != "false") throw fault("true or false");
        result.number = text == "true" ? 1 : 0;
        return result;
    }
    if (domain.carrier.kind == Carrier::Kind::enumeration) {
        const auto found = domain.texts.find(without_blanks(text));
        if (found == domain.texts.end()) throw fault("a value of its type");
        result.number = found->second;
        return result;
    }
    const auto number = decimal(text);
    if (!number) throw fault("a number");
    const bool real = domain.carrier.kind == Carrier::Kind::real;
    const double scaled = real ? *number * static_cast<double>(model_->interface().scale) : *number;
    if (!real && scaled != std::floor(scaled)) throw fault("a whole number");
    // A decimal of the model as binary floating point is off by less than this.
    const double near = std::round(scaled);
    const bool whole = std::abs(scaled - near) <= 1e-9 * std::max(1.0, std::abs(scaled));
    if (whole && std::abs(near) < 9e15 &&
        std::binary_search(domain.values.begin(), domain.values.end(), static_cast<std::int64_t>(near)))
        result.number = static_cast<std::int64_t>(near);
    result.text = fmt::format("{}", *number);
    result.passed_on = model_->boundary().passed_on.of(domain.kind) && !domain.values.empty();
    return result;
}

LoggedEvent TraceAlphabet::parse(const TraceToken& token) const {
    LoggedEvent event = kind(token);
    const std::size_t mark = token.text.find_first_of("?!");
    const std::string_view name = token.text.substr(0, mark);
    const std::string_view rest = token.text.substr(mark + 1);
    std::vector<const Domain*> domains;
    if (event.kind == LoggedEvent::Kind::read) {
        if (input_domains_[event.index]) domains.push_back(&*input_domains_[event.index]);
    } else {
        for (const Domain& domain : output_domains_[event.index]) domains.push_back(&domain);
    }
    const auto parts = rest.empty() ? std::vector<std::string_view>{} : arguments(rest);
    if (parts.size() != domains.size())
        throw TraceFault{&rules::log_value,
                         {std::string(name), fmt::format("{} value{}", domains.size(), domains.size() == 1 ? "" : "s"),
                          fmt::format("{}", parts.size())},
                         token.column,
                         static_cast<std::uint32_t>(token.text.size())};
    for (std::size_t i = 0; i < parts.size(); ++i) event.values.push_back(value(*domains[i], parts[i], token, name));
    if (event.inside()) event.event = stand_in(event, 0);
    return event;
}

const LoggedEvent& TraceAlphabet::read(const TraceToken& token) {
    constexpr std::size_t kept = 1U << 14U;
    const auto found = known_.find(std::string(token.text));
    if (found != known_.end()) return found->second;
    last_ = parse(token);
    if (known_.size() >= kept || !last_.inside()) return last_;
    return known_.emplace(std::string(token.text), last_).first->second;
}

std::int64_t TraceAlphabet::replace(const Domain& domain, const LoggedValue& value, std::uint64_t salt) const {
    if (value.number) return *value.number;
    return domain.values[mixed(value.text, salt) % domain.values.size()];
}

process::Event TraceAlphabet::stand_in(const LoggedEvent& event, std::uint64_t salt) const {
    const Alphabet& alphabet = model_->alphabet();
    if (event.kind == LoggedEvent::Kind::read) {
        if (event.values.empty()) return alphabet.read(event.index, 1);
        const std::int64_t number = replace(*input_domains_[event.index], event.values.front(), salt);
        const auto& values = model_->interface().inputs[event.index].values;
        const auto place = std::find(values.begin(), values.end(), number);
        return alphabet.read(event.index, 1 + static_cast<std::uint32_t>(place - values.begin()));
    }
    std::vector<std::int64_t> numbers;
    for (std::size_t i = 0; i < event.values.size(); ++i)
        numbers.push_back(replace(output_domains_[event.index][i], event.values[i], salt));
    return alphabet.write(event.index, numbers);
}

}  // namespace robochart::conformance
