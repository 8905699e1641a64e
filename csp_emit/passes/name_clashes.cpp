// SPDX-License-Identifier: Apache-2.0
// See name_clashes.hpp. A name that both sides declare at the top is not renamed if it is a channel of RoboTool's
// library or a component. The type checker then reports the second declaration.
#include "csp_emit/passes/name_clashes.hpp"

#include <map>

#include "checker/cspm/syntax/lookup.hpp"
#include "checker/cspm/types/builtins.hpp"
#include "csp_emit/base/library.hpp"

namespace robochart::csp_emit {

using cspm::DeclKind;
using cspm::DeclPtr;

cspm::NewNames new_names_of_ours(const UserNames& theirs, const std::vector<DeclPtr>& generated, NameManager& names) {
    cspm::NewNames result;
    if (theirs.constructors.empty()) return result;
    for (const std::string& name : cspm::bound_names(generated))
        if (theirs.constructors.contains(name)) result.try_emplace(name, names.unique_name(name));
    return result;
}

namespace {

/// True if the name is a channel or type of RoboTool in the library, which a block must not declare again.
bool is_shared(const std::string& name) {
    return name == "InOut" || name == "in" || name == "out" || name == "tock" || name == "tock'";
}

/// True if a block's declaration with this name would hide a declaration of CSPM or of the library.
bool hides_generated(const std::string& name) {
    return is_predefined(name) || (library_names().contains(name) && !is_shared(name));
}

/// True if the instantiations define an element of the model with this name.
bool defines_element(const std::set<std::string>& given, const std::string& name) {
    return given.contains(name) && !is_shared(name);
}

/// Chooses new names for the declarations of one script's blocks.
class Theirs {
public:
    Theirs(const std::vector<FileBlocks>& files, const NamesForBlocks& of_model, const std::vector<DeclPtr>& generated,
           NameManager& names)
        : of_model_(of_model), names_(names) {
        std::set<std::string> constructors;
        for (const FileBlocks& file : files) {
            UserNames given = user_names(file.instantiations);
            UserNames own = user_names(file.others);
            for (const auto* declared : {&given.constructors, &own.constructors})
                constructors.insert(declared->begin(), declared->end());
            for (const std::string& name : own.all) ++files_that_declare_[name];
            given_.merge(given.all);
            modules_.merge(given.modules);
            own_.push_back(std::move(own));
        }
        if (!constructors.empty())
            for (const std::string& name : cspm::value_names(generated))
                if (constructors.contains(name)) values_.insert(name);
        choose_common();
    }

    cspm::QualifiedNames of_file(std::size_t file) {
        cspm::QualifiedNames result{common_, of_model_.first, of_model_.inside, of_model_.last, modules_};
        const UserNames& own = own_[file];
        result.modules.insert(own.modules.begin(), own.modules.end());
        for (const std::string& name : own.all) {
            if (given_.contains(name)) continue;
            result.plain.erase(name);
            if (hides_generated(name) || values_.contains(name) || files_that_declare_[name] > 1)
                result.plain[name] = names_.unique_name(name);
        }
        return result;
    }

private:
    /// Chooses names that are the same in all files: for the model's elements, and for the declarations of the
    /// instantiations.
    void choose_common() {
        for (const auto& [before, after] : of_model_.data)
            if (defines_element(given_, before) || !is_reserved(before)) common_.emplace(before, after);
        for (const std::string& name : given_)
            if (!common_.contains(name) && (hides_generated(name) || values_.contains(name)))
                common_[name] = names_.unique_name(name);
    }

    const NamesForBlocks& of_model_;
    NameManager& names_;
    std::vector<UserNames> own_;             ///< names declared in each file, except in its instantiations
    std::set<std::string> given_, modules_;  ///< names declared in the instantiations
    std::set<std::string> values_;           ///< values of the generated modules that are also a block's channels or
                                             ///< constructors
    std::map<std::string, int> files_that_declare_;
    cspm::NewNames common_;
};

/// Finds names of CSPM or the library that a surrounding declaration hides.
class Capture {
public:
    std::set<std::string> found;

    /// Visits the declarations at the top of the script. They cannot have predefined names, and they include the names
    /// of the library.
    void visit_top(const std::vector<DeclPtr>& decls) {
        for (const DeclPtr& decl : decls) {
            for (const std::string& name : names_of(*decl))
                if (is_predefined(name)) found.insert(name);
            visit_declaration(*decl);
        }
    }

private:
    static std::vector<std::string> names_of(const cspm::Decl& decl) {
        if (decl.kind == DeclKind::transparent || decl.kind == DeclKind::external || decl.kind == DeclKind::timed ||
            decl.kind == DeclKind::annotation || decl.kind == DeclKind::include)
            return {};
        return cspm::declared_names(decl);
    }
    static void names_of(const cspm::PatternPtr& pattern, std::vector<std::string>& names) {
        if (!pattern) return;
        if (pattern->kind == cspm::PatternKind::name) names.push_back(pattern->text);
        for (const auto& part : pattern->args) names_of(part, names);
    }

    /// True if CSPM predefines the name as a value, which is used without a call.
    static bool is_value(const std::string& name) {
        const cspm::BuiltinName* builtin = cspm::find_builtin(name);
        return builtin != nullptr && builtin->arguments < 0;
    }

    /// Adds names to the scope. The destructor removes them.
    class Around {
    public:
        explicit Around(std::multiset<std::string>& names) : names_(names) {}
        ~Around() {
            for (const std::string& name : added_) names_.erase(names_.find(name));
        }
        Around(const Around&) = delete;
        Around& operator=(const Around&) = delete;
        void add_names(const std::string& name) {
            if (!hides_generated(name)) return;
            names_.insert(name);
            added_.push_back(name);
        }
        void add_names(const std::vector<std::string>& names) {
            for (const std::string& name : names) add_names(name);
        }
        void add_names(const cspm::PatternPtr& pattern) {
            std::vector<std::string> names;
            names_of(pattern, names);
            add_names(names);
        }

    private:
        std::multiset<std::string>& names_;
        std::vector<std::string> added_;
    };

    void visit_declaration(const cspm::Decl& decl) {
        Around around(around_);
        around.add_names(decl.parameters);
        for (const auto* parts : {&decl.decls, &decl.exports})
            for (const DeclPtr& part : *parts)
                if (decl.kind == DeclKind::module) around.add_names(names_of(*part));
        for (const auto& group : decl.patterns)
            for (const auto& pattern : group) around.add_names(pattern);
        for (const auto* parts : {&decl.decls, &decl.exports})
            for (const DeclPtr& part : *parts) this->visit_declaration(*part);
        visit_expression(decl.body);
        for (const cspm::Constructor& constructor : decl.constructors) visit_expression(constructor.fields);
        for (const cspm::ExprPtr& argument : decl.arguments) visit_expression(argument);
    }

    void visit_expression(const cspm::ExprPtr& expr) {
        if (!expr) return;
        Around around(around_);
        for (const cspm::Field& field : expr->fields) around.add_names(field.pattern);
        for (const cspm::Clause& clause : expr->clauses) around.add_names(clause.pattern);
        for (const cspm::PatternPtr& pattern : expr->patterns) around.add_names(pattern);
        for (const DeclPtr& decl : expr->decls) around.add_names(names_of(*decl));
        if (expr->kind == cspm::ExprKind::apply && expr->args.front()->kind == cspm::ExprKind::name &&
            around_.contains(expr->args.front()->text))
            found.insert(expr->args.front()->text);
        if (expr->kind == cspm::ExprKind::name && around_.contains(expr->text) && is_value(expr->text))
            found.insert(expr->text);
        for (const cspm::ExprPtr& argument : expr->args) this->visit_expression(argument);
        for (const cspm::Field& field : expr->fields) this->visit_expression(field.value);
        for (const cspm::Clause& clause : expr->clauses) this->visit_expression(clause.value);
        for (const cspm::Link& link : expr->links) {
            this->visit_expression(link.from);
            this->visit_expression(link.to);
        }
        for (const DeclPtr& decl : expr->decls) visit_declaration(*decl);
    }

    std::multiset<std::string> around_;  ///< predefined and library names that surrounding declarations or bindings
                                         ///< hide
};

}  // namespace

std::vector<cspm::QualifiedNames> new_names_of_theirs(const std::vector<FileBlocks>& files,
                                                      const NamesForBlocks& of_model,
                                                      const std::vector<DeclPtr>& generated, NameManager& names) {
    Theirs theirs(files, of_model, generated, names);
    std::vector<cspm::QualifiedNames> result;
    for (std::size_t i = 0; i < files.size(); ++i) result.push_back(theirs.of_file(i));
    return result;
}

std::set<std::string> given_names(const std::vector<FileBlocks>& files, const NamesForBlocks& of_model) {
    std::set<std::string> given;
    for (const FileBlocks& file : files) given.merge(user_names(file.instantiations).all);
    std::set<std::string> result = given;
    for (const auto& [before, after] : of_model.data)
        if (defines_element(given, before)) result.insert(after);
    return result;
}

std::set<std::string> captured_names(const std::vector<DeclPtr>& generated) {
    Capture capture;
    capture.visit_top(generated);
    return std::move(capture.found);
}

}  // namespace robochart::csp_emit
