// SPDX-License-Identifier: Apache-2.0
// See moves.hpp. Computes the combinations again in the same way as the explorer, and compares them with its results.
#include "prism/explore/moves.hpp"

#include <fmt/format.h>

#include <cmath>

namespace robochart::prism {

std::string text_of(const std::vector<Move>& moves, const diagnostics::SourceManager& sources) {
    std::string text;
    for (const Move& move : moves) {
        if (!text.empty()) text += " or ";
        if (!move.action.empty()) text += fmt::format("[{}] ", move.action);
        for (std::size_t i = 0; i < move.parts.size(); ++i) {
            const Move::Part& part = move.parts[i];
            text += fmt::format("{}{} (line {})", i == 0 ? "" : ", ", part.module,
                                sources.position(part.command.source, part.command.begin).line);
        }
    }
    return text.empty() ? "no command" : text;
}

MoveReader::MoveReader(const StateSpace& space)
    : space_(space),
      code_(space.code({})),
      commands_(space.model(), space.layout(), code_, numbers_, unused_),
      values_(space.layout().fields().size()) {}

std::vector<Move> MoveReader::list_moves(markov::State state, std::uint32_t choice, std::optional<markov::State> to) {
    const lts::StateView from = space_.packed_state(state);
    from_.assign(from.begin(), from.end());
    space_.unpack(state, values_.data());
    to_ = to;
    choice_ = choice;
    found_.clear();
    commands_.evaluate(values_.data());
    for (const CommandTable::Act& act : commands_.acts()) {
        chosen_.assign(act.groups.size(), 0);
        const bool mdp = space_.chain().kind == markov::Kind::mdp;
        if (!mdp || space_.chain().action[choice] == act.action) combine(act, 0);
    }
    return found_;
}

void MoveReader::combine(const CommandTable::Act& act, std::size_t part) {
    if (part < act.groups.size()) {
        for (const std::uint32_t command : commands_.enabled_commands(act.groups[part])) {
            chosen_[part] = command;
            combine(act, part + 1);
        }
        return;
    }
    Branches branches;
    branch(act, 0, from_, NumberTable::one, branches);
    if ((!to_ || branches.contains(*to_)) && (space_.chain().kind == markov::Kind::dtmc || is_choice(branches)))
        found_.push_back(make_move(act));
}

void MoveReader::branch(const CommandTable::Act& act, std::size_t part, const std::vector<lts::Word>& words,
                        NumberTable::Id probability, Branches& branches) {
    if (part == act.groups.size()) {
        branches[space_.number_of({words.data(), words.size()})] += numbers_[probability].bounds().middle();
        return;
    }
    for (const Effect& effect : commands_.effects_of(chosen_[part])) {
        std::vector<lts::Word> next = words;
        for (std::uint32_t i = effect.first_write; i < effect.end_write; ++i) {
            const Write& write = *commands_.write(i);
            space_.layout().set(next.data(), write.variable, write.value);
        }
        branch(act, part + 1, next, numbers_.product(probability, effect.probability), branches);
    }
}

/// Returns whether the branches are those of a choice: the same targets with the same probabilities.
bool MoveReader::is_choice(const Branches& branches) const {
    const markov::Model& chain = space_.chain();
    const std::uint64_t first = chain.first_branch[choice_];
    if (chain.first_branch[choice_ + 1] - first != branches.size()) return false;
    constexpr double rounding = 1e-12;
    std::uint64_t at = first;
    for (const auto& [target, probability] : branches) {
        const markov::Number number = chain.numbers[chain.number[at]];
        if (chain.target[at++] != target || std::abs(number.high - probability) > rounding) return false;
    }
    return true;
}

Move MoveReader::make_move(const CommandTable::Act& act) const {
    Move result;
    result.action = commands_.actions()[act.action];
    for (std::size_t i = 0; i < chosen_.size(); ++i)
        result.parts.push_back({commands_.module(act.groups[i]), commands_.span(chosen_[i])});
    return result;
}

}  // namespace robochart::prism
