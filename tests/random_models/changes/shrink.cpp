// SPDX-License-Identifier: Apache-2.0
#include "tests/random_models/changes/shrink.hpp"

#include <algorithm>

#include "frontend/syntax/expression_visitor.hpp"

namespace robochart::random_models {

using namespace frontend;

namespace {

/// Collects the cuts of one file.
class Cutter {
public:
    Cutter(std::size_t file, std::string_view text, std::vector<Cut>& out) : file_(file), text_(text), out_(out) {}

    void file(const File& file) {
        add(0, text_.size(), "");
        for (const auto& declared : file.declarations) declaration(*declared);
        for (const Import& import : file.imports) lines(import.span);
        for (const Assertion& assertion : file.assertions) lines(assertion.span);
        for (const CspBlock& block : file.csp_blocks) lines(block.span);
        comments();
    }

private:
    void add(std::size_t begin, std::size_t end, std::string replacement) {
        if (end - begin > replacement.size()) out_.push_back({file_, begin, end, std::move(replacement)});
    }
    void comments() {
        for (std::size_t at = text_.find('/'); at != std::string_view::npos; at = text_.find('/', at + 1)) {
            const std::string_view rest = text_.substr(at);
            const bool block = rest.starts_with("/*");
            if (!block && !rest.starts_with("//")) continue;
            const std::size_t last = text_.find(block ? "*/" : "\n", at + 2);
            const std::size_t end = std::min(text_.size(), last + (block && last != std::string_view::npos ? 2 : 0));
            add(at, end, "");
            at = end;
        }
    }
    void whole(diagnostics::Span span) {
        if (span.is_known()) add(span.begin, span.end, "");
    }
    /// Cuts the lines of a span, for members whose span does not include their keyword.
    void lines(diagnostics::Span span) {
        if (!span.is_known()) return;
        const std::size_t before = text_.substr(0, span.begin).rfind('\n');
        const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
        add(begin, std::min(text_.size(), text_.find('\n', span.end)), "");
    }
    void lines(const ExprPtr& expr) {
        if (!expr) return;
        lines(expr->span);
        expression(*expr);
    }

    void expression(const Expr& expr) {
        walk_tree(expr, [&](const Expr& part) {
            for_children(part, [&](const Expr& child) { replace(part.span, child.span); });
        });
    }
    void replace(diagnostics::Span whole, diagnostics::Span part) {
        add(whole.begin, whole.end, std::string(text_.substr(part.begin, part.end - part.begin)));
    }
    void statement(const Stmt& statement) {
        walk_tree(statement, [&](const Stmt& part) {
            if (part.kind != StmtKind::skip) add(part.span.begin, part.span.end, "skip");
            for (const StmtPtr& inner : part.body) replace(part.span, inner->span);
            for_expressions(part, [&](const Expr& expr) { expression(expr); });
        });
    }

    void context(const Context& context) {
        for (const InterfaceClause& clause : context.interfaces) lines(clause.name.span);
        for (const VariablePtr& variable : context.variables) {
            lines(variable->span);
            if (variable->initial) expression(*variable->initial);
        }
        for (const auto& event : context.events) whole(event->span);
        for (const auto& clock : context.clocks) whole(clock->span);
        for (const auto& signature : context.signatures) whole(signature->span);
    }

    /// Cuts a node with its transitions, because the transitions of a junction cannot be removed one by one (J1, J2).
    void with_transitions(const State& node, const NodeContainer& container) {
        std::vector<diagnostics::Span> parts = {node.span};
        for (const auto& transition : container.transitions)
            if (transition->from.text() == node.name || transition->to.text() == node.name)
                parts.push_back(transition->span);
        std::ranges::sort(parts, [](const auto& a, const auto& b) { return a.begin < b.begin; });
        std::string gaps;
        for (std::size_t i = 1; i < parts.size(); ++i) {
            const std::string_view gap = text_.substr(parts[i - 1].end, parts[i].begin - parts[i - 1].end);
            gaps += gap.substr(0, gap.find_last_not_of(" \n") + 1);
        }
        add(parts.front().begin, parts.back().end, std::move(gaps));
    }

    void nodes(const NodeContainer& container) {
        for (const auto& node : container.nodes) {
            with_transitions(*node, container);
            for (const Action& action : node->actions) {
                whole(action.span);
                if (action.statement) statement(*action.statement);
            }
            nodes(*node);
        }
        for (const auto& transition : container.transitions) this->transition(*transition);
    }

    void transition(const Transition& transition) {
        whole(transition.span);
        if (transition.trigger) lines(transition.trigger->span);
        for (const Transition::Reset& reset : transition.resets) lines(reset.name.span);
        for (const ExprPtr* expr : {&transition.probability, &transition.deadline, &transition.condition}) lines(*expr);
        if (!transition.action) return;
        lines(transition.action->span);
        statement(*transition.action);
    }

    void declaration(const Declaration& declared) {
        whole(declared.span);
        if (const auto* type = dynamic_cast<const TypeDeclaration*>(&declared)) {
            for (const VariablePtr& field : type->fields) whole(field->span);
            for (const auto& literal : type->literals) whole(literal->span);
        }
        if (const auto* function = dynamic_cast<const Function*>(&declared))
            for (const auto* list : {&function->preconditions, &function->postconditions})
                for (const ExprPtr& condition : *list) lines(condition);
        if (const auto* plain = dynamic_cast<const Context*>(&declared)) context(*plain);
        if (const auto* machine = dynamic_cast<const Machine*>(&declared)) {
            for (const auto* list : {&machine->preconditions, &machine->postconditions})
                for (const ExprPtr& condition : *list) lines(condition);
            nodes(*machine);
        }
        if (const auto* component = dynamic_cast<const Component*>(&declared)) {
            for (const Declaration* part : component->order) declaration(*part);
            for (const auto& connection : component->connections) whole(connection->span);
        }
    }

    std::size_t file_;
    std::string_view text_;
    std::vector<Cut>& out_;
};

/// Removes the line at a position if it is blank.
void drop_blank_line(std::string& text, std::size_t at) {
    const std::size_t before = text.substr(0, at).find_last_not_of(' ');
    const std::size_t behind = text.find_first_not_of(' ', at);
    const bool begins = before == std::string::npos || text[before] == '\n';
    if (!begins || behind == std::string::npos || text[behind] != '\n') return;
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    text.erase(begin, behind + 1 - begin);
}

std::size_t size_of(const Cut& cut) {
    return cut.end - cut.begin - cut.replacement.size();
}

}  // namespace

std::vector<Cut> find_cuts(const Project& project) {
    const auto read = parse(project);
    std::vector<Cut> result;
    for (std::size_t i = 0; i < project.size(); ++i) Cutter(i, project[i].text, result).file(*read->model.files[i]);
    std::ranges::stable_sort(result, [](const Cut& a, const Cut& b) { return size_of(a) > size_of(b); });
    return result;
}

Project apply_cut(const Project& project, const Cut& cut) {
    Project result = project;
    std::string& text = result[cut.file].text;
    text.replace(cut.begin, cut.end - cut.begin, cut.replacement);
    drop_blank_line(text, std::min(cut.begin, text.size()));
    if (text.find_first_not_of(" \n") == std::string::npos)
        result.erase(result.begin() + static_cast<std::ptrdiff_t>(cut.file));
    return result;
}

/// Continues the search at the same position after each cut, because earlier cuts that failed rarely succeed now.
Project shrink(Project failing, const std::function<bool(const Project&)>& fails, std::size_t budget) {
    std::size_t skipped = 0;
    bool progress = true;
    while (progress) {
        progress = false;
        std::vector<Cut> possible = find_cuts(failing);
        for (std::size_t i = skipped; i < possible.size() && budget > 0; ++i) {
            Project variant = apply_cut(failing, possible[i]);
            --budget;
            if (!fails(variant)) continue;
            failing = std::move(variant);
            skipped = i;
            progress = true;
            break;
        }
        if (!progress && skipped > 0 && budget > 0) {
            skipped = 0;
            progress = true;
        }
    }
    return failing;
}

}  // namespace robochart::random_models
