// SPDX-License-Identifier: Apache-2.0
// Represents types during inference as nodes of an arena. A link binds a variable, and a trail records the bindings so
// that they can be undone. Dotted types follow the FDR manual: `a => b` (dotable) becomes b when it is dotted with an
// a. `a =>* b` (extendable) becomes b after an unknown number of arguments; the variable on its left collects them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace robochart::cspm::types {

using TypeId = std::uint32_t;
inline constexpr TypeId no_type = 0xffffffffU;

enum class TypeKind : std::uint8_t {
    variable,
    integer,
    boolean,
    character,
    process,
    event,
    datatype,
    set,
    sequence,
    map,
    tuple,
    function,    ///< arguments, then the result
    dot,         ///< the parts of a dotted value, at least two
    dotable,     ///< argument, result
    extendable,  ///< result, and the variable that collects the arguments
    complete,    ///< the value of an extendable's variable if there are no more arguments
};

/// Returns the type with this name in CSPM (Int, Bool, Char, Proc or Event), or `variable` for any other name.
[[nodiscard]] TypeKind primitive_kind(std::string_view name);

/// A set of constraints on a type, one bit for each. Eq implies Set.
using Constraints = std::uint8_t;
enum Constraint : std::uint8_t {
    can_equal = 1,    ///< Eq: a script may compare the values
    can_order = 2,    ///< Ord: a script may order the values
    can_input = 4,    ///< Complete: a script may input the values on channels
    can_collect = 8,  ///< Set: a script may build sets of the values
    can_yield = 16,   ///< Yieldable: the result of a dot, which is a datatype or an event
};

struct Scheme {
    std::vector<TypeId> quantified;
    TypeId type = no_type;
};

struct TypeNode {
    TypeKind kind = TypeKind::variable;
    Constraints constraints = 0;  ///< of variables
    bool rigid = false;           ///< true for a variable of an annotation; it is never bound
    bool closed = false;          ///< contains no variables
    bool plain = false;           ///< closed and without dotted types, so evaluating dots changes nothing
    /// For variables: the level of the group of declarations to which the variable belongs. When the group ends, the
    /// variable is generalised.
    std::uint32_t level = 0;
    TypeId link = no_type;    ///< the binding of a variable
    std::uint32_t first = 0;  ///< index of the arguments; datatype: its number; rigid: the index of its name
    std::uint32_t count = 0;
};

/// Thrown if a type becomes too deep or too large.
struct TypeOverflow {
    bool deep = false;
};

class TypeStore {
public:
    static constexpr unsigned max_depth = 4000;
    static constexpr std::uint64_t max_steps = 3'000'000;  ///< limits the work on types for one declaration

    TypeStore();

    // The following functions create types.
    [[nodiscard]] TypeId fresh_variable(Constraints constraints = 0);
    [[nodiscard]] TypeId rigid_variable(const std::string& name, Constraints constraints);
    [[nodiscard]] TypeId atom(TypeKind kind) const { return static_cast<TypeId>(kind); }
    [[nodiscard]] TypeId datatype(std::uint32_t number);
    [[nodiscard]] TypeId make_type(TypeKind kind, const std::vector<TypeId>& args);
    [[nodiscard]] TypeId set_of(TypeId element) { return make_type(TypeKind::set, {element}); }
    [[nodiscard]] TypeId sequence_of(TypeId element) { return make_type(TypeKind::sequence, {element}); }
    /// Returns a dotted type with these parts. There must be at least one.
    [[nodiscard]] TypeId dot_type(const std::vector<TypeId>& parts);
    [[nodiscard]] TypeId dotable_type(TypeId argument, TypeId result) {
        return make_type(TypeKind::dotable, {argument, result});
    }
    /// Returns the type that becomes `result` when it has received several arguments.
    [[nodiscard]] TypeId dotable_type(const std::vector<TypeId>& arguments, std::size_t from, TypeId result);
    [[nodiscard]] TypeId extendable_type(TypeId result, TypeId arguments) {
        return make_type(TypeKind::extendable, {result, arguments});
    }

    // The following functions read types.
    /// Follows bindings of variables. Replaces an extendable whose arguments are known by its value.
    [[nodiscard]] TypeId head(TypeId type);
    [[nodiscard]] const TypeNode& node(TypeId type) const { return nodes_[type]; }
    /// Returns the kind of `head`.
    [[nodiscard]] TypeKind kind(TypeId type) { return nodes_[head(type)].kind; }
    [[nodiscard]] TypeId argument(TypeId type, std::size_t i) const { return args_[nodes_[type].first + i]; }
    [[nodiscard]] std::vector<TypeId> arguments(TypeId type) const;
    [[nodiscard]] const std::string& rigid_name(TypeId type) const { return names_[nodes_[type].first]; }
    /// Returns the parts of a dotted type, without nested dots. Any other type is its only part.
    [[nodiscard]] std::vector<TypeId> dot_parts(TypeId type);
    /// Returns the result of a dotable after all its arguments. Appends these arguments, without nested dots, to
    /// `arguments`. A type of another kind is returned unchanged.
    [[nodiscard]] TypeId split(TypeId type, std::vector<TypeId>& arguments);

    // The following functions change variables.
    void bind(TypeId variable, TypeId type);
    void constrain(TypeId variable, Constraints constraints);
    void lower_level(TypeId variable, std::uint32_t level);
    /// Lowers the level of each variable in `type` to at most `level`. Returns true if `sought` occurs in the type.
    bool lower_and_find(TypeId type, TypeId sought, std::uint32_t level);
    /// Returns the variables of a type that belong to levels above the current one. The result is sorted.
    [[nodiscard]] std::vector<TypeId> open_variables(TypeId type);

    // groups of declarations
    void enter_level() { ++level_; }
    void leave_level() { --level_; }
    [[nodiscard]] std::uint32_t level() const { return level_; }
    void renew_steps() { steps_ = 0; }
    void count_step() {
        if (++steps_ > max_steps) throw TypeOverflow{false};
    }

    // changes that can be undone
    [[nodiscard]] std::size_t trail_mark() const { return trail_.size(); }
    void recording(bool on) { recording_ = on; }
    void undo_to(std::size_t mark);

    // datatypes
    [[nodiscard]] std::uint32_t new_datatype(const std::string& name);
    [[nodiscard]] const std::string& datatype_name(std::uint32_t number) const { return datatypes_[number].name; }
    [[nodiscard]] bool is_comparable(std::uint32_t number) const { return datatypes_[number].comparable; }
    void set_comparable(std::uint32_t number, bool value) { datatypes_[number].comparable = value; }

    /// Counts the depth of the recursion on a type, and throws TypeOverflow if it is too large.
    class Depth {
    public:
        explicit Depth(TypeStore& store) : store_(store) {
            store_.count_step();
            if (store_.depth_ >= max_depth) throw TypeOverflow{true};
            ++store_.depth_;
        }
        ~Depth() { --store_.depth_; }
        Depth(const Depth&) = delete;
        Depth& operator=(const Depth&) = delete;

    private:
        TypeStore& store_;
    };

private:
    struct Datatype {
        std::string name;
        bool comparable = false;
        TypeId type = no_type;
    };

    void gather_open(TypeId type, std::vector<TypeId>& out);
    TypeId add(const TypeNode& node);
    void record_change(TypeId type);
    TypeId follow_links(TypeId type);

    std::vector<TypeNode> nodes_;
    std::vector<TypeId> args_;
    std::vector<std::string> names_;
    std::vector<Datatype> datatypes_;
    std::vector<std::pair<TypeId, TypeNode>> trail_;
    bool recording_ = false;
    std::uint32_t level_ = 0;
    unsigned depth_ = 0;
    std::uint64_t steps_ = 0;
};

/// Prints types in FDR's notation. All types that one writer prints use the same names for the same variables.
class TypeWriter {
public:
    explicit TypeWriter(TypeStore& store) : store_(store) {}
    /// Returns the text of the type without constraints.
    [[nodiscard]] std::string type_text(TypeId type);
    /// Returns the text of the type. The constraints of its variables precede it.
    [[nodiscard]] std::string with_constraints(TypeId type);

private:
    void write(TypeId type, int binding, std::string& out);
    void write_list(const std::vector<TypeId>& types, std::string& out);
    [[nodiscard]] std::string variable(TypeId type);

    TypeStore& store_;
    std::vector<std::pair<TypeId, std::string>> seen_;
    std::size_t next_ = 0;
    unsigned depth_ = 0;
};

/// Returns the name of a constraint in FDR.
[[nodiscard]] std::string constraint_name(Constraint constraint);

}  // namespace robochart::cspm::types
