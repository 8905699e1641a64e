#include "frontend/syntax/foreign_words.hpp"

#include <algorithm>
#include <array>

namespace robochart::frontend {

namespace {

using enum ForeignPlace;

constexpr std::string_view to_machine = "a state machine begins with `stm` and its name";
constexpr std::string_view to_record = "a type with fields is a `datatype`";
constexpr std::string_view to_enumeration = "a type of named values is an `enumeration`";
constexpr std::string_view to_trigger = "the event that a transition awaits stands behind `trigger`";
constexpr std::string_view to_condition = "what must hold for a transition stands behind `condition`";
constexpr std::string_view to_action = "what a transition does stands behind `action`";
constexpr std::string_view to_during = "what a state does while it is active stands behind `during`";
constexpr std::string_view to_entry = "what a state does when it is entered stands behind `entry`";
constexpr std::string_view to_exit = "what a state does when it is left stands behind `exit`";
constexpr std::string_view to_reset = "a clock `C` is reset by `#C`";
constexpr std::string_view to_wait = "`wait(n)` lets n time units pass";
constexpr std::string_view to_send = "an event `e` is sent by `e`, with a value by `e!v`";
constexpr std::string_view to_clock =
    "time is measured by a clock: reset it (`#C`) on the way into the state, and ask `condition since(C) >= n`";
constexpr std::string_view no_direction =
    "an event has no direction: it is received where a trigger awaits it, and sent where an action names it";
constexpr std::string_view no_loop =
    "there are no loops in actions: a loop is a transition that leads back, with the condition to go on";
constexpr std::string_view to_skip = "`skip` is the action that does nothing";
constexpr std::string_view to_end = "an `if` ends with `end`";
constexpr std::string_view to_operation =
    "what a machine calls is declared in an interface, and defined by `operation`";

constexpr std::array<ForeignWord, 91> rows{{
    {"statemachine", declaration, "stm", to_machine},
    {"StateMachine", declaration, "stm", to_machine},
    {"state_machine", declaration, "stm", to_machine},
    {"machine", declaration, "stm", to_machine},
    {"process", declaration, "stm", to_machine},
    {"chart", declaration, "stm", to_machine},
    {"statechart", declaration, "stm", to_machine},
    {"scxml", declaration, "stm", to_machine},
    {"enum", declaration, "enumeration", to_enumeration},
    {"struct", declaration, "datatype", to_record},
    {"class", declaration, "datatype", to_record},
    {"typedef", declaration, "type", "a type without structure is declared by `type` and its name"},
    {"def", declaration, "function", "a function of values is a `function`, what machines call an `operation`"},
    {"procedure", declaration, "operation", to_operation},
    {"robot", declaration, "", "the robot is declared by `robotic platform` and its name"},
    {"endmodule", declaration, "", "what is declared stands in braces: `module M { ... }`"},

    {"statemachine", member, "stm", to_machine},
    {"input", member, "", no_direction, true},
    {"output", member, "", no_direction, true},
    {"inport", member, "", no_direction, true},
    {"outport", member, "", no_direction, true},
    {"signal", member, "event", "what machines exchange is an `event`"},
    {"chan", member, "event", "what machines exchange is an `event`"},
    {"channel", member, "event", "what machines exchange is an `event`"},
    {"timer", member, "clock", "time is measured by a `clock`"},
    {"constant", member, "const", "a constant is declared by `const`"},
    {"variable", member, "var", "a variable is declared by `var`"},
    {"local", member, "var", "a variable is declared by `var`"},
    {"start", member, "initial", "a machine begins at an `initial` junction"},
    {"init", member, "initial", "a machine begins at an `initial` junction"},
    {"choice", member, "junction", "a choice between conditions is a `junction`"},
    {"edge", member, "transition", "a step from one state to another is a `transition`"},
    {"trans", member, "transition", "a step from one state to another is a `transition`"},
    {";", member, "", "members are not separated by anything", true},
    {",", member, "", "members are not separated by anything", true},

    {"do", state_part, "during", to_during},
    {"doActivity", state_part, "during", to_during},
    {"while", state_part, "during", to_during},
    {"onentry", state_part, "entry", to_entry},
    {"onEntry", state_part, "entry", to_entry},
    {"enter", state_part, "entry", to_entry},
    {"en", state_part, "entry", to_entry},
    {"du", state_part, "during", to_during},
    {"ex", state_part, "exit", to_exit},
    {"onexit", state_part, "exit", to_exit},
    {"onExit", state_part, "exit", to_exit},
    {"leave", state_part, "exit", to_exit},
    {"invariant", state_part, "",
     "a state has no invariant: a transition whose condition asks a clock leaves it in time"},

    {"on", clause, "trigger", to_trigger},
    {"upon", clause, "trigger", to_trigger},
    {"event", clause, "trigger", to_trigger},
    {"sync", clause, "trigger", to_trigger},
    {"when", clause, "condition", to_condition},
    {"guard", clause, "condition", to_condition},
    {"cond", clause, "condition", to_condition},
    {"if", clause, "condition", to_condition},
    {"provided", clause, "condition", to_condition},
    {"/", clause, "action", to_action},
    {"do", clause, "action", to_action},
    {"effect", clause, "action", to_action},
    {"assign", clause, "action", to_action},
    {"update", clause, "action", to_action},
    {"source", clause, "from", "a transition leads `from` a node `to` a node"},
    {"target", clause, "to", "a transition leads `from` a node `to` a node"},
    {"reset", clause, "#", to_reset},
    {"after", clause, "", to_clock},
    {"timeout", clause, "", to_clock},

    {"emit", statement, "send", to_send},
    {"raise", statement, "send", to_send},
    {"generate", statement, "send", to_send},
    {"reset", statement, "#", to_reset},
    {"while", statement, "", no_loop},
    {"for", statement, "", no_loop},
    {"repeat", statement, "", no_loop},

    {"endif", if_end, "end", to_end},
    {"fi", if_end, "end", to_end},

    {"and", infix, "/\\", "conditions are joined by `/\\`"},
    {"or", infix, "\\/", "conditions are joined by `\\/`"},
    {"mod", infix, "%", "the remainder is `%`"},
    {"implies", infix, "=>", "`=>` is implication"},

    {"delay", operation, "wait", to_wait},
    {"sleep", operation, "wait", to_wait},
    {"Wait", operation, "wait", to_wait},
    {"pause", operation, "wait", to_wait},

    {"null", event, "skip", to_skip},
    {"nop", event, "skip", to_skip},
    {"pass", event, "skip", to_skip},

    {"True", value, "true", "truth values are `true` and `false`"},
    {"False", value, "false", "truth values are `true` and `false`"},
    {"TRUE", value, "true", "truth values are `true` and `false`"},
    {"FALSE", value, "false", "truth values are `true` and `false`"},
}};

constexpr std::array<ForeignWord, 17> types{{
    {"bool", type, "boolean", "the type of truth values is `boolean`"},
    {"Boolean", type, "boolean", "the type of truth values is `boolean`"},
    {"integer", type, "int", "the type of integers is `int`"},
    {"Integer", type, "int", "the type of integers is `int`"},
    {"long", type, "int", "the type of integers is `int`"},
    {"int32", type, "int", "the type of integers is `int`"},
    {"int64", type, "int", "the type of integers is `int`"},
    {"natural", type, "nat", "the type of natural numbers is `nat`"},
    {"Natural", type, "nat", "the type of natural numbers is `nat`"},
    {"uint", type, "nat", "the type of natural numbers is `nat`"},
    {"unsigned", type, "nat", "the type of natural numbers is `nat`"},
    {"uint32", type, "nat", "the type of natural numbers is `nat`"},
    {"float", type, "real", "the type of real numbers is `real`"},
    {"double", type, "real", "the type of real numbers is `real`"},
    {"single", type, "real", "the type of real numbers is `real`"},
    {"Real", type, "real", "the type of real numbers is `real`"},
    {"String", type, "string", "the type of texts is `string`"},
}};

constexpr auto table = [] {
    std::array<ForeignWord, rows.size() + types.size()> all{};
    std::copy(rows.begin(), rows.end(), all.begin());
    std::copy(types.begin(), types.end(), all.begin() + rows.size());
    return all;
}();

}  // namespace

std::span<const ForeignWord> foreign_words() {
    return table;
}

const ForeignWord* foreign_word(std::string_view word, ForeignPlace place) {
    const auto* const found = std::find_if(
        table.begin(), table.end(), [&](const ForeignWord& each) { return each.word == word && each.place == place; });
    return found == table.end() ? nullptr : found;
}

}  // namespace robochart::frontend
