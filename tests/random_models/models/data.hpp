// The types of a random model and expressions of a given type (private to the component). Expressions are well-typed by
// construction, after the rules of the type provider (language reference 2, Types).
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

/// A type; equal types are one object.
struct DataType {
    Form form = Form::nat;
    std::string written;                                  ///< as RoboChart text
    std::vector<const DataType*> parts;                   ///< element, operands, types of fields, argument and result
    std::vector<std::string> labels;                      ///< literals, fields; given: the function that yields a value
    std::size_t rows = 0, columns = 0;                    ///< matrix; vector: columns
    std::vector<std::vector<const DataType*>> arguments;  ///< enumeration: of each literal
};

/// A variable, constant, parameter or bound variable.
struct Named {
    std::string name;
    const DataType* type = nullptr;
    std::string interface = {};  ///< that is required for it; "" if none is
};

/// A declared function.
struct Operator {
    std::string name;
    std::vector<const DataType*> parameters;
    const DataType* result = nullptr;
};

/// A function over type variables: a toolkit's, or declared so in the model.
struct Generic {
    std::string name;
    std::string package;  ///< of a toolkit; "" for the model's own
    std::vector<frontend::TypeExprPtr> parameters;
    frontend::TypeExprPtr result;
};

/// The functions that a text declares.
[[nodiscard]] std::vector<Generic> read_generics(const std::string& package, const std::string& text);
/// Those of the four toolkits.
[[nodiscard]] const std::vector<Generic>& toolkit_functions();

/// What stands for each type variable.
using TypeChoice = std::map<std::string, const DataType*>;

/// Text of an expression and how tightly it binds (levels of the grammar, `iff` 0 to atoms 13).
struct Written {
    std::string text;
    int level = 13;
};

/// The types and functions of a system of components.
class Types {
public:
    Types(Random& random, const Shape& shape, Names& names);

    /// A type for variables and events; built anew within the shape or one that exists.
    const DataType* any();
    /// A type that exists already.
    const DataType* existing();
    /// The same for a part of a product: no wider numbers inside of it, so that tuples of equal type are comparable.
    const DataType* existing_part();
    /// A type that need not be one for variables, such as that of an argument of a toolkit's function.
    const DataType* sought(DataType type);
    /// The types under type variables with which `written` is a type that fits; false if there are none.
    bool unify(const frontend::TypeExpr& written, const DataType& type, TypeChoice& choice) const;
    /// The type written; chooses types for variables that are still open.
    const DataType* instance(const frontend::TypeExpr& written, TypeChoice& choice);
    [[nodiscard]] const DataType* boolean() const { return &types_[0]; }
    [[nodiscard]] const DataType* nat() const { return &types_[1]; }
    [[nodiscard]] const std::vector<Operator>& functions() const { return functions_; }
    [[nodiscard]] const std::vector<Generic>& generics() const { return generics_; }
    /// Declares functions over type variables, if the shape has them.
    void declare_generics();
    /// Declares a function over the types that exist, if the shape has functions.
    void declare_function();
    /// The declarations made so far, each a definition of its own.
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

/// nat, int or real.
[[nodiscard]] bool is_number(const DataType& type);

/// A value of type `from` may stand where `to` is expected.
[[nodiscard]] bool fits(const DataType& from, const DataType& to);

/// Writes expressions over what is in scope.
class Expressions {
public:
    Expressions(Random& random, const Shape& shape, Types& types) : random_(random), shape_(shape), types_(types) {}

    /// What expressions may read.
    std::vector<Named> scope;
    /// Functions may be called (not where values must be constant).
    bool calls = true;

    /// An expression that fits the type; its height is bounded by the shape.
    std::string of(const DataType& type);
    /// The same as an operand that binds at least as tightly as `level`.
    std::string operand(const DataType& type, int level);
    /// A literal, or a composition of literals.
    std::string literal(const DataType& type);
    /// A small natural number.
    std::string number(std::size_t least = 0);

private:
    Written make(const DataType& type, std::size_t depth);
    Written leaf(const DataType& type);
    Written compound(const DataType& type, std::size_t depth);
    Written common(const DataType& type, std::size_t depth);
    Written conditional(const DataType& type, std::size_t depth);
    Written let(const DataType& type, std::size_t depth);
    Written the(const DataType& type, std::size_t depth);
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
    Written quantified(std::size_t depth);
    Written numeric(const DataType& type, std::size_t depth);
    Written set(const DataType& type, std::size_t depth);
    Written binary(const DataType& left, const std::string& op, const DataType& right, int level, std::size_t depth);
    std::string list(const std::vector<const DataType*>& types, std::size_t depth, int level);
    std::string tuple_parts(const DataType& type, std::size_t depth);
    std::string constructor(const DataType& type, std::size_t depth);
    std::string at(int level, const DataType& type, std::size_t depth);
    std::string literal_text(const DataType& type);
    std::string decimal();
    std::string interval(std::size_t depth);
    [[nodiscard]] std::vector<std::string> readable(const DataType& type) const;

    Random& random_;
    const Shape& shape_;
    Types& types_;
    std::size_t bound_ = 0;  ///< bound variables named so far
};

}  // namespace robochart::random_models
