// SPDX-License-Identifier: Apache-2.0
// Defines the code to which expressions are compiled. A name in code is an index: of a frame slot, a member of a let, a
// global definition, a constructor or a built-in. So evaluation never looks up a name.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "checker/cspm/eval/value.hpp"
#include "checker/cspm/syntax/syntax.hpp"
#include "checker/cspm/types/builtins.hpp"

namespace robochart::cspm {

/// Code that has its own frame of variables: a function's clause, a constant, a prefix, or the environment of a let.
struct Unit {
    Unit* parent = nullptr;
    const Group* group = nullptr;               ///< the let whose environment this unit represents
    const Group* member_of = nullptr;           ///< the let that contains this unit's member
    std::vector<std::pair<int, int>> captures;  ///< captured variables: (slot in the parent's frame, slot here)
    int self_slot = -1;                         ///< the slot for the group that contains the member
    int size = 0;
};

struct MatchCode {
    PatternKind kind = PatternKind::wildcard;
    /// Meaning of a name: true for a constructor or channel, whose index is `number`; false for a variable, whose slot
    /// is `number`.
    bool head = false;
    std::int64_t number = 0;
    std::vector<MatchCode> args;
};

/// What a name refers to.
enum class Reference : std::uint8_t { none, local, member, global, head, builtin };

/// The duration function and the tock event of a timed section.
struct TimedSection {
    const Code* duration = nullptr;  ///< null if every event takes one unit
    Unit* unit = nullptr;
    int tock = -1;                   ///< index of the head
    Value duration_value = nullptr;  ///< the function's value after its evaluation
};

struct FieldCode {
    FieldKind kind = FieldKind::output;
    Span span;
    const Code* value = nullptr;
    std::vector<MatchCode> patterns;  ///< input: the parts of the pattern, left to right
};

struct ClauseCode {
    bool generator = false;
    MatchCode pattern;
    const Code* value = nullptr;
};

struct Code {
    ExprKind kind = ExprKind::integer;
    Span span;
    Reference reference = Reference::none;
    int slot = -1;   ///< local, member: slot; global, head, builtin: index
    int index = -1;  ///< member: the index of the member
    Value constant = nullptr;
    std::vector<const Code*> args;
    std::vector<FieldCode> fields;
    std::vector<ClauseCode> clauses;  ///< prefix for `[] e : S @ e -> P`: the clauses `e : S`
    std::vector<std::pair<const Code*, const Code*>> links;
    std::vector<ClauseCode> link_clauses;  ///< replicated linked parallel: clauses of the links
    Unit* unit = nullptr;                  ///< of a prefix
    const Function* function = nullptr;    ///< of a lambda
    const Group* group = nullptr;          ///< of a let
    TimedSection* timed = nullptr;         ///< the timed section that contains the code
    std::uint32_t number = 0;              ///< of a prefix: identifies its place in the script
    mutable std::uint8_t too_long = 0;     ///< how many early evaluations took too long (Evaluator)
};

struct FunctionClause {
    Unit* unit = nullptr;
    std::vector<MatchCode> patterns;  ///< the patterns of all groups, one after the other
    const Code* body = nullptr;
};

/// A function, or a constant (a function without argument groups).
struct Function {
    std::uint32_t number = 0;
    std::string name;
    Span span;
    std::vector<std::size_t> groups;  ///< number of arguments in each group
    std::vector<FunctionClause> clauses;
    std::vector<bool> unread;          ///< whether each argument is never read; empty if there are several groups
    std::size_t environment = 0;       ///< number of captured items, which precede the arguments
    mutable std::int8_t watched = -1;  ///< 1: calls are observed; 0: they are not; -1: not yet known
    mutable std::int8_t process = -1;  ///< 1: the result is obviously a process; 0: it is not; -1: not yet known
};

/// A member of a let: a function, a constant, or a variable that a pattern on the left side of a constant binds.
struct Member {
    Function function;
    int component_of = -1;  ///< for a variable of a pattern: the index of the constant member
    int component_slot = -1;
};
struct Group {
    std::uint32_t number = 0;
    Unit* unit = nullptr;
    std::vector<Member> members;
};

/// A channel or a constructor.
struct Head {
    std::string name;  ///< qualified, as printed
    Span span;
    bool channel = false;
    int type = -1;  ///< for a constructor: index of its datatype in `globals`
    const Code* fields_code = nullptr;
    Unit* unit = nullptr;
    bool evaluated = false;
    bool running = false;
    Values fields;  ///< one set for each field
};

enum class GlobalKind : std::uint8_t { function, component, datatype, subtype, nametype };
struct Global {
    GlobalKind kind = GlobalKind::function;
    Function function;  ///< unused for a subtype; a constant for a nametype
    int component_of = -1;
    int component_slot = -1;
    std::vector<int> heads;                            ///< datatype
    std::vector<std::pair<int, const Code*>> subtype;  ///< heads with their fields
    Value known = nullptr;
    Value lazily = nullptr;          ///< a value with a part that failed; valid in one query
    std::uint64_t lazily_entry = 0;  ///< the query in which `lazily` is valid
    bool running = false;
};

/// The code of a whole script.
struct Program {
    std::deque<Unit> units;
    std::deque<Code> codes;
    std::deque<Group> groups;
    std::deque<Function> lambdas;
    std::deque<Global> globals;
    std::deque<Head> heads;
    std::deque<TimedSection> timed;
    std::vector<const Code*> prefixes;
};

}  // namespace robochart::cspm
