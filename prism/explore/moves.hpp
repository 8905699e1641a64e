// SPDX-License-Identifier: Apache-2.0
// Describes transitions of a state space by the commands and modules that cause them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "prism/explore/commands.hpp"
#include "prism/explore/state_space.hpp"

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

/// Returns a text such as "[go] Robot (line 7), Human (line 12)". Several moves are joined by "or"; without a move the
/// text is "no command".
[[nodiscard]] std::string text_of(const std::vector<Move>& moves, const diagnostics::SourceManager& sources);

class MoveReader {
public:
    /// `space` must outlive the object.
    explicit MoveReader(const StateSpace& space);

    /// Returns the moves that lead to a choice of a state. If `to` is given, only moves that may lead to `to` are
    /// returned. In a dtmc the result may contain several moves. The model draws one of them. In an mdp it contains
    /// several moves if different commands form the same choice. It is empty for the loop at a deadlock.
    [[nodiscard]] std::vector<Move> list_moves(markov::State state, std::uint32_t choice,
                                               std::optional<markov::State> to = {});

private:
    using Branches = std::map<markov::State, double>;

    void combine(const CommandTable::Act& act, std::size_t part);
    void branch(const CommandTable::Act& act, std::size_t part, const std::vector<lts::Word>& words,
                NumberTable::Id probability, Branches& branches);
    [[nodiscard]] bool is_choice(const Branches& branches) const;
    [[nodiscard]] Move make_move(const CommandTable::Act& act) const;

    const StateSpace& space_;
    Code code_;
    NumberTable numbers_;
    diagnostics::Diagnostics unused_;  ///< discarded, because the exploration has reported them
    CommandTable commands_;
    std::vector<std::int32_t> values_;
    std::vector<std::uint32_t> chosen_;
    std::vector<lts::Word> from_;
    std::optional<markov::State> to_;
    std::uint32_t choice_ = 0;
    std::vector<Move> found_;
};

}  // namespace robochart::prism
