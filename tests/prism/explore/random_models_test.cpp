// SPDX-License-Identifier: Apache-2.0
// Explores random models with the program and with a naive implementation of the semantics, which shares only the
// parser with it. States, choices, targets and probabilities must be the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "base/diagnostics/splitmix64.hpp"
#include "tests/prism/support.hpp"

namespace robochart::prism {
namespace {

using testing::Explored;
using State = std::map<std::string, int>;
using Distribution = std::map<State, Rational>;
/// The choices of an mdp's state. A dtmc has only one choice, without an action.
using Choices = std::multiset<std::pair<std::string, Distribution>>;

class Random {
public:
    explicit Random(std::uint64_t seed) : seed_(seed) {}
    int below(int bound) { return static_cast<int>(diagnostics::splitmix64(seed_) % static_cast<unsigned>(bound)); }

private:
    std::uint64_t seed_;
};

constexpr int most = 2;  // variables have values 0..2

std::string variable(int module, int number) {
    return std::string(1, static_cast<char>('x' + number)) + std::to_string(module);
}

std::string operand(Random& random, int modules) {
    if (random.below(3) == 0) return std::to_string(random.below(most + 1));
    return variable(random.below(modules), random.below(2));
}

std::string guard(Random& random, int modules, int depth) {
    if (depth > 0 && random.below(2) == 0) {
        const char* connectives[] = {" & ", " | ", " => ", " <=> "};
        const std::string left = guard(random, modules, depth - 1);
        return "(" + left + connectives[random.below(4)] + guard(random, modules, depth - 1) + ")";
    }
    const char* relations[] = {"=", "!=", "<", "<=", ">", ">="};
    const std::string left = operand(random, modules);
    const std::string relation = relations[random.below(6)];
    return (random.below(5) == 0 ? "!(" : "(") + left + relation + operand(random, modules) + ")";
}

/// Returns a random expression that stays in its range in every state.
std::string value(Random& random, int modules) {
    const std::string a = operand(random, modules);
    const std::string b = operand(random, modules);
    switch (random.below(5)) {
        case 0:
            return a;
        case 1:
            return "min(" + a + "+" + b + ",2)";
        case 2:
            return "mod(" + a + "-" + b + ",3)";
        case 3:
            return "(" + guard(random, modules, 0) + "?" + a + ":" + b + ")";
        default:
            return "floor((" + a + "+" + b + ")/2)";
    }
}

std::string update(Random& random, int modules, int module) {
    if (random.below(4) == 0) return "true";
    std::string text;
    const int written = 1 + random.below(2);
    for (int i = 0; i < written; ++i)
        text += (i == 0 ? "(" : " & (") + variable(module, i) + "'=" + value(random, modules) + ")";
    return text;
}

std::string command(Random& random, int modules, int module) {
    const char* actions[] = {"", "", "a", "b"};
    std::string text = std::string("  [") + actions[random.below(4)] + "] " + guard(random, modules, 1) + " -> ";
    switch (random.below(4)) {
        case 0:
            return text + update(random, modules, module) + ";\n";
        case 1: {
            text += "1/3:" + update(random, modules, module) + " + 2/3:" + update(random, modules, module);
            return text + ";\n";
        }
        case 2: {
            // A probability that depends on the state and may be 0.
            const std::string p = variable(random.below(modules), 0) + "/2";
            text += p + ":" + update(random, modules, module) + " + 1-" + p + ":";
            return text + update(random, modules, module) + ";\n";
        }
        default: {
            text += "0.5:" + update(random, modules, module) + " + 0.25:" + update(random, modules, module);
            return text + " + 0.25:" + update(random, modules, module) + ";\n";
        }
    }
}

std::string random_model(std::uint64_t seed) {
    Random random(seed);
    const int modules = 2 + random.below(2);
    std::string text = random.below(2) == 0 ? "dtmc\n" : "mdp\n";
    for (int module = 0; module < modules; ++module) {
        text += "module M" + std::to_string(module) + "\n";
        for (int i = 0; i < 2; ++i)
            text += "  " + variable(module, i) + ":[0..2] init " + std::to_string(random.below(3)) + ";\n";
        const int commands = 2 + random.below(4);
        for (int i = 0; i < commands; ++i) text += command(random, modules, module);
        text += "endmodule\n";
    }
    return text;
}

// ---------------------------------------------------------------- the naive implementation

Rational evaluate(const ExprPtr& expr, const State& state) {
    const auto part = [&](std::size_t i) { return evaluate(expr->parts[i], state); };
    const auto truth = [](bool holds) { return Rational(holds ? 1 : 0); };
    switch (expr->op) {
        case Op::integer:
            return Rational(std::stoi(expr->text));
        case Op::real:
            return Rational(static_cast<int>(std::stod(expr->text) * 100), 100);
        case Op::boolean:
            return truth(expr->text == "true");
        case Op::name:
            return Rational(state.at(expr->text));
        case Op::conditional:
            return part(0) != 0 ? part(1) : part(2);
        case Op::implies:
            return truth(part(0) == 0 || part(1) != 0);
        case Op::iff:
            return truth(part(0) == part(1));
        case Op::disjunction:
            return truth(part(0) != 0 || part(1) != 0);
        case Op::conjunction:
            return truth(part(0) != 0 && part(1) != 0);
        case Op::negation:
            return truth(part(0) == 0);
        case Op::equal:
            return truth(part(0) == part(1));
        case Op::unequal:
            return truth(part(0) != part(1));
        case Op::less:
            return truth(part(0) < part(1));
        case Op::less_equal:
            return truth(part(0) <= part(1));
        case Op::greater:
            return truth(part(0) > part(1));
        case Op::greater_equal:
            return truth(part(0) >= part(1));
        case Op::add:
            return part(0) + part(1);
        case Op::subtract:
            return part(0) - part(1);
        case Op::divide:
            return part(0) / part(1);
        default:
            break;
    }
    const Rational a = part(0);
    if (expr->text == "min") return std::min(a, part(1));
    const Rational divisor = expr->text == "mod" ? part(1) : Rational(1);
    int whole = 0;  // numerator of a / divisor, which is small
    while (divisor * (whole + 1) <= a) ++whole;
    while (divisor * whole > a) --whole;
    return expr->text == "mod" ? Rational(a - divisor * whole) : Rational(whole);
}

class Naive {
public:
    explicit Naive(const ModelFile& file) : file_(file) {
        for (const Module& module : file.modules)
            for (const Variable& variable : module.variables)
                initial[variable.name.text] = static_cast<int>(std::stoi(variable.initial->text));
        std::vector<State> open{initial};
        while (!open.empty()) {
            const State state = open.back();
            open.pop_back();
            if (choices.contains(state)) continue;
            choices[state] = expand(state);
            for (const auto& [action, distribution] : choices[state])
                for (const auto& [target, probability] : distribution) open.push_back(target);
        }
    }

    State initial;
    std::map<State, Choices> choices;

private:
    using Combination = std::vector<const Command*>;

    /// Returns the combinations of commands by definition: the modules whose text mentions a must all have an enabled
    /// a-command, and every combination of such commands is one choice.
    std::vector<std::pair<std::string, Combination>> combinations(const State& state) const {
        std::vector<std::pair<std::string, Combination>> result;
        for (const std::string action : {"", "a", "b"}) {
            std::vector<Combination> all{{}};
            bool mentioned = false;
            for (const Module& module : file_.modules) {
                Combination enabled;
                bool mentions = false;
                for (const Command& command : module.commands) {
                    if (command.action.text != action) continue;
                    mentions = true;
                    if (evaluate(command.guard, state) != 0) enabled.push_back(&command);
                }
                if (action.empty()) {
                    for (const Command* command : enabled) result.push_back({"", {command}});
                    continue;
                }
                if (!mentions) continue;
                mentioned = true;
                std::vector<Combination> longer;
                for (const Combination& before : all)
                    for (const Command* command : enabled) {
                        longer.push_back(before);
                        longer.back().push_back(command);
                    }
                all = longer;
            }
            if (mentioned)
                for (const Combination& combination : all) result.emplace_back(action, combination);
        }
        return result;
    }

    static Distribution outcome_of(const Combination& commands, const State& state) {
        Distribution result{{state, 1}};
        for (const Command* command : commands) {
            Distribution next;
            for (const auto& [before, probability] : result)
                for (const Branch& branch : command->branches) {
                    const Rational factor = branch.probability ? evaluate(branch.probability, state) : Rational(1);
                    if (factor == 0) continue;
                    State after = before;
                    for (const Assignment& assignment : branch.assignments)
                        after[assignment.variable.text] = evaluate(assignment.value, state).convert_to<int>();
                    next[after] += probability * factor;
                }
            result = next;
        }
        return result;
    }

    Choices expand(const State& state) const {
        Choices result;
        const auto all = combinations(state);
        if (all.empty()) return {{"", {{state, 1}}}};
        Distribution mean;
        for (const auto& [action, commands] : all) {
            const Distribution one = outcome_of(commands, state);
            result.emplace(action, one);
            for (const auto& [target, probability] : one) mean[target] += probability / all.size();
        }
        return file_.kind == ModelKind::mdp ? result : Choices{{"", mean}};
    }

    const ModelFile& file_;
};

State state_of(const StateSpace& space, markov::State number) {
    std::vector<std::int32_t> values(space.layout().fields().size());
    space.unpack(number, values.data());
    State state;
    for (std::size_t i = 0; i < values.size(); ++i) state[space.layout().fields()[i].name] = values[i];
    return state;
}

std::map<State, Choices> choices_of(const StateSpace& space) {
    const markov::Model& chain = space.chain();
    std::map<State, Choices> result;
    for (markov::State state = 0; state < chain.states(); ++state) {
        Choices& choices = result[state_of(space, state)];
        for (std::size_t choice = chain.first_choice[state]; choice < chain.first_choice[state + 1]; ++choice) {
            Distribution distribution;
            for (std::uint64_t i = chain.first_branch[choice]; i < chain.first_branch[choice + 1]; ++i)
                distribution[state_of(space, chain.target[i])] = chain.exact[chain.number[i]];
            const bool mdp = chain.kind == markov::Kind::mdp;
            choices.emplace(mdp ? chain.actions[chain.action[choice]] : "", distribution);
        }
    }
    return result;
}

TEST(PrismRandomModels, AreExploredAsTheSemanticsSays) {
    std::size_t states = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        const std::string text = random_model(seed);
        const Explored model(text);
        testing::Read read;
        const ModelFile file = read_model(read.sources, read.add(text), read.diagnostics);
        const Naive naive(file);
        EXPECT_EQ(state_of(*model.space, model.space->chain().initial.front()), naive.initial);
        EXPECT_TRUE(choices_of(*model.space) == naive.choices) << text;
        states += naive.choices.size();
    }
    EXPECT_GT(states, 600U);
}

}  // namespace
}  // namespace robochart::prism
