// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/packed/direct_steps.hpp"

#include <algorithm>

#include "checker/cspm/packed/not_packed.hpp"

namespace robochart::cspm {

using process::Op;
using process::TermId;

namespace {

/// Thrown if the steps must be computed with terms.
struct NotDirect {};

/// Returns the operands of a chain P op Q op R from left to right.
std::vector<const Code*> chain_operands(const Code& code) {
    std::vector<const Code*> operands;
    const Code* left = &code;
    for (; left->kind == code.kind; left = left->args[0]) operands.push_back(left->args[1]);
    operands.push_back(left);
    std::ranges::reverse(operands);
    return operands;
}

std::size_t place_of(Value value) {
    return (value->id ^ (value->id >> 10U)) & 1023U;
}

}  // namespace

// Sorts steps. Gives the same result as the function with this name in firing_rules.cpp.
void PackedSteps::put_in_order(std::size_t first) {
    const auto begin = steps.begin() + static_cast<std::ptrdiff_t>(first);
    const auto earlier = [](const Step& a, const Step& b) { return a.event < b.event; };
    if (!std::is_sorted(begin, steps.end(), earlier)) std::stable_sort(begin, steps.end(), earlier);
    std::size_t distinct = first;
    std::size_t group = first;
    for (std::size_t i = first; i < steps.size(); ++i) {
        if (distinct > group && steps[i].event != steps[group].event) group = distinct;
        const auto same = [&](const Step& other) { return std::ranges::equal(target(other), target(steps[i])); };
        const auto from = steps.begin() + static_cast<std::ptrdiff_t>(group);
        const auto to = steps.begin() + static_cast<std::ptrdiff_t>(distinct);
        if (std::none_of(from, to, same)) steps[distinct++] = steps[i];
    }
    steps.resize(distinct);
}

/// Lends a frame or another list of values from a pool. The destructor returns it.
class DirectSteps::Borrowed {
public:
    explicit Borrowed(DirectSteps& owner) : owner_(owner) {
        if (owner.borrowed_ == owner.frames_.size()) owner.frames_.emplace_back();
        list = &owner.frames_[owner.borrowed_++];
        list->clear();
    }
    ~Borrowed() { --owner_.borrowed_; }
    Borrowed(const Borrowed&) = delete;
    Borrowed& operator=(const Borrowed&) = delete;
    Frame* list;

private:
    DirectSteps& owner_;
};

/// Limits how many calls are unfolded before an event occurs. Deeper calls are evaluated with terms, because that
/// evaluation detects recursion without an end.
class DirectSteps::Nested {
public:
    explicit Nested(DirectSteps& owner) : owner_(owner) {
        constexpr unsigned deepest = 64;
        if (owner.nested_ >= deepest) throw NotDirect{};
        ++owner.nested_;
    }
    ~Nested() { --owner_.nested_; }
    Nested(const Nested&) = delete;
    Nested& operator=(const Nested&) = delete;

private:
    DirectSteps& owner_;
};

DirectSteps::DirectSteps(Evaluator& values, TermCodec& codec, PackedParts& parts)
    : values_(values),
      tables_(values.parts()),
      codec_(codec),
      parts_(parts),
      unread_(tables_.store.character(unread_character)) {}

bool DirectSteps::find(std::span<const std::uint8_t> bytes, PackedSteps& out) {
    if (unanswered_ >= 32 && ++passed_ % 16 != 0) return false;
    out.clear();
    out_ = &out;
    ++unanswered_;
    try {
        const Work::Question question(tables_.work, Work::small_stack_bytes);
        ByteReader in(bytes);
        steps_of_row(in);
        out.put_in_order(0);
        unanswered_ = 0;
        return true;
    } catch (const NotDirect&) {
    } catch (const EvaluationError&) {  // the evaluation with terms will fail again and report the place
    }
    return false;
}

// ---------------------------------------------------------------- rows

void DirectSteps::steps_of_row(ByteReader& in) {
    const Nested nested(*this);
    switch (static_cast<Op>(in.read_byte())) {
        case Op::stop:
        case Op::omega:
            return;
        case Op::skip: {
            const std::size_t begin = out_->bytes.size();
            TermCodec::begin_operator(Op::omega, out_->bytes);
            return out_->add(process::tick, process::tick, begin);
        }
        case Op::call:
            return row_call(in);
        case Op::prefix:
            return row_prefix(in);
        case Op::external_choice:
            return row_choice(in);
        case Op::internal_choice:
            return row_internal(in);
        case Op::sequential:
            return row_sequential(in);
        case Op::hide:
            return row_hide(in);
        case Op::rename:
            return row_rename(in);
        case Op::div:
        case Op::run:
        case Op::chaos:
        case Op::interrupt:
        case Op::sliding:
        case Op::exception:
        case Op::sync_choice:
        case Op::sync_interrupt:
        case Op::parallel:
        case Op::alphabetised:
        case Op::prioritise:
        case Op::prioritise_order:
        case Op::chase:
        case Op::compress:
        case Op::machine:
        case Op::chaos_offer:
            break;
    }
    throw NotDirect{};
}

void DirectSteps::row_call(ByteReader& in) {
    const Function* const function = codec_.call_head(in);
    if (function == nullptr) throw NotDirect{};
    const TermCodec::CallShape shape = TermCodec::shape(*function);
    const Borrowed given(*this);
    const Borrowed arguments(*this);
    for (std::size_t i = 0; i < shape.given; ++i) given.list->push_back(codec_.read_value(in));
    const auto environment = given.list->begin() + static_cast<std::ptrdiff_t>(function->environment);
    arguments.list->assign(environment, given.list->end());
    for (std::size_t i = 0; i < shape.arguments; ++i) arguments.list->push_back(codec_.read_value(in));
    steps_of_function(*function, *given.list, *arguments.list);
}

void DirectSteps::row_prefix(ByteReader& in) {
    const auto kind = static_cast<PrefixKind>(in.read_byte());
    if (kind != PrefixKind::script && kind != PrefixKind::chosen) throw NotDirect{};
    const Code& code = *tables_.program.prefixes.at(in.read_number());
    if (code.timed != nullptr) throw NotDirect{};
    const Borrowed inside(*this);
    const auto size = static_cast<std::size_t>(code.unit->size);
    if (kind == PrefixKind::script) {
        inside.list->assign(size, nullptr);
        for (const auto& [from, to] : code.unit->captures)
            (*inside.list)[static_cast<std::size_t>(to)] = codec_.read_value(in);
        return perform_all_offers(code, *inside.list);
    }
    const Value field = codec_.read_value(in);
    const Value base = codec_.read_value(in);
    for (std::size_t i = 0; i < size; ++i) inside.list->push_back(codec_.read_value(in));
    perform_fields(code, static_cast<std::size_t>(field->number), base, *inside.list);
}

void DirectSteps::row_choice(ByteReader& in) {
    const std::size_t first = out_->steps.size();
    for (std::uint64_t operands = in.read_number(); operands > 0; --operands) steps_of_row(in);
    refuse_taus(first);
}

void DirectSteps::row_internal(ByteReader& in) {
    for (std::uint64_t operands = in.read_number(); operands > 0; --operands) {
        const std::size_t from = in.position();
        codec_.skip(in);
        const auto operand = in.bytes_since(from);
        const std::size_t begin = out_->bytes.size();
        out_->bytes.insert(out_->bytes.end(), operand.begin(), operand.end());
        out_->add(process::tau, process::tau, begin);
    }
}

void DirectSteps::row_sequential(ByteReader& in) {
    const std::size_t first = out_->steps.size();
    ByteReader operand = in;
    codec_.skip(in);
    const std::size_t from = in.position();
    codec_.skip(in);
    steps_of_row(operand);
    append_next_process(first, in.bytes_since(from));
}

void DirectSteps::row_hide(ByteReader& in) {
    const std::size_t first = out_->steps.size();
    const process::SetId set = parts_.set(static_cast<std::uint32_t>(in.read_number()));
    steps_of_row(in);
    hide_events(first, set);
}

void DirectSteps::row_rename(ByteReader& in) {
    const std::size_t first = out_->steps.size();
    const process::RenamingId renaming = parts_.renaming(static_cast<std::uint32_t>(in.read_number()));
    steps_of_row(in);
    rename_events(first, renaming);
}

// ---------------------------------------------------------------- operators (firing_rules.cpp)

/// Rejects steps with tau. A tau of an operand does not resolve a choice; only the rules for terms handle this.
void DirectSteps::refuse_taus(std::size_t first) const {
    for (std::size_t i = first; i < out_->steps.size(); ++i)
        if (out_->steps[i].event == process::tau) throw NotDirect{};
}

/// Writes the bytes of the operator, followed by the target of the step. Returns the position of the first byte.
std::size_t DirectSteps::wrap_target(Op op, std::uint32_t part, const PackedSteps::Step& step) {
    Bytes& bytes = out_->bytes;
    const std::size_t begin = bytes.size();
    TermCodec::begin_operator(op, bytes);
    if (op != Op::sequential) put_number(part, bytes);
    for (std::uint32_t i = step.begin; i < step.end; ++i) bytes.push_back(bytes[i]);
    return begin;
}

void DirectSteps::append_next_process(std::size_t first, std::span<const std::uint8_t> next) {
    out_->put_in_order(first);
    Bytes& bytes = out_->bytes;
    for (std::size_t i = first; i < out_->steps.size(); ++i) {
        PackedSteps::Step& step = out_->steps[i];
        const bool ends = step.event == process::tick;
        if (ends) step.event = step.revealed = process::tau;
        const std::size_t begin = ends ? bytes.size() : wrap_target(Op::sequential, 0, step);
        bytes.insert(bytes.end(), next.begin(), next.end());
        step.begin = static_cast<std::uint32_t>(begin);
        step.end = static_cast<std::uint32_t>(bytes.size());
    }
}

void DirectSteps::hide_events(std::size_t first, process::SetId set) {
    out_->put_in_order(first);
    const std::uint32_t part = parts_.number_of(set);
    for (std::size_t i = first; i < out_->steps.size(); ++i) {
        PackedSteps::Step& step = out_->steps[i];
        if (step.event == process::tick) continue;
        if (step.event != process::tau && tables_.terms.contains(set, step.event)) step.event = process::tau;
        step.begin = static_cast<std::uint32_t>(wrap_target(Op::hide, part, step));
        step.end = static_cast<std::uint32_t>(out_->bytes.size());
    }
}

void DirectSteps::rename_events(std::size_t first, process::RenamingId renaming) {
    out_->put_in_order(first);
    const process::Renaming& pairs = tables_.terms[renaming];
    const std::uint32_t part = parts_.number_of(renaming);
    const auto begin = out_->steps.begin() + static_cast<std::ptrdiff_t>(first);
    const std::vector<PackedSteps::Step> operand(begin, out_->steps.end());
    out_->steps.erase(begin, out_->steps.end());
    for (const PackedSteps::Step& step : operand) {
        if (step.event == process::tick) {
            out_->steps.push_back(step);
            continue;
        }
        const std::size_t target = wrap_target(Op::rename, part, step);
        auto pair = std::ranges::lower_bound(pairs, process::EventPair{step.event, 0});
        const bool named = step.event != process::tau && pair != pairs.end() && pair->first == step.event;
        if (!named) out_->add(step.event, step.revealed, target);
        for (; named && pair != pairs.end() && pair->first == step.event; ++pair)
            out_->add(pair->second, pair->second, target);
    }
}

// ---------------------------------------------------------------- processes of the script (eval/processes.cpp)

void DirectSteps::steps_of_process(const Code& code, Frame& frame) {
    tables_.work.count_step(code.span);
    switch (code.kind) {
        case ExprKind::name:
            return steps_of_name(code, frame);
        case ExprKind::apply:
            return steps_of_apply(code, frame);
        case ExprKind::if_then_else:
            return steps_of_process(*code.args[values_.eval_boolean(*code.args[0], frame) ? 1 : 2], frame);
        case ExprKind::let:
            values_.open_let(code, frame);
            return steps_of_process(*code.args[0], frame);
        case ExprKind::prefix:
            return steps_of_prefix(code, frame);
        case ExprKind::guard:
            if (values_.eval_boolean(*code.args[0], frame)) return steps_of_process(*code.args[1], frame);
            if (code.timed != nullptr) throw NotDirect{};
            return;
        case ExprKind::external_choice:
        case ExprKind::replicated_external:
            return steps_of_external_choice(code, frame);
        case ExprKind::internal_choice:
            return steps_of_internal_choice(code, frame);
        case ExprKind::sequential:
            return steps_of_sequential(code, frame);
        case ExprKind::hide:
            return steps_of_hide(code, frame);
        default:
            throw NotDirect{};
    }
}

void DirectSteps::steps_of_name(const Code& code, Frame& frame) {
    Values none;
    if (code.reference == Reference::member) {
        const auto& group = static_cast<const GroupObject&>(*frame[static_cast<std::size_t>(code.slot)]);
        const Member& member = group.group->members[static_cast<std::size_t>(code.index)];
        if (member.function.groups.empty() && member.component_of < 0)
            return steps_of_function(member.function, {values_.share_value(&group)}, none);
    }
    if (code.reference == Reference::global) {
        const Global& global = tables_.program.globals[static_cast<std::size_t>(code.slot)];
        if (global.kind == GlobalKind::function && global.function.groups.empty())
            return steps_of_function(global.function, {}, none);
    }
    steps_of_value(values_.eval_name(code, frame));
}

/// Returns the global function with this name if it has a single group with this number of arguments, otherwise null.
const Function* DirectSteps::global_with(const Code& callee, std::size_t arguments) const {
    if (callee.kind != ExprKind::name || callee.reference != Reference::global) return nullptr;
    const Global& global = tables_.program.globals[static_cast<std::size_t>(callee.slot)];
    const bool plain = global.kind == GlobalKind::function && global.function.groups.size() == 1 &&
                       global.function.groups[0] == arguments;
    return plain ? &global.function : nullptr;
}

void DirectSteps::steps_of_apply(const Code& code, Frame& frame) {
    const std::size_t given = code.args.size() - 1;
    const Borrowed arguments(*this);
    const Function* definition = global_with(*code.args[0], given);
    const Values none;
    const Values* items = &none;
    if (definition == nullptr) {
        const Value function = values_.share_value(values_.eval(*code.args[0], frame));
        if (function->kind != Kind::function) throw NotDirect{};
        definition = function->function;
        items = &function->items;
        const TermCodec::CallShape shape = TermCodec::shape(*definition);
        if (definition->groups.empty() || items->size() != shape.given || given != shape.arguments) throw NotDirect{};
        arguments.list->assign(items->begin() + static_cast<std::ptrdiff_t>(definition->environment), items->end());
    }
    for (std::size_t i = 0; i < given; ++i) {
        const Value argument = values_.share_value(values_.eval(*code.args[i + 1], frame));
        const bool unread = i < definition->unread.size() && definition->unread[i];
        arguments.list->push_back(unread ? unread_ : argument);
    }
    steps_of_function(*definition, *items, *arguments.list);
}

void DirectSteps::steps_of_function(const Function& function, const Values& environment, Values& arguments) {
    const Nested nested(*this);
    const Borrowed frame(*this);
    const FunctionClause& clause = values_.choose_clause(function, environment, arguments, *frame.list, function.span);
    steps_of_process(*clause.body, *frame.list);
}

void DirectSteps::steps_of_value(Value made) {
    if (made->kind != Kind::process) throw NotDirect{};
    Bytes bytes;
    codec_.write(static_cast<TermId>(made->number), bytes);
    ByteReader in(bytes);
    steps_of_row(in);
}

void DirectSteps::steps_of_internal_choice(const Code& code, Frame& frame) {
    for (const Code* operand : chain_operands(code)) {
        const std::size_t begin = out_->bytes.size();
        write_process(*operand, frame);
        out_->add(process::tau, process::tau, begin);
    }
}

void DirectSteps::steps_of_external_choice(const Code& code, Frame& frame) {
    if (code.timed != nullptr) throw NotDirect{};
    const std::size_t first = out_->steps.size();
    if (code.kind == ExprKind::external_choice) {
        for (const Code* operand : chain_operands(code)) steps_of_process(*operand, frame);
    } else {
        std::size_t operands = 0;
        values_.for_each(code, code.clauses, 0, frame, [&](Frame& inside) {
            steps_of_process(*code.args[0], inside);
            ++operands;
        });
        if (operands == 1) return;  // a choice with one operand is equal to that operand
    }
    refuse_taus(first);
}

void DirectSteps::steps_of_sequential(const Code& code, Frame& frame) {
    const std::size_t first = out_->steps.size();
    steps_of_process(*code.args[0], frame);
    const std::size_t begin = out_->bytes.size();
    write_process(*code.args[1], frame);
    const Bytes next(out_->bytes.begin() + static_cast<std::ptrdiff_t>(begin), out_->bytes.end());
    append_next_process(first, next);
}

void DirectSteps::steps_of_hide(const Code& code, Frame& frame) {
    const std::size_t first = out_->steps.size();
    steps_of_process(*code.args[0], frame);
    const process::SetId set = tables_.process_evaluator.set_id(*code.args[1], frame);
    if (!tables_.terms[set].empty()) hide_events(first, set);
}

// ---------------------------------------------------------------- prefixes (eval/prefixes.cpp)

/// Returns the value of a variable that a prefix captures.
Value DirectSteps::captured_value(const Frame& frame, int slot) {
    const Value value = frame[static_cast<std::size_t>(slot)];
    return value == nullptr ? tables_.store.tuple({}) : values_.share_value(value);
}

void DirectSteps::steps_of_prefix(const Code& code, Frame& frame) {
    const auto chooses = [](const FieldCode& field) { return field.kind == FieldKind::nondeterministic; };
    if (code.timed != nullptr || std::ranges::any_of(code.fields, chooses)) throw NotDirect{};
    const Borrowed inside(*this);
    inside.list->assign(static_cast<std::size_t>(code.unit->size), nullptr);
    for (const auto& [from, to] : code.unit->captures)
        (*inside.list)[static_cast<std::size_t>(to)] = captured_value(frame, from);
    perform_all_offers(code, *inside.list);
}

void DirectSteps::perform_all_offers(const Code& code, Frame& frame) {
    const auto begin = [&](Frame& inside) {
        perform_fields(code, 0, values_.share_value(values_.eval(*code.args[0], inside)), inside);
    };
    if (code.clauses.empty()) return begin(frame);
    values_.for_each(code, code.clauses, 0, frame, begin);
}

void DirectSteps::perform_fields(const Code& code, std::size_t field, Value base, Frame& frame) {
    if (field == code.fields.size()) {
        const process::Event event = event_of(base, code.args[0]->span);
        const std::size_t begin = out_->bytes.size();
        write_process(*code.args[1], frame);
        return out_->add(event, event, begin);
    }
    const FieldCode& field_code = code.fields[field];
    if (field_code.kind != FieldKind::output && field_code.kind != FieldKind::dot)
        return input_field(code, field, base, frame);
    const Value value = values_.share_value(values_.eval(*field_code.value, frame));
    perform_fields(code, field + 1, combine_dot(base, value, field_code.span), frame);
}

void DirectSteps::input_field(const Code& code, std::size_t field, Value base, Frame& frame) {
    const FieldCode& input = code.fields[field];
    if (input.value == nullptr) return input_parts(code, field, 0, base, frame);
    const Value set = values_.share_value(values_.eval(*input.value, frame));
    for (Value value : tables_.domains.elements(set, input.span)) {
        Value bound = value;
        if (values_.match_pattern(input.patterns[0], bound, frame))
            perform_fields(code, field + 1, combine_dot(base, value, input.span), frame);
    }
}

void DirectSteps::input_parts(const Code& code, std::size_t field, std::size_t part, Value base, Frame& frame) {
    const FieldCode& input = code.fields[field];
    if (part == input.patterns.size()) return perform_fields(code, field + 1, base, frame);
    const MatchCode& pattern = input.patterns[part];
    if (pattern.kind == PatternKind::name && pattern.head) {
        const Value head = tables_.domains.head_value(static_cast<int>(pattern.number));
        return input_parts(code, field, part + 1, combine_dot(base, head, input.span), frame);
    }
    const bool last = field + 1 == code.fields.size() && part + 1 == input.patterns.size();
    const Value set = last ? tables_.domains.extensions(base) : tables_.domains.one_field_extensions(base);
    for (const Value value : set->items) {
        Value bound = value;
        if (!values_.match_pattern(pattern, bound, frame)) continue;
        input_parts(code, field, part + 1, combine_dot(base, value, input.span), frame);
    }
}

// Both functions cache their results. A cached result depends only on values that outlive this object.

Value DirectSteps::combine_dot(Value base, Value more, Span span) {
    Dotted& known = dotted_[(place_of(base) * 31 + place_of(more)) & 1023U];
    if (known.base != base || known.more != more) known = {base, more, tables_.domains.append_fields(base, more, span)};
    return known.result;
}

process::Event DirectSteps::event_of(Value value, Span span) {
    Named& known = events_[place_of(value)];
    if (known.value != value) known = {value, tables_.domains.event_of(value, span)};
    return known.event;
}

}  // namespace robochart::cspm
