// SPDX-License-Identifier: Apache-2.0
// See sequence_limits.hpp.
#include "semantics/instantiate/sequence_limits.hpp"

#include <algorithm>
#include <optional>

#include "semantics/ir/arithmetic.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::ir {
namespace {

struct Window {
    std::int64_t first, last;
};

class Limits {
public:
    Limits(const System& system, const Instantiation& instantiation)
        : system_(system), longest_(instantiation.sequence_bound) {}

    void look_at(const Expr& expr) {
        std::optional<Window> places;
        if (expr.kind == ExprKind::toolkit && expr.text == "sequence_toolkit_extract")
            places = positions_in(*expr.args.at(0));
        if (expr.kind == ExprKind::index && is_sequence(*expr.args.at(0))) places = positions_in(*expr.args.at(1));
        if (places && places->last > longest_)
            found_.push_back({SequenceLimit::Kind::window, expr.span, places->first, places->last});
        if (!is_comparison(expr.kind) || expr.args.size() != 2) return;
        for (const std::size_t side : {0U, 1U})
            if (is_length(*expr.args[side]) && expr.args[1 - side]->kind == ExprKind::integer)
                read_comparison(expr, expr.args[1 - side]->number, side == 0);
    }
    [[nodiscard]] std::vector<SequenceLimit> take_limits() { return std::move(found_); }

private:
    [[nodiscard]] bool is_sequence(const Expr& expr) const {
        if (expr.kind == ExprKind::cast) return is_sequence(*expr.args.at(0));
        return expr.type.is_valid() && system_.type(expr.type).kind == TypeKind::sequence;
    }
    [[nodiscard]] bool is_length(const Expr& expr) const {
        if (expr.kind == ExprKind::cast) return is_length(*expr.args.at(0));
        return expr.kind == ExprKind::toolkit && expr.text == "sequence_toolkit_size" && is_sequence(*expr.args.at(0));
    }
    /// Returns the positions that a number, a set of numbers or a range refers to.
    [[nodiscard]] static std::optional<Window> positions_in(const Expr& expr) {
        if (expr.kind == ExprKind::integer) return Window{expr.number, expr.number};
        const bool listed =
            expr.kind == ExprKind::set || expr.kind == ExprKind::set_range || expr.kind == ExprKind::range;
        if (!listed || expr.args.empty()) return std::nullopt;
        std::optional<Window> result;
        for (const ExprPtr& arg : expr.args) {
            const auto part = arg ? positions_in(*arg) : std::nullopt;
            if (!part) return std::nullopt;
            result = result ? Window{std::min(result->first, part->first), std::max(result->last, part->last)} : part;
        }
        return result;
    }
    /// Records how long sequences must be so that this comparison with a length is true for some lengths and false for
    /// others. Lengths are at least 0 and at most that of the longest sequence.
    void read_comparison(const Expr& expr, std::int64_t number, bool length_first) {
        const bool above = expr.kind == (length_first ? ExprKind::greater : ExprKind::less) ||
                           expr.kind == (length_first ? ExprKind::less_equal : ExprKind::greater_equal);
        const std::int64_t needed = above ? number_after(number) : number;
        if (needed > longest_) found_.push_back({SequenceLimit::Kind::length, expr.span, 0, needed});
    }

    const System& system_;
    std::int64_t longest_;
    std::vector<SequenceLimit> found_;
};

}  // namespace

std::vector<SequenceLimit> sequence_limits(const System& system, const Instantiation& instantiation) {
    Limits limits(system, instantiation);
    visit_expressions(system, [&](const Expr& root, ExprRole) {
        visit_operands(root, [&](const Expr& expr) { limits.look_at(expr); });
    });
    return limits.take_limits();
}

}  // namespace robochart::ir
