// SPDX-License-Identifier: Apache-2.0
// Converts syntax trees to code: resolves scopes, modules and instances, and assigns slots to names (code.hpp). A
// module without parameters is a part of the script; its names get a prefix. For an instance, the declarations of its
// module are copied, and the parameters are defined as the arguments.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <string>

#include "base/diagnostics/pollable.hpp"
#include "checker/cspm/eval/code.hpp"
#include "checker/cspm/eval/evaluation_error.hpp"
#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::cspm {

class Resolver {
public:
    Resolver(Program& program, ValueStore& store);

    /// Sets the budget that compilations poll. The budget must outlive them.
    void set_budget(diagnostics::Pollable& budget) { budget_ = &budget; }
    /// Declares and compiles a script's declarations.
    void compile_script(const Script& script);
    /// Compiles an expression in the script's global scope. If `place` is not null, the expression belongs to this
    /// assertion of the script, and is compiled in the scope of the enclosing module or timed section.
    const Code* compile_expression(const ExprPtr& expr, const Decl* place, Unit*& unit);

private:
    struct Module;
    enum class What { local, member, global, head, builtin, module };
    struct Binding {
        What what = What::global;
        Unit* owner = nullptr;
        int slot = -1;
        const Group* group = nullptr;
        int index = -1;
        Module* module = nullptr;
        Span span;
    };
    struct Scope {
        Scope* parent = nullptr;
        std::map<std::string, Binding, std::less<>> names;
    };
    struct Module {
        const Decl* decl = nullptr;  // the declaration of the module
        Scope* outer = nullptr;      // the scope of that declaration
        Scope exported;
        const Decl* instance = nullptr;  // null for a module that is no instance; otherwise created on first use
        Scope* instance_scope = nullptr;
        TimedSection* timed = nullptr;
        std::string name;  // qualified name
        bool running = false;
    };
    struct Place {
        Scope* scope = nullptr;
        TimedSection* timed = nullptr;
    };
    struct Target {
        Scope* scope = nullptr;
        Scope* exported = nullptr;  // null if the names are not exported
        std::string prefix;
        TimedSection* timed = nullptr;
    };

    // A let that is being compiled: its members, the slot of its environment, and the tasks to run when all members are
    // declared.
    struct LetScope {
        Group& group;
        int slot;
        std::vector<std::function<void()>>& jobs;
    };

    // declarations
    void declare(const std::vector<DeclPtr>& decls, const Target& target);
    std::size_t declare_function(const std::vector<DeclPtr>& decls, std::size_t first, const Target& target);
    std::vector<DeclPtr> split_tuple(const Decl& decl);
    void declare_value(const Decl& decl, const Target& target);
    void declare_channel(const Decl& decl, const Target& target);
    void declare_datatype(const Decl& decl, const Target& target);
    void declare_subtype(const Decl& decl, const Target& target);
    void declare_nametype(const Decl& decl, const Target& target);
    void declare_module(const Decl& decl, const Target& target);
    void declare_instance(const Decl& decl, const Target& target);
    void declare_timed(const Decl& decl, const Target& target);
    void declare_builtins(const Decl& decl, Scope& scope, Scope* exported);
    void declare_contents(Module& module, const std::string& prefix, TimedSection* timed, Scope* inner);
    void create_instance(Module& module);
    void bind_name(const Target& target, const std::string& name, Binding binding);
    int new_global(GlobalKind kind, const std::string& name, Span span);
    void schedule_job(const Target& target, std::function<void()> job);
    void run_jobs();

    // names
    [[nodiscard]] const Binding* find(std::string_view text, Scope* scope);
    const Binding* find_inside(Module& module, std::string_view path);
    [[nodiscard]] const Binding* find_simple(std::string_view name, Scope* scope) const;
    const Code* compile_name(const Expr& expr);
    const Code* compile_reference(const Expr& expr, const Binding& binding);
    static int import_local(Unit& unit, const Unit& owner, int slot);
    static int import_group(Unit& unit, const Binding& binding);
    static int capture_variable(Unit& unit, int parent_slot);

    // code
    Unit& new_unit(Unit* parent);
    Code& new_code(const Expr& expr);
    Scope& new_scope(Scope* parent);
    const Code* compile(const ExprPtr& expr);
    const Code* compile_literal(const Expr& expr);
    const Code* compile_lambda(const Expr& expr);
    const Code* compile_let(const Expr& expr);
    void let_members(const std::vector<DeclPtr>& decls, LetScope& let);
    std::size_t let_member(LetScope& let, const std::string& name, Span span);
    void let_bind(LetScope& let, const std::string& name, std::size_t index, Span span);
    void let_clause(LetScope& let, std::size_t index, const Decl& decl);
    void let_value(const Decl& decl, LetScope& let);
    void let_timed(const Decl& decl, LetScope& let);
    std::vector<std::string> pattern_variables(const Pattern& pattern);
    const Code* compile_prefix(const Expr& expr, const std::vector<Clause>& offered);
    [[nodiscard]] bool offers_events(const Expr& choice) const;
    FieldCode compile_field(const Field& field);
    void field_parts(const Pattern& pattern, std::vector<MatchCode>& parts);
    const Code* with_clauses(const Expr& expr);
    std::vector<ClauseCode> compile_clauses(const std::vector<Clause>& clauses);
    void clause_of(Function& function, const Decl& decl, Unit* parent, const Group* member_of);
    MatchCode compile_pattern(const Pattern& pattern);
    void collect_variables(const MatchCode& match, const Pattern& pattern,
                           std::vector<std::pair<std::string, int>>& out) const;
    [[noreturn]] static void fail(const std::string& message, Span span);

    Program& program_;
    ValueStore& store_;
    std::deque<Scope> scopes_;
    std::deque<Module> modules_;
    std::deque<std::function<void()>> jobs_;
    diagnostics::Pollable* budget_ = &diagnostics::unlimited;
    std::map<const Decl*, Place> places_;
    Scope* global_ = nullptr;
    Scope* scope_ = nullptr;
    Unit* unit_ = nullptr;
    TimedSection* timed_ = nullptr;
    std::deque<DeclPtr> made_;  // declarations that split_tuple created
    std::uint32_t functions_ = 0;
    unsigned instances_ = 0;
};

}  // namespace robochart::cspm
