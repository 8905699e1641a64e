// SPDX-License-Identifier: Apache-2.0
// Shows hints about facts that a text omits: the types of variables that are declared without a type, and the values of
// constants whose initial expressions use only whole-number arithmetic.
#include <charconv>
#include <map>
#include <optional>

#include "editors/server/features/models.hpp"
#include "frontend/syntax/file_visitor.hpp"
#include "frontend/types/types.hpp"

namespace robochart::lsp {

namespace {

using namespace frontend;
using Whole = std::optional<std::int64_t>;

/// The values of constants as given in the model; an assertion may give other values.
class ConstantValues {
public:
    Whole value_of(const Expr& expr) {
        switch (expr.kind) {
            case ExprKind::integer:
                return read_literal(expr.text);
            case ExprKind::parenthesised:
                return value_of(*expr.args[0]);
            case ExprKind::name:
                return of_name(expr.target);
            case ExprKind::unary:
                return expr.unary == UnaryOp::negate ? combine_values(BinaryOp::minus, 0, value_of(*expr.args[0]))
                                                     : std::nullopt;
            case ExprKind::binary:
                return combine_values(*expr.binary, value_of(*expr.args[0]), value_of(*expr.args[1]));
            default:
                return std::nullopt;
        }
    }

private:
    static constexpr int max_depth = 16;

    static Whole read_literal(std::string_view text) {
        std::int64_t value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        return error == std::errc() && end == text.data() + text.size() ? Whole(value) : std::nullopt;
    }

    /// Combines two values. Does not compute division and remainder, because the finite instantiation clips and rounds
    /// them.
    static Whole combine_values(BinaryOp op, Whole left, Whole right) {
        std::int64_t value = 0;
        if (!left || !right) return std::nullopt;
        bool overflow = true;
        if (op == BinaryOp::plus) overflow = __builtin_add_overflow(*left, *right, &value);
        if (op == BinaryOp::minus) overflow = __builtin_sub_overflow(*left, *right, &value);
        if (op == BinaryOp::times) overflow = __builtin_mul_overflow(*left, *right, &value);
        return overflow ? std::nullopt : Whole(value);
    }

    /// Returns the value of a constant; no value if it is defined by itself, or through too many other constants.
    Whole of_name(const Declaration* target) {
        const auto* constant = dynamic_cast<const Variable*>(target);
        if (constant == nullptr || constant->kind != DeclKind::constant || !constant->initial) return std::nullopt;
        const auto known = values_.find(constant);
        if (known != values_.end()) return known->second;
        if (depth_ == max_depth) return std::nullopt;
        values_[constant] = std::nullopt;
        ++depth_;
        const Whole value = value_of(*constant->initial);
        --depth_;
        return values_[constant] = value;
    }

    std::map<const Variable*, Whole> values_;  ///< for lookup only; the order of pointers is never used
    int depth_ = 0;
};

class Hints {
public:
    Hints(const SourceManager& sources, Encoding encoding, Span range)
        : positions_(sources, range.source, encoding), wanted_(range) {}

    void visit(const Variable& variable) {
        type_of(variable);
        value_of(variable);
    }
    /// Other nodes have no hints.
    template <class Node>
    void visit(const Node&) {}

    [[nodiscard]] Json take_hints() { return std::move(result_); }

private:
    void type_of(const Variable& variable) {
        if (variable.type_expr || !variable.type) return;
        const std::string type = to_string(variable.type);
        const bool certain = type.find('?') == std::string::npos && type != "unknown";
        constexpr std::size_t longest = 60;
        constexpr int type_kind = 1;
        if (certain && type.size() <= longest) add(variable.name_span.end, ": " + type, type_kind);
    }
    void value_of(const Variable& variable) {
        if (variable.kind != DeclKind::constant || !variable.initial || !variable.type) return;
        const ExprKind form = variable.initial->kind;
        const TypeForm type = variable.type->form;
        if (form == ExprKind::integer || (type != TypeForm::nat && type != TypeForm::integer)) return;
        const Whole value = values_.value_of(*variable.initial);
        const bool is_literal = form == ExprKind::unary && variable.initial->args[0]->kind == ExprKind::integer;
        if (!value || is_literal || (type == TypeForm::nat && *value < 0)) return;
        add(variable.initial->span.end, "= " + std::to_string(*value), {});
    }
    void add(std::uint32_t offset, std::string label, std::optional<int> kind) {
        if (offset < wanted_.begin || wanted_.end < offset) return;
        Json hint = Json::object(
            {{"position", positions_.lsp_position(offset)}, {"label", std::move(label)}, {"paddingLeft", true}});
        if (kind) hint["kind"] = *kind;
        result_.push_back(std::move(hint));
    }

    PositionTable positions_;
    Span wanted_;
    ConstantValues values_;
    Json result_ = Json::array();
};

}  // namespace

Json Models::inlay_hints(const Request& request) {
    const Target target = target_of(request);
    const SourceManager& sources = target.project.sources();
    const Span range = span_of(sources, target.document.source, request.params["range"], session_.client.encoding);
    Hints hints(sources, session_.client.encoding, range);
    Traversal(hints).visit_file(target.project.tree_of(target.document));
    return hints.take_hints();
}

}  // namespace robochart::lsp
