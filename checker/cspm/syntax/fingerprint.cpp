// SPDX-License-Identifier: Apache-2.0
// Hashes the parts of a tree in the order in which syntax.cpp compares them. Ignores comments, spans and parentheses.
#include "checker/cspm/syntax/fingerprint.hpp"

#include <string_view>

#include "base/diagnostics/splitmix64.hpp"

namespace robochart::cspm {
namespace {

std::uint64_t mix_word(std::uint64_t sum, std::uint64_t word) {
    return diagnostics::splitmix64_mixed(sum + diagnostics::splitmix64_step + word);
}

}  // namespace

class Fingerprints::Digest {
public:
    explicit Digest(Fingerprints& known) : known_(known) {}

    [[nodiscard]] Fingerprint result() const { return result_; }

    void add_decls(const std::vector<DeclPtr>& list) {
        add_word(list.size());
        for (const DeclPtr& decl : list) add_decl(decl);
    }

private:
    void add_word(std::uint64_t value) { result_.hash = mix_word(result_.hash, value); }
    void add_text(std::string_view value) {
        add_word(value.size());
        // FNV-1a instead of std::hash, whose results depend on the library.
        std::uint64_t hash = 0xcbf29ce484222325U;
        for (const char character : value) hash = (hash ^ static_cast<unsigned char>(character)) * 0x100000001b3U;
        add_word(hash);
        result_.size += value.size();
    }
    void add_texts(const std::vector<std::string>& list) {
        add_word(list.size());
        for (const std::string& text : list) add_text(text);
    }

    void add_patterns(const std::vector<PatternPtr>& list) {
        add_word(list.size());
        for (const PatternPtr& pattern : list) add_pattern(pattern);
    }
    void add_pattern(const PatternPtr& pattern) {
        if (!pattern) return add_word(0);
        add_word(1 + static_cast<std::uint64_t>(pattern->kind));
        add_word(static_cast<std::uint64_t>(pattern->number));
        add_text(pattern->text);
        add_patterns(pattern->args);
        ++result_.size;
    }

    void add_exprs(const std::vector<ExprPtr>& list) {
        add_word(list.size());
        for (const ExprPtr& expr : list) add_expr(expr);
    }
    void add_expr(const ExprPtr& outer) {
        const Expr* expr = outer.get();
        while (expr != nullptr && expr->kind == ExprKind::parenthesised) expr = expr->args.at(0).get();
        if (expr == nullptr) return add_word(0);
        add_word(1 + static_cast<std::uint64_t>(expr->kind));
        add_word(static_cast<std::uint64_t>(expr->number));
        add_text(expr->text);
        add_exprs(expr->args);
        for (const Field& field : expr->fields) this->add_field(field);
        for (const Clause& clause : expr->clauses) {
            add_pattern(clause.pattern);
            this->add_expr(clause.value);
        }
        for (const Link& link : expr->links) {
            this->add_expr(link.from);
            this->add_expr(link.to);
        }
        add_patterns(expr->patterns);
        add_decls(expr->decls);
        result_.size += 2;
    }
    void add_field(const Field& field) {
        // The same conversion as in syntax.cpp.
        const FieldKind kind = field.kind == FieldKind::dot ? FieldKind::output : field.kind;
        add_word(static_cast<std::uint64_t>(kind));
        add_expr(field.value);
        add_pattern(field.pattern);
    }

    void add_decl(const DeclPtr& pointer) {
        const Decl& decl = *pointer;
        add_word(static_cast<std::uint64_t>(decl.kind));
        add_texts(decl.names);
        add_word(decl.patterns.size());
        for (const auto& group : decl.patterns) add_patterns(group);
        add_expr(decl.body);
        add_word(decl.constructors.size());
        for (const Constructor& constructor : decl.constructors) {
            add_text(constructor.name);
            add_expr(constructor.fields);
        }
        add_texts(decl.parameters);
        add_decls(decl.decls);
        const Fingerprint inside = known_.of_exports(pointer);
        add_word(inside.hash);
        result_.size += inside.size + 3;
        add_exprs(decl.arguments);
        add_text(decl.text);
        add_assertion(decl.assertion);
    }
    void add_assertion(const Assertion& assertion) {
        add_word(static_cast<std::uint64_t>(assertion.kind));
        add_word(static_cast<std::uint64_t>(assertion.model));
        add_word((assertion.negated ? 1U : 0U) + (assertion.partial_order ? 2U : 0U));
        add_expr(assertion.specification);
        add_expr(assertion.implementation);
        add_expr(assertion.tau_priority);
    }

    Fingerprints& known_;
    Fingerprint result_;
};

Fingerprint Fingerprints::of_exports(const DeclPtr& module) {
    if (module->exports.empty()) return {};
    if (const auto found = exports_.find(module); found != exports_.end()) return found->second;
    Digest digest(*this);
    digest.add_decls(module->exports);
    return exports_[module] = digest.result();
}

}  // namespace robochart::cspm
