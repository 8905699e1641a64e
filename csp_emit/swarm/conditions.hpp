// Conditions of a swarm's claims as events: what is seen of all robots at once.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "csp_emit/swarm/swarm.hpp"

namespace robochart::csp_emit {

/// An event that says what a condition depends on. Its fields are those of the condition's parts, each once: for
/// `linked` and `apart` the set of pairs that are so near, for `away` whether it is so.
class Observation {
public:
    /// `channel`: the name of the event's channel.
    Observation(const SwarmCondition& condition, std::string channel);

    [[nodiscard]] const std::string& channel() const { return channel_; }
    /// Whether the condition has such a part.
    [[nodiscard]] bool asks(SwarmCondition::Kind kind) const;
    /// Whether it has a part about pairs.
    [[nodiscard]] bool asks_pairs() const;
    [[nodiscard]] std::string channel_declaration() const;
    /// The event as a pair i__, j__ at offset x__, y__ takes part in it.
    [[nodiscard]] std::string seen_by_pair() const;
    /// The event as it is at x__, y__ on the way from a place.
    [[nodiscard]] std::string seen_on_way(std::int64_t x, std::int64_t y) const;
    /// Definitions of `holds_CHANNEL` and `fails_CHANNEL`: the events with which the condition holds, and the others.
    [[nodiscard]] std::string meaning() const;

private:
    /// A part about what is seen, without those that it consists of.
    struct Atom {
        SwarmCondition::Kind kind;
        std::uint32_t distance;
    };

    void collect(const SwarmCondition& condition);
    [[nodiscard]] std::string text(const SwarmCondition& condition) const;
    [[nodiscard]] std::string chain(std::span<const SwarmCondition> parts, const char* word) const;
    [[nodiscard]] std::size_t place(const SwarmCondition& condition) const;

    std::string channel_;
    SwarmCondition condition_;
    std::vector<Atom> atoms_;
};

}  // namespace robochart::csp_emit
