// SPDX-License-Identifier: Apache-2.0
// Compiles the commands of a model to code, and computes their effects in a state.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "prism/checks/checked.hpp"
#include "prism/explore/code.hpp"
#include "prism/explore/layout.hpp"
#include "prism/explore/number_table.hpp"

namespace robochart::prism {

/// The effect of one branch of an enabled command: its probability, and the assignments to variables.
struct Effect {
    NumberTable::Id probability = NumberTable::one;
    std::uint32_t first_write = 0, end_write = 0;  ///< indices into CommandTable::writes
};
struct Write {
    std::uint32_t variable = 0;
    std::int64_t value = 0;
};

/// Checks that the encoding omits no step in a state (CheckedModel::left_out).
class LeftOut {
public:
    LeftOut(const CheckedModel& model, Code& code);
    /// Throws EvaluationError if the encoding omits a step in this state.
    void refuse_left_out(StateValues state) const;

private:
    const Code& code_;
    std::optional<Code::Root> root_;
};

/// The commands in groups. Each action of each module has a group.
class CommandTable {
public:
    /// Throws EvaluationError. Reports warnings to `diagnostics`, which must outlive the table.
    CommandTable(const CheckedModel& model, const Layout& layout, Code& code, NumberTable& numbers,
                 diagnostics::Diagnostics& diagnostics);

    /// A synchronisation, whose parts are groups of commands.
    struct Act {
        std::uint32_t action = 0;  ///< index into `actions`
        std::vector<std::uint32_t> groups;
    };
    [[nodiscard]] const std::vector<Act>& acts() const { return acts_; }
    [[nodiscard]] const std::vector<std::string>& actions() const { return actions_; }  ///< the first is ""

    /// Finds the enabled commands of all groups, and evaluates the effects of the commands that can act. Throws
    /// EvaluationError.
    void evaluate(StateValues state);
    /// Finds the enabled commands of all groups without evaluating their effects.
    void evaluate_guards(StateValues state);
    /// Evaluates the effects of one command that is enabled in the state.
    void evaluate_effects(std::uint32_t command, StateValues state) { evaluate_effects(commands_[command], state); }
    /// Returns the enabled commands of a group, as indices for the effects of commands.
    [[nodiscard]] const std::vector<std::uint32_t>& enabled_commands(std::uint32_t group) const {
        return enabled_[group];
    }
    [[nodiscard]] const std::vector<Effect>& effects_of(std::uint32_t command) const {
        return commands_[command].effects;
    }
    [[nodiscard]] const Write* write(std::uint32_t index) const { return writes_.data() + index; }
    [[nodiscard]] Span span(std::uint32_t command) const { return commands_[command].source->span; }
    /// Returns the name of the module that contains the commands of a group.
    [[nodiscard]] const std::string& module(std::uint32_t group) const {
        return model_.modules[group_names_[group].module].name.text;
    }

private:
    /// A probability of a command: a constant, or an expression that reads variables.
    struct Probability {
        bool fixed = true;
        NumberTable::Id id = NumberTable::one;
        Code::Root root = 0;
        Span span;
        std::vector<std::uint32_t> variables;
        std::unordered_map<std::uint64_t, std::vector<std::pair<std::vector<std::int32_t>, NumberTable::Id>>> known;
    };
    struct CodedBranch {
        Probability probability;
        std::vector<std::pair<std::uint32_t, Code::Root>> assignments;
        std::vector<Span> spans;
    };
    struct CodedCommand {
        const Command* source = nullptr;
        Code::Root guard = 0;
        std::vector<CodedBranch> branches;
        bool fixed = true;  ///< all probabilities are constant
        bool warned = false;
        std::vector<Effect> effects;  ///< the effects in the state that was evaluated last
    };

    void add_command(const Command& command);
    Probability probability(const ExprPtr& expr);
    std::uint32_t group(const ActionOfModule& part);
    std::uint32_t action(const std::string& name);
    NumberTable::Id evaluate_probability(Probability& probability, StateValues state);
    void check_probability(const Probability& probability, NumberTable::Id id);
    void evaluate_effects(CodedCommand& command, StateValues state);
    void write_values(const CodedBranch& branch, Effect& effect, StateValues state);
    /// Divides the probabilities of the command by their sum if the sum is almost 1.
    void check_sum(CodedCommand& command);

    const CheckedModel& model_;
    const Layout& layout_;
    Code& code_;
    NumberTable& numbers_;
    diagnostics::Diagnostics& diagnostics_;
    std::vector<CodedCommand> commands_;
    std::vector<std::vector<std::uint32_t>> groups_;  ///< commands
    std::vector<ActionOfModule> group_names_;
    std::vector<std::vector<std::uint32_t>> enabled_;
    std::vector<bool> acting_;  ///< groups that belong to a synchronisation all of whose groups have an enabled command
    std::vector<Act> acts_;
    std::vector<std::string> actions_{""};
    std::vector<bool> proper_;  ///< numbers that are known to be probabilities
    std::vector<Write> writes_;
};

}  // namespace robochart::prism
