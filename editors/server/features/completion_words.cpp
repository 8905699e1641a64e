// SPDX-License-Identifier: Apache-2.0
// Lists the keywords for each context, and the snippets.
#include "editors/server/features/completion_words.hpp"

#include <algorithm>

namespace robochart::lsp {

namespace {

using Words = std::vector<std::string_view>;

const Words file_words = {"import",    "interface",   "robotic platform", "controller", "stm",
                          "operation", "function",    "module",           "type",       "datatype",
                          "record",    "enumeration", "package",          "diagram"};
const Words interface_words = {"var", "const", "event", "_broadcast event", "clock"};
const Words context_words = {"uses", "requires", "provides", "var", "const", "event", "_broadcast event", "clock"};
const Words node_words = {"state", "initial", "final", "junction", "probabilistic", "transition"};
const Words part_words = {"operation", "opref", "stm", "sref", "connection"};
const Words module_words = {"robotic platform", "rref", "controller", "cref", "connection"};
const Words action_words = {"entry", "during", "exit"};
const Words contract_words = {"precondition", "postcondition"};
/// The clauses in the order of the grammar; `#C` and `<{ e }` are between `trigger` and `condition`.
const Words clause_words = {"from", "to", "trigger", "probability", "condition", "action"};

Words join_lists(std::initializer_list<Words> lists) {
    Words result;
    for (const Words& list : lists) result.insert(result.end(), list.begin(), list.end());
    return result;
}

Words clauses_after(std::string_view last) {
    const auto found = std::ranges::find(clause_words, last);
    if (found == clause_words.end()) return {"from"};
    if (last == "from") return {"to"};
    auto next = found + 1;
    if (last == "trigger") ++next;  // a transition has either a trigger or a probability
    return {next, clause_words.end()};
}

}  // namespace

Words member_words(Block block, std::string_view last_clause) {
    switch (block) {
        case Block::file:
            return file_words;
        case Block::interface:
            return interface_words;
        case Block::platform:
            return context_words;
        case Block::controller:
            return join_lists({context_words, part_words});
        case Block::module:
            return module_words;
        case Block::machine:
            return join_lists({context_words, node_words});
        case Block::operation:
            return join_lists({context_words, node_words, contract_words, {"terminates"}});
        case Block::function:
            return contract_words;
        case Block::state:
            return join_lists({action_words, node_words});
        case Block::transition:
            return clauses_after(last_clause);
        case Block::type:
        case Block::bracket:
            break;
    }
    return {};
}

Words robosim_member_words(Block block) {
    switch (block) {
        case Block::machine:
            return {"cycleDef", "input context", "output context"};
        case Block::operation:
            return {"input context", "output context"};
        case Block::controller:
        case Block::module:
            return {"cycleDef"};
        case Block::transition:
            return {"exec"};
        case Block::file:
        case Block::interface:
        case Block::platform:
        case Block::function:
        case Block::state:
        case Block::type:
        case Block::bracket:
            break;
    }
    return {};
}

const Words& assertion_member_words() {
    static const Words words = {"assertion", "timed assertion", "untimed assertion", "csp", "timed csp", "untimed csp",
                                "import",    "package",         "sleec assertion"};
    return words;
}

Words infix_words(Block block, bool is_assertions) {
    if (is_assertions)
        return {"is",
                "does not",
                "refines",
                "equals",
                "terminates",
                "conforms to",
                "in the traces model",
                "with",
                "and",
                "in the failures divergences model",
                "in the tick-tock model",
                "associated to",
                "csp-begin"};
    const Words operators = {"in", "iff", "cat", "as", "is", "then", "else", "end"};
    switch (block) {
        case Block::controller:
        case Block::module:
            return {"on", "to"};
        case Block::transition:
        case Block::state:
        case Block::machine:
        case Block::operation:
        case Block::function:
        case Block::bracket:
            return operators;
        case Block::file:
        case Block::interface:
        case Block::platform:
        case Block::type:
            break;
    }
    return {};
}

const Words& type_words() {
    static const Words words = {"nat", "int", "real", "boolean", "string", "Seq(", "Set(", "vector(", "matrix("};
    return words;
}

const Words& expression_words() {
    static const Words words = {"true",   "false", "not",   "if",         "let",     "forall",    "exists", "exists1",
                                "lambda", "the",   "since", "sinceEntry", "inverse", "transpose", "result"};
    return words;
}

const Words& statement_words() {
    static const Words words = {"skip", "if", "wait", "send"};
    return words;
}

const Words& property_words() {
    static const Words words = {"deadlock-free", "divergence-free", "timelock-free", "deterministic",
                                "not",           "reachable in",    "initialised",   "missed in",
                                "equal to",      "terminate",       "refine"};
    return words;
}

const Words& toolkit_packages() {
    static const Words words = {"set_toolkit", "relation_toolkit", "function_toolkit", "sequence_toolkit"};
    return words;
}

const std::vector<Snippet>& snippets_for(Block block) {
    static const Snippet state{"state … {}", "state ${1:S} {\n\t$0\n}"};
    static const Snippet transition{"transition … {}",
                                    "transition ${1:t} {\n\tfrom ${2:source}\n\tto ${3:target}\n\t$0\n}"};
    static const Snippet machine{"stm … {}",
                                 "stm ${1:S} {\n\tinitial i0\n\tstate ${2:A} {\n\t}\n\ttransition t0 {\n\t\tfrom "
                                 "i0\n\t\tto ${2:A}\n\t}\n\t$0\n}"};
    static const Snippet interface { "interface … {}", "interface ${1:I} {\n\t$0\n}" };
    static const Snippet controller{"controller … {}", "controller ${1:C} {\n\t$0\n}"};
    static const Snippet module{"module … {}", "module ${1:M} {\n\trref rp = ${2:R}\n\tcref c = ${3:C}\n\t$0\n}"};
    static const Snippet connection{"connection … to …", "connection ${1:a} on ${2:e} to ${3:b} on ${4:f} ( _async )"};
    static const std::vector<Snippet> in_file = {machine, interface, controller, module};
    static const std::vector<Snippet> in_machine = {state, transition};
    static const std::vector<Snippet> in_component = {connection};
    static const std::vector<Snippet> none;
    switch (block) {
        case Block::file:
            return in_file;
        case Block::machine:
        case Block::operation:
        case Block::state:
            return in_machine;
        case Block::controller:
        case Block::module:
            return in_component;
        case Block::interface:
        case Block::platform:
        case Block::function:
        case Block::transition:
        case Block::type:
        case Block::bracket:
            break;
    }
    return none;
}

}  // namespace robochart::lsp
