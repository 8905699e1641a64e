// SPDX-License-Identifier: Apache-2.0
// Writes the bytes of process expressions without creating their terms. TermCodec would write the same bytes for these
// terms (eval/processes.cpp).
#include <algorithm>

#include "checker/cspm/packed/direct_steps.hpp"

namespace robochart::cspm {

using process::Op;
using process::TermId;

void DirectSteps::write_process(const Code& code, Frame& frame) {
    tables_.work.count_step(code.span);
    switch (code.kind) {
        case ExprKind::name:
            return write_name(code, frame);
        case ExprKind::apply:
            return write_apply(code, frame);
        case ExprKind::if_then_else:
            return write_process(*code.args[values_.eval_boolean(*code.args[0], frame) ? 1 : 2], frame);
        case ExprKind::let:
            values_.open_let(code, frame);
            return write_process(*code.args[0], frame);
        case ExprKind::prefix:
            return write_prefix(code, frame);
        case ExprKind::guard:
            if (values_.eval_boolean(*code.args[0], frame)) return write_process(*code.args[1], frame);
            return codec_.write(tables_.processes.make_stop(code.timed), out_->bytes);
        case ExprKind::external_choice:
            if (code.timed != nullptr) return write_made(code, frame);
            return write_choice(code, frame);
        case ExprKind::internal_choice:
            return write_choice(code, frame);
        case ExprKind::sequential:
            TermCodec::begin_operator(Op::sequential, out_->bytes);
            write_process(*code.args[0], frame);
            return write_process(*code.args[1], frame);
        default:
            return write_made(code, frame);
    }
}

/// Builds the term of the expression and encodes it.
void DirectSteps::write_made(const Code& code, Frame& frame) {
    codec_.write(tables_.process_evaluator.process(code, frame), out_->bytes);
}

void DirectSteps::write_value(Value made) {
    codec_.write(tables_.processes.term_of(made, {}), out_->bytes);
}

void DirectSteps::write_name(const Code& code, Frame& frame) {
    if (code.reference == Reference::member) {
        const auto& group = static_cast<const GroupObject&>(*frame[static_cast<std::size_t>(code.slot)]);
        const Member& member = group.group->members[static_cast<std::size_t>(code.index)];
        if (member.function.groups.empty() && member.component_of < 0) {
            const Value environment = values_.share_value(&group);
            TermCodec::begin_call(member.function, out_->bytes);
            return codec_.write(environment, out_->bytes);
        }
    }
    if (code.reference == Reference::global) {
        const Global& global = tables_.program.globals[static_cast<std::size_t>(code.slot)];
        if (global.kind == GlobalKind::function && global.function.groups.empty())
            return TermCodec::begin_call(global.function, out_->bytes);
    }
    write_value(values_.eval_name(code, frame));
}

void DirectSteps::write_apply(const Code& code, Frame& frame) {
    if (const Function* const function = global_with(*code.args[0], code.args.size() - 1))
        return write_global_call(*function, code, frame);
    write_made(code, frame);
}

void DirectSteps::write_global_call(const Function& function, const Code& code, Frame& frame) {
    TermCodec::begin_call(function, out_->bytes);
    for (std::size_t i = 1; i < code.args.size(); ++i) {
        const Value argument = values_.share_value(values_.eval(*code.args[i], frame));
        const bool unread = i <= function.unread.size() && function.unread[i - 1];
        codec_.write(unread ? unread_ : argument, out_->bytes);
    }
}

void DirectSteps::write_prefix(const Code& code, Frame& frame) {
    const auto chooses = [](const FieldCode& field) { return field.kind == FieldKind::nondeterministic; };
    if (std::ranges::any_of(code.fields, chooses)) return write_made(code, frame);
    TermCodec::begin_operator(Op::prefix, out_->bytes);
    out_->bytes.push_back(static_cast<std::uint8_t>(PrefixKind::script));
    put_number(code.number, out_->bytes);
    for (const auto& [from, to] : code.unit->captures) codec_.write(captured_value(frame, from), out_->bytes);
}

void DirectSteps::write_choice(const Code& code, Frame& frame) {
    std::size_t operands = 1;
    for (const Code* left = &code; left->kind == code.kind; left = left->args[0]) ++operands;
    TermCodec::begin_operator(code.kind == ExprKind::external_choice ? Op::external_choice : Op::internal_choice,
                              out_->bytes);
    put_number(operands, out_->bytes);
    std::vector<const Code*> right;
    const Code* left = &code;
    for (; left->kind == code.kind; left = left->args[0]) right.push_back(left->args[1]);
    write_process(*left, frame);
    for (auto operand = right.rbegin(); operand != right.rend(); ++operand) write_process(**operand, frame);
}

}  // namespace robochart::cspm
