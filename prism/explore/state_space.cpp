// SPDX-License-Identifier: Apache-2.0
// See state_space.hpp.
#include "prism/explore/state_space.hpp"

#include "prism/explore/explorer.hpp"

namespace robochart::prism {

StateSpace::StateSpace(const CheckedModel& model, const Values& constants, const ExploreOptions& options,
                       diagnostics::Diagnostics& diagnostics)
    : instance_(model, constants), options_(options), diagnostics_(diagnostics), store_(layout().words()) {
    Code code = instance_.code();
    Explorer explorer(*this, code);
    explorer();
}

StateSpace::StateSpace(const CheckedModel& model, const Values& constants, GivenSpace given,
                       const ExploreOptions& options, diagnostics::Diagnostics& diagnostics)
    : instance_(model, constants),
      options_(options),
      diagnostics_(diagnostics),
      store_(layout().words()),
      given_(true),
      chain_(std::move(given.chain)),
      deadlocks_(std::move(given.deadlocks)) {
    const std::size_t fields = layout().fields().size();
    rows_.resize(chain_.states() * layout().words());
    for (std::size_t state = 0; state < chain_.states(); ++state)
        layout().pack(given.values.data() + state * fields, rows_.data() + state * layout().words());
    for (const bool deadlock : deadlocks_) deadlock_count_ += deadlock ? 1 : 0;
}

std::string StateSpace::state_text(markov::State state) const {
    std::vector<std::int32_t> values(layout().fields().size());
    unpack(state, values.data());
    return layout().state_text(values.data());
}

markov::StateSet StateSpace::states_satisfying(const Code& code, Code::Root root) const {
    markov::StateSet result(chain_.states());
    std::vector<std::int32_t> values(layout().fields().size());
    for (markov::State state = 0; state < result.size(); ++state) {
        if (options_.budget != nullptr) options_.budget->poll();
        unpack(state, values.data());
        try {
            result[state] = code.holds(root, values.data());
        } catch (EvaluationError& error) {
            error.state = layout().state_text(values.data());
            throw;
        }
    }
    return result;
}

}  // namespace robochart::prism
