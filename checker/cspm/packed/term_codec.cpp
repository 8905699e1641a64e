// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/packed/term_codec.hpp"

#include <algorithm>

#include "checker/cspm/packed/not_packed.hpp"
#include "checker/process/operators.hpp"

namespace robochart::cspm {

using process::Op;
using process::Payload;
using process::properties_of;
using process::TermId;

namespace {

// The first byte of a value is a number up to `most_small`, a kind (counted from `first_kind`), or another constant.
constexpr std::uint8_t first_kind = 0x80;
constexpr std::uint8_t false_value = 0xC0;
constexpr std::uint8_t true_value = 0xC1;
constexpr std::uint8_t bare_head = 0xC2;  // a channel or constructor without fields
constexpr std::int64_t most_small = 0x7F;

constexpr unsigned deepest = 1000;

/// Limits how deep terms and values are nested, because reading and writing them is recursive.
class Deeper {
public:
    explicit Deeper(unsigned& depth) : depth_(depth) {
        if (depth_ >= deepest) throw NotPacked{"a process has more than 1000 parts inside each other"};
        ++depth_;
    }
    ~Deeper() { --depth_; }
    Deeper(const Deeper&) = delete;
    Deeper& operator=(const Deeper&) = delete;

private:
    unsigned& depth_;
};

/// Returns true if the encoding of values of this kind contains a number.
bool has_number(Kind kind) {
    switch (kind) {
        case Kind::tuple:
        case Kind::sequence:
        case Kind::set:
        case Kind::map:
        case Kind::dot:
        case Kind::function:
        case Kind::group:
            return false;
        case Kind::integer:
        case Kind::boolean:
        case Kind::character:
        case Kind::head:
        case Kind::process:
        case Kind::builtin:
        case Kind::integers:
        case Kind::integers_from:
        case Kind::processes:
        case Kind::datatype:
        case Kind::sequences_over:
        case Kind::subsets_of:
        case Kind::maps_over:
        case Kind::united:
        case Kind::sequence_from:
        case Kind::stream:
        case Kind::thunk:
            break;
    }
    return true;
}

template <class T>
void put_at(std::vector<T>& list, std::size_t at, T value) {
    if (at >= list.size()) list.resize(at + 1, nullptr);
    list[at] = value;
}

}  // namespace

TermCodec::TermCodec(const Program& program, ValueStore& store, process::TermStore& terms, ProcessTerms& processes,
                     PackedParts& parts)
    : program_(program), store_(store), terms_(terms), processes_(processes), parts_(parts) {
    const auto add = [this](const Function& function) {
        // Functions without clauses have no number, so the index cannot contain them.
        if (!function.clauses.empty()) put_at<const Function*>(functions_, function.number, &function);
    };
    for (const Global& global : program.globals)
        if (global.kind == GlobalKind::function) add(global.function);
    for (const Function& lambda : program.lambdas) add(lambda);
    for (const Group& group : program.groups) {
        put_at<const Group*>(groups_, group.number, &group);
        for (const Member& member : group.members) add(member.function);
    }
}

// ---------------------------------------------------------------- values

void TermCodec::write(Value value, Bytes& out) {
    switch (value->kind) {
        case Kind::integer:
            if (value->number >= 0 && value->number <= most_small)
                return out.push_back(static_cast<std::uint8_t>(value->number));
            out.push_back(first_kind + static_cast<std::uint8_t>(Kind::integer));
            return put_signed(value->number, out);
        case Kind::boolean:
            return out.push_back(value->number != 0 ? true_value : false_value);
        case Kind::process:
            if (inside_sets_ > 0) throw NotPacked{"a set has processes as elements"};
            out.push_back(first_kind + static_cast<std::uint8_t>(Kind::process));
            return write(static_cast<TermId>(value->number), out);
        case Kind::stream:
        case Kind::thunk:
            throw NotPacked{"an argument is an infinite sequence"};
        default:
            break;
    }
    if (value->kind == Kind::dot && value->items.size() == 1 && value->items[0]->kind == Kind::head) {
        out.push_back(bare_head);
        return put_number(static_cast<std::uint64_t>(value->items[0]->number), out);
    }
    const Deeper deeper(depth_);
    out.push_back(first_kind + static_cast<std::uint8_t>(value->kind));
    if (has_number(value->kind))
        put_signed(value->number, out);
    else if (value->number != 0)
        throw NotPacked{"an argument is not a value of the script"};
    if (value->kind == Kind::function) put_number(value->function->number, out);
    if (value->kind == Kind::group) put_number(value->group->number, out);
    put_number(value->items.size(), out);
    // Sets and the keys of maps are sorted. The order of processes depends on when they were created, so the bytes
    // would too. Therefore a process inside such a value is rejected.
    const bool ordered = value->kind == Kind::set || value->kind == Kind::map || value->kind == Kind::united;
    if (ordered) ++inside_sets_;
    try {
        write_values(value->items, 0, out);
    } catch (const NotPacked&) {
        inside_sets_ = 0;
        throw;
    }
    if (ordered) --inside_sets_;
}

void TermCodec::write_values(const Values& values, std::size_t from, Bytes& out) {
    for (std::size_t i = from; i < values.size(); ++i) write(values[i], out);
}

Value TermCodec::read_value(ByteReader& in) {
    const std::uint8_t first = in.read_byte();
    if (first <= most_small) return store_.integer(first);
    if (first == false_value || first == true_value) return store_.boolean(first == true_value);
    if (first == bare_head) {
        const auto head = static_cast<std::int64_t>(in.read_number());
        return store_.dot({store_.make(Kind::head, head, {})});
    }
    const auto kind = static_cast<Kind>(first - first_kind);
    if (kind == Kind::integer) return store_.integer(in.signed_number());
    if (kind == Kind::process) return store_.make(kind, static_cast<std::int64_t>(read(in)), {});
    const std::int64_t number = has_number(kind) ? in.signed_number() : 0;
    const Function* const function = kind == Kind::function ? functions_.at(in.read_number()) : nullptr;
    const Group* const group = kind == Kind::group ? groups_.at(in.read_number()) : nullptr;
    Values items = read_values(in.read_number(), in);
    if (group != nullptr) return store_.shared_group(*group, std::move(items), group->members.size());
    return store_.make(kind, number, std::move(items), function);
}

Values TermCodec::read_values(std::size_t count, ByteReader& in) {
    Values values;
    values.reserve(count);
    for (std::size_t i = 0; i < count; ++i) values.push_back(read_value(in));
    return values;
}

void TermCodec::skip_value(ByteReader& in) {
    const std::uint8_t first = in.read_byte();
    if (first <= most_small || first == false_value || first == true_value) return;
    const auto kind = static_cast<Kind>(first - first_kind);
    if (first == bare_head || kind == Kind::integer) return static_cast<void>(in.read_number());
    if (kind == Kind::process) return skip(in);
    if (has_number(kind)) (void)in.read_number();
    if (kind == Kind::function || kind == Kind::group) (void)in.read_number();
    skip_values(in.read_number(), in);
}

void TermCodec::skip_values(std::size_t count, ByteReader& in) {
    for (std::size_t i = 0; i < count; ++i) skip_value(in);
}

// ---------------------------------------------------------------- calls

TermCodec::CallShape TermCodec::shape(const Function& function) {
    std::size_t given = function.environment;
    for (const std::size_t group : function.groups) given += group;
    const std::size_t last = function.groups.empty() ? 0 : function.groups.back();
    return {given - last, last};
}

void TermCodec::begin_call(const Function& function, Bytes& out) {
    begin_operator(Op::call, out);
    put_number(function.number + std::uint64_t{1}, out);
}

const Function* TermCodec::call_head(ByteReader& in) const {
    const std::uint64_t number = in.read_number();
    return number == 0 ? nullptr : functions_.at(number - 1);
}

void TermCodec::write_call(const process::Term& term, Bytes& out) {
    const Value key = processes_.call_key(term.payload);
    const Value function = key->items[0];
    if (function->kind == Kind::function && function->number == 0) {
        const CallShape expected = shape(*function->function);
        if (function->items.size() == expected.given && key->items.size() == expected.arguments + 1) {
            begin_call(*function->function, out);
            write_values(function->items, 0, out);
            return write_values(key->items, 1, out);
        }
    }
    begin_operator(Op::call, out);
    put_number(0, out);
    put_number(key->items.size(), out);
    write_values(key->items, 0, out);
}

TermId TermCodec::read_call(ByteReader& in) {
    const Function* const definition = call_head(in);
    if (definition == nullptr) {
        const Values key = read_values(in.read_number(), in);
        return processes_.make_call(key[0], {key.begin() + 1, key.end()});
    }
    const CallShape expected = shape(*definition);
    const Value function = store_.make(Kind::function, 0, read_values(expected.given, in), definition);
    return processes_.make_call(function, read_values(expected.arguments, in));
}

// ---------------------------------------------------------------- prefixes

/// Returns how many values follow the place in the key of a prefix.
std::size_t TermCodec::values_of_prefix(PrefixKind kind, std::uint64_t place) const {
    switch (kind) {
        case PrefixKind::script:
            return program_.prefixes.at(place)->unit->captures.size();
        case PrefixKind::chosen:  // index of the field, event so far, variables
            return 2 + static_cast<std::size_t>(program_.prefixes.at(place)->unit->size);
        case PrefixKind::waiting:  // number of tocks, process after them
            return 2;
        case PrefixKind::stopped:
        case PrefixKind::skipping:
            return 0;
        case PrefixKind::buffer:
            return 3;
    }
    throw NotPacked{"a prefix of no kind"};
}

// Writes a prefix. The first value of its key is its place in the script or the tock event. Only the key of a buffer
// starts differently.
void TermCodec::write_prefix(const process::Term& term, Bytes& out) {
    const auto [kind, key] = processes_.prefix_key(term.payload);
    begin_operator(Op::prefix, out);
    out.push_back(static_cast<std::uint8_t>(kind));
    std::uint64_t place = 0;
    const std::size_t first = kind == PrefixKind::buffer ? 0 : 1;
    if (kind == PrefixKind::script || kind == PrefixKind::chosen) {
        place = static_cast<std::uint64_t>(key->items[0]->number);
        put_number(place, out);
    } else if (first == 1) {
        const auto tock = static_cast<process::Event>(key->items[0]->number);
        put_number(parts_.number_of(terms_.intern_set({tock})), out);
    }
    if (key->items.size() != first + values_of_prefix(kind, place)) throw NotPacked{"a prefix of another form"};
    write_values(key->items, first, out);
}

TermId TermCodec::read_prefix(ByteReader& in) {
    const auto kind = static_cast<PrefixKind>(in.read_byte());
    Values key;
    std::uint64_t place = 0;
    if (kind == PrefixKind::script || kind == PrefixKind::chosen) {
        place = in.read_number();
        key.push_back(store_.integer(static_cast<std::int64_t>(place)));
    } else if (kind != PrefixKind::buffer) {
        const process::SetId tock = parts_.set(static_cast<std::uint32_t>(in.read_number()));
        key.push_back(store_.integer(terms_[tock].front()));
    }
    const Values values = read_values(values_of_prefix(kind, place), in);
    key.insert(key.end(), values.begin(), values.end());
    return processes_.make_prefix(kind, std::move(key));
}

void TermCodec::skip_prefix(ByteReader& in) {
    const auto kind = static_cast<PrefixKind>(in.read_byte());
    const std::uint64_t place = kind == PrefixKind::buffer ? 0 : in.read_number();
    skip_values(values_of_prefix(kind, place), in);
}

// ---------------------------------------------------------------- operators

void TermCodec::write(TermId id, Bytes& out) {
    const Deeper deeper(depth_);
    const process::Term& term = terms_[id];
    switch (term.op) {
        case Op::call:
            return write_call(term, out);
        case Op::prefix:
            return write_prefix(term, out);
        case Op::compress:
        case Op::machine:
            throw NotPacked{"a compression is a part of the process"};
        default:
            break;
    }
    begin_operator(term.op, out);
    switch (properties_of(term.op).payload) {
        case Payload::none:
            break;
        case Payload::set:
            put_number(parts_.number_of(process::SetId{term.payload}), out);
            break;
        case Payload::renaming:
            put_number(parts_.number_of(process::RenamingId{term.payload}), out);
            break;
        case Payload::order:
            put_number(parts_.number_of(process::OrderId{term.payload}), out);
            break;
    }
    if (!properties_of(term.op).operands) put_number(term.children.size(), out);
    write_children(term, out);
}

void TermCodec::write_children(const process::Term& term, Bytes& out) {
    for (const process::SetId set : term.sets) put_number(parts_.number_of(set), out);
    for (const TermId child : term.children) write(child, out);
}

TermId TermCodec::read(ByteReader& in) {
    const auto op = static_cast<Op>(in.read_byte());
    if (op == Op::call) return read_call(in);
    if (op == Op::prefix) return read_prefix(in);
    return read_operator(op, in);
}

std::uint32_t TermCodec::read_part(Op op, ByteReader& in) {
    const auto number = [&in] { return static_cast<std::uint32_t>(in.read_number()); };
    switch (properties_of(op).payload) {
        case Payload::none:
            return 0;
        case Payload::set:
            return payload(parts_.set(number()));
        case Payload::renaming:
            return payload(parts_.renaming(number()));
        case Payload::order:
            return payload(parts_.order(number()));
    }
    return 0;
}

TermId TermCodec::read_operator(Op op, ByteReader& in) {
    process::Term term{op, read_part(op, in), {}, {}};
    const std::optional<std::size_t> fixed = properties_of(op).operands;
    const std::size_t operands = fixed ? *fixed : in.read_number();
    if (op == Op::alphabetised)
        for (std::size_t i = 0; i < operands; ++i)
            term.sets.push_back(parts_.set(static_cast<std::uint32_t>(in.read_number())));
    for (std::size_t i = 0; i < operands; ++i) term.children.push_back(read(in));
    return terms_.intern_term(term);
}

void TermCodec::skip(ByteReader& in) {
    const auto op = static_cast<Op>(in.read_byte());
    if (op == Op::prefix) return skip_prefix(in);
    if (op == Op::call) {
        const Function* const definition = call_head(in);
        if (definition == nullptr) return skip_values(in.read_number(), in);
        const CallShape expected = shape(*definition);
        return skip_values(expected.given + expected.arguments, in);
    }
    if (properties_of(op).payload != Payload::none) (void)in.read_number();
    const std::optional<std::size_t> fixed = properties_of(op).operands;
    const std::size_t operands = fixed ? *fixed : in.read_number();
    if (op == Op::alphabetised)
        for (std::size_t i = 0; i < operands; ++i) (void)in.read_number();
    for (std::size_t i = 0; i < operands; ++i) skip(in);
}

}  // namespace robochart::cspm
