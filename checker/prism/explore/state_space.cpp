// See state_space.hpp.
#include "checker/prism/explore/state_space.hpp"

#include "checker/prism/explore/explorer.hpp"

namespace robochart::prism {

StateSpace::StateSpace(const CheckedModel& model, const Values& constants, const ExploreOptions& options,
                       diagnostics::Diagnostics& diagnostics)
    : instance_(model, constants), options_(options), diagnostics_(diagnostics), store_(layout().words()) {
    Code code = instance_.code();
    Explorer explorer(*this, code);
    explorer();
}

std::string StateSpace::text(markov::State state) const {
    std::vector<std::int32_t> values(layout().fields().size());
    unpack(state, values.data());
    return layout().text(values.data());
}

markov::StateSet StateSpace::satisfying(const Code& code, Code::Root root) const {
    markov::StateSet result(store_.size());
    std::vector<std::int32_t> values(layout().fields().size());
    for (markov::State state = 0; state < result.size(); ++state) {
        if (options_.budget != nullptr) options_.budget->poll();
        unpack(state, values.data());
        try {
            result[state] = code.holds(root, values.data());
        } catch (EvaluationError& error) {
            error.state = layout().text(values.data());
            throw;
        }
    }
    return result;
}

}  // namespace robochart::prism
