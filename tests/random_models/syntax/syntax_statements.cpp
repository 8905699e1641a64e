// SPDX-License-Identifier: Apache-2.0
// Builds the statements of random syntax trees.
#include "tests/random_models/syntax/syntax_builder.hpp"

namespace robochart::random_models {

using namespace frontend;

namespace {

StmtPtr make(StmtKind kind) {
    auto statement = std::make_unique<Stmt>();
    statement->kind = kind;
    return statement;
}

}  // namespace

StmtPtr SyntaxBuilder::statement(std::size_t depth) {
    if (depth == 0 || !random_.chance(40)) return timed(depth);
    StmtPtr sequence = make(StmtKind::sequence);
    for (std::size_t i = random_.between(2, 3); i > 0; --i) sequence->body.push_back(timed(depth - 1));
    return sequence;
}

StmtPtr SyntaxBuilder::timed(std::size_t depth) {
    StmtPtr inner = basic(depth);
    if (!random_.chance(20)) return inner;
    StmtPtr deadline = make(StmtKind::deadline);
    deadline->body.push_back(std::move(inner));
    deadline->value = expression(depth);
    return deadline;
}

/// Returns a statement that contains other statements.
StmtPtr SyntaxBuilder::nested(StmtKind kind, std::size_t depth) {
    StmtPtr result = make(kind);
    result->body.push_back(statement(depth));
    if (kind == StmtKind::parenthesised) return result;
    result->condition = expression(depth);
    if (random_.chance(50)) result->body.push_back(statement(depth));
    return result;
}

StmtPtr SyntaxBuilder::basic(std::size_t depth) {
    const std::size_t way = random_.below(depth == 0 ? 8 : 11);
    const std::size_t inner = depth == 0 ? 0 : depth - 1;
    StmtPtr result;
    switch (way) {
        case 0:
            return make(StmtKind::skip);
        case 1:
            result = make(StmtKind::assignment);
            result->target = target(inner);
            result->value = expression(inner);
            return result;
        case 2:
        case 3:
            result = make(StmtKind::communication);
            result->send_keyword = random_.chance(30);
            result->communication = communication(inner, false);
            return result;
        case 4:
            result = make(StmtKind::call);
            result->name = qualified();
            add_list(result->args, 0, 2, inner);
            return result;
        case 5:
            result = make(StmtKind::wait);
            result->value = at(6, inner);
            // `wait([m, n])` would be parsed as a wait with an interval, which is a separate form.
            if (result->value->kind == ExprKind::range) result->value->lower_closed = false;
            return result;
        case 6:
            result = make(StmtKind::wait_interval);
            result->value = expression(inner);
            result->upper = expression(inner);
            return result;
        case 7:
            result = make(StmtKind::clock_reset);
            result->name = simple();
            return result;
        case 8:
            return nested(StmtKind::parenthesised, inner);
        default:
            return nested(StmtKind::if_then_else, inner);
    }
}

std::unique_ptr<Communication> SyntaxBuilder::communication(std::size_t depth, bool) {
    constexpr int call_level = 15;
    auto result = std::make_unique<Communication>();
    result->kind = static_cast<CommKind>(random_.below(4));
    result->event = simple();
    if (random_.chance(15)) result->from_variable = simple();
    if (random_.chance(15)) result->predicate = expression(depth);
    if (result->kind == CommKind::input) result->variable = qualified();
    if (result->kind == CommKind::output || result->kind == CommKind::sync) result->value = at(call_level, depth);
    return result;
}

}  // namespace robochart::random_models
