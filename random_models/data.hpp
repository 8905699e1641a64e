// The types of a random model and expressions of a given type (private to the room). Expressions are well-typed by
// construction, after the rules of the type provider (language reference 2, Types).
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "random_models/names.hpp"
#include "random_models/random.hpp"
#include "random_models/shape.hpp"

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
};

/// A type; equal types are one object.
struct DataType {
    Form form = Form::nat;
    std::string written;                 ///< as RoboChart text
    std::vector<const DataType*> parts;  ///< element, operands, types of fields
    std::vector<std::string> labels;     ///< literals, fields; given: the function that yields a value
    std::size_t rows = 0, columns = 0;   ///< matrix; vector: columns
};

/// A variable, constant, parameter or bound variable.
struct Named {
    std::string name;
    const DataType* type = nullptr;
};

/// A declared function.
struct Operator {
    std::string name;
    std::vector<const DataType*> parameters;
    const DataType* result = nullptr;
};

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
    [[nodiscard]] const DataType* boolean() const { return &types_[0]; }
    [[nodiscard]] const DataType* nat() const { return &types_[1]; }
    [[nodiscard]] const std::vector<Operator>& functions() const { return functions_; }
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
    [[nodiscard]] std::vector<Form> compound_forms() const;

    Random& random_;
    const Shape& shape_;
    Names& names_;
    std::deque<DataType> types_;
    std::vector<Operator> functions_;
    std::vector<std::string> declarations_;
};

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
