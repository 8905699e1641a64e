// Expressions of the model as C++ text over the Types policy.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cpp_emit/generation.hpp"

namespace robochart::cpp_emit {

/// The member behind ExprKind::member's number: a field's index, or a place counted from 1.
[[nodiscard]] std::string member_name(const ir::Type&, std::int64_t number);

class ExpressionWriter {
public:
    /// `frame` is how the code refers to the unit's own state: "f".
    ExpressionWriter(const Generation& generation, const Unit& unit, std::string frame)
        : generation_(generation), unit_(unit), frame_(std::move(frame)) {}

    /// What `trigger_value` means: the incoming value, as C++ text.
    void set_incoming(std::string text) { incoming_ = std::move(text); }

    [[nodiscard]] std::string write(const ir::Expr&) const;
    /// The same as an operand: in parentheses unless it binds tightest.
    [[nodiscard]] std::string operand(const ir::Expr&) const;
    /// The expression as a value of a numeric type other than its own; others unchanged.
    [[nodiscard]] std::string write_as(const ir::Expr&, ir::TypeId) const;
    /// Where a variable is stored; "" for shared variables that nothing reads.
    [[nodiscard]] std::string variable(ir::VariableId) const;
    [[nodiscard]] std::string clock(ir::ClockId) const;
    /// An item's place, counted from 1.
    [[nodiscard]] std::string place(const ir::Expr& index) const;

private:
    [[nodiscard]] std::string right(const ir::Expr&) const;  ///< without a seeded fault
    [[nodiscard]] std::string operand_as(const ir::Expr&, ir::TypeKind) const;
    [[nodiscard]] std::string arithmetic(const ir::Expr&, const char* symbol) const;
    [[nodiscard]] std::string function(const ir::Expr&, const char* name) const;
    [[nodiscard]] std::string comparison(const ir::Expr&, const char* symbol) const;
    [[nodiscard]] std::string logical(const ir::Expr&, const char* symbol) const;
    [[nodiscard]] std::string constant(const ir::Expr&) const;
    [[nodiscard]] std::string enum_literal(const ir::Expr&) const;
    [[nodiscard]] std::string list(const ir::Expr&, const std::vector<ir::TypeId>& types) const;
    [[nodiscard]] std::string built(const ir::Expr&, const char* maker) const;
    [[nodiscard]] std::string cast(const ir::Expr&) const;
    [[nodiscard]] std::string call(const ir::Expr&) const;
    [[nodiscard]] std::string let(const ir::Expr&) const;
    [[nodiscard]] ir::TypeKind kind(const ir::Expr&) const;
    [[nodiscard]] std::string type_text(ir::TypeId) const;
    [[nodiscard]] std::string index(const ir::Expr&) const;
    [[nodiscard]] std::string membership(const ir::Expr&) const;

    // expression_composed.cpp: what binds variables, functions as values, toolkits, vectors and matrices
    [[nodiscard]] std::string any(const ir::Expr&, std::size_t from, const std::string& visit) const;
    [[nodiscard]] std::string quantified(const ir::Expr&) const;
    [[nodiscard]] std::string collected(const ir::Expr&) const;
    [[nodiscard]] std::string collected_item(const ir::Expr&) const;
    [[nodiscard]] std::string bound_values(const ir::Expr&, ir::TypeId) const;
    [[nodiscard]] std::string apply(const ir::Expr&) const;
    [[nodiscard]] std::string lookup(const ir::Expr& function, const std::vector<std::string>& arguments,
                                     ir::TypeId domain) const;
    [[nodiscard]] std::string beta_reduced(const ir::Expr& lambda, const std::vector<std::string>& arguments) const;
    [[nodiscard]] std::string platform_call(ir::FunctionId, const std::string& arguments) const;
    [[nodiscard]] std::string function_value(const ir::Expr&) const;
    [[nodiscard]] std::string toolkit(const ir::Expr&) const;
    [[nodiscard]] std::string range(const ir::Expr&) const;
    [[nodiscard]] std::string is_type(const ir::Expr&) const;
    [[nodiscard]] bool block_arithmetic(const ir::Expr&) const;
    [[nodiscard]] std::string block_operand(const ir::Expr&, ir::TypeId entry) const;
    [[nodiscard]] std::string block_arithmetic_text(const ir::Expr&) const;

    const Generation& generation_;
    const Unit& unit_;
    std::string frame_;
    std::string incoming_;
};

}  // namespace robochart::cpp_emit
