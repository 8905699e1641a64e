// SPDX-License-Identifier: Apache-2.0
// See letters.hpp.
#include "claims/decide/letters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/base/types.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::claims {
namespace {

namespace build = cspm::build;

constexpr std::size_t most_letters = 5000;

/// A value of a condition with its text in the script.
struct LetterValue {
    Fraction value;
    std::string text;
    cspm::ExprPtr expression;
};

LetterValue number_value(std::int64_t number, std::int64_t scale) {
    return {Fraction(number, scale), fmt::format("{}", number), build::number(number)};
}

std::vector<LetterValue> values_of(const ir::Type& type, const ir::Instantiation& instantiation) {
    std::vector<LetterValue> result;
    const auto add_numbers = [&](const std::vector<std::int64_t>& numbers, std::int64_t scale) {
        for (const std::int64_t number : numbers) result.push_back(number_value(number, scale));
    };
    if (type.kind == ir::TypeKind::nat) add_numbers(instantiation.nat, 1);
    if (type.kind == ir::TypeKind::integer) add_numbers(instantiation.integer, 1);
    if (type.kind == ir::TypeKind::real) add_numbers(instantiation.real, instantiation.scale);
    if (type.kind == ir::TypeKind::boolean)
        for (const bool value : {false, true})
            result.push_back({Fraction(value ? 1 : 0), value ? "true" : "false", build::boolean(value)});
    if (type.kind == ir::TypeKind::enumeration)
        for (std::size_t i = 0; i < type.labels.size(); ++i) {
            if (!type.literal_args[i].empty()) return {};
            const std::string name = csp_emit::literal_name(type, i);
            result.push_back({Fraction(static_cast<std::int64_t>(i)), name, build::name(name)});
        }
    return result;
}

/// Returns the channels whose values some condition reads.
std::set<std::size_t> channels_with_values(const CheckedClaim& claim) {
    std::set<std::size_t> result(claim.remembered.begin(), claim.remembered.end());
    for (const Events* events : sets_of(claim))
        for (const EventMatch& match : events->any)
            if (match.condition) result.insert(match.channels.begin(), match.channels.end());
    return result;
}

/// Throws NotDecided if one of the channels carries numbers, because a csp block may give numbers other values than the
/// instantiation. It does not change enumerations and truth values.
void refuse_numbers(const CheckedClaim& claim, const std::set<std::size_t>& channels, const ir::System& system) {
    for (const std::size_t channel : channels)
        for (const ir::TypeId type : claim.component.channels[channel].types) {
            const ir::TypeKind kind = system.type(type).kind;
            if (kind != ir::TypeKind::boolean && kind != ir::TypeKind::enumeration)
                throw NotDecided("a csp block sets the values, which conditions of claims do not read");
        }
}

bool reads_last(const Condition& condition) {
    return condition.operand == Operand::last || std::ranges::any_of(condition.parts, reads_last);
}

}  // namespace

std::vector<const Events*> sets_of(const CheckedClaim& claim) {
    return {&claim.scope.first, &claim.scope.last, &claim.body.events, &claim.body.others, &claim.body.exceptions};
}

namespace {

class LetterMaker {
public:
    LetterMaker(const CheckedClaim& claim, const ir::System& system, const ir::Instantiation& instantiation)
        : claim_(claim), system_(system), instantiation_(instantiation) {}

    void add_channel(std::size_t channel, bool with_values) {
        const Channel& of = claim_.component.channels[channel];
        const std::string name = claim_.component.path + "::" + of.name + (of.kind == ChannelKind::call ? "Call" : "");
        Letter letter{{channel, {}}, {}, {name}, {build::name(name)}, of.name};
        if (of.kind != ChannelKind::call) extend(letter, of.kind == ChannelKind::input ? "in" : "out");
        if (with_values)
            add_values(letter, of, 0);
        else
            letters_.push_back(std::move(letter));
    }
    std::vector<Letter> take() { return std::move(letters_); }

private:
    static void extend(Letter& letter, const std::string& text) {
        letter.events[0] += "." + text;
        letter.prefixes[0] = build::dot({letter.prefixes[0], build::name(text)});
    }

    void add_values(const Letter& letter, const Channel& channel, std::size_t at) {
        instantiation_.poll();
        if (at == channel.types.size()) {
            letters_.push_back(letter);
            if (letters_.size() > most_letters)
                throw NotDecided(fmt::format("`{}` has more than {} values", channel.name, most_letters));
            return;
        }
        const ir::Type& type = system_.type(channel.types[at]);
        const std::vector<LetterValue> values = values_of(type, instantiation_);
        if (values.empty())
            throw NotDecided(fmt::format("`{}` also carries values of the type {}, which conditions do not list",
                                         channel.name, type.name));
        for (const LetterValue& value : values) {
            Letter next = letter;
            next.events[0] += "." + value.text;
            next.prefixes[0] = build::dot({next.prefixes[0], value.expression});
            next.occurrence.values.push_back(value.value);
            add_values(next, channel, at + 1);
        }
    }

    const CheckedClaim& claim_;
    const ir::System& system_;
    const ir::Instantiation& instantiation_;
    std::vector<Letter> letters_;
};

}  // namespace

std::string shown_channel(const std::string& machine) {
    return machine + "::shown__";
}

namespace {

/// Returns one letter for each combination of truth values of the claim's facts about a machine. The letter allows any
/// values of the other facts that the machine shows.
std::vector<Letter> fact_letters(const CheckedClaim& claim, const std::string& machine,
                                 const std::vector<Fact>& facts) {
    std::vector<std::optional<std::size_t>> of_claim;  // index: the position in the event
    for (const Fact& fact : facts) {
        const auto found = std::ranges::find(claim.facts, fact);
        of_claim.push_back(found == claim.facts.end() ? std::nullopt
                                                      : std::optional<std::size_t>(found - claim.facts.begin()));
    }
    std::map<std::vector<FactValue>, Letter> letters;
    for (std::size_t bits = 0; bits < (std::size_t{1} << facts.size()); ++bits) {
        std::vector<FactValue> values;
        std::string event = shown_channel(machine);
        cspm::ExprPtr prefix = build::name(event);
        for (std::size_t i = 0; i < facts.size(); ++i) {
            const bool holds = (bits >> i) % 2 == 1;
            if (of_claim[i]) values.push_back({*of_claim[i], holds});
            event += holds ? ".true" : ".false";
            prefix = build::dot({prefix, build::boolean(holds)});
        }
        if (values.empty()) return {};
        Letter& letter = letters.try_emplace(values, Letter{{}, values, {}, {}, machine}).first->second;
        letter.events.push_back(event);
        letter.prefixes.push_back(prefix);
    }
    std::vector<Letter> result;
    for (auto& [values, letter] : letters) result.push_back(std::move(letter));
    return result;
}

}  // namespace

std::vector<cspm::ExprPtr> channels_of_facts(const CheckedClaim& claim) {
    std::vector<cspm::ExprPtr> result;
    for (const MachinePart& part : claim.component.machines) {
        const auto shows = [&](const Fact& fact) { return fact.machine == part.path; };
        if (std::ranges::any_of(claim.facts, shows)) result.push_back(build::name(shown_channel(part.path)));
    }
    return result;
}

std::vector<Letter> letters_of(const CheckedClaim& claim, const ir::System& system,
                               const ir::Instantiation& instantiation, const ShownFacts& shown) {
    std::set<std::size_t> channels(claim.remembered.begin(), claim.remembered.end());
    for (const Events* events : sets_of(claim))
        for (const EventMatch& match : events->any) channels.insert(match.channels.begin(), match.channels.end());
    const std::set<std::size_t> with_values = channels_with_values(claim);
    if (std::ranges::any_of(system.csp_blocks, ir::is_instantiations)) refuse_numbers(claim, with_values, system);
    LetterMaker maker(claim, system, instantiation);
    for (const std::size_t channel : channels) maker.add_channel(channel, with_values.contains(channel));
    std::vector<Letter> result = maker.take();
    for (const auto& [machine, facts] : shown)
        for (Letter& letter : fact_letters(claim, machine, facts)) result.push_back(std::move(letter));
    return result;
}

void require_channels(const CheckedClaim& claim, const std::vector<Letter>& letters,
                      const csp_emit::Provenance& provenance) {
    for (const Letter& letter : letters) {
        if (!letter.facts.empty()) {
            if (!provenance.events.contains(shown_channel(claim.facts[letter.facts.front().fact].machine)))
                throw NotDecided(fmt::format("the semantics of {} does not show its states", claim.component.path));
            continue;
        }
        const Channel& of = claim.component.channels[letter.occurrence.channel];
        const char* end = "Call";
        if (of.kind != ChannelKind::call) end = of.kind == ChannelKind::input ? ".in" : ".out";
        if (!provenance.events.contains(claim.component.path + "::" + of.name + end))
            throw NotDecided(fmt::format("the semantics of {} has no event `{}`", claim.component.path, of.name));
    }
}

const Letter* find_letter(const std::vector<Letter>& letters, const std::string& event) {
    const auto found = std::ranges::find_if(letters, [&](const Letter& letter) {
        return std::ranges::any_of(
            letter.events, [&](const std::string& known) { return event == known || event.starts_with(known + "."); });
    });
    return found == letters.end() ? nullptr : &*found;
}

std::string text_of(const Letter& letter, const CheckedClaim& claim, const std::string& event) {
    const Channel& channel = claim.component.channels[letter.occurrence.channel];
    const std::string direction = channel.kind == ChannelKind::input ? ".in" : ".out";
    const std::string prefix =
        claim.component.path + "::" + letter.name + (channel.kind == ChannelKind::call ? "Call" : direction);
    if (event.size() <= prefix.size()) return letter.name;
    std::string values;
    for (const char c : event.substr(prefix.size() + 1)) {
        if (c == '.')
            values += ", ";
        else
            values += c;
    }
    return fmt::format("{}({})", letter.name, values);
}

std::vector<const EventMatch*> matches_without_value(const CheckedClaim& claim, const std::vector<Letter>& letters) {
    std::vector<const EventMatch*> result;
    MonitorState state;
    state.last.resize(claim.remembered.size());
    state.facts.resize(claim.facts.size());
    for (const Events* events : sets_of(claim))
        for (const EventMatch& match : events->any) {
            if (!match.condition || reads_last(*match.condition)) continue;
            const Events alone{{match}, false, false, ""};
            const bool some = std::ranges::any_of(letters, [&](const Letter& letter) {
                return letter.facts.empty() && Monitor::matches(alone, letter.occurrence, state);
            });
            if (!some) result.push_back(&match);
        }
    return result;
}

std::string why_not_followed(const CheckedClaim& claim) {
    if (claim.body.kind == BodyKind::possible || claim.body.kind == BodyKind::can_take)
        return "one run does not show what other runs do";
    if (!claim.facts.empty()) return "events do not show states and variables";
    return "";
}

std::string why_not_monitored(const CheckedClaim& claim) {
    return claim.raised ? "it is about control cycles, which `conform` decides" : why_not_followed(claim);
}

}  // namespace robochart::claims
