// SPDX-License-Identifier: Apache-2.0
// The parts are hashed in the order in which syntax.cpp compares them, without comments, spans and parentheses.
#include "checker/cspm/syntax/fingerprint.hpp"

#include <string_view>

#include "base/diagnostics/splitmix64.hpp"

namespace robochart::cspm {
namespace {

std::uint64_t mixed(std::uint64_t sum, std::uint64_t word) {
    return diagnostics::splitmix64_mixed(sum + diagnostics::splitmix64_step + word);
}

}  // namespace

class Fingerprints::Digest {
public:
    explicit Digest(Fingerprints& known) : known_(known) {}

    [[nodiscard]] Fingerprint result() const { return result_; }

    void decls(const std::vector<DeclPtr>& list) {
        word(list.size());
        for (const DeclPtr& each : list) decl(each);
    }

private:
    void word(std::uint64_t value) { result_.hash = mixed(result_.hash, value); }
    void text(std::string_view value) {
        word(value.size());
        // FNV-1a, which does not depend on the library's std::hash.
        std::uint64_t hash = 0xcbf29ce484222325U;
        for (const char each : value) hash = (hash ^ static_cast<unsigned char>(each)) * 0x100000001b3U;
        word(hash);
        result_.size += value.size();
    }
    void texts(const std::vector<std::string>& list) {
        word(list.size());
        for (const std::string& each : list) text(each);
    }

    void patterns(const std::vector<PatternPtr>& list) {
        word(list.size());
        for (const PatternPtr& each : list) pattern(each);
    }
    void pattern(const PatternPtr& pattern) {
        if (!pattern) return word(0);
        word(1 + static_cast<std::uint64_t>(pattern->kind));
        word(static_cast<std::uint64_t>(pattern->number));
        text(pattern->text);
        patterns(pattern->args);
        ++result_.size;
    }

    void exprs(const std::vector<ExprPtr>& list) {
        word(list.size());
        for (const ExprPtr& each : list) expr(each);
    }
    void expr(const ExprPtr& outer) {
        const Expr* expr = outer.get();
        while (expr != nullptr && expr->kind == ExprKind::parenthesised) expr = expr->args.at(0).get();
        if (expr == nullptr) return word(0);
        word(1 + static_cast<std::uint64_t>(expr->kind));
        word(static_cast<std::uint64_t>(expr->number));
        text(expr->text);
        exprs(expr->args);
        for (const Field& field : expr->fields) this->field(field);
        for (const Clause& clause : expr->clauses) {
            pattern(clause.pattern);
            this->expr(clause.value);
        }
        for (const Link& link : expr->links) {
            this->expr(link.from);
            this->expr(link.to);
        }
        patterns(expr->patterns);
        decls(expr->decls);
        result_.size += 2;
    }
    void field(const Field& field) {
        const FieldKind kind = field.kind == FieldKind::dot ? FieldKind::output : field.kind;  // as in syntax.cpp
        word(static_cast<std::uint64_t>(kind));
        expr(field.value);
        pattern(field.pattern);
    }

    void decl(const DeclPtr& pointer) {
        const Decl& decl = *pointer;
        word(static_cast<std::uint64_t>(decl.kind));
        texts(decl.names);
        word(decl.patterns.size());
        for (const auto& group : decl.patterns) patterns(group);
        expr(decl.body);
        word(decl.constructors.size());
        for (const Constructor& each : decl.constructors) {
            text(each.name);
            expr(each.fields);
        }
        texts(decl.parameters);
        decls(decl.decls);
        const Fingerprint inside = known_.of_exports(pointer);
        word(inside.hash);
        result_.size += inside.size + 3;
        exprs(decl.arguments);
        text(decl.text);
        assertion(decl.assertion);
    }
    void assertion(const Assertion& assertion) {
        word(static_cast<std::uint64_t>(assertion.kind));
        word(static_cast<std::uint64_t>(assertion.model));
        word((assertion.negated ? 1U : 0U) + (assertion.partial_order ? 2U : 0U));
        expr(assertion.specification);
        expr(assertion.implementation);
        expr(assertion.tau_priority);
    }

    Fingerprints& known_;
    Fingerprint result_;
};

Fingerprint Fingerprints::of_exports(const DeclPtr& module) {
    if (module->exports.empty()) return {};
    if (const auto found = exports_.find(module); found != exports_.end()) return found->second;
    Digest digest(*this);
    digest.decls(module->exports);
    return exports_[module] = digest.result();
}

}  // namespace robochart::cspm
