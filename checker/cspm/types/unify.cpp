// SPDX-License-Identifier: Apache-2.0
// Unifies plain types, variables, and dotted types (FDR manual, "Type system": dotable and extendable types).
// tomgr/libcspm, which is FDR's own type checker, defines the rules for dotted types.
#include "checker/cspm/types/unify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "checker/cspm/types/rules.hpp"

namespace robochart::cspm::types {

namespace {

// Puts an element on a stack. The destructor removes it, even after an exception.
template <typename T>
class Pushed {
public:
    Pushed(std::vector<T>& stack, T item) : stack_(stack) { stack_.push_back(item); }
    ~Pushed() { stack_.pop_back(); }
    Pushed(const Pushed&) = delete;
    Pushed& operator=(const Pushed&) = delete;

private:
    std::vector<T>& stack_;
};

bool is_structure(TypeKind kind) {
    return kind == TypeKind::set || kind == TypeKind::sequence || kind == TypeKind::map || kind == TypeKind::tuple ||
           kind == TypeKind::function;
}

bool is_atom(TypeKind kind) {
    return kind == TypeKind::integer || kind == TypeKind::boolean || kind == TypeKind::character ||
           kind == TypeKind::process || kind == TypeKind::event;
}

bool is_result_kind(TypeKind kind) {
    return kind == TypeKind::event || kind == TypeKind::datatype || kind == TypeKind::dotable ||
           kind == TypeKind::extendable;
}

}  // namespace

TypeId Unifier::unify(TypeId expected, TypeId actual) {
    const TypeStore::Depth guard(store_);
    const Pushed pair(pairs_, {expected, actual});
    return unify_heads(store_.head(expected), store_.head(actual));
}

TypeId Unifier::unify_one_way(TypeId expected, TypeId actual) {
    const bool before = std::exchange(one_way_, true);
    try {
        const TypeId result = unify(expected, actual);
        one_way_ = before;
        return result;
    } catch (...) {
        one_way_ = before;
        throw;
    }
}

TypeId Unifier::unify_heads(TypeId a, TypeId b) {
    if (a == b) return a;
    const TypeKind left = store_.node(a).kind;
    const TypeKind right = store_.node(b).kind;
    if (left == TypeKind::variable) return right == TypeKind::variable ? unify_variables(a, b) : unify_variable(a, b);
    if (right == TypeKind::variable) return unify_variable(b, a);
    if (left == right) {
        if (is_structure(left)) return unify_arguments(a, b);
        if (is_atom(left)) return a;
        if (left == TypeKind::dotable) return unify_dotables(a, b);
        if (left == TypeKind::dot) return unify_dots(a, b);
        if (left == TypeKind::extendable) return unify_extendable(a, b);
        mismatch();
    }
    if (left == TypeKind::dot && is_result_kind(right)) return unify_dot_with(a, b, true);
    if (right == TypeKind::dot && is_result_kind(left)) return unify_dot_with(b, a, false);
    if (left == TypeKind::extendable || right == TypeKind::extendable) return unify_extendable(a, b);
    mismatch();
}

// ---------------------------------------------------------------- variables

TypeId Unifier::unify_variables(TypeId a, TypeId b) {
    if (store_.node(b).rigid) {
        if (store_.node(a).rigid) mismatch();
        std::swap(a, b);
    }
    if (store_.node(a).rigid) {
        constrain_all(store_.node(b).constraints, a);
    } else {
        store_.constrain(a, store_.node(b).constraints);
    }
    store_.lower_level(a, store_.node(b).level);
    store_.bind(b, a);
    return a;
}

TypeId Unifier::unify_variable(TypeId variable, TypeId type) {
    if (store_.node(variable).rigid && has_kind(type, TypeKind::dot)) {
        // A dot is never equal to a variable of an annotation, but the result of the dot may be equal to it.
        const TypeId yielded = store_.head(evaluate_dots(type));
        if (!has_kind(yielded, TypeKind::dot)) return unify(variable, yielded);
    }
    constrain_all(store_.node(variable).constraints, type);
    return substitute(variable, type);
}

// Binds a variable to a type. If the type contains the variable, both may still be equal once the dots in the type have
// been evaluated.
TypeId Unifier::substitute(TypeId variable, TypeId type) {
    if (store_.node(variable).rigid) mismatch();
    const std::uint32_t level = store_.node(variable).level;
    if (store_.lower_and_find(type, variable, level)) {
        type = evaluate_dots(type);
        if (store_.head(type) == variable) return type;
        if (store_.lower_and_find(type, variable, level)) {
            TypeWriter writer(store_);
            std::vector<std::string> shown{writer.type_text(variable), writer.type_text(type)};
            throw TypeFault{&rules::infinite_type, std::move(shown), {}, here_};
        }
    }
    store_.bind(variable, type);
    return type;
}

// ---------------------------------------------------------------- structures

TypeId Unifier::unify_arguments(TypeId a, TypeId b) {
    const Parts left = store_.arguments(a);
    const Parts right = store_.arguments(b);
    if (left.size() != right.size()) mismatch();
    Parts result;
    for (std::size_t i = 0; i < left.size(); ++i) result.push_back(unify(left[i], right[i]));
    return result == left ? a : store_.make_type(store_.node(a).kind, result);
}

// ---------------------------------------------------------------- dotted types

// Unifies two dotables. If only one of them has arguments left and the result of the other is an extendable, this
// extendable takes these arguments.
TypeId Unifier::unify_dotables(TypeId a, TypeId b) {
    Parts left;
    Parts right;
    const TypeId left_end = store_.split(a, left);
    const TypeId right_end = store_.split(b, right);
    const bool left_open = has_kind(left_end, TypeKind::extendable);
    const bool right_open = has_kind(right_end, TypeKind::extendable);
    if (!left_open && !right_open) {
        const TypeId end = unify(left_end, right_end);
        return store_.dotable_type(store_.dot_type(combine(left, right)), end);
    }
    if (!left_open || right_open) (void)unify(left_end, right_end);
    left = evaluate(left, Match::longest);
    right = evaluate(right, Match::longest);
    Parts shared;
    for (std::size_t i = 0; i < std::min(left.size(), right.size()); ++i) {
        const TypeId l = left_open ? result_type(left[i]) : left[i];
        const TypeId r = right_open ? result_type(right[i]) : right[i];
        shared.push_back(unify(l, r));
    }
    const Parts& longer = left.size() > right.size() ? left : right;
    if (!right_open && right.size() >= left.size()) {
        (void)unify(left_end, store_.dotable_type(right, shared.size(), right_end));
    } else if (!right_open) {
        (void)unify(left_end, right_end);
    } else if (!left_open && left.size() >= right.size()) {
        (void)unify(store_.dotable_type(left, shared.size(), left_end), right_end);
    }
    for (std::size_t i = shared.size(); i < longer.size(); ++i) {
        const bool open = &longer == &left ? left_open : right_open;
        shared.push_back(open ? result_type(longer[i]) : longer[i]);
    }
    return store_.dotable_type(store_.dot_type(shared), right_open ? left_end : right_end);
}

TypeId Unifier::unify_dots(TypeId a, TypeId b) {
    return store_.dot_type(combine(store_.dot_parts(a), store_.dot_parts(b)));
}

// Unifies a dot with another type: h.x.y is a T if h applied to x and y is a T.
TypeId Unifier::unify_dot_with(TypeId dot, TypeId other, bool dot_expected) {
    if (dot_expected && one_way_) mismatch();
    Parts parts = store_.dot_parts(dot);
    const bool open = store_.node(other).kind == TypeKind::extendable;
    if (open && !dot_expected) {
        parts = evaluate(std::move(parts), Match::shortest);
        if (parts.size() == 1) return unify(other, parts.front());
    }
    const TypeId rest = store_.dot_type({parts.begin() + 1, parts.end()});
    const TypeId head_type = store_.dotable_type(rest, other);
    const bool swapped = dot_expected && store_.node(other).kind == TypeKind::dotable;
    const TypeId first = swapped ? unify(parts.front(), head_type) : unify(head_type, parts.front());
    return open ? store_.dot_type({first, rest}) : other;
}

void Unifier::set_arguments(TypeId variable, TypeId arguments) {
    variable = store_.head(variable);
    const TypeNode node = store_.node(variable);
    if (node.kind == TypeKind::complete && arguments == variable) return;
    TypeWriter writer(store_);
    if (node.kind != TypeKind::variable || node.rigid) {
        const std::string name = node.rigid ? store_.rigid_name(variable) : "the rest";
        throw TypeFault{&rules::fixed_extension, {name}, {}, here_};
    }
    if (store_.lower_and_find(arguments, variable, node.level)) {
        const bool several = store_.node(arguments).kind == TypeKind::dotable;
        const TypeId first = several ? store_.argument(arguments, 0) : arguments;
        std::vector<std::string> shown{writer.type_text(variable), writer.type_text(first)};
        throw TypeFault{&rules::infinite_type, std::move(shown), {}, here_};
    }
    store_.bind(variable, arguments);
}

// Unifies an extendable with another type, in any order. The other type must not be a dotted value.
TypeId Unifier::unify_extendable(TypeId a, TypeId b) {
    const bool left = store_.node(a).kind == TypeKind::extendable;
    const TypeId open = left ? a : b;
    const TypeId other = left ? b : a;
    const TypeId variable = store_.head(store_.argument(open, 1));
    const TypeId end = store_.argument(open, 0);
    if (store_.node(other).kind == TypeKind::dotable) {
        const TypeId rest = store_.fresh_variable();
        const TypeId given = store_.argument(other, 0);
        const TypeId yielded = store_.argument(other, 1);
        (void)unify(store_.extendable_type(end, rest), yielded);
        set_arguments(variable, store_.dotable_type(given, rest));
        return store_.dotable_type(given, store_.extendable_type(end, rest));
    }
    if (store_.node(other).kind == TypeKind::extendable) {
        const TypeId second = store_.head(store_.argument(other, 1));
        const TypeId result = unify(store_.argument(a, 0), store_.argument(b, 0));
        if (variable != second) {
            const bool keep_second = store_.node(second).rigid;
            set_arguments(keep_second ? variable : second, keep_second ? second : variable);
        }
        return store_.extendable_type(result, store_.head(variable));
    }
    const TypeId result = left ? unify(end, other) : unify(other, end);
    set_arguments(variable, store_.atom(TypeKind::complete));
    return result;
}

// ---------------------------------------------------------------- findings

// Returns the type for a message, with as many dots evaluated as possible. The evaluation may bind variables. This does
// no harm, because the declaration is already ill-typed.
TypeId Unifier::type_to_display(TypeId type) {
    if (failing_) return type;
    failing_ = true;
    try {
        type = evaluate_dots(type);
    } catch (const TypeFault&) {  // the type is printed without evaluation
    }
    failing_ = false;
    return type;
}

TypeFault Unifier::make_fault(TypeWriter& writer, TypeId expected, TypeId actual) {
    const TypeKind left = store_.kind(expected);
    const TypeKind right = store_.kind(actual);
    Parts parts;
    if (left == TypeKind::dotable && right != TypeKind::dotable && right != TypeKind::variable) {
        (void)store_.split(expected, parts);
        return {
            &rules::too_many_fields, {writer.type_text(actual), writer.type_text(store_.dot_type(parts))}, {}, here_};
    }
    if (right == TypeKind::dot && is_result_kind(left)) {
        parts = store_.dot_parts(actual);
        const TypeKind first = store_.kind(parts.front());
        if (first == TypeKind::event || first == TypeKind::datatype) {
            const TypeId rest = store_.dot_type({parts.begin() + 1, parts.end()});
            return {&rules::too_many_fields, {writer.type_text(parts.front()), writer.type_text(rest)}, {}, here_};
        }
    }
    if (right == TypeKind::dotable && (left == TypeKind::event || left == TypeKind::datatype)) {
        const TypeId end = store_.split(actual, parts);
        if (store_.head(end) == store_.head(expected)) {
            const std::string fields = writer.type_text(store_.dot_type(parts));
            const std::string whole =
                left == TypeKind::event ? "an event" : fmt::format("a value of {}", writer.type_text(end));
            TypeFault few{&rules::too_few_fields, {whole, fields}, {}, here_};
            few.notes.push_back(
                {here_, fmt::format("it must be followed by `.` and a value of {}, or in a prefix by `?x`", fields)});
            return few;
        }
    }
    return {&rules::mismatch, {writer.type_text(expected), writer.type_text(actual)}, {}, here_};
}

void Unifier::mismatch() {
    const auto [outer_expected, outer_actual] = pairs_.front();
    const auto [inner_expected, inner_actual] = pairs_.back();
    const std::size_t pairs = pairs_.size();
    TypeWriter writer(store_);
    TypeFault inner = make_fault(writer, type_to_display(inner_expected), type_to_display(inner_actual));
    if (pairs == 1) throw TypeFault(std::move(inner));
    TypeFault outer = make_fault(writer, type_to_display(outer_expected), type_to_display(outer_actual));
    const bool special = inner.rule != &rules::mismatch;
    TypeFault result = special ? inner : outer;
    const TypeFault& other = special ? outer : inner;
    if (other.rule == &rules::mismatch && other.arguments != result.arguments) {
        const std::string intro = special ? "while matching " : "there, ";
        result.notes.push_back(
            {here_, intro + other.arguments[0] + " is expected and " + other.arguments[1] + " found"});
    }
    throw TypeFault(std::move(result));
}

}  // namespace robochart::cspm::types
