// SPDX-License-Identifier: Apache-2.0
// Completes text with the names and keywords that are allowed at a place.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "editors/server/features/completion_context.hpp"
#include "editors/server/features/completion_words.hpp"
#include "editors/server/features/csp_blocks.hpp"
#include "editors/server/features/models.hpp"
#include "editors/server/workspace/describe.hpp"
#include "editors/server/workspace/visible.hpp"
#include "frontend/types/types.hpp"

namespace robochart::lsp {

namespace {

using namespace frontend;

/// How near a name is declared; the list is sorted by this rank.
enum class Rank { scope = 1, project = 2, word = 3, snippet = 4 };

bool is_node(DeclKind kind) {
    return kind == DeclKind::state || kind == DeclKind::initial || kind == DeclKind::final ||
           kind == DeclKind::junction || kind == DeclKind::probabilistic;
}
bool is_value(DeclKind kind) {
    return kind == DeclKind::variable || kind == DeclKind::constant || kind == DeclKind::parameter;
}
bool is_type(DeclKind kind) {
    return kind == DeclKind::primitive_type || kind == DeclKind::record_type || kind == DeclKind::enumeration;
}
bool is_component(DeclKind kind) {
    return kind == DeclKind::module || kind == DeclKind::controller || kind == DeclKind::state_machine ||
           kind == DeclKind::operation || kind == DeclKind::platform || kind == DeclKind::reference;
}

class Completer {
public:
    Completer(const Session& session, const Target& target)
        : session_(session),
          model_(target.project.current_model()),
          file_(target.project.tree_of(target.document)),
          robosim_(file_.dialect == frontend::Dialect::robosim),
          sources_(target.project.sources()),
          source_(target.document.source),
          context_(context_at(sources_, target.document.source, target.document.is_assertions, target.offset)) {
        edit_range_ = lsp_range(sources_, context_.prefix, session.client.encoding);
        for (const Enclosing& enclosing : context_.enclosing) {
            const Declaration* found = declared_at(file_, enclosing.name);
            if (found == nullptr) continue;
            if (dynamic_cast<const NodeContainer*>(found) != nullptr && enclosing.block != Block::transition)
                container_ = found;
            const bool scope =
                dynamic_cast<const frontend::Context*>(found) != nullptr || found->kind == DeclKind::function;
            if (scope) scope_ = found;
        }
    }

    Json run() {
        if (!context_.qualifier.empty())
            add_qualified();
        else if (!context_.value.empty())
            add_fields();
        else
            add_unqualified();
        return Json::object({{"isIncomplete", false}, {"items", std::move(items_)}});
    }

private:
    // Items

    void add(const std::string& label, int kind, Rank rank, const std::string& about, const std::string& text,
             bool snippet = false) {
        if (!seen_.insert(label).second) return;
        Json item = Json::object({{"label", label},
                                  {"kind", kind},
                                  {"sortText", fmt::format("{}{}", static_cast<int>(rank), label)},
                                  {"textEdit", Json::object({{"range", edit_range_}, {"newText", text}})}});
        if (!about.empty()) item["detail"] = about;
        if (snippet) item["insertTextFormat"] = 2;
        items_.push_back(std::move(item));
    }
    void add(const Declaration& declaration, Rank rank) {
        if (declaration.name.empty()) return;
        const std::string text = is_reserved(declaration.name) ? "^" + declaration.name : declaration.name;
        add(declaration.name, completion_kind(declaration), rank, detail_of(declaration), text);
    }
    void add_words(const std::vector<std::string_view>& list) {
        constexpr int keyword = 14;
        for (const std::string_view word : list) add(std::string(word), keyword, Rank::word, "", std::string(word));
    }
    void add_package(const std::string& name) {
        constexpr int module_kind = 9;
        add(name, module_kind, Rank::project, "package", name);
    }

    template <class Filter>
    void from_scope(const Filter& filter) {
        if (scope_ == nullptr) return;
        if (const auto* function = dynamic_cast<const Function*>(scope_))
            for (const auto& parameter : function->parameters)
                if (filter(parameter->kind)) add(*parameter, Rank::scope);
        for (const Declaration* member : members_of(*scope_))
            if (filter(member->kind)) add(*member, Rank::scope);
    }
    template <class Filter>
    void from_project(const Filter& filter) {
        for (const Declaration* declaration : visible_from(model_, file_))
            if (filter(declaration->kind)) add(*declaration, Rank::project);
    }
    /// Adds the components inside the controllers and modules that contain the place.
    template <class Filter>
    void from_parts(const Filter& filter) {
        for (const Enclosing& enclosing : context_.enclosing)
            if (const auto* component = dynamic_cast<const Component*>(declared_at(file_, enclosing.name)))
                for (const Declaration* part : component->order)
                    if (filter(part->kind)) add(*part, Rank::scope);
    }
    void add_packages() {
        for (const std::string& name : packages_behind(model_, {})) add_package(name);
    }

    // The expected construct

    void add_unqualified() {
        switch (context_.expected) {
            case Wanted::nothing:
                return;
            case Wanted::member:
                return add_member_words();
            case Wanted::continuation:
                add_words(infix_words(context_.enclosing.back().block, file_.is_assertions));
                return add_member_words();
            case Wanted::source:
                return add_nodes(DeclKind::final);
            case Wanted::target:
                return add_nodes(DeclKind::initial);
            case Wanted::event:
                return from_scope([](DeclKind kind) { return kind == DeclKind::event; });
            case Wanted::interface:
                from_project([](DeclKind kind) { return kind == DeclKind::interface; });
                return add_packages();
            case Wanted::type:
                from_project(is_type);
                add_words(type_words());
                return add_packages();
            case Wanted::reference:
                return add_reference_targets();
            case Wanted::clock:
                return from_scope([](DeclKind kind) { return kind == DeclKind::clock; });
            case Wanted::state:
                return add_states();
            case Wanted::variable:
                return from_scope([](DeclKind kind) { return kind == DeclKind::variable; });
            case Wanted::expression:
                return add_expression_names();
            case Wanted::statement:
                return add_statement_names();
            case Wanted::branch:
                add_statement_names();
                return add_expression_names();
            case Wanted::connection_node:
                return connection_nodes();
            case Wanted::connection_event:
                return connection_events();
            case Wanted::import:
                return add_imports();
            case Wanted::component:
                from_project(is_component);
                add_blocks();
                return add_packages();
            case Wanted::property:
                return add_words(property_words());
            case Wanted::rule:
                return add_rules();
        }
    }

    /// Adds the rules in the files of the assertion file's folder.
    void add_rules() {
        constexpr int function = 3;
        const std::string& path = sources_.path(source_);
        const std::string folder = path.substr(0, std::min(path.rfind('/'), path.size()));
        for (const auto& [rule, file] : session_.rule_names(folder)) add(rule, function, Rank::scope, file, rule);
    }

    void add_member_words() {
        const Block block = context_.enclosing.back().block;
        add_words(file_.is_assertions ? assertion_member_words() : member_words(block, context_.word));
        if (robosim_ && !file_.is_assertions) add_words(robosim_member_words(block));
        if (robosim_ && file_.is_assertions) add_words({"simulation"});
        if (!session_.client.snippets || file_.is_assertions) return;
        constexpr int snippet_kind = 15;
        for (const Snippet& snippet : snippets_for(block))
            add(std::string(snippet.label), snippet_kind, Rank::snippet, "snippet", std::string(snippet.text), true);
    }

    void add_nodes(DeclKind except) {
        const auto* container = dynamic_cast<const NodeContainer*>(container_);
        if (container == nullptr) return;
        for (const auto& node : container->nodes)
            if (node->kind != except) add(*node, Rank::scope);
    }

    /// Adds states at any depth, outer ones first.
    void add_states() {
        const auto* machine = dynamic_cast<const Machine*>(scope_);
        std::vector<const NodeContainer*> level;
        if (machine != nullptr) level.push_back(machine);
        for (std::size_t i = 0; i < level.size(); ++i)
            for (const auto& node : level[i]->nodes) {
                if (node->kind == DeclKind::state) add(*node, Rank::scope);
                level.push_back(node.get());
            }
    }

    /// Returns the kind of component to which a reference with the word before the cursor refers.
    [[nodiscard]] DeclKind referenced_kind() const {
        if (context_.word == "sref") return DeclKind::state_machine;
        if (context_.word == "cref") return DeclKind::controller;
        if (context_.word == "rref") return DeclKind::platform;
        return DeclKind::operation;
    }

    void add_reference_targets() {
        const DeclKind kind = referenced_kind();
        from_parts([&](DeclKind candidate) { return candidate == kind; });
        from_project([&](DeclKind candidate) { return candidate == kind; });
        add_packages();
    }

    void add_bound_names() {
        constexpr int variable = 6;
        for (const std::string& name : context_.bound) add(name, variable, Rank::scope, "", name);
    }

    void add_expression_names() {
        add_bound_names();
        from_scope(is_value);
        from_project([](DeclKind kind) {
            return kind == DeclKind::function || kind == DeclKind::enum_literal || kind == DeclKind::enumeration ||
                   kind == DeclKind::record_type;
        });
        add_words(expression_words());
        if (!robosim_) return;
        add_words({"cycle"});
        from_scope([](DeclKind kind) { return kind == DeclKind::event || kind == DeclKind::operation_signature; });
    }

    void add_statement_names() {
        from_scope([](DeclKind kind) {
            return kind == DeclKind::operation_signature || kind == DeclKind::event || kind == DeclKind::variable;
        });
        add_words(statement_words());
        if (robosim_) add_words({"exec"});
    }

    [[nodiscard]] const Component* enclosing_component() const {
        for (auto enclosing = context_.enclosing.rbegin(); enclosing != context_.enclosing.rend(); ++enclosing)
            if (const auto* found = dynamic_cast<const Component*>(declared_at(file_, enclosing->name))) return found;
        return nullptr;
    }

    void connection_nodes() {
        const Component* around = enclosing_component();
        if (around == nullptr) return;
        for (const Declaration* part : around->order) add(*part, Rank::scope);
        if (around->kind == DeclKind::controller) add(*around, Rank::scope);
    }

    void connection_events() {
        const Component* around = enclosing_component();
        if (around == nullptr || context_.path.empty()) return;
        const Declaration* node = around->name == context_.path.front() ? around : nullptr;
        for (const Declaration* part : around->order)
            if (part->name == context_.path.front()) node = part;
        if (node == nullptr) return;
        for (const Declaration* member : members_of(*node))
            if (member->kind == DeclKind::event) add(*member, Rank::scope);
    }

    void add_imports() {
        add_packages();
        for (const std::string_view name : toolkit_packages()) add_package(std::string(name));
    }

    void add_blocks() {
        constexpr int function = 3;
        for (const auto& file : model_.files)
            for (const CspBlock& block : file->csp_blocks) add(block.name, function, Rank::project, "csp", block.name);
    }

    /// Adds the names of suitable kinds after `A::B::`.
    void add_qualified() {
        const auto fits = [&](DeclKind kind) {
            switch (context_.expected) {
                case Wanted::interface:
                    return kind == DeclKind::interface;
                case Wanted::type:
                    return is_type(kind);
                case Wanted::expression:
                case Wanted::branch:
                case Wanted::statement:
                    return kind == DeclKind::enum_literal || kind == DeclKind::enumeration ||
                           kind == DeclKind::function || kind == DeclKind::record_type;
                case Wanted::state:
                    return is_node(kind);
                case Wanted::nothing:
                case Wanted::member:
                case Wanted::continuation:
                case Wanted::source:
                case Wanted::target:
                case Wanted::event:
                case Wanted::reference:
                case Wanted::clock:
                case Wanted::variable:
                case Wanted::connection_node:
                case Wanted::connection_event:
                case Wanted::import:
                case Wanted::component:
                case Wanted::property:
                case Wanted::rule:
                    break;
            }
            return kind != DeclKind::transition && kind != DeclKind::field;
        };
        for (const Declaration* declaration : declarations_after(model_, file_, context_.qualifier))
            if (fits(declaration->kind)) add(*declaration, Rank::scope);
        for (const std::string& name : packages_behind(model_, context_.qualifier)) add_package(name);
        if (context_.expected == Wanted::import) add("*", 14, Rank::word, "everything", "*");
    }

    /// Adds the fields after `a[1].f.`. After an event and `.`, a value is expected instead.
    void add_fields() {
        const auto first = [&](const Declaration* declaration) { return declaration->name == context_.value.front(); };
        if (scope_ == nullptr) return;
        const auto members = members_of(*scope_);
        const auto found = std::ranges::find_if(members, first);
        if (found == members.end()) return;
        if ((*found)->kind == DeclKind::event) return add_expression_names();
        const auto* variable = dynamic_cast<const Variable*>(*found);
        TypePtr type = variable != nullptr ? variable->type : nullptr;
        for (std::size_t i = 1; i < context_.value.size() && type; ++i) type = part_of(*type, context_.value[i]);
        if (!type || type->form != TypeForm::record) return;
        for (const auto& field : type->declaration->fields) add(*field, Rank::scope);
    }

    static TypePtr part_of(const Type& type, const std::string& step) {
        const bool indexed =
            type.form == TypeForm::sequence || type.form == TypeForm::vector || type.form == TypeForm::matrix;
        if (step.empty()) return indexed ? type.args[0] : nullptr;
        if (type.form != TypeForm::record) return nullptr;
        const auto* field = dynamic_cast<const Variable*>(member_of(*type.declaration, step));
        return field != nullptr ? field->type : nullptr;
    }

    const Session& session_;
    const Model& model_;
    const File& file_;
    const bool robosim_;
    const SourceManager& sources_;
    SourceId source_;
    CompletionContext context_;
    Json edit_range_;
    const Declaration* scope_ = nullptr;      ///< the component or function that contains the place
    const Declaration* container_ = nullptr;  ///< the innermost machine, operation or state that contains it
    Json items_ = Json::array();
    std::set<std::string> seen_;
};

}  // namespace

Json Models::completion(const Request& request) {
    const Target target = target_of(request);
    if (std::optional<Json> in_block = completion_in_block(session_, target)) return std::move(*in_block);
    return Completer(session_, target).run();
}

}  // namespace robochart::lsp
