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

/// An exact number, a truth value or a literal; no value for other texts.
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

FollowedClaim::FollowedClaim(const claims::CheckedClaim& claim, const ir::System& system, durations::Unit unit)
    : claim_(&claim), system_(&system), account_(claim, unit) {
    if (claim.body.kind == claims::BodyKind::possible) give_up("one run does not show what other runs do");
}

void FollowedClaim::observe(std::string_view name, bool input, const std::vector<std::string>& values,
                            std::uint64_t line) {
    const auto& channels = claim_->component.channels;
    for (std::size_t i = 0; i < channels.size(); ++i)
        if (channels[i].name == name && (channels[i].kind == claims::ChannelKind::input) == input)
            observe_channel(i, values, line);
}

void FollowedClaim::tock(std::uint64_t line) {
    account_.tock();
    note(line);
}

void FollowedClaim::end(std::uint64_t line) {
    account_.end();
    note(line);
}

void FollowedClaim::give_up(std::string why) {
    if (!is_broken() && unknown_.empty()) unknown_ = std::move(why);
}

void FollowedClaim::observe_channel(std::size_t channel, const std::vector<std::string>& values, std::uint64_t line) {
    const claims::Channel& of = claim_->component.channels[channel];
    claims::Occurrence occurrence{channel, {}};
    const std::string text = values.empty() ? of.name : fmt::format("{}({})", of.name, fmt::join(values, ", "));
    for (std::size_t i = 0; i < of.types.size(); ++i) {
        const auto value = i < values.size() ? value_of(values[i], system_->type(of.types[i])) : std::nullopt;
        if (!value && reads_values(channel))
            return give_up(fmt::format("{} has a value that no condition reads", text));
        occurrence.values.push_back(value.value_or(claims::Fraction()));
    }
    try {
        account_.observe(occurrence, text);
    } catch (const claims::NotComputable& error) {
        give_up(error.what());
    }
    note(line);
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
