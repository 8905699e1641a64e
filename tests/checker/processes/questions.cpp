// SPDX-License-Identifier: Apache-2.0
#include "questions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

#include "random_process.hpp"

namespace robochart::refine {
namespace {

using naive::Behaviour;
using naive::Kind;
using naive::Process;
using naive::Semantics;
using naive::Tree;

const char* model(Semantics semantics) {
    switch (semantics) {
        case Semantics::T:
            return "T";
        case Semantics::F:
            return "F";
        case Semantics::FD:
            break;
    }
    return "FD";
}

std::vector<Question> all_questions() {
    using Ask = Question::Kind;
    std::vector<Question> result;
    for (const Semantics semantics : {Semantics::T, Semantics::F, Semantics::FD}) {
        result.push_back({Ask::refinement, semantics, 0, 1});
        result.push_back({Ask::refinement, semantics, 1, 0});
        if (semantics == Semantics::T) continue;
        result.push_back({Ask::deadlock_free, semantics, 1, 1});
        result.push_back({Ask::deterministic, semantics, 1, 1});
    }
    result.push_back({Ask::divergence_free, Semantics::FD, 1, 1});
    result.push_back({Ask::has_trace, Semantics::T, 1, 1});
    return result;
}

std::string events(const std::vector<naive::Letter>& trace) {
    std::vector<std::string> names;
    for (naive::Letter l : trace) names.emplace_back(1, static_cast<char>('a' + l));
    return fmt::format("<{}>", fmt::join(names, ", "));
}

Process change_tree(const Process& process, const std::function<void(Tree&)>& change) {
    Tree tree = *process;
    change(tree);
    return std::make_shared<const Tree>(std::move(tree));
}

/// Adds all processes in which one operand is replaced by a smaller one.
void smaller_operands(const Process& process, std::vector<Process>& out);

/// Returns all processes that are one step smaller.
std::vector<Process> smaller(const Process& process) {
    std::vector<Process> result;
    const Process stop = std::make_shared<const Tree>();
    if (process->kind != Kind::stop && process->kind != Kind::skip) result.push_back(stop);
    result.insert(result.end(), process->operands.begin(), process->operands.end());
    if (process->kind == Kind::prefix && process->operands.size() > 1)
        for (std::size_t i = 0; i < process->operands.size(); ++i)
            result.push_back(change_tree(process, [&](Tree& tree) {
                tree.operands.erase(tree.operands.begin() + static_cast<std::ptrdiff_t>(i));
                tree.letters.erase(tree.letters.begin() + static_cast<std::ptrdiff_t>(i));
            }));
    if (process->kind != Kind::prioritise_order)
        for (const naive::Letter letter : process->set)
            result.push_back(change_tree(process, [&](Tree& tree) { tree.set.erase(letter); }));
    for (std::size_t i = 0; i < process->sets.size(); ++i)
        for (const naive::Letter letter : process->sets[i])
            result.push_back(change_tree(process, [&](Tree& tree) { tree.sets[i].erase(letter); }));
    for (std::size_t i = 0; i < process->renaming.size() && process->renaming.size() > 1; ++i)
        result.push_back(change_tree(
            process, [&](Tree& tree) { tree.renaming.erase(tree.renaming.begin() + static_cast<std::ptrdiff_t>(i)); }));
    smaller_operands(process, result);
    return result;
}

void smaller_operands(const Process& process, std::vector<Process>& out) {
    for (std::size_t i = 0; i < process->operands.size(); ++i)
        for (const Process& next : smaller(process->operands[i]))
            out.push_back(change_tree(process, [&](Tree& tree) { tree.operands[i] = next; }));
}

/// Returns whether every recursion is guarded by an event. Shrinking must not produce unguarded recursion, which has no
/// meaning.
bool guarded(const Process& process) {
    if (process->kind == Kind::call) return false;
    if (process->kind == Kind::prefix) return true;
    const bool first_only = process->kind == Kind::sequential || process->kind == Kind::exception;
    const auto end = process->operands.empty() || !first_only ? process->operands.end() : process->operands.begin() + 1;
    return std::all_of(process->operands.begin(), end, guarded);
}

}  // namespace

const std::vector<Question>& questions() {
    static const std::vector<Question> all = all_questions();
    return all;
}

std::string assertion_kind(const Question& question) {
    switch (question.kind) {
        case Question::Kind::refinement:
            return fmt::format("[{}=", model(question.semantics));
        case Question::Kind::deadlock_free:
            return fmt::format("deadlock free [{}]", model(question.semantics));
        case Question::Kind::divergence_free:
            return "divergence free";
        case Question::Kind::deterministic:
            return fmt::format("deterministic [{}]", model(question.semantics));
        case Question::Kind::has_trace:
            return fmt::format("has trace [{}]", model(question.semantics));
    }
    return "?";
}

std::string assertion(const Question& question, const std::vector<naive::Letter>& trace) {
    if (question.kind == Question::Kind::refinement)
        return fmt::format("assert M{} {} M{}", question.left, assertion_kind(question), question.right);
    const bool traced = question.kind == Question::Kind::has_trace;
    return fmt::format("assert M{} :[{}]{}", question.left, assertion_kind(question),
                       traced ? ": " + events(trace) : "");
}

std::string script_with_assertions(const Case& test_case) {
    std::string text = show(test_case.script);
    for (const Question& question : questions()) text += assertion(question, test_case.trace) + "\n";
    return text;
}

std::optional<Graphs> explore(const Case& test_case, std::size_t largest) {
    const auto first = naive::explore(test_case.script, test_case.script.mains.at(0), largest);
    const auto second = naive::explore(test_case.script, test_case.script.mains.at(1), largest);
    if (!first || !second) return std::nullopt;
    return Graphs{{*first, *second}};
}

bool expected(const Question& question, const Graphs& graphs, const std::vector<naive::Letter>& trace) {
    const Behaviour left(graphs.graphs[question.left], naive::letters_used);
    const Behaviour right(graphs.graphs[question.right], naive::letters_used);
    switch (question.kind) {
        case Question::Kind::refinement:
            return naive::refines(left, right, question.semantics);
        case Question::Kind::deadlock_free:
            return naive::deadlock_free(left, question.semantics);
        case Question::Kind::divergence_free:
            return naive::divergence_free(left);
        case Question::Kind::deterministic:
            return naive::deterministic(left, question.semantics);
        case Question::Kind::has_trace:
            return naive::has_trace(left, trace);
    }
    return false;
}

std::vector<Case> smaller(const Case& test_case) {
    std::vector<Case> result;
    for (std::size_t i = 0; i < test_case.script.mains.size(); ++i)
        for (const Process& next : smaller(test_case.script.mains[i])) {
            result.push_back(test_case);
            result.back().script.mains[i] = next;
        }
    for (std::size_t i = 0; i < test_case.script.definitions.size(); ++i)
        for (const Process& next : smaller(test_case.script.definitions[i])) {
            if (!guarded(next)) continue;
            result.push_back(test_case);
            result.back().script.definitions[i] = next;
        }
    const auto size = [](const Case& candidate) { return show(candidate.script).size(); };
    std::ranges::stable_sort(result, [&](const Case& x, const Case& y) { return size(x) < size(y); });
    return result;
}

}  // namespace robochart::refine
