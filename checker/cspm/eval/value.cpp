// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/eval/value.hpp"

#include <algorithm>

#include "base/diagnostics/containers.hpp"
#include "checker/cspm/eval/code.hpp"

namespace robochart::cspm {

namespace {

constexpr std::int64_t least_small = -64;
constexpr std::int64_t most_small = 1024;

int three_way(std::int64_t a, std::int64_t b) {
    if (a == b) return 0;
    return a < b ? -1 : 1;
}

int compare_items(const Values& a, const Values& b) {
    const std::size_t both = std::min(a.size(), b.size());
    for (std::size_t i = 0; i < both; ++i) {
        if (const int order = compare(a[i], b[i]); order != 0) return order;
    }
    return three_way(static_cast<std::int64_t>(a.size()), static_cast<std::int64_t>(b.size()));
}

}  // namespace

bool is_set(Value value) {
    return value->kind == Kind::set || (value->kind >= Kind::integers && value->kind <= Kind::united);
}

bool is_stream(Value value) {
    return value->kind == Kind::sequence_from || value->kind == Kind::stream;
}

bool is_infinite(Value sequence) {
    while (sequence->kind == Kind::stream || sequence->kind == Kind::thunk) {
        const bool waits = sequence->kind == Kind::thunk;
        sequence = waits ? static_cast<const Thunk&>(*sequence).result : sequence->items[1];
        if (sequence == nullptr) return false;
    }
    return sequence->kind == Kind::sequence_from;
}

int compare(Value a, Value b) {
    if (a == b) return 0;
    if (a->kind != b->kind) return three_way(static_cast<int>(a->kind), static_cast<int>(b->kind));
    if (const int order = three_way(a->number, b->number); order != 0) return order;
    if (a->function != b->function) return three_way(a->function->number, b->function->number);
    if (a->group != b->group) return three_way(a->group->number, b->group->number);
    return compare_items(a->items, b->items);
}

std::size_t ValueStore::Hash::operator()(const Object* object) const {
    std::uint64_t hash = static_cast<std::uint64_t>(object->kind) * 0x9e3779b97f4a7c15ULL;
    const auto mix = [&hash](std::uint64_t word) {
        hash ^= word + 0x9e3779b97f4a7c15ULL + (hash << 6U) + (hash >> 2U);
        hash *= 0xff51afd7ed558ccdULL;
    };
    mix(static_cast<std::uint64_t>(object->number));
    if (object->function != nullptr) mix(object->function->number);
    if (object->group != nullptr) mix(object->group->number);
    for (const Value item : object->items) mix(item->id);
    return hash;
}

bool ValueStore::Same::operator()(const Object* a, const Object* b) const {
    return a->kind == b->kind && a->number == b->number && a->function == b->function && a->group == b->group &&
           a->items == b->items;
}

ValueStore::ValueStore() {
    true_ = make(Kind::boolean, 1, {});
    false_ = make(Kind::boolean, 0, {});
    for (std::int64_t i = least_small; i <= most_small; ++i) small_integers_.push_back(make(Kind::integer, i, {}));
}

Value ValueStore::integer(std::int64_t number) {
    if (number >= least_small && number <= most_small) {
        return small_integers_[static_cast<std::size_t>(number - least_small)];
    }
    return make(Kind::integer, number, {});
}

Value ValueStore::make_string(const std::string& characters) {
    Values items;
    for (const char c : characters) items.push_back(character(static_cast<unsigned char>(c)));
    return sequence(std::move(items));
}

Value ValueStore::form_as_part(Value value) const {
    const bool unlisted = value->kind >= Kind::integers && value->kind <= Kind::united;
    return unlisted && listed_ ? listed_(value) : value;
}

Value ValueStore::set(Values items) {
    for (Value& item : items) item = form_as_part(item);
    constexpr std::uint32_t between_polls = 4096;
    std::uint32_t compared = 0;
    const auto less = [&](Value a, Value b) {
        if (++compared % between_polls == 0) budget_->poll();
        return compare(a, b) < 0;
    };
    if (!std::ranges::is_sorted(items, less)) std::ranges::sort(items, less);
    diagnostics::erase_repeated(items);
    return sorted_set(std::move(items));
}

void ValueStore::note_processes(Object& object) {
    object.made = object.kind == Kind::process || object.kind == Kind::stream ||
                  std::ranges::any_of(object.items, [](Value item) { return item->made; });
    const bool ordered = object.kind == Kind::set || object.kind == Kind::united;
    const std::size_t alone = object.kind == Kind::map ? 2 : 1;
    if (object.made && (ordered || object.kind == Kind::map) && object.items.size() > alone) orders_processes_ = true;
}

Value ValueStore::make(Kind kind, std::int64_t number, Values items, const Function* function, const Group* group) {
    // A dot that does not begin with a channel or constructor is a type A.B. The sets in it are not listed.
    const bool named = kind == Kind::dot && !items.empty() && items[0]->kind == Kind::head;
    if (named || kind == Kind::tuple || kind == Kind::sequence || kind == Kind::map)
        for (Value& item : items) item = form_as_part(item);
    Object key{kind, true, false, static_cast<std::uint32_t>(index_.size()), number, function, group, std::move(items)};
    const auto found = index_.find(&key);
    if (found != index_.end()) return *found;
    note_processes(key);
    objects_.push_back(std::move(key));
    index_.insert(&objects_.back());
    return &objects_.back();
}

const GroupObject* ValueStore::shared_group(const Group& group, Values items, std::size_t members) {
    GroupObject key;
    key.kind = Kind::group;
    key.shared = true;
    key.id = static_cast<std::uint32_t>(index_.size());
    key.group = &group;
    key.items = std::move(items);
    const auto found = index_.find(&key);
    if (found != index_.end()) return static_cast<const GroupObject*>(*found);
    note_processes(key);
    key.known.resize(members, nullptr);
    key.running.resize(members, false);
    groups_.push_back(std::move(key));
    index_.insert(&groups_.back());
    return &groups_.back();
}

Value ValueStore::closure(const Function& function, Values items) {
    temporary_objects_.push_back({Kind::function, false, false, 0, 0, &function, nullptr, std::move(items)});
    return &temporary_objects_.back();
}

Value ValueStore::compound(Kind kind, std::int64_t number, Values items) {
    // A stream is never shared here: if it is finite, it equals a sequence. Only the evaluator can find this out, and
    // then shares that sequence instead.
    bool shared = kind != Kind::stream;
    for (Value& item : items) {
        if (item->kind == Kind::thunk && static_cast<const Thunk&>(*item).result != nullptr)
            item = static_cast<const Thunk&>(*item).result;
        shared = shared && item->shared;
    }
    if (shared) return make(kind, number, std::move(items));
    temporary_objects_.push_back({kind, false, false, 0, number, nullptr, nullptr, std::move(items)});
    return &temporary_objects_.back();
}

const GroupObject* ValueStore::group(const Group& group, Values items, std::size_t members) {
    GroupObject& object = temporary_groups_.emplace_back();
    object.kind = Kind::group;
    object.group = &group;
    object.items = std::move(items);
    object.known.resize(members, nullptr);
    object.running.resize(members, false);
    return &object;
}

Value ValueStore::thunk(const Code& code, Values frame) {
    Thunk& object = thunks_.emplace_back();
    object.kind = Kind::thunk;
    object.code = &code;
    object.frame = std::move(frame);
    return &object;
}

void ValueStore::delete_temporaries() {
    temporary_objects_.clear();
    temporary_groups_.clear();
    thunks_.clear();
}

}  // namespace robochart::cspm
