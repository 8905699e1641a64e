// SPDX-License-Identifier: Apache-2.0
// Describes the definitions of a machine in terms of the model: the active states, the content of each parameter, and
// the transition or statement that causes each offered event.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "csp_emit/machine/tables/machine_tables.hpp"

namespace robochart::csp_emit {

/// Owns the meanings of offers, which are the events that configurations offer. Several definitions may share a
/// meaning.
class DefinitionMeanings {
public:
    explicit DefinitionMeanings(const MachineTables& tables) : tables_(tables) {}

    [[nodiscard]] DefinitionMeaning meaning_of(const Point&, const Function&);

private:
    using Offer = std::shared_ptr<const OfferMeaning>;
    std::string describe_activation(const Activation& config) const;
    void add_parameters(const Function&, DefinitionMeaning&) const;
    std::vector<ir::Origin> active_states(const View& now) const;
    std::vector<std::string> nodes_ahead(const View& now) const;
    std::vector<Offer> offers_of(const View& now);
    Offer make_offer(const RunningMachine&, ir::TransitionId);
    Offer make_offer(const RunningThread&);

    const MachineTables& tables_;
    std::map<std::pair<std::uint32_t, std::string>, Offer> offers_;  ///< by frame and key of the element
};

}  // namespace robochart::csp_emit
