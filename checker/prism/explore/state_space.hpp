// A model with values for its constants, explored: its states, and the Markov model over them.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "checker/lts/state_store.hpp"
#include "checker/markov/model/model.hpp"
#include "checker/prism/explore/instance.hpp"
#include "checker/prism/explore/number_table.hpp"
#include "diagnostics/diagnostic.hpp"

namespace robochart::prism {

struct ExploreOptions {
    std::uint64_t max_states = 500'000'000;
    bool exact = false;  ///< every probability must be a fraction
    diagnostics::Budget* budget = nullptr;
};

/// The states that are reachable, numbered breadth first, and what happens in them.
class StateSpace {
public:
    /// `model` and `diagnostics`, which takes warnings, outlive it. Throws EvaluationError, LimitReached.
    StateSpace(const CheckedModel& model, const Values& constants, const ExploreOptions& options,
               diagnostics::Diagnostics& diagnostics);

    [[nodiscard]] const markov::Model& chain() const { return chain_; }
    [[nodiscard]] const Instance& instance() const { return instance_; }
    [[nodiscard]] const CheckedModel& model() const { return instance_.model(); }
    [[nodiscard]] const Layout& layout() const { return instance_.layout(); }
    /// Values of the constants of the model.
    [[nodiscard]] const Values& constants() const { return instance_.constants(); }
    /// Transitions as PRISM counts them: branches.
    [[nodiscard]] std::uint64_t transitions() const { return chain_.target.size(); }
    /// States in which no command is enabled.
    [[nodiscard]] const markov::StateSet& deadlocks() const { return deadlocks_; }
    [[nodiscard]] std::uint64_t deadlock_count() const { return deadlock_count_; }

    /// "x=1, y=false".
    [[nodiscard]] std::string text(markov::State state) const;
    [[nodiscard]] lts::StateView packed(markov::State state) const { return store_[state]; }
    /// The number of a packed state that is reachable.
    [[nodiscard]] markov::State number_of(lts::StateView packed) const { return store_.find(packed); }
    void unpack(markov::State state, std::int32_t* values) const { layout().unpack(store_[state], values); }

    /// Code for expressions over its states, with more constants. Throws EvaluationError.
    [[nodiscard]] Code code(const Values& more) const { return instance_.code(more); }
    /// Where an expression of type bool holds; labels of the model, "deadlock" and "init" are replaced before.
    [[nodiscard]] markov::StateSet satisfying(const Code& code, Code::Root root) const;
    /// The rewards of a structure, by its index; `exact`: with fractions.
    [[nodiscard]] markov::Rewards rewards(std::size_t structure, bool exact) const;

private:
    friend class Explorer;
    friend class RewardTable;

    Instance instance_;
    ExploreOptions options_;
    diagnostics::Diagnostics& diagnostics_;
    lts::StateStore store_;
    markov::Model chain_;
    markov::StateSet deadlocks_;
    std::uint64_t deadlock_count_ = 0;
};

}  // namespace robochart::prism
