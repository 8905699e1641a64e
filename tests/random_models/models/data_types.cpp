// SPDX-License-Identifier: Apache-2.0
// Makes the types and functions of random models.
#include <fmt/format.h>

#include "tests/random_models/models/data.hpp"

namespace robochart::random_models {

namespace {

std::string product_operand(const DataType& type) {
    const bool loose = type.form == Form::product || type.form == Form::vector || type.form == Form::matrix;
    return loose ? "(" + type.written + ")" : type.written;
}

std::string join_parts(const std::vector<const DataType*>& parts) {
    std::string out;
    for (const DataType* part : parts) out += (out.empty() ? "" : " * ") + product_operand(*part);
    return out;
}

}  // namespace

Types::Types(Random& random, const Shape& shape, Names& names) : random_(random), shape_(shape), names_(names) {
    types_.push_back({Form::boolean, "boolean", {}, {}, 0, 0, {}});
    types_.push_back({Form::nat, "nat", {}, {}, 0, 0, {}});
    if (shape.data.integers) types_.push_back({Form::integer, "int", {}, {}, 0, 0, {}});
    if (shape.data.reals) types_.push_back({Form::real, "real", {}, {}, 0, 0, {}});
    if (shape.data.strings) types_.push_back({Form::string, "string", {}, {}, 0, 0, {}});
}

const DataType* Types::intern(DataType type) {
    for (const DataType& known : types_)
        if (known.written == type.written) return &known;
    types_.push_back(std::move(type));
    return &types_.back();
}

const DataType* Types::existing_type() {
    const std::size_t first = shape_.data.naturals ? 0 : 2;
    const std::size_t index = random_.below(types_.size());
    return &types_[index == 1 && first > 0 ? 0 : index];
}

const DataType* Types::existing_part() {
    const DataType* type = existing_type();
    const bool wide = type->form == Form::sequence || type->form == Form::set || type->form == Form::vector ||
                      type->form == Form::matrix || type->form == Form::product || type->form == Form::function ||
                      type->form == Form::relation;
    return wide ? boolean() : type;
}

std::vector<Form> Types::compound_forms() const {
    const Data& data = shape_.data;
    std::vector<Form> forms;
    if (data.given) forms.push_back(Form::given);
    if (data.enumerations) forms.push_back(Form::enumeration);
    if (data.records) forms.push_back(Form::record);
    if (data.products) forms.push_back(Form::product);
    if (data.sequences) forms.push_back(Form::sequence);
    if (data.sets) forms.push_back(Form::set);
    if (data.vectors) forms.insert(forms.end(), {Form::vector, Form::matrix});
    if (data.relations) forms.insert(forms.end(), {Form::function, Form::relation});
    return forms;
}

const DataType* Types::any_type() {
    const std::vector<Form> forms = compound_forms();
    if (forms.empty() || types_.size() > 12 || random_.chance(60)) return existing_type();
    return compound(random_.pick(forms));
}

const DataType* Types::compound(Form form) {
    DataType type;
    type.form = form;
    switch (form) {
        case Form::given:
            return given();
        case Form::enumeration:
            return enumeration();
        case Form::record:
            return record();
        case Form::function:
        case Form::relation:
            return mapping(form);
        case Form::product:
            for (std::size_t i = random_.between(2, 3); i > 0; --i) type.parts.push_back(existing_part());
            type.written = join_parts(type.parts);
            return intern(std::move(type));
        case Form::sequence:
        case Form::set:
            type.parts = {existing_type()};
            type.written = (form == Form::set ? "Set(" : "Seq(") + type.parts[0]->written + ")";
            return intern(std::move(type));
        case Form::boolean:
        case Form::nat:
        case Form::integer:
        case Form::real:
        case Form::string:
        case Form::vector:
        case Form::matrix:
            break;
    }
    const std::size_t real = shape_.data.integers ? 3 : 2;
    type.parts = {shape_.data.reals && random_.chance(70) ? &types_[real] : nat()};
    type.rows = random_.between(2, 3);
    type.columns = random_.between(shape_.data.relations && form == Form::matrix ? 1 : 2, 3);
    type.written = form == Form::vector
                       ? fmt::format("vector({}, {})", type.parts[0]->written, type.columns)
                       : fmt::format("matrix({}, {}, {})", type.parts[0]->written, type.rows, type.columns);
    return intern(std::move(type));
}

const DataType* Types::given() {
    DataType type;
    type.form = Form::given;
    type.written = names_.unused_name("Token");
    type.labels = {names_.unused_name("some")};
    declarations_.push_back("type " + type.written + "\n");
    declarations_.push_back(fmt::format("function {}() : {} {{\n}}\n", type.labels[0], type.written));
    return intern(std::move(type));
}

const DataType* Types::enumeration() {
    DataType type;
    type.form = Form::enumeration;
    type.written = names_.unused_name("Mode");
    for (std::size_t i = random_.between(1, 4); i > 0; --i) type.labels.push_back(names_.unused_name("L"));
    std::string text = "enumeration " + type.written + " {\n";
    for (const std::string& label : type.labels) {
        std::string arguments;
        type.arguments.emplace_back();
        if (shape_.data.constructors && random_.chance(25))
            for (std::size_t i = random_.between(1, 2); i > 0; --i) {
                type.arguments.back().push_back(any_type());
                arguments += (arguments.empty() ? "" : ", ") + type.arguments.back().back()->written;
            }
        text += "    " + label + (arguments.empty() ? "" : "(" + arguments + ")") + "\n";
    }
    declarations_.push_back(text + "}\n");
    return intern(std::move(type));
}

/// Returns `A -> B`, `A <-> B`, or a type with `A * B` before the arrow. Like parts of products, the operands contain
/// no wider numbers.
const DataType* Types::mapping(Form form) {
    DataType type;
    type.form = form;
    const bool pairs = shape_.data.products && random_.chance(25);
    type.parts.push_back(pairs ? compound(Form::product) : existing_part());
    type.parts.push_back(existing_part());
    type.written = fmt::format("{} {} {}", product_operand(*type.parts[0]), form == Form::function ? "->" : "<->",
                               type.parts[1]->written);
    return intern(std::move(type));
}

const DataType* Types::record() {
    DataType type;
    type.form = Form::record;
    for (std::size_t i = random_.between(1, 3); i > 0; --i) type.parts.push_back(existing_type());
    type.written = names_.unused_name("Point");
    const bool record_word = random_.chance(30);
    std::string text = (record_word ? "record " : "datatype ") + type.written + " {\n";
    for (const DataType* part : type.parts) {
        type.labels.push_back(names_.unused_name("f"));
        text += "    " + type.labels.back() + " : " + part->written + "\n";
    }
    declarations_.push_back(text + "}\n");
    return intern(std::move(type));
}

void Types::declare_function() {
    Operator function;
    function.name = names_.unused_name("fun");
    std::string parameters;
    Expressions conditions(random_, shape_, *this);
    for (std::size_t i = random_.below(3); i > 0; --i) {
        function.parameters.push_back(existing_type());
        conditions.scope.push_back({names_.unused_name("p"), function.parameters.back()});
        parameters += fmt::format("{}{} : {}", parameters.empty() ? "" : ", ", conditions.scope.back().name,
                                  function.parameters.back()->written);
    }
    function.result = existing_type();
    std::string text = fmt::format("function {}({}) : {} {{\n", function.name, parameters, function.result->written);
    for (std::size_t i = random_.below(2); i > 0; --i)
        text += "    precondition " + conditions.expression_text(*boolean()) + "\n";
    if (random_.chance(50)) text += "    postcondition result == " + conditions.operand(*function.result, 6) + "\n";
    declarations_.push_back(text + "}\n");
    functions_.push_back(std::move(function));
}

}  // namespace robochart::random_models
