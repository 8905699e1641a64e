// SPDX-License-Identifier: Apache-2.0
// Reads values in logs by the types of the model. Replaces numbers outside the carriers if the component only passes
// them on, or only compares them with constants: then all numbers on the same side of each constant give the same
// answers. So a run with such a number remains a run if its numbers are renamed by a bijection that preserves the
// sides.
#include "conformance/model/logged_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <utility>

#include "base/diagnostics/containers.hpp"
#include "base/diagnostics/scanner.hpp"
#include "conformance/code/interface.hpp"
#include "cpp_emit/plan/types.hpp"
#include "semantics/evaluate/carrier.hpp"

namespace robochart::conformance {

namespace {

using ir::TypeKind;

const std::vector<std::int64_t>* carrier_numbers(const ir::Instantiation& instantiation, TypeKind kind) {
    if (kind == TypeKind::nat) return &instantiation.nat;
    if (kind == TypeKind::integer) return &instantiation.integer;
    if (kind == TypeKind::real) return &instantiation.real;
    return nullptr;
}

std::uint64_t hash_text(std::string_view text, std::uint64_t salt) {
    std::uint64_t hash = 0xcbf29ce484222325ULL ^ (salt * 0x9E3779B97F4A7C15ULL);
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    return (hash ^ hash >> 32U) * 0x9E3779B97F4A7C15ULL >> 16U;
}

/// Parses one value from left to right. Recursion depth: the depth of its type.
class ValueParser : diagnostics::Scanner {
public:
    ValueParser(const ir::System& system, const ir::Instantiation& instantiation, const TestedNumbers& numbers,
                NumberReading reading, std::string_view text)
        : Scanner(text), system_(system), instantiation_(instantiation), numbers_(numbers), reading_(reading) {}

    LoggedPart parse_whole(ir::TypeId type) {
        LoggedPart result = parse_value(type);
        skip_blanks();
        if (!at_end()) throw ValueFault{describe_shape(type), 0, text_.size()};
        return result;
    }

private:
    LoggedPart parse_value(ir::TypeId id) {
        const ir::Type& type = system_.type(id);
        skip_blanks();
        const std::size_t begin = at_;
        switch (type.kind) {
            case TypeKind::boolean:
                return parse_truth();
            case TypeKind::nat:
            case TypeKind::integer:
            case TypeKind::real:
            case TypeKind::given:
                return parse_number(type.kind);
            case TypeKind::enumeration:
                return parse_literal(id);
            case TypeKind::string:
                return parse_characters();
            case TypeKind::sequence:
            case TypeKind::set:
                return parse_list(type, begin, type.kind == TypeKind::set ? "{}" : "<>",
                                  [&] { return parse_value(type.args[0]); });
            case TypeKind::relation:
            case TypeKind::function:
                return parse_list(type, begin, "{}", [&] { return parse_tuple(type, begin); });
            case TypeKind::vector:
                return parse_row(type, type.sizes.at(0), begin);
            case TypeKind::matrix:
                return parse_repeated(type, type.sizes.at(0), begin,
                                      [&] { return parse_row(type, type.sizes.at(1), begin); });
            case TypeKind::product:
            case TypeKind::record:
            case TypeKind::unit:
                break;
        }
        return parse_tuple(type, begin);
    }

    // ------------------------------------------------------------ values without parts

    LoggedPart parse_truth() {
        const std::string_view word = parse_name();
        if (word != "true" && word != "false") throw make_fault("true or false", word);
        return {word == "true" ? 1 : 0, "", 0, TypeKind::boolean, {}};
    }

    LoggedPart parse_number(TypeKind kind) {
        const std::string_view tail = rest();
        double value = 0;
        const auto [end, code] = std::from_chars(tail.data(), tail.data() + tail.size(), value);
        const auto length = static_cast<std::size_t>(end - tail.data());
        if (code != std::errc() || !std::isfinite(value) || (length < tail.size() && !ends_value(tail[length])))
            throw make_fault("a number", parse_name());
        const std::string_view word = tail.substr(0, length);
        const bool real = kind == TypeKind::real;
        const double scaled = real ? value * static_cast<double>(instantiation_.scale) : value;
        if (!real && scaled != std::floor(scaled)) throw make_fault("a whole number", word);
        at_ += length;
        if (const auto known = known_code(kind, value)) return {*known, "", 0, kind, {}};
        const double near = std::round(scaled);
        if (std::abs(near) < 9e15 && is_near(kind, value, scaled, near) &&
            is_in_carrier(kind, static_cast<std::int64_t>(near)))
            return {static_cast<std::int64_t>(near), "", 0, kind, {}};
        return {0, fmt::format("{}", value), value, kind, {}};
    }

    /// The number of the carrier for a logged number of NumberCodes, or for one that is a literal but for a rounding
    /// error.
    [[nodiscard]] std::optional<std::int64_t> known_code(TypeKind kind, double value) const {
        if (numbers_.codes.empty()) return std::nullopt;
        if (reading_ == NumberReading::exact) {
            const auto found = numbers_.codes.find({kind, value});
            return found == numbers_.codes.end() ? std::nullopt : std::optional(found->second);
        }
        if (kind != TypeKind::real) return std::nullopt;
        const auto rounds_to = [&](double literal) {
            return std::abs(value - literal) <= 1e-9 * std::max(1.0, std::abs(literal)) ||
                   value == static_cast<double>(static_cast<float>(literal));
        };
        const auto literal = std::ranges::find_if(numbers_.literals, rounds_to);
        if (literal == numbers_.literals.end()) return std::nullopt;
        const std::int64_t code = std::llround(*literal * static_cast<double>(instantiation_.scale));
        return is_in_carrier(kind, code) ? std::optional(code) : std::nullopt;
    }

    /// Returns whether the logged number is taken as `near`, in units of 1/scale.
    [[nodiscard]] bool is_near(TypeKind kind, double value, double scaled, double near) const {
        if (kind != TypeKind::real) return scaled == near;
        const double decimal = near / static_cast<double>(instantiation_.scale);
        const NumberUse use = numbers_.uses.use_of(kind);
        const bool tested = use == NumberUse::compared || use == NumberUse::related;
        if (reading_ == NumberReading::exact && tested) return value == decimal;
        // the error of a decimal of the model in binary floating point is smaller
        if (std::abs(scaled - near) <= 1e-9 * std::max(1.0, std::abs(scaled))) return true;
        return use != NumberUse::computed && value == static_cast<double>(static_cast<float>(decimal));
    }

    [[nodiscard]] bool is_in_carrier(TypeKind kind, std::int64_t value) const {
        if (kind == TypeKind::given) return value >= 0 && value < instantiation_.given_size;
        const auto* const all = carrier_numbers(instantiation_, kind);
        return std::ranges::binary_search(*all, value);
    }

    /// Parses a literal by its name in the model or in CSP.
    LoggedPart parse_literal(ir::TypeId id) {
        const ir::Type& type = system_.type(id);
        const std::size_t begin = at_;
        const std::string_view word = parse_name();
        LoggedPart result{0, "", 0, TypeKind::enumeration, {}};
        const auto same = [&](std::size_t i) {
            return word == type.labels[i] ||
                   word == cpp_emit::cspm_value(system_, id, {static_cast<std::int64_t>(i), {}});
        };
        std::size_t index = 0;
        while (index < type.labels.size() && !same(index)) ++index;
        if (index == type.labels.size()) throw make_fault(describe_shape(id), word);
        result.number = static_cast<std::int64_t>(index);
        if (index >= type.literal_args.size() || type.literal_args[index].empty()) return result;
        const std::vector<ir::TypeId>& arguments = type.literal_args[index];
        expect('(', type, begin);
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            if (i > 0) expect(',', type, begin);
            result.parts.push_back(parse_value(arguments[i]));
        }
        expect(')', type, begin);
        return result;
    }

    LoggedPart parse_characters() {
        const std::size_t begin = at_;
        LoggedPart result{0, "", 0, TypeKind::string, {}};
        const auto unfinished = [&] { return ValueFault{"a text in quotes", begin, text_.size() - begin}; };
        if (!accept("\"")) throw unfinished();
        while (!at_end() && peek() != '"') result.parts.push_back({parse_character(), "", 0, TypeKind::unit, {}});
        if (!accept("\"")) throw unfinished();
        return result;
    }

    /// Parses a character. A backslash and three octal digits encode any character.
    std::int64_t parse_character() {
        const auto digit = [&](std::size_t i) {
            const char c = peek(i);
            return c >= '0' && c <= '7' ? c - '0' : -1;
        };
        if (text_[at_] == '\\' && digit(1) >= 0 && digit(1) < 4 && digit(2) >= 0 && digit(3) >= 0) {
            const int code = digit(1) * 64 + digit(2) * 8 + digit(3);
            at_ += 4;
            return code;
        }
        return static_cast<unsigned char>(text_[at_++]);
    }

    // ------------------------------------------------------------ values with parts

    template <class Item>
    LoggedPart parse_list(const ir::Type& type, std::size_t begin, const char* brackets, const Item& item) {
        LoggedPart result{0, "", 0, type.kind, {}};
        expect(brackets[0], type, begin);
        if (accept_character(brackets[1])) return result;
        do result.parts.push_back(item());
        while (accept_character(','));
        expect(brackets[1], type, begin);
        return result;
    }

    /// Parses items in parentheses; a single item has none.
    template <class Item>
    LoggedPart parse_repeated(const ir::Type& type, std::int64_t count, std::size_t begin, const Item& item) {
        LoggedPart result{0, "", 0, TypeKind::product, {}};
        if (count != 1) expect('(', type, begin);
        for (std::int64_t i = 0; i < count; ++i) {
            if (i > 0) expect(',', type, begin);
            result.parts.push_back(item());
        }
        if (count != 1) expect(')', type, begin);
        return result;
    }

    LoggedPart parse_row(const ir::Type& type, std::int64_t count, std::size_t begin) {
        return parse_repeated(type, count, begin, [&] { return parse_value(type.args.at(0)); });
    }

    LoggedPart parse_tuple(const ir::Type& type, std::size_t begin) {
        std::size_t next = 0;
        return parse_repeated(type, static_cast<std::int64_t>(type.args.size()), begin,
                              [&] { return parse_value(type.args[next++]); });
    }

    // ------------------------------------------------------------ text

    void skip_blanks() {
        skip_while([](char c) { return c == ' ' || c == '\t'; });
    }
    bool accept_character(char c) {
        skip_blanks();
        return accept({&c, 1});
    }
    void expect(char c, const ir::Type& type, std::size_t begin) {
        if (!accept_character(c)) throw ValueFault{describe_shape(type), begin, text_.size() - begin};
    }
    static bool ends_value(char c) {
        static constexpr std::string_view ends = " \t,()<>{}\"";
        return ends.find(c) != std::string_view::npos;
    }
    std::string_view parse_name() {
        const std::size_t begin = at_;
        skip_while([](char c) { return !ends_value(c); });
        return text_from(begin);
    }
    [[nodiscard]] ValueFault make_fault(std::string expected, std::string_view word) const {
        const auto begin = static_cast<std::size_t>(word.data() - text_.data());
        return {std::move(expected), begin, word.size()};
    }

    [[nodiscard]] std::string describe_shape(ir::TypeId id) const { return describe_shape(system_.type(id)); }
    /// Describes the form of the type's values.
    [[nodiscard]] static std::string describe_shape(const ir::Type& type) {
        switch (type.kind) {
            case TypeKind::enumeration:
                return "a literal of " + type.name;
            case TypeKind::sequence:
                return "a sequence `<...,...>`";
            case TypeKind::set:
                return "a set `{...,...}`";
            case TypeKind::relation:
            case TypeKind::function:
                return "pairs `{(...,...),...}`";
            case TypeKind::matrix:
                return fmt::format("{} rows of {} values, `((...,...),...)`", type.sizes.at(0), type.sizes.at(1));
            case TypeKind::vector:
                return fmt::format("{} values `(...,...)`", type.sizes.at(0));
            case TypeKind::record:
            case TypeKind::product:
                return fmt::format("{} values `(...,...)`", type.args.size());
            case TypeKind::boolean:
            case TypeKind::nat:
            case TypeKind::integer:
            case TypeKind::real:
            case TypeKind::string:
            case TypeKind::given:
            case TypeKind::unit:
                break;
        }
        return "one value of its type";
    }

    const ir::System& system_;
    const ir::Instantiation& instantiation_;
    const TestedNumbers& numbers_;
    NumberReading reading_;
};

bool all_inside(const LoggedPart& part) {
    return part.outside.empty() && std::ranges::all_of(part.parts, all_inside);
}

}  // namespace

ValueReader::ValueReader(const ir::System& system, const ir::Instantiation& instantiation, ir::TypeId type,
                         const TestedNumbers& numbers, NumberReading reading)
    : system_(&system),
      instantiation_(&instantiation),
      type_(type),
      numbers_(numbers),
      reading_(reading),
      composed_(cpp_emit::is_composed(system.type(type))) {
    if (!composed_) return;
    for (const ir::Value& value : ir::carrier_values(system, instantiation, type))
        places_.emplace(value, static_cast<std::int64_t>(places_.size()));
}

ValueReader::Answers ValueReader::answers_for(TypeKind kind, double value) const {
    const auto found = numbers_.constants.find(kind);
    if (numbers_.uses.use_of(kind) == NumberUse::passed_on || found == numbers_.constants.end()) return {0, -1};
    const ComparedConstants& constants = found->second;
    const auto below = std::ranges::lower_bound(constants.ordered, value) - constants.ordered.begin();
    const auto equal = std::ranges::find(constants.all, value);
    return {static_cast<std::size_t>(below), equal == constants.all.end() ? -1 : equal - constants.all.begin()};
}

const std::vector<std::int64_t>& ValueReader::candidates(const LoggedPart& part) const {
    static const std::vector<std::int64_t> none;
    const auto* const all = carrier_numbers(*instantiation_, part.kind);
    if (all == nullptr || numbers_.uses.use_of(part.kind) >= NumberUse::related) return none;
    const Answers answers = answers_for(part.kind, part.value);
    const auto [known, fresh] = candidates_.try_emplace({part.kind, answers});
    std::vector<std::int64_t>& chosen = known->second;
    if (!fresh) return chosen;
    const double units = part.kind == TypeKind::real ? static_cast<double>(instantiation_->scale) : 1;
    std::vector<std::int64_t> literals;
    for (const std::int64_t number : *all) {
        const double value = static_cast<double>(number) / units;
        if (answers_for(part.kind, value) != answers) continue;
        (std::ranges::binary_search(numbers_.literals, value) ? literals : chosen).push_back(number);
    }
    if (chosen.empty()) chosen = std::move(literals);
    return chosen;
}

std::optional<std::int64_t> ValueReader::replacement_number(const LoggedPart& part, std::uint64_t salt) const {
    if (part.outside.empty()) return part.number;
    const std::vector<std::int64_t>& all = candidates(part);
    return all.empty() ? std::nullopt : std::optional(all[hash_text(part.outside, salt) % all.size()]);
}

/// Returns the corresponding value of the model, with other numbers in place of those outside their carriers.
std::optional<ir::Value> ValueReader::replacement_value(const LoggedPart& part, std::uint64_t salt) const {
    const auto number = replacement_number(part, salt);
    if (!number) return std::nullopt;
    ir::Value value{*number, {}};
    for (const LoggedPart& inner_part : part.parts) {
        auto inner = replacement_value(inner_part, salt);
        if (!inner) return std::nullopt;
        value.parts.push_back(std::move(*inner));
    }
    if (part.kind == TypeKind::set || part.kind == TypeKind::relation || part.kind == TypeKind::function)
        diagnostics::sort_unique(value.parts);
    return value;
}

const SequenceTests* ValueReader::sequence_tests() const {
    const auto found = numbers_.sequences.types.find(type_.index);
    return found == numbers_.sequences.types.end() ? nullptr : &found->second;
}

std::optional<std::int64_t> ValueReader::sequence_index(const SequenceTests& tests, const LoggedPart& sequence) const {
    std::vector<double> items;
    for (const LoggedPart& item : sequence.parts) {
        const double unit = item.kind == TypeKind::real ? static_cast<double>(instantiation_->scale) : 1;
        items.push_back(item.outside.empty() ? static_cast<double>(item.number) / unit : item.value);
    }
    const auto found = tests.sequences.find(tests.signs_at(items));
    if (found == tests.sequences.end()) return std::nullopt;
    return places_.at(found->second);
}

std::optional<std::int64_t> ValueReader::carrier_index(const LoggedPart& whole, std::uint64_t salt) const {
    if (const SequenceTests* const tests = sequence_tests()) return sequence_index(*tests, whole);
    const auto value = replacement_value(whole, salt);
    if (!value) return std::nullopt;
    if (!composed_) return value->number;
    const auto found = places_.find(*value);
    return found == places_.end() ? std::nullopt : std::optional(found->second);
}

/// Returns whether all numbers outside their carriers can be replaced. Functions are total over their carriers, so they
/// contain no such numbers.
bool ValueReader::is_replaceable(const LoggedPart& part) const {
    return part.kind == TypeKind::function
               ? all_inside(part)
               : std::ranges::all_of(part.parts, [&](const LoggedPart& inner) { return is_replaceable(inner); });
}

LoggedValue ValueReader::read_value(std::string_view text) const {
    LoggedValue result;
    result.whole = ValueParser(*system_, *instantiation_, numbers_, reading_, text).parse_whole(type_);
    const bool inside = all_inside(result.whole);
    if (inside || sequence_tests() != nullptr) result.number = carrier_index(result.whole, 0);
    if (result.number) return result;
    result.text = composed_ ? std::string(text) : result.whole.outside;
    // A value that is outside for another reason, such as a sequence that is too long, cannot be replaced.
    result.replaceable = !inside && is_replaceable(result.whole) && carrier_index(result.whole, 0).has_value();
    return result;
}

std::int64_t ValueReader::replacement_index(const LoggedValue& value, std::uint64_t salt) const {
    return value.number ? *value.number : carrier_index(value.whole, salt).value();
}

namespace {

/// Writes values. Recursion depth: the depth of their types.
class Writing {
public:
    Writing(const ir::System& system, const ir::Instantiation& instantiation)
        : system_(system), instantiation_(instantiation) {}

    [[nodiscard]] std::string write_value(ir::TypeId id, const ir::Value& value) const {
        const ir::Type& type = system_.type(id);
        switch (type.kind) {
            case TypeKind::boolean:
                return value.number != 0 ? "true" : "false";
            case TypeKind::real:
                return people_text({Carrier::Kind::real, {}, {}}, value.number, instantiation_.scale);
            case TypeKind::enumeration:
                return write_literal(type, value);
            case TypeKind::string:
                return write_characters(value);
            case TypeKind::sequence:
                return "<" + write_items(type.args.at(0), value) + ">";
            case TypeKind::set:
                return "{" + write_items(type.args.at(0), value) + "}";
            case TypeKind::relation:
            case TypeKind::function:
                return "{" +
                       join_items(value, [&](const ir::Value& pair, std::size_t) { return write_tuple(type, pair); }) +
                       "}";
            case TypeKind::matrix:
                return add_brackets(value, join_items(value, [&](const ir::Value& row, std::size_t) {
                                        return add_brackets(row, write_items(type.args.at(0), row));
                                    }));
            case TypeKind::vector:
                return add_brackets(value, write_items(type.args.at(0), value));
            case TypeKind::record:
            case TypeKind::product:
                return write_tuple(type, value);
            case TypeKind::nat:
            case TypeKind::integer:
            case TypeKind::given:
            case TypeKind::unit:
                break;
        }
        return fmt::format("{}", value.number);
    }

private:
    template <class Item>
    static std::string join_items(const ir::Value& value, const Item& item) {
        std::string text;
        for (std::size_t i = 0; i < value.parts.size(); ++i) text += (i == 0 ? "" : ",") + item(value.parts[i], i);
        return text;
    }
    static std::string add_brackets(const ir::Value& value, const std::string& text) {
        return value.parts.size() == 1 ? text : "(" + text + ")";
    }
    [[nodiscard]] std::string write_items(ir::TypeId type, const ir::Value& value) const {
        return join_items(value, [&](const ir::Value& part, std::size_t) { return this->write_value(type, part); });
    }
    [[nodiscard]] std::string write_tuple(const ir::Type& type, const ir::Value& value) const {
        return add_brackets(value, join_items(value, [&](const ir::Value& part, std::size_t i) {
                                return this->write_value(type.args.at(i), part);
                            }));
    }
    [[nodiscard]] std::string write_literal(const ir::Type& type, const ir::Value& value) const {
        const auto index = static_cast<std::size_t>(value.number);
        if (value.parts.empty()) return type.labels.at(index);
        return fmt::format("{}({})", type.labels.at(index),
                           join_items(value, [&](const ir::Value& part, std::size_t i) {
                               return this->write_value(type.literal_args[index].at(i), part);
                           }));
    }
    /// Returns the string as robochart/trace.hpp prints it.
    static std::string write_characters(const ir::Value& value) {
        static constexpr std::string_view special = "\"\\!?/";
        std::string text;
        for (const ir::Value& part : value.parts) {
            const bool plain = part.number > 0x20 && part.number != 0x7f &&
                               special.find(static_cast<char>(part.number)) == std::string_view::npos;
            text += plain ? std::string(1, static_cast<char>(part.number)) : fmt::format("\\{:03o}", part.number);
        }
        return '"' + text + '"';
    }

    const ir::System& system_;
    const ir::Instantiation& instantiation_;
};

}  // namespace

std::string log_text(const ir::System& system, const ir::Instantiation& instantiation, ir::TypeId type,
                     const ir::Value& value) {
    return Writing(system, instantiation).write_value(type, value);
}

}  // namespace robochart::conformance
