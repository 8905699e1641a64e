// SPDX-License-Identifier: Apache-2.0
// Explores a model with values for its constants: finds its states, and builds the Markov model over them.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "checker/lts/state_store.hpp"
#include "prism/explore/instance.hpp"
#include "prism/explore/number_table.hpp"
#include "prism/markov/model/model.hpp"

namespace robochart::prism {

struct ExploreOptions {
    std::uint64_t max_states = 500'000'000;
    bool exact = false;  ///< every probability must be a fraction
    diagnostics::Budget* budget = nullptr;
};

/// States that another component of the program has explored, with the values of a model's variables.
struct GivenSpace {
    markov::Model chain;
    markov::StateSet deadlocks;        ///< states in which the label "deadlock" holds
    std::vector<std::int32_t> values;  ///< values of the first state in the order of the variables, then of the second,
                                       ///< ...
};

/// The reachable states, numbered in breadth-first order, and their transitions.
class StateSpace {
public:
    /// Explores the model. `model` and `diagnostics`, which receives warnings, must outlive the object. Throws
    /// EvaluationError, LimitReached.
    StateSpace(const CheckedModel& model, const Values& constants, const ExploreOptions& options,
               diagnostics::Diagnostics& diagnostics);
    /// Creates the space from given states. `model` provides the names of the variables and the rewards. Throws
    /// EvaluationError.
    StateSpace(const CheckedModel& model, const Values& constants, GivenSpace given, const ExploreOptions& options,
               diagnostics::Diagnostics& diagnostics);

    [[nodiscard]] const markov::Model& chain() const { return chain_; }
    [[nodiscard]] const Instance& instance() const { return instance_; }
    [[nodiscard]] const CheckedModel& model() const { return instance_.model(); }
    [[nodiscard]] const Layout& layout() const { return instance_.layout(); }
    /// Returns the values of the model's constants.
    [[nodiscard]] const Values& constants() const { return instance_.constants(); }
    /// Returns the number of branches, which PRISM reports as the number of transitions.
    [[nodiscard]] std::uint64_t transitions() const { return chain_.target.size(); }
    /// Returns the states in which no command is enabled.
    [[nodiscard]] const markov::StateSet& deadlocks() const { return deadlocks_; }
    [[nodiscard]] std::uint64_t deadlock_count() const { return deadlock_count_; }

    /// Returns a text such as "x=1, y=false".
    [[nodiscard]] std::string state_text(markov::State state) const;
    [[nodiscard]] lts::StateView packed_state(markov::State state) const {
        if (!given_) return store_[state];
        return lts::StateView(rows_).subspan(std::size_t{state} * layout().words(), layout().words());
    }
    /// Returns the number of a reachable packed state; only for explored spaces.
    [[nodiscard]] markov::State number_of(lts::StateView packed) const { return store_.find(packed); }
    void unpack(markov::State state, std::int32_t* values) const { layout().unpack(packed_state(state), values); }

    /// Returns an object that compiles expressions over the states, with additional constants. Throws EvaluationError.
    [[nodiscard]] Code code(const Values& more) const { return instance_.code(more); }
    /// Returns the states in which a bool expression holds. Labels of the model, "deadlock" and "init" must have been
    /// replaced.
    [[nodiscard]] markov::StateSet states_satisfying(const Code& code, Code::Root root) const;
    /// Returns the rewards of the structure with this index. `exact`: whether to include fractions.
    [[nodiscard]] markov::Rewards rewards(std::size_t structure, bool exact) const;

private:
    friend class Explorer;
    friend class RewardTable;

    Instance instance_;
    ExploreOptions options_;
    diagnostics::Diagnostics& diagnostics_;
    lts::StateStore store_;
    bool given_ = false;
    std::vector<lts::Word> rows_;  ///< for given states; several may have equal values
    markov::Model chain_;
    markov::StateSet deadlocks_;
    std::uint64_t deadlock_count_ = 0;
};

}  // namespace robochart::prism
