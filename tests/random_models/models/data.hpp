// SPDX-License-Identifier: Apache-2.0
// Makes the types of a random model, and expressions of a given type (private to the component). Expressions are
// well-typed by construction, by the rules for types (language reference 2, Types).
#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "frontend/syntax/ast.hpp"
#include "tests/random_models/models/names.hpp"
#include "tests/random_models/models/random.hpp"
#include "tests/random_models/models/shape.hpp"

namespace robochart::random_models {

enum class Form {
    boolean,
    nat,
    integer,
    real,
    string,
    given,
    enumeration,
    record,
    product,
    sequence,
    set,
    vector,
    matrix,
    function,
    relation,
};

/// A type. Equal types are the same object.
struct DataType {
    Form form = Form::nat;
    std::string written;                                  ///< as RoboChart text
    std::vector<const DataType*> parts;                   ///< element, operands, types of fields, argument and result
    std::vector<std::string> labels;                      ///< literals, fields; given type: its function
    std::size_t rows = 0, columns = 0;                    ///< matrix; vector: columns
    std::vector<std::vector<const DataType*>> arguments;  ///< enumeration: types of the parameters of each literal
};

/// A variable, constant, parameter or bound variable.
struct Named {
    std::string name;
    const DataType* type = nullptr;
    std::string interface = {};  ///< the interface that must be required for it, or "" if none
};

/// A declared function.
struct Operator {
    std::string name;
    std::vector<const DataType*> parameters;
    const DataType* result = nullptr;
};

/// A generic function of a toolkit or of the model.
struct Generic {
    std::string name;
    std::string package;  ///< of a toolkit, or "" for the model's own functions
    std::vector<frontend::TypeExprPtr> parameters;
    frontend::TypeExprPtr result;
};

/// Returns the functions that a text declares.
[[nodiscard]] std::vector<Generic> read_generics(const std::string& package, const std::string& text);
/// Returns the functions of the four toolkits.
[[nodiscard]] const std::vector<Generic>& toolkit_functions();

/// The types that are chosen for the type variables.
using TypeChoice = std::map<std::string, const DataType*>;

/// The text of an expression and its precedence, which is a level of the grammar (from `iff` 0 to atoms 13).
struct Written {
    std::string text;
    int level = 13;
};

/// The types and functions of a system of components.
class Types {
public:
    Types(Random& random, const Shape& shape, Names& names);

    /// Returns a type for variables and events: a new one within the shape, or an existing one.
    const DataType* any_type();
    /// Returns an existing type.
    const DataType* existing_type();
    /// Returns an existing type for a part of a product. It contains no wider numbers, so that tuples of equal type are
    /// comparable.
    const DataType* existing_part();
    /// Returns a type that no variable needs to have, such as the type of an argument of a toolkit's function.
    const DataType* sought_type(DataType type);
    /// Finds types for the type variables such that `written` becomes a type that fits. Returns false if there are
    /// none.
    bool unify(const frontend::TypeExpr& written, const DataType& type, TypeChoice& choice) const;
    /// Returns the type that the text denotes. Chooses types for variables that are still open.
    const DataType* instance(const frontend::TypeExpr& written, TypeChoice& choice);
    [[nodiscard]] const DataType* boolean() const { return &types_[0]; }
    [[nodiscard]] const DataType* nat() const { return &types_[1]; }
    [[nodiscard]] const std::vector<Operator>& functions() const { return functions_; }
    [[nodiscard]] const std::vector<Generic>& generics() const { return generics_; }
    /// Declares generic functions, if the shape includes them.
    void declare_generics();
    /// Declares a function over the existing types, if the shape includes functions.
    void declare_function();
    /// Returns the declarations so far, each of them a separate definition.
    [[nodiscard]] const std::vector<std::string>& declarations() const { return declarations_; }

private:
    const DataType* intern(DataType type);
    const DataType* compound(Form form);
    const DataType* enumeration();
    const DataType* record();
    const DataType* given();
    const DataType* mapping(Form form);
    [[nodiscard]] const DataType* basic(const std::string& name) const;
    [[nodiscard]] std::vector<Form> compound_forms() const;

    Random& random_;
    const Shape& shape_;
    Names& names_;
    std::deque<DataType> types_;
    std::deque<DataType> sought_;
    std::vector<Operator> functions_;
    std::vector<Generic> generics_;
    std::vector<std::string> declarations_;
};

/// Returns true for nat, int and real.
[[nodiscard]] bool is_number(const DataType& type);

/// Returns whether a value of type `from` may be used where `to` is expected.
[[nodiscard]] bool fits_type(const DataType& from, const DataType& to);

/// Generates expressions over the names in scope.
class Expressions {
public:
    Expressions(Random& random, const Shape& shape, Types& types) : random_(random), shape_(shape), types_(types) {}

    /// The names that expressions may read.
    std::vector<Named> scope;
    /// False in constant expressions, which may not call functions.
    bool calls = true;

    /// Returns an expression that fits the type. The shape bounds its height.
    std::string expression_text(const DataType& type);
    /// Returns such an expression as an operand with a precedence of at least `level`.
    std::string operand(const DataType& type, int level);
    /// Returns a literal, or a composition of literals.
    std::string literal(const DataType& type);
    /// Returns a small natural number.
    std::string number(std::size_t least = 0);

private:
    Written make(const DataType& type, std::size_t depth);
    Written leaf(const DataType& type);
    Written compound(const DataType& type, std::size_t depth);
    Written common(const DataType& type, std::size_t depth);
    Written conditional(const DataType& type, std::size_t depth);
    Written let(const DataType& type, std::size_t depth);
    Written definite_description(const DataType& type, std::size_t depth);
    Written application(const DataType& type, std::size_t depth);
    Written part(const DataType& type);
    Written call(const DataType& type, std::size_t depth);
    Written generic_call(const DataType& type, std::size_t depth);
    Written generic_call(const Generic& function, TypeChoice choice, std::size_t depth);
    Written generic_comparison(std::size_t depth);
    std::string mapping(const DataType& type, std::size_t depth);
    std::string literal_of(const DataType& type, std::size_t depth);
    Written type_test(std::size_t depth);
    Written comprehension(const DataType& element, std::size_t depth);
    Written matrix(const DataType& type, std::size_t depth);
    Written boolean(std::size_t depth);
    Written comparison(std::size_t depth);
    Written membership(std::size_t depth);
    Written quantified_formula(std::size_t depth);
    Written numeric(const DataType& type, std::size_t depth);
    Written set(const DataType& type, std::size_t depth);
    Written binary(const DataType& left, const std::string& op, const DataType& right, int level, std::size_t depth);
    std::string list(const std::vector<const DataType*>& types, std::size_t depth, int level);
    std::string tuple_parts(const DataType& type, std::size_t depth);
    std::string constructor(const DataType& type, std::size_t depth);
    std::string text_at_level(int level, const DataType& type, std::size_t depth);
    std::string literal_text(const DataType& type);
    std::string decimal();
    std::string interval(std::size_t depth);
    [[nodiscard]] std::vector<std::string> readable(const DataType& type) const;

    Random& random_;
    const Shape& shape_;
    Types& types_;
    std::size_t bound_ = 0;  ///< number of bound variables so far
};

}  // namespace robochart::random_models
