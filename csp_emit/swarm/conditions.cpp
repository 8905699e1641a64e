// SPDX-License-Identifier: Apache-2.0
#include "csp_emit/swarm/conditions.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace robochart::csp_emit {

using Kind = SwarmCondition::Kind;

Observation::Observation(const SwarmCondition& condition, std::string channel)
    : channel_(std::move(channel)), condition_(condition) {
    collect_atoms(condition_);
}

void Observation::collect_atoms(const SwarmCondition& condition) {
    for (const SwarmCondition& part : condition.parts) collect_atoms(part);
    if (condition.parts.empty() && atom_index(condition) == atoms_.size())
        atoms_.push_back({condition.kind, condition.distance});
}

std::size_t Observation::atom_index(const SwarmCondition& condition) const {
    const auto found = std::ranges::find_if(
        atoms_, [&](const Atom& atom) { return atom.kind == condition.kind && atom.distance == condition.distance; });
    return static_cast<std::size_t>(found - atoms_.begin());
}

bool Observation::has_atom(Kind kind) const {
    return std::ranges::any_of(atoms_, [&](const Atom& atom) { return atom.kind == kind; });
}

bool Observation::asks_pairs() const {
    return has_atom(Kind::linked) || has_atom(Kind::apart);
}

std::string Observation::channel_declaration() const {
    std::string fields;
    for (const Atom& atom : atoms_)
        fields += fmt::format("{}{}", fields.empty() ? "" : ".", atom.kind == Kind::away ? "Bool" : "Set(Pairs)");
    return fmt::format("channel {} : {}\n", channel_, fields);
}

std::string Observation::seen_by_pair() const {
    std::string event = channel_;
    for (std::size_t k = 0; k < atoms_.size(); ++k)
        event += atoms_[k].kind == Kind::away
                     ? fmt::format("?a{}__", k)
                     : fmt::format("?a{0}__:{{s__ | s__ <- Set(Pairs), member((i__,j__),s__) == near(x__,y__,{1})}}", k,
                                   atoms_[k].distance);
    return event;
}

std::string Observation::seen_on_way(std::int64_t x, std::int64_t y) const {
    std::string event = channel_;
    for (std::size_t k = 0; k < atoms_.size(); ++k)
        event += atoms_[k].kind == Kind::away
                     ? fmt::format("!(not near(column(x__ - {}), row(y__ - {}), {}))", x, y, atoms_[k].distance - 1)
                     : fmt::format("?a{}__", k);
    return event;
}

std::string Observation::condition_text(const SwarmCondition& condition) const {
    const auto field = [&] { return fmt::format("a{}__", atom_index(condition)); };
    switch (condition.kind) {
        case Kind::linked:
            return fmt::format("joined({{0}},{})", field());
        case Kind::apart:
            return fmt::format("empty({})", field());
        case Kind::away:
            return field();
        case Kind::negation:
            return fmt::format("not ({})", condition_text(condition.parts.front()));
        case Kind::both:
            return chain_text(condition.parts, "and");
        case Kind::either:
            return chain_text(condition.parts, "or");
    }
    return "";
}

/// Returns the parts joined by `word`. They are split in halves, so that the depth of the expression grows with the
/// logarithm of the number of parts.
std::string Observation::chain_text(std::span<const SwarmCondition> parts, const char* word) const {
    if (parts.size() == 1) return condition_text(parts.front());
    const std::size_t half = parts.size() / 2;
    return fmt::format("({} {} {})", chain_text(parts.first(half), word), word, chain_text(parts.subspan(half), word));
}

std::string Observation::define_meaning() const {
    std::string event = channel_;
    std::string sets;
    for (std::size_t k = 0; k < atoms_.size(); ++k) {
        event += fmt::format(".a{}__", k);
        sets +=
            fmt::format("{}a{}__ <- {}", k == 0 ? "" : ", ", k, atoms_[k].kind == Kind::away ? "Bool" : "Set(Pairs)");
    }
    const std::string holds = condition_text(condition_);
    return fmt::format("holds_{0} = {{{1} | {2}, {3}}}\nfails_{0} = {{{1} | {2}, not ({3})}}\n", channel_, event, sets,
                       holds);
}

}  // namespace robochart::csp_emit
