// Transitions of a state space in terms of the model: which commands of which modules make them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "checker/prism/explore/commands.hpp"
#include "checker/prism/explore/state_space.hpp"

namespace robochart::prism {

/// Commands that act together.
struct Move {
    struct Part {
        std::string module;
        Span command;
    };
    std::string action;  ///< "": none
    std::vector<Part> parts;
};

/// "[go] Robot (line 7), Human (line 12)"; several with "or" between them; "no command" of none.
[[nodiscard]] std::string text_of(const std::vector<Move>& moves, const diagnostics::SourceManager& sources);

class MoveReader {
public:
    /// `space` outlives it.
    explicit MoveReader(const StateSpace& space);

    /// The commands that the choice of a state stands for, as far as they may lead to `to` where that is given. More
    /// than one element: of a dtmc, which draws one of them; of an mdp, choices that count as one. Empty for the loop
    /// of a deadlock.
    [[nodiscard]] std::vector<Move> moves(markov::State state, std::uint32_t choice,
                                          std::optional<markov::State> to = {});

private:
    using Branches = std::map<markov::State, double>;

    void combine(const CommandTable::Act& act, std::size_t part);
    void branch(const CommandTable::Act& act, std::size_t part, const std::vector<lts::Word>& words,
                NumberTable::Id probability, Branches& branches);
    [[nodiscard]] bool is_choice(const Branches& branches) const;
    [[nodiscard]] Move move(const CommandTable::Act& act) const;

    const StateSpace& space_;
    Code code_;
    NumberTable numbers_;
    diagnostics::Diagnostics unused_;  ///< the exploration has reported them
    CommandTable commands_;
    std::vector<std::int32_t> values_;
    std::vector<std::uint32_t> chosen_;
    std::vector<lts::Word> from_;
    std::optional<markov::State> to_;
    std::uint32_t choice_ = 0;
    std::vector<Move> found_;
};

}  // namespace robochart::prism
