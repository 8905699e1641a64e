// SPDX-License-Identifier: Apache-2.0
// Defines the values of the evaluator for CSPM. Data are hash-consed: equal values are one object, so comparing
// pointers decides equality. The order of values is structural and never depends on addresses. A function is a
// definition with captured values. Thunks (unevaluated values) and values that contain or capture thunks are temporary.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <unordered_set>
#include <vector>

#include "base/diagnostics/pollable.hpp"

namespace robochart::cspm {

struct Code;
struct Function;
struct Group;

enum class Kind : std::uint8_t {
    integer,
    boolean,
    character,
    tuple,
    sequence,
    set,             ///< explicit: items sorted by `compare`
    map,             ///< items: k1, v1, k2, v2... sorted by key
    head,            ///< a channel or constructor; `number`: its index; only as the first item of a dot
    dot,             ///< a.b.c; fields of channels and constructors are complete values, possibly dots themselves
    process,         ///< `number`: the term
    function,        ///< `function` with its environment and the arguments given so far
    builtin,         ///< `number`: the built-in
    integers,        ///< Int
    integers_from,   ///< {n..}
    processes,       ///< Proc
    datatype,        ///< all values of a datatype; `number`: its global
    sequences_over,  ///< Seq(items[0])
    subsets_of,      ///< Set(items[0])
    maps_over,       ///< Map(items[0], items[1])
    /// A union of sets that cannot all be listed. Items: these sets, sorted, and then at most one explicit set.
    united,
    sequence_from,  ///< <n..>
    stream,         ///< a sequence whose elements are not all stored, possibly infinite (streams.cpp)
    group,          ///< the environment of a let's declarations
    thunk,
};

struct Object {
    Kind kind = Kind::integer;
    bool shared = false;  ///< hash-consed: contains only shared objects and lives as long as the store
    /// For shared objects: true if their order depends on when processes were created.
    bool made = false;
    std::uint32_t id = 0;
    std::int64_t number = 0;
    const Function* function = nullptr;
    const Group* group = nullptr;
    std::vector<const Object*> items;
};

using Value = const Object*;
using Values = std::vector<Value>;

/// The environment of a `let`. The value of a declaration is stored in `known` when it is first needed.
struct GroupObject : Object {
    mutable Values known;
    mutable std::vector<bool> running;
};

/// An unevaluated expression, with copies of the variables that it may use.
struct Thunk : Object {
    const Code* code = nullptr;
    mutable Values frame;
    mutable Value result = nullptr;
    mutable bool running = false;
};

/// Returns true if the value is a set, explicit or not.
[[nodiscard]] bool is_set(Value value);
/// Returns true if the value is a sequence whose elements are not all stored.
[[nodiscard]] bool is_stream(Value value);
/// Returns true if a sequence is obviously infinite. Evaluates no thunks.
[[nodiscard]] bool is_infinite(Value sequence);
/// Compares shared values in a total, structural order.
[[nodiscard]] int compare(Value a, Value b);

/// Creates and owns values.
class ValueStore {
public:
    ValueStore();

    /// Sets the budget that long work polls. The budget must outlive the store.
    void set_budget(diagnostics::Pollable& budget) { budget_ = &budget; }
    /// Sets the function that lists the elements of a set, if possible. The store applies it to sets inside other
    /// values. So two equal values become one object even if a set in them is written in two ways: `(Set({1}), 1)`
    /// equals `({{}, {1}}, 1)`.
    void list_sets_by(std::function<Value(Value)> listed) { listed_ = std::move(listed); }
    /// Returns the form that a value has inside other values. A set is replaced by the list of its elements, if
    /// possible.
    [[nodiscard]] Value form_as_part(Value value) const;

    [[nodiscard]] Value integer(std::int64_t number);
    [[nodiscard]] Value boolean(bool truth) const { return truth ? true_ : false_; }
    [[nodiscard]] Value character(std::int64_t code) { return make(Kind::character, code, {}); }
    [[nodiscard]] Value tuple(Values items) { return make(Kind::tuple, 0, std::move(items)); }
    [[nodiscard]] Value sequence(Values items) { return make(Kind::sequence, 0, std::move(items)); }
    [[nodiscard]] Value make_string(const std::string& characters);
    /// Creates a set: sorts the items and removes duplicates.
    [[nodiscard]] Value set(Values items);
    /// Creates a set from sorted items that are elements of other sets.
    [[nodiscard]] Value sorted_set(Values items) { return make(Kind::set, 0, std::move(items)); }
    [[nodiscard]] Value dot(Values items) { return make(Kind::dot, 0, std::move(items)); }
    [[nodiscard]] Value make(Kind kind, std::int64_t number, Values items, const Function* function = nullptr,
                             const Group* group = nullptr);

    // The following functions create temporary objects. All of these objects are deleted together.
    /// Creates a tuple, sequence or map, which is shared if its items are shared, or a stream, which is never shared.
    [[nodiscard]] Value compound(Kind kind, std::int64_t number, Values items);
    [[nodiscard]] Value closure(const Function& function, Values items);
    [[nodiscard]] const GroupObject* group(const Group& group, Values items, std::size_t members);
    [[nodiscard]] Value thunk(const Code& code, Values frame);
    /// Returns the shared object of a group whose items are shared.
    [[nodiscard]] const GroupObject* shared_group(const Group& group, Values items, std::size_t members);
    /// Deletes all temporary objects. None of them may be in use.
    void delete_temporaries();
    /// Returns true if the elements of some set are ordered by the creation of processes.
    [[nodiscard]] bool orders_processes() const { return orders_processes_; }
    /// Returns the number of values that live as long as the store.
    [[nodiscard]] std::size_t size() const { return index_.size(); }

private:
    struct Hash {
        std::size_t operator()(const Object* object) const;
    };
    struct Same {
        bool operator()(const Object* a, const Object* b) const;
    };

    std::deque<Object> objects_;
    std::deque<GroupObject> groups_;
    std::unordered_set<const Object*, Hash, Same> index_;
    std::deque<Object> temporary_objects_;
    std::deque<GroupObject> temporary_groups_;
    std::deque<Thunk> thunks_;
    void note_processes(Object& object);

    std::vector<Value> small_integers_;
    bool orders_processes_ = false;
    diagnostics::Pollable* budget_ = &diagnostics::unlimited;
    std::function<Value(Value)> listed_;
    Value true_ = nullptr;
    Value false_ = nullptr;
};

}  // namespace robochart::cspm
