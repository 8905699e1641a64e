// SPDX-License-Identifier: Apache-2.0
// Expressions as code for evaluation: names are resolved to frame slots, members of a let, global definitions,
// constructors or built-ins, so that evaluation never looks up a name.
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

/// Code that shares one frame of variables: a function's clause, a constant, a prefix, a let's environment.
struct Unit {
    Unit* parent = nullptr;
    const Group* group = nullptr;               ///< the let whose environment this unit represents
    const Group* member_of = nullptr;           ///< the let to which this unit's member belongs
    std::vector<std::pair<int, int>> captures;  ///< (slot in the parent's frame, slot here)
    int self_slot = -1;                         ///< the slot for the member's own group object
    int size = 0;
};

struct MatchCode {
    PatternKind kind = PatternKind::wildcard;
    bool head = false;  ///< name: a constructor or channel, `number` is its index; otherwise a variable, `number` is
                        ///< its slot
    std::int64_t number = 0;
    std::vector<MatchCode> args;
};

/// The kinds of meanings of a name.
enum class Reference : std::uint8_t { none, local, member, global, head, builtin };

/// The duration function and tock of a timed section.
struct TimedSection {
    const Code* duration = nullptr;  ///< null: every event takes one unit
    Unit* unit = nullptr;
    int tock = -1;                   ///< head index
    Value duration_value = nullptr;  ///< set after its evaluation
};

struct FieldCode {
    FieldKind kind = FieldKind::output;
    Span span;
    const Code* value = nullptr;
    std::vector<MatchCode> patterns;  ///< input: the pattern's parts, left to right
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
    std::vector<ClauseCode> clauses;  ///< prefix that represents `[] e : S @ e -> P`: the clauses `e : S`
    std::vector<std::pair<const Code*, const Code*>> links;
    std::vector<ClauseCode> link_clauses;  ///< replicated linked parallel: clauses of the links
    Unit* unit = nullptr;                  ///< prefix
    const Function* function = nullptr;    ///< lambda
    const Group* group = nullptr;          ///< let
    TimedSection* timed = nullptr;         ///< inside a timed section
    std::uint32_t number = 0;              ///< prefix: identity
    mutable std::uint8_t too_long = 0;     ///< number of times that its early evaluation was abandoned (see Evaluator)
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
    std::vector<bool> unread;          ///< only for a single group: true for arguments that are never read
    std::size_t environment = 0;       ///< number of captured items before the arguments
    mutable std::int8_t watched = -1;  ///< 1 if calls are observed, otherwise 0; -1: unknown
    mutable std::int8_t process = -1;  ///< 1 if the result is obviously a process, otherwise 0; -1: unknown
};

/// A let's declarations; a member is a function, a constant, or a part of a constant that is a pattern.
struct Member {
    Function function;
    int component_of = -1;  ///< a part: the index of the constant member that contains it
    int component_slot = -1;
};
struct Group {
    std::uint32_t number = 0;
    Unit* unit = nullptr;
    std::vector<Member> members;
};

/// Channels and constructors.
struct Head {
    std::string name;  ///< as printed, qualified
    Span span;
    bool channel = false;
    int type = -1;  ///< constructors: the global of their datatype
    const Code* fields_code = nullptr;
    Unit* unit = nullptr;
    bool evaluated = false;
    bool running = false;
    Values fields;  ///< one set for each field
};

enum class GlobalKind : std::uint8_t { function, component, datatype, subtype, nametype };
struct Global {
    GlobalKind kind = GlobalKind::function;
    Function function;  ///< subtype, nametype: unused; nametype: a constant
    int component_of = -1;
    int component_slot = -1;
    std::vector<int> heads;                            ///< datatype
    std::vector<std::pair<int, const Code*>> subtype;  ///< head, fields
    Value known = nullptr;
    Value lazily = nullptr;          ///< the value if one of its parts cannot be evaluated...
    std::uint64_t lazily_entry = 0;  ///< ...valid only during the query with this number
    bool running = false;
};

/// The code of a script.
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
