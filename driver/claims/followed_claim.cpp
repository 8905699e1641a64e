// SPDX-License-Identifier: Apache-2.0
// See followed_claim.hpp.
#include "driver/claims/followed_claim.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <utility>

#include "claims/decide/letters.hpp"

namespace robochart::driver {
namespace {

/// Returns the number that represents a number, a truth value or a literal exactly; no value for other texts.
std::optional<claims::Fraction> value_of(std::string_view text, const ir::Type& type) {
    if (type.kind == ir::TypeKind::boolean) {
        if (text == "true" || text == "false") return claims::Fraction(text == "true" ? 1 : 0);
        return std::nullopt;
    }
    if (type.kind == ir::TypeKind::enumeration) {
        const auto found = std::ranges::find(type.labels, text);
        if (found == type.labels.end()) return std::nullopt;
        return claims::Fraction(found - type.labels.begin());
    }
    const bool negative = text.starts_with("-");
    if (negative) text.remove_prefix(1);
    const bool number =
        !text.empty() && std::ranges::all_of(text, [](char c) { return (c >= '0' && c <= '9') || c == '.'; });
    if (!number || std::ranges::count(text, '.') > 1) return std::nullopt;
    try {
        return claims::Fraction(negative ? -1 : 1) * claims::Fraction::of_decimal(text);
    } catch (const claims::NotComputable&) {
        return std::nullopt;
    }
}

}  // namespace

FollowedClaim::FollowedClaim(const claims::CheckedClaim& claim, const ir::System& system, durations::Unit unit,
                             Drops drops)
    : claim_(&claim), system_(&system), account_(claim, unit), drops_(std::move(drops)) {
    if (claim.body.kind == claims::BodyKind::possible) give_up("one run does not show what other runs do");
}

void FollowedClaim::observe(std::string_view name, bool input, const std::vector<std::string>& values,
                            std::uint64_t line) {
    if (!input) observe_inputs();
    const auto& channels = claim_->component.channels;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        if (channels[i].name != name || (channels[i].kind == claims::ChannelKind::input) != input) continue;
        const std::optional<Named> event = named(i, values, line);
        if (!event) continue;
        if (input)
            raised_.push_back(*event);
        else
            observe_event(*event);
    }
}

void FollowedClaim::tock(std::uint64_t line) {
    observe_inputs();
    account_.tock();
    note(line);
}

void FollowedClaim::end(std::uint64_t line) {
    observe_inputs();
    account_.end();
    note(line);
}

void FollowedClaim::give_up(std::string why) {
    observe_inputs();
    if (!is_broken() && unknown_.empty()) unknown_ = std::move(why);
}

std::optional<FollowedClaim::Named> FollowedClaim::named(std::size_t channel, const std::vector<std::string>& values,
                                                         std::uint64_t line) {
    const claims::Channel& of = claim_->component.channels[channel];
    Named result{
        {channel, {}}, values.empty() ? of.name : fmt::format("{}({})", of.name, fmt::join(values, ", ")), line};
    for (std::size_t i = 0; i < of.types.size(); ++i) {
        const auto value = i < values.size() ? value_of(values[i], system_->type(of.types[i])) : std::nullopt;
        if (!value && reads_values(channel)) {
            give_up(fmt::format("{} has a value that no condition reads", result.text));
            return std::nullopt;
        }
        result.occurrence.values.push_back(value.value_or(claims::Fraction()));
    }
    return result;
}

void FollowedClaim::observe_inputs() {
    if (raised_.empty()) return;
    std::vector<Named> inputs = std::exchange(raised_, {});
    const auto& channels = claim_->component.channels;
    for (const claims::CheckedOrder::Drop& drop : drops_) {
        const auto is = [&](const std::string& name) {
            return [&](const Named& input) { return channels[input.occurrence.channel].name == name; };
        };
        if (std::ranges::any_of(inputs, is(drop.event))) std::erase_if(inputs, is(drop.dropped));
    }
    std::vector<claims::Occurrence> raised;
    for (const Named& input : inputs) raised.push_back(input.occurrence);
    for (const claims::Occurrence& next : claims::Monitor(*claim_).order_raised(account_.state(), raised))
        observe_event(*std::ranges::find(inputs, next, &Named::occurrence));
}

void FollowedClaim::observe_event(const Named& event) {
    try {
        account_.observe(event.occurrence, event.text);
    } catch (const claims::NotComputable& error) {
        if (!is_broken() && unknown_.empty()) unknown_ = error.what();
    }
    note(event.line);
}

bool FollowedClaim::reads_values(std::size_t channel) const {
    if (std::ranges::find(claim_->remembered, channel) != claim_->remembered.end()) return true;
    return std::ranges::any_of(claims::sets_of(*claim_), [&](const claims::Events* events) {
        return std::ranges::any_of(events->any, [&](const claims::EventMatch& match) {
            return match.condition && std::ranges::find(match.channels, channel) != match.channels.end();
        });
    });
}

void FollowedClaim::note(std::uint64_t line) {
    if (!account_.is_broken() || is_broken() || !unknown_.empty()) return;
    line_ = line;
    reasons_ = account_.reasons();
}

std::vector<std::size_t> channels_of(const claims::CheckedClaim& claim) {
    std::set<std::size_t> result(claim.remembered.begin(), claim.remembered.end());
    for (const claims::Events* events : claims::sets_of(claim))
        for (const claims::EventMatch& match : events->any) result.insert(match.channels.begin(), match.channels.end());
    return {result.begin(), result.end()};
}

}  // namespace robochart::driver
