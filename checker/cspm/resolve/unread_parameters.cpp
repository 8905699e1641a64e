// SPDX-License-Identifier: Apache-2.0
// Finds the variables that are read. A variable is read wherever its name occurs, with one exception: the name is a
// whole argument of a call. Then it is read only if the parameter is read. This relation is stored as a link. The
// algorithm follows the links backwards from variables that are certainly read.
#include "checker/cspm/resolve/unread_parameters.hpp"

#include <set>

namespace robochart::cspm {
namespace {

/// A variable: a slot in the frame of a unit.
using Variable = std::pair<const Unit*, int>;

bool is_variable(const MatchCode& pattern) {
    return pattern.kind == PatternKind::name && !pattern.head;
}

class Reading {
public:
    explicit Reading(const Program& program) : program_(program) {
        for (const Unit& unit : program.units)
            for (const auto& [from, to] : unit.captures) links_[{&unit, to}].push_back({unit.parent, from});
        for (const Global& global : program.globals) function(global.function);
        for (const Global& global : program.globals)
            for (const auto& [head, fields] : global.subtype) expression(fields, global.function.clauses.at(0).unit);
        for (const Head& head : program.heads) expression(head.fields_code, head.unit);
        for (const TimedSection& section : program.timed) expression(section.duration, section.unit);
    }

    [[nodiscard]] bool reads(const Variable& variable) const { return read_.contains(variable); }

private:
    void function(const Function& function) {
        for (const FunctionClause& clause : function.clauses) expression(clause.body, clause.unit);
    }
    void expression(const Code* code, const Unit* unit);
    void call(const Code& code, const Function& callee, const Unit* unit);
    [[nodiscard]] const Function* callee(const Code& code) const;
    void read(const Variable& variable);

    const Program& program_;
    std::set<Variable> read_;
    std::map<Variable, std::vector<Variable>> links_;  // if the key is read, these variables are read too
};

void Reading::read(const Variable& variable) {
    std::vector<Variable> pending{variable};
    while (!pending.empty()) {
        const Variable next = pending.back();
        pending.pop_back();
        if (!read_.insert(next).second) continue;
        const std::vector<Variable>& more = links_[next];
        pending.insert(pending.end(), more.begin(), more.end());
    }
}

/// Returns the definition that an application calls. Returns null if it is unknown, or if some arguments of the
/// definition are missing.
const Function* Reading::callee(const Code& code) const {
    if (code.kind != ExprKind::apply || code.args[0]->kind != ExprKind::name) return nullptr;
    const Code& name = *code.args[0];
    const Function* function = nullptr;
    if (name.reference == Reference::global)
        function = &program_.globals[static_cast<std::size_t>(name.slot)].function;
    else if (name.reference == Reference::member)
        function = &name.group->members[static_cast<std::size_t>(name.index)].function;
    const bool complete = function != nullptr && function->groups == std::vector{code.args.size() - 1};
    return complete ? function : nullptr;
}

void Reading::call(const Code& code, const Function& callee, const Unit* unit) {
    for (std::size_t i = 0; i + 1 < code.args.size(); ++i) {
        const Code& argument = *code.args[i + 1];
        if (argument.kind != ExprKind::name || argument.reference != Reference::local) {
            expression(&argument, unit);
            continue;
        }
        const Variable given{unit, argument.slot};
        for (const FunctionClause& clause : callee.clauses) {
            const MatchCode& pattern = clause.patterns[i];
            if (pattern.kind == PatternKind::wildcard) continue;
            const Variable taken{clause.unit, static_cast<int>(pattern.number)};
            if (is_variable(pattern) && !read_.contains(taken))
                links_[taken].push_back(given);
            else
                read(given);
        }
    }
}

void Reading::expression(const Code* code, const Unit* unit) {
    if (code == nullptr) return;
    if (code->kind == ExprKind::prefix) unit = code->unit;
    if (code->kind == ExprKind::name) {
        if (code->reference == Reference::local || code->reference == Reference::member) read({unit, code->slot});
        return;
    }
    if (const Function* named = callee(*code)) {
        expression(code->args[0], unit);
        return call(*code, *named, unit);
    }
    if (code->group != nullptr)
        for (const Member& member : code->group->members) function(member.function);
    if (code->function != nullptr) function(*code->function);
    for (const FieldCode& field : code->fields) expression(field.value, unit);
    for (const ClauseCode& clause : code->clauses) expression(clause.value, unit);
    for (const ClauseCode& clause : code->link_clauses) expression(clause.value, unit);
    for (const auto& [from, to] : code->links) {
        expression(from, unit);
        expression(to, unit);
    }
    for (const Code* arg : code->args) expression(arg, unit);
}

void mark_unread(Function& function, const Reading& reading) {
    if (function.groups.size() != 1) return;
    function.unread.assign(function.groups.front(), true);
    for (const FunctionClause& clause : function.clauses)
        for (std::size_t i = 0; i < clause.patterns.size(); ++i) {
            const MatchCode& pattern = clause.patterns[i];
            const bool unread =
                pattern.kind == PatternKind::wildcard ||
                (is_variable(pattern) && !reading.reads({clause.unit, static_cast<int>(pattern.number)}));
            if (!unread) function.unread[i] = false;
        }
}

}  // namespace

void find_unread_parameters(Program& program) {
    const Reading reading(program);
    for (Global& global : program.globals) mark_unread(global.function, reading);
    for (Group& group : program.groups)
        for (Member& member : group.members) mark_unread(member.function, reading);
}

}  // namespace robochart::cspm
