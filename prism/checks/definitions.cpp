// SPDX-License-Identifier: Apache-2.0
// See definitions.hpp.
#include "prism/checks/definitions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "prism/checks/rules.hpp"

namespace robochart::prism {
namespace {

/// Sorts definitions by a depth-first search. The search does not recurse, because chains of definitions may be long.
class Order {
public:
    Order(const std::vector<Defined>& definitions, diagnostics::Diagnostics& diagnostics)
        : definitions_(definitions), diagnostics_(diagnostics), marks_(definitions.size(), Mark::fresh) {
        for (std::size_t i = 0; i < definitions.size(); ++i) index_.emplace(definitions[i].name.text, i);
    }

    std::vector<std::size_t> operator()() {
        for (std::size_t i = 0; i < definitions_.size(); ++i)
            if (marks_[i] == Mark::fresh) search(i);
        return std::move(order_);
    }

private:
    enum class Mark : std::uint8_t { fresh, open, done, cyclic };
    struct Frame {
        std::size_t definition;
        std::vector<std::size_t> uses;
        std::size_t next = 0;
    };

    std::vector<std::size_t> uses_of(std::size_t definition) const {
        std::vector<std::size_t> result;
        for_each_name(definitions_[definition].body, [&](const Expr& name) {
            const auto found = index_.find(name.text);
            if (found != index_.end()) result.push_back(found->second);
        });
        return result;
    }

    void open(std::size_t definition) {
        diagnostics_.poll();
        marks_[definition] = Mark::open;
        stack_.push_back({definition, uses_of(definition)});
    }

    void search(std::size_t first) {
        open(first);
        while (!stack_.empty()) {
            Frame& top = stack_.back();
            if (top.next < top.uses.size()) {
                const std::size_t use = top.uses[top.next++];
                if (marks_[use] == Mark::open) report(use);
                if (marks_[use] == Mark::fresh) open(use);
                continue;
            }
            if (marks_[top.definition] == Mark::open) {
                marks_[top.definition] = Mark::done;
                order_.push_back(top.definition);
            }
            stack_.pop_back();
        }
    }

    void report(std::size_t definition) {
        std::string path;
        std::size_t from = 0;
        while (stack_[from].definition != definition) ++from;
        constexpr std::size_t most = 10;
        for (std::size_t i = from; i < stack_.size(); ++i) {
            marks_[stack_[i].definition] = Mark::cyclic;
            if (i - from < most) path += definitions_[stack_[i].definition].name.text + " uses ";
            if (i - from == most) path += "... uses ";
        }
        const Name& name = definitions_[definition].name;
        diagnostics_.report(rules::defined_by_itself, name.span, {name.text, path + name.text});
    }

    const std::vector<Defined>& definitions_;
    diagnostics::Diagnostics& diagnostics_;
    std::map<std::string, std::size_t, std::less<>> index_;
    std::vector<Mark> marks_;
    std::vector<Frame> stack_;
    std::vector<std::size_t> order_;
};

}  // namespace

std::vector<std::size_t> definition_order(const std::vector<Defined>& definitions,
                                          diagnostics::Diagnostics& diagnostics) {
    return Order(definitions, diagnostics)();
}

bool is_manageable(const ExprPtr& expr, Span place, diagnostics::Diagnostics& diagnostics) {
    if (!expr || (expr->height <= max_height && expr->size <= max_size)) return true;
    const bool high = expr->height > max_height;
    diagnostics.report(rules::expands_too_far, place,
                       {high ? fmt::format("{} levels", max_height) : fmt::format("{} operations", max_size)});
    return false;
}

std::vector<Definition> expand_formulas(const std::vector<Definition>& formulas, Rewriter& rewriter,
                                        diagnostics::Diagnostics& diagnostics) {
    std::vector<Defined> definitions;
    for (const Definition& formula : formulas) definitions.push_back({formula.name, formula.body});
    std::vector<Definition> result = formulas;
    bool grown = false;
    for (const std::size_t i : definition_order(definitions, diagnostics)) {
        result[i].body = rewriter(formulas[i].body);
        // Only the first definition that is too large is reported. It is not expanded in other definitions.
        diagnostics::Diagnostics more;
        const bool good = is_manageable(result[i].body, formulas[i].name.span, grown ? more : diagnostics);
        grown = grown || !good;
        if (!good) result[i].body = make_expr(Op::boolean, formulas[i].name.span, {}, "false");
        rewriter.expressions.emplace(formulas[i].name.text, result[i].body);
    }
    return result;
}

}  // namespace robochart::prism
