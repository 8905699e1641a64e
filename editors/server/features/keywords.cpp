// SPDX-License-Identifier: Apache-2.0
// Lists the meanings of reserved words (language reference, chapters 2 and 3; docs/semantics.md for timing).
#include "editors/server/features/keywords.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace robochart::lsp {

namespace {

struct WordMeaning {
    std::string_view word;
    std::string_view text;
};

/// Sorted by word.
constexpr std::array robochart_meanings = {
    WordMeaning{"_async",
                "The connection has a buffer of one place that keeps the newest value: the sender never waits for the "
                "receiver."},
    WordMeaning{"_broadcast",
                "The event may be received by any number of robots. It has no meaning for one robot alone."},
    WordMeaning{"action",
                "The statement of a transition. It runs after the exit actions of the source and before the "
                "entry actions of the target."},
    WordMeaning{"as", "`e as T`: the value of `e` as a value of type `T`."},
    WordMeaning{"cat", "`s cat t`: the sequence `s` followed by the sequence `t`."},
    WordMeaning{"clock",
                "Declares a clock. It counts time units from 0, since the machine started or since its last reset "
                "`#C`; `since(C)` reads it."},
    WordMeaning{"condition",
                "The guard of a transition: it can be taken only while this is true. `condition else` is "
                "true where the guards of the node's other transitions are false."},
    WordMeaning{"connection",
                "Connects an event of one component with an event of another. Both take part at the same "
                "time, unless the connection is marked `_async`."},
    WordMeaning{"const",
                "Declares a constant. Without a value here it is a parameter of the model: an instantiation or an "
                "assertion gives the value."},
    WordMeaning{"context",
                "`input context` and `output context` of a RoboSim machine or operation list its registers: what it "
                "reads and writes by `$`."},
    WordMeaning{"controller",
                "Declares state machines that run in parallel, the operations that they call and the "
                "connections between them."},
    WordMeaning{"cref", "A controller that is declared elsewhere, as a part of this module."},
    WordMeaning{"cycle", "RoboSim: the length of a cycle, in time units."},
    WordMeaning{"cycleDef",
                "RoboSim: the length of the component's cycles, `cycleDef cycle == 1`. The parts of a component run in "
                "its cycles."},
    WordMeaning{"datatype", "Declares a record type with its fields."},
    WordMeaning{"diagram", "Names a diagram of the file. It has no meaning for the behaviour."},
    WordMeaning{"during",
                "An action that runs while its state is active, beside everything inside the state. It begins "
                "once the state has been entered, and is cut off where the state is left."},
    WordMeaning{"else", "What happens, or which value counts, if the condition is false."},
    WordMeaning{"end", "Ends an `if`."},
    WordMeaning{"entry",
                "An action that runs when its state is entered, before the states inside are entered. Only what "
                "waits or communicates in it takes time."},
    WordMeaning{"enumeration", "Declares a type by listing its literals. A literal may have arguments."},
    WordMeaning{"event",
                "Declares an event, with the type of its values if it has any. An event itself takes no time."},
    WordMeaning{"exec", "RoboSim: ends the cycle. The machine goes on in the next cycle, with the new inputs."},
    WordMeaning{"exists", "True if the condition holds for at least one value of the variables."},
    WordMeaning{"exists1", "True if the condition holds for exactly one value of the variables."},
    WordMeaning{"exit",
                "An action that runs when its state is left, after the states inside have been left. Only what "
                "waits or communicates in it takes time."},
    WordMeaning{"false", "The boolean value that is not `true`."},
    WordMeaning{"final", "A node in which the machine, or the state around it, has ended."},
    WordMeaning{"forall", "True if the condition holds for every value of the variables."},
    WordMeaning{"from", "The source of a transition or of a communication."},
    WordMeaning{"function",
                "Declares a mathematical function by its precondition and postcondition. It changes nothing "
                "and takes no time."},
    WordMeaning{"if", "Chooses between two statements or two values by a condition."},
    WordMeaning{"iff", "`a iff b`: true if `a` and `b` are both true or both false."},
    WordMeaning{"import", "Makes declarations of another package known in this file without the package's name."},
    WordMeaning{"in", "`x in S`: true if `x` is an element of the set `S`."},
    WordMeaning{"initial", "The node in which a machine or a composite state begins. It is left at once."},
    WordMeaning{
        "input",
        "`input context`: the inputs of a RoboSim machine or operation. A cycle begins by reading all of them."},
    WordMeaning{"interface",
                "Declares variables, constants, events, clocks and operations together, for components that "
                "use, require or provide them."},
    WordMeaning{"inverse", "The inverse of a matrix."},
    WordMeaning{"is", "`x is T`: true if the value of `x` is of type `T`."},
    WordMeaning{"junction", "A node that is left at once by a transition whose guard is true. No time passes in it."},
    WordMeaning{"lambda", "A function given by an expression over its parameters."},
    WordMeaning{"let", "Gives names to values for one expression: `let x == e @ body`."},
    WordMeaning{"matrix", "`matrix(T, r, c)`: the type of matrices of `T` with `r` rows and `c` columns."},
    WordMeaning{"module",
                "Declares a whole robot: one robotic platform, controllers, and the connections between them."},
    WordMeaning{"mult", "`[mult]`: the connection is used in both directions."},
    WordMeaning{"not", "`not b`: true if `b` is false."},
    WordMeaning{"on", "`C on e`: the event `e` of the component `C`, at an end of a connection."},
    WordMeaning{"operation",
                "Declares an operation with a body: a machine that runs when it is called. The call lasts "
                "until the operation reaches a final node."},
    WordMeaning{"opref", "An operation that is declared elsewhere, as a part of this controller."},
    WordMeaning{
        "output",
        "`output context`: the outputs of a RoboSim machine or operation. Each can be written once in a cycle."},
    WordMeaning{"package", "The package that the declarations of this file belong to."},
    WordMeaning{"platform",
                "`robotic platform`: the variables, events and operations that the robot offers to its "
                "software. Calls of its operations take no time."},
    WordMeaning{"postcondition", "What is true of the result of a function, or after an operation."},
    WordMeaning{"precondition", "What must be true where a function is applied or an operation is called."},
    WordMeaning{"probabilistic",
                "A junction that chooses its transition by probabilities. Checks by CSP treat the choice "
                "as free."},
    WordMeaning{"probability", "How probable this transition of a probabilistic junction is."},
    WordMeaning{"provides", "The component declares what is in the interface, and other components may use it."},
    WordMeaning{"record", "Declares a record type with its fields."},
    WordMeaning{"requires",
                "The component uses the variables and operations of the interface, which a component around "
                "it must provide."},
    WordMeaning{"result", "In a postcondition: the value of the function."},
    WordMeaning{"robotic",
                "`robotic platform`: the variables, events and operations that the robot offers to its "
                "software. Calls of its operations take no time."},
    WordMeaning{"rref", "A robotic platform that is declared elsewhere, as a part of this module."},
    WordMeaning{"send",
                "`send e!v`: the machine communicates the event. It waits until whoever is connected takes part; "
                "time may pass meanwhile."},
    WordMeaning{"since", "`since(C)`: the number of time units since the clock `C` was reset last."},
    WordMeaning{"sinceEntry",
                "`sinceEntry(S)`: the number of time units since the state `S` was entered last, counted "
                "from the end of its entry action."},
    WordMeaning{"skip", "The statement that does nothing and takes no time."},
    WordMeaning{"sref", "A state machine that is declared elsewhere, as a part of this controller."},
    WordMeaning{"state",
                "Declares a state. A machine stays in it until one of its transitions can be taken; time may "
                "pass meanwhile. States inside make it composite."},
    WordMeaning{"stm",
                "Declares a state machine: nodes, transitions, and the variables, events and clocks that they use."},
    WordMeaning{"terminates", "The operation promises that every call of it comes to an end."},
    WordMeaning{"the",
                "The value of the variables, or of the expression over them, for which the condition holds; there "
                "must be exactly one."},
    WordMeaning{"then", "What happens, or which value counts, if the condition is true."},
    WordMeaning{"to", "The target of a transition, the other end of a connection, or the upper bound of a range."},
    WordMeaning{"transition",
                "Declares a transition between two nodes. It is taken where its trigger occurs and its "
                "condition is true. Taking it takes no time, except for what the actions do."},
    WordMeaning{"transpose", "The transpose of a matrix."},
    WordMeaning{"trigger",
                "The event that a transition takes. It may store the value (`e?x`), reset clocks (`#C`) and "
                "have a deadline (`<{d}`): the time within which it must happen."},
    WordMeaning{"true", "The boolean value that is not `false`."},
    WordMeaning{"type", "Declares a type about whose values nothing is known. An instantiation makes it finite."},
    WordMeaning{"uses", "The component has what the interface declares, such as its events, as its own."},
    WordMeaning{"var", "Declares a variable, with its first value if one is given."},
    WordMeaning{"vector", "`vector(T, n)`: the type of vectors of `T` with `n` entries."},
    WordMeaning{"wait",
                "`wait(d)`: lets exactly `d` time units pass. `wait([m, n])` lets some number between `m` and `n` "
                "pass. In the untimed semantics it does nothing."},
};

/// Sorted by word.
constexpr std::array assertion_meanings = {
    WordMeaning{"assertion",
                "A claim about a component that `robochart-verify check` decides. Without `timed` or "
                "`untimed` before it, it is decided in both semantics."},
    WordMeaning{"conform", "`does not conform to`: some run of the component breaks the rule."},
    WordMeaning{"conforms", "`C conforms to R`: no run of the component breaks the rule, which a `.sleec` file has."},
    WordMeaning{"constant", "`constant c of X set to v`: the value that the constant has for this assertion."},
    WordMeaning{"csp", "A block of CSPM text. Its processes can take part in assertions."},
    WordMeaning{"deadlock-free",
                "The component never reaches a state in which nothing can happen any more. A component that "
                "has terminated is in such a state."},
    WordMeaning{"deterministic", "After the same events the component never can both accept and refuse an event."},
    WordMeaning{"divergence-free", "The component never performs events that cannot be seen from outside without end."},
    WordMeaning{"equal",
                "`is not equal to`: at least one of the two components has a behaviour that the other has not."},
    WordMeaning{"equals", "Each of the two components refines the other."},
    WordMeaning{"initialised",
                "`clock C is initialised`: some run resets the clock, and no run reads it before its first reset."},
    WordMeaning{"missed",
                "`event E is missed in S for N time units`: some run stays in S and refuses E before N time units in a "
                "row, while calls and outputs are taken at once. Without `for`: before one."},
    WordMeaning{"reachable", "`S is reachable in M`: there is a behaviour of `M` that enters the state `S`."},
    WordMeaning{"refine", "`does not refine`: the first component has a behaviour that the second has not."},
    WordMeaning{"refines", "Every behaviour of the first component is one of the second."},
    WordMeaning{"sleec", "`sleec assertion`: whether a component obeys a rule in SLEEC, of a file in the same folder."},
    WordMeaning{"terminate", "`does not terminate`: the component never ends."},
    WordMeaning{"terminates", "The component can end, and never stops without having ended."},
    WordMeaning{"timed", "The assertion is decided in the timed semantics, in which time passes by `tock`."},
    WordMeaning{"timelock-free", "Time can pass wherever nothing internal is left to do: no deadline can be missed."},
    WordMeaning{"untimed",
                "The assertion is decided in the semantics without time: waits, resets and deadlines do "
                "nothing, and guards that read clocks count as true."},
};

std::string_view meaning_in(std::span<const WordMeaning> table, std::string_view word) {
    const auto found = std::ranges::lower_bound(table, word, {}, &WordMeaning::word);
    return found != table.end() && found->word == word ? found->text : std::string_view();
}

}  // namespace

std::string_view meaning_of_word(std::string_view word) {
    return meaning_in(robochart_meanings, word);
}

std::string_view meaning_of_assertion_word(std::string_view word) {
    return meaning_in(assertion_meanings, word);
}

}  // namespace robochart::lsp
