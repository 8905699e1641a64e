// SPDX-License-Identifier: Apache-2.0
#include "frontend/syntax/foreign_words.hpp"

#include <algorithm>
#include <array>

namespace robochart::frontend {

namespace {

using enum ForeignPlace;

constexpr std::string_view to_machine = "a state machine begins with `stm` and its name";
constexpr std::string_view to_record = "a type with fields is a `datatype`";
constexpr std::string_view to_enumeration = "a type of named values is an `enumeration`";
constexpr std::string_view to_trigger = "the trigger of a transition is written after `trigger`";
constexpr std::string_view to_condition = "the condition of a transition is written after `condition`";
constexpr std::string_view to_action = "the action of a transition is written after `action`";
constexpr std::string_view to_during = "the action of an active state is written after `during`";
constexpr std::string_view to_entry = "the entry action of a state is written after `entry`";
constexpr std::string_view to_exit = "the exit action of a state is written after `exit`";
constexpr std::string_view to_reset = "`#C` resets the clock `C`";
constexpr std::string_view to_wait = "`wait(n)` lets n time units pass";
constexpr std::string_view to_send = "`e` sends an event `e`, and `e!v` sends it with a value";
constexpr std::string_view to_clock =
    "clocks measure time: reset a clock (`#C`) on the transition into the state, and test it with `condition since(C) "
    ">= n`";
constexpr std::string_view no_direction = "an event has no direction: a trigger receives it, and an action sends it";
constexpr std::string_view no_loop =
    "actions have no loops: write a transition that leads back to the state, with the condition of the loop";
constexpr std::string_view to_skip = "`skip` is the action that does nothing";
constexpr std::string_view to_end = "an `if` ends with `end`";
constexpr std::string_view to_operation = "declare an operation in an interface, and define it with `operation`";

constexpr std::array<ForeignWord, 108> rows{{
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
    {"typedef", declaration, "type", "`type` and a name declare a type without structure"},
    {"def", declaration, "function", "a `function` computes a value, and an `operation` is called by machines"},
    {"procedure", declaration, "operation", to_operation},
    {"robot", declaration, "", "`robotic platform` and a name declare the robot"},
    {"platform", declaration, "", "`robotic platform` and a name declare the robot"},
    {"endmodule", declaration, "", "the members of a declaration are in braces: `module M { ... }`"},

    {"statemachine", member, "stm", to_machine},
    {"input", member, "", no_direction, true},
    {"output", member, "", no_direction, true},
    {"inport", member, "", no_direction, true},
    {"outport", member, "", no_direction, true},
    {"signal", member, "event", "machines communicate by an `event`"},
    {"chan", member, "event", "machines communicate by an `event`"},
    {"channel", member, "event", "machines communicate by an `event`"},
    {"timer", member, "clock", "a `clock` measures time"},
    {"constant", member, "const", "`const` declares a constant"},
    {"variable", member, "var", "`var` declares a variable"},
    {"local", member, "var", "`var` declares a variable"},
    {"start", member, "initial", "a machine begins at an `initial` junction"},
    {"init", member, "initial", "a machine begins at an `initial` junction"},
    {"choice", member, "junction", "a choice between conditions is a `junction`"},
    {"edge", member, "transition", "a step from one state to another is a `transition`"},
    {"trans", member, "transition", "a step from one state to another is a `transition`"},
    {"let", member, "var", "`var` declares a variable"},
    {"void", member, "", "an operation has a name and parameters, and no result", true},
    {"operation", member, "", "in an interface an operation is declared by its name and parameters", true},
    {"implements", member, "",
     "a platform `provides` an interface, a machine `requires` its operations and `uses` its events"},
    {"history", member, "", "there is no history: a state is entered at its initial junction"},
    {"fork", member, "", "there are no regions: the machines of one controller run in parallel"},
    {"join", member, "", "there are no regions: the machines of one controller run in parallel"},
    {";", member, "", "members need no separator", true},
    {",", member, "", "members need no separator", true},

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
    {"region", state_part, "", "there are no regions: the machines of one controller run in parallel"},
    {"within", state_part, "", "`S <{ n }` is a statement with a deadline of n time units"},
    {"invariant", state_part, "",
     "a state has no invariant: add a transition that leaves the state, with a condition on a clock"},

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
    {"return", statement, "", "an operation has no result: it ends in a `final` state"},
    {"goto", statement, "", "a transition leads to another state"},

    {"endif", if_end, "end", to_end},
    {"fi", if_end, "end", to_end},

    {"and", infix, "/\\", "join conditions with `/\\`"},
    {"or", infix, "\\/", "join conditions with `\\/`"},
    {"mod", infix, "%", "`%` is the remainder"},
    {"implies", infix, "=>", "`=>` is implication"},

    {"delay", operation, "wait", to_wait},
    {"sleep", operation, "wait", to_wait},
    {"Wait", operation, "wait", to_wait},
    {"pause", operation, "wait", to_wait},
    {"print", operation, "", "for output, call an operation that the platform provides"},
    {"printf", operation, "", "for output, call an operation that the platform provides"},
    {"log", operation, "", "for output, call an operation that the platform provides"},

    {"exec", event, "", "`exec` ends a cycle of RoboSim: a file that uses it is a `.rst`"},
    {"null", event, "skip", to_skip},
    {"nop", event, "skip", to_skip},
    {"pass", event, "skip", to_skip},
    {"return", event, "", "an operation has no result: it ends in a `final` state"},

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

using diagnostics::Advice;

constexpr std::string_view clock_form = "a clock is declared only by its name, `clock C`, and counts time units from 0";
constexpr std::string_view transition_form =
    "a transition has the form `transition t { from A to B trigger e condition c action a }`; only `from` and `to` are "
    "needed";
constexpr std::string_view state_form = "a state has the form `state S { entry a }`; its braces may be empty";
constexpr std::string_view async_form = "an asynchronous connection ends with `(_async)`";
constexpr std::string_view initial_form =
    "a machine begins at an initial junction: `initial i`, and `transition t { from i to S }`";
constexpr std::string_view one_trigger = "a transition waits for one event: use another transition for another event";
constexpr std::string_view trigger_form =
    "`trigger e` waits for an event, and `trigger e?x` stores its value in a variable";
constexpr std::string_view assignment_form = "an assignment is written `x = e`";
constexpr std::string_view no_unit =
    "a number has decimal digits and no unit: durations are counted in time units, whose length depends on the "
    "scenario or platform";
constexpr std::string_view point_form = "a decimal number has digits on both sides of the point: `0.5`, `1.0`";
constexpr std::string_view no_range =
    "a type has no range: `--range T=0..5` or a block Instantiations sets the values that are checked";
constexpr std::string_view comment_form = "a comment begins with `//`";
constexpr std::string_view hash_form = "a comment begins with `//`; `#` resets clocks in transitions and actions";
constexpr std::string_view enumeration_form = "an enumeration has the form `enumeration E { A B }`";
constexpr std::string_view record_form = "a type with fields has the form `datatype D { x : int y : real }`";
constexpr std::string_view machine_form = "a state machine has the form `stm S { ... }`, without parameters or parents";
constexpr std::string_view reference_form =
    "a reference has the form `sref s = S` (machine), `cref c = C` (controller) or `rref r = R` (platform)";
constexpr std::string_view connection_form = "a connection has the form `connection a on e to b on f`";
constexpr std::string_view parameter_form = "a parameter is written `x : int`";
constexpr std::string_view if_form = "an `if` has the form `if c then S else T end`";
constexpr std::string_view to_more_if =
    "write another `if` in the `else`, with a separate `end`: `else if c then S end end`";
constexpr std::string_view assertion_form =
    "an assertion has the form `assertion A : P::M is deadlock-free` or `assertion A : P::M refines Q`";
constexpr std::string_view one_claim = "each claim is a separate assertion, which ends where the next one begins";
constexpr std::string_view property_form = "a property is written after `is`: `P::M is deadlock-free`";
constexpr std::string_view reachable_form = "the claim is `P::S::A is reachable in P::S`, or `is not reachable`";
constexpr std::string_view refinement_form =
    "`P refines Q` claims that Q allows the behaviour of P, and `P equals Q` that both have the same behaviour";
constexpr std::string_view csp_form =
    "a process specifies the required behaviour: `csp Q csp-begin ... csp-end`, and `assertion A : P::M refines Q` "
    "(docs/claims-in-csp.md)";
constexpr std::string_view probability_form =
    "a query for a probability is `prob property A : Prob=? of [Finally ...]` (docs/assertions.md)";
constexpr std::string_view path_form = "a path is `Finally p`, `Globally p`, `Next p` or `p Until q`";
constexpr std::string_view constant_form = "`with constant c of P::S set to 3` sets a constant";
constexpr std::string_view model_form = "write the name of a model in full: `in the traces model`";
constexpr std::string_view block_form = "a block has the form `csp NAME csp-begin ... csp-end`";
constexpr std::string_view time_form = "`timed` and `untimed` come before `assertion`: `timed assertion A : ...`";
constexpr std::string_view any_member = "`assertion`, `csp` or `import`";
constexpr std::string_view any_claim = "`is`, `does`, `terminates`, `refines` or `equals`";
constexpr std::string_view any_property = "a property such as `deadlock-free`";

constexpr std::array forms{
    // Assertions.
    Advice{any_member, "@ assert", assertion_form},
    Advice{any_member, "@ check", assertion_form},
    Advice{any_member, "@ property", assertion_form},
    Advice{any_member, "untimed @", time_form},
    Advice{any_member, "timed @", time_form},
    Advice{any_member, "@ NAME [ ]", csp_form},
    Advice{any_member, "@ NAME < >", csp_form},
    Advice{any_member, "@ NAME = ?", probability_form},
    Advice{any_member, "@ ;", one_claim},
    Advice{any_member, "@ ,", one_claim},
    Advice{any_member, "@ and", one_claim},
    Advice{any_member, "@ where", constant_form},
    Advice{"`:`", "assertion timed @", time_form},
    Advice{"`:`", "assertion untimed @", time_form},
    Advice{"`:`", "assertion NAME @", assertion_form},
    Advice{any_claim, "@ deadlock", property_form},
    Advice{any_claim, "@ divergence", property_form},
    Advice{any_claim, "@ deterministic", property_form},
    Advice{any_claim, "@ reachable", property_form},
    Advice{any_claim, "NAME @ .", "the name of an element of a package or component is `P::M`"},
    Advice{any_claim, "@ reaches", reachable_form},
    Advice{any_claim, "@ [", refinement_form},
    Advice{any_claim, "@ ==", refinement_form},
    Advice{any_claim, "@ =", refinement_form},
    Advice{any_claim, "NAME @ (", csp_form},
    Advice{"`terminate` or `refine`", "@ deadlock", property_form},
    Advice{any_property, "@ livelock", "a model without livelock is `divergence-free`"},
    Advice{any_property, "@ deadlock_free", "write `deadlock-free`, with a hyphen"},
    Advice{any_property, "@ divergence_free", "write `divergence-free`, with a hyphen"},
    Advice{any_property, "@ never", reachable_form},
    Advice{any_property, "@ reached", reachable_form},
    Advice{any_property, "@ equivalent", refinement_form},
    Advice{any_property, "@ clock", "name the clock: `assertion A : clock P::S::C is initialised`"},
    Advice{"`in`", "reachable @", reachable_form},
    Advice{"`is`", "event NAME @ missed", "the claim is `event E is not missed in P::S`"},
    Advice{"`the`", "in @", model_form},
    Advice{"`of`", "constant NAME @", constant_form},
    Advice{"`csp-begin`", "@", block_form},
    Advice{"the block's name", "@", block_form},
    Advice{"`]`", "[ eventually @", path_form},
    Advice{"`]`", "[ always @", path_form},
    Advice{"`]`", "[ F @", path_form},
    Advice{"`]`", "[ G @", path_form},
    // Declarations.
    Advice{"", "package NAME @ {",
           "the package clause comes once, at the beginning of the file, without braces: `package p`"},
    Advice{"", "import @ TEXT",
           "files of a folder are read together; `import p::*` makes the names of a package known"},
    Advice{"", "type NAME @ =", "`type T` declares a new type; types cannot have second names"},
    Advice{"", "enumeration NAME @", enumeration_form},
    Advice{"", "datatype NAME @", record_form},
    Advice{"", "clock NAME @ =", clock_form},
    Advice{"", "clock NAME @ :", clock_form},
    Advice{"", "stm NAME @", machine_form},
    Advice{"", "var NAME @ =", "a variable has a type: `var x : nat = 0`"},
    Advice{"", "const NAME @ =", "a constant has a type: `const c : nat = 3`"},
    Advice{"", ": NAME @ [",
           "the type of a sequence is `Seq(nat)`, and that of a vector of 5 numbers is `vector(real, 5)`"},
    Advice{"", ": NAME @ NUMBER", no_range},
    Advice{"a type", ": @ [", no_range},
    Advice{"a type", ": @ NUMBER", no_range},
    Advice{"`:` and a type", "( NAME @", parameter_form},
    Advice{"`:` and a type", ", NAME @", parameter_form},
    Advice{"", ") @ :", "an operation has no result: return a value by an event or a shared variable"},
    Advice{"a member of a controller", "@ NAME NAME", reference_form},
    Advice{"`=`", "sref NAME @", reference_form},
    Advice{"`=`", "cref NAME @", reference_form},
    Advice{"`=`", "rref NAME @", reference_form},
    Advice{"`on`", "connection NAME @", connection_form},
    Advice{"the name of a component", "connection @", connection_form},
    Advice{"`mult`", "[ @ async", async_form},
    Advice{"`mult`", "[ @ _async", async_form},
    // Nodes and transitions.
    Advice{"a name", "transition @", transition_form},
    Advice{"`{`", "transition NAME @", transition_form},
    Advice{"", "@ [ * ]", initial_form},
    Advice{"a name", "initial @", initial_form},
    Advice{"", "@ NAME ->", transition_form},
    Advice{"", "NAME @ ->", transition_form},
    Advice{"a name", "probabilistic @", "a junction has a name: `probabilistic p`"},
    Advice{"a name", "state @", state_form},
    Advice{"`{`", "state NAME @", state_form},
    Advice{"", "trigger after @", to_clock},
    Advice{"", "trigger NAME @ , NAME", one_trigger},
    Advice{"", "trigger NAME @ or", one_trigger},
    Advice{"", "trigger NAME @ ||", one_trigger},
    Advice{"", "trigger NAME @ \\/", one_trigger},
    Advice{"", "trigger NAME @ (", trigger_form},
    Advice{"", "trigger @ !", "`trigger` only receives events; send an event after `action`"},
    // Statements and expressions.
    Advice{"", "NAME @ ==", assignment_form},
    Advice{"", "NAME @ <-", assignment_form},
    Advice{"", "NAME @ < -", assignment_form},
    Advice{"a statement", "@ !", to_send},
    Advice{"", "send NAME @ to", "the connections of the controller and the module determine the receiver of an event"},
    Advice{"`then`", "@", if_form},
    Advice{"", "@ elif", to_more_if},
    Advice{"", "@ elsif", to_more_if},
    Advice{"", "@ elseif", to_more_if},
    Advice{"", "wait @", to_wait},
    Advice{"", "since @", "the time since clock C was reset is `since(C)`"},
    Advice{"", "sinceEntry @", "the time since state S was entered is `sinceEntry(S)`"},
    Advice{"", "sinceEntry ( @", "the time since state S was entered is `sinceEntry(S)`"},
    Advice{"", "@ ?", "a choice between values is `if c then a else b end`"},
    Advice{"an expression", "* @ *", "there is no operator for powers: write `x * x`"},
    Advice{"an expression", "@ |", "there is no operator for the absolute value: write `if x < 0 then -x else x end`"},
    Advice{"an expression", "@ .", point_form},
    Advice{"the name of a field", "NUMBER . @", point_form},
    Advice{"", "NUMBER % @", "`%` is the remainder; write a share as a number from 0 to 1: `0.5`"},
    Advice{"", "NUMBER @ s", no_unit},
    Advice{"", "NUMBER @ ms", no_unit},
    Advice{"", "NUMBER @ sec", no_unit},
    Advice{"", "NUMBER @ seconds", no_unit},
    Advice{"", "NUMBER @ min", no_unit},
    Advice{"", "NUMBER @ time", no_unit},
    Advice{"", "NUMBER @ deg", no_unit},
    Advice{"", "NUMBER @ cm", no_unit},
    Advice{"", "NUMBER @ m", no_unit},
    Advice{"", "- - NAME @", comment_form},
    Advice{"a declaration", "@ - -", comment_form},
    Advice{any_member, "@ - -", comment_form},
    Advice{"a declaration", "@ #", comment_form},
    Advice{any_member, "@ #", comment_form},
    Advice{"a member of a state machine", "@ #", hash_form},
    Advice{"a node, transition or action of the state", "@ #", hash_form},
};

constexpr auto table = [] {
    std::array<ForeignWord, rows.size() + types.size()> all{};
    std::ranges::copy(rows, all.begin());
    std::ranges::copy(types, all.begin() + rows.size());
    return all;
}();

}  // namespace

std::span<const ForeignWord> foreign_words() {
    return table;
}

std::span<const Advice> foreign_forms() {
    return forms;
}

diagnostics::AdviceWord advice_word(const TokenList& tokens, std::ptrdiff_t index) {
    using enum diagnostics::WordKind;
    if (index < 0 || index >= std::ssize(tokens)) return {end, {}};
    const Token token = tokens[static_cast<std::size_t>(index)];
    switch (token.kind) {
        case TokenKind::end:
            return {end, {}};
        case TokenKind::identifier:
            return {name, token.escaped ? std::string_view() : token.text};
        case TokenKind::integer:
        case TokenKind::real:
            return {number, token.text};
        case TokenKind::string:
            return {text, token.text};
        case TokenKind::keyword:
        case TokenKind::symbol:
        case TokenKind::csp_code:
            break;
    }
    return {other, token.text};
}

const ForeignWord* foreign_word(std::string_view word, ForeignPlace place) {
    const auto* const found = std::ranges::find_if(
        table, [&](const ForeignWord& entry) { return entry.word == word && entry.place == place; });
    return found == table.end() ? nullptr : found;
}

}  // namespace robochart::frontend
