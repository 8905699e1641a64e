// SPDX-License-Identifier: Apache-2.0
// Writes the actions of random models.
#include <fmt/format.h>

#include "tests/random_models/models/behaviour.hpp"

namespace robochart::random_models {

void Lines::line(const std::string& text) {
    text_.append(4 * depth_, ' ');
    text_ += text + "\n";
}

void Lines::open(const std::string& head) {
    line(head + " {");
    ++depth_;
}

void Lines::close() {
    --depth_;
    line("}");
}

void Lines::embed(const std::string& text) {
    std::size_t begin = 0;
    while (begin < text.size()) {
        const std::size_t end = text.find('\n', begin);
        line(text.substr(begin, end - begin));
        begin = end == std::string::npos ? text.size() : end + 1;
    }
}

Behaviour::Behaviour(Random& random, const Shape& shape, Names& names, Types& types, const Surroundings& around)
    : random_(random),
      shape_(shape),
      names_(names),
      types_(types),
      around_(around),
      expressions_(random, shape, types) {
    expressions_.scope = around.readable;
}

std::string Behaviour::action() {
    return shape_.paced ? sequence(2) + "; wait(1)" : sequence(2);
}

std::string Behaviour::sequence(std::size_t depth) {
    std::string out = statement(depth);
    for (std::size_t i = random_.between(shape_.statements.low, shape_.statements.high); i > 1; --i)
        out += "; " + statement(depth);
    return out;
}

std::string Behaviour::statement(std::size_t depth) {
    if (depth > 0 && shape_.conditionals && random_.chance(15)) return conditional(depth - 1);
    if (depth > 0 && random_.chance(5)) return "(" + sequence(depth - 1) + ")";
    if (shape_.time && random_.chance(25)) return timed_statement();
    return simple_statement();
}

std::string Behaviour::conditional(std::size_t depth) {
    const std::string condition = expressions_.expression_text(*types_.boolean());
    const std::string yes = sequence(depth);
    std::string no;
    if (random_.chance(50)) no = " else " + sequence(depth);
    return fmt::format("if {} then {}{} end", condition, yes, no);
}

/// Returns a statement that takes no time itself, or `skip` if nothing suitable is in scope.
std::string Behaviour::simple_statement() {
    constexpr int attempts = 4;
    for (int i = 0; i < attempts; ++i) {
        const std::size_t way = random_.below(100);
        const std::size_t other = 5;
        const std::size_t rest = 100 - other - shape_.calls;
        std::string found;
        if (way < shape_.calls && !around_.operations.empty()) found = call();
        if (way >= shape_.calls && way < shape_.calls + rest * 4 / 7 && !around_.writable.empty()) found = assignment();
        if (way >= shape_.calls + rest * 4 / 7 && way < 100 - other && !around_.ports.empty()) found = communication();
        if (!found.empty()) return found;
    }
    return "skip";
}

std::string Behaviour::assignment() {
    const Named target = part_of(random_.pick(around_.writable));
    return fmt::format("{} = {}", target.name, expressions_.expression_text(*target.type));
}

Named Behaviour::part_of(Named whole) {
    const DataType& type = *whole.type;
    const bool record = type.form == Form::record;
    const bool indexed = type.form == Form::sequence || type.form == Form::vector || type.form == Form::product;
    if (!(record || indexed) || !random_.chance(40)) return whole;
    const bool any = record || type.form == Form::product;
    const std::size_t at = any ? random_.below(type.parts.size()) : 0;
    const std::string name = record ? whole.name + "." + type.labels[at] : fmt::format("{}[{}]", whole.name, at + 1);
    return part_of({name, type.parts[at]});
}

std::string Behaviour::filter(const Port& port, const std::string& peer) {
    if (!port.broadcast) {
        const bool conditional = shape_.predicates && peer == "from" && random_.chance(25);
        return conditional ? "[|" + expressions_.operand(*types_.boolean(), 4) + "|]" : "";
    }
    if (random_.chance(40)) return {};
    std::string origin;
    if (peer == "from" && random_.chance(60))
        for (const Named& variable : around_.writable)
            if (variable.type->form == Form::nat) origin = variable.name + " = from";
    std::string condition;
    if (origin.empty() || random_.chance(50))
        condition =
            fmt::format("{} == {} /\\ {}", peer, expressions_.number(), expressions_.operand(*types_.boolean(), 4));
    return fmt::format("[|{}{}{}|]", origin, origin.empty() || condition.empty() ? "" : " | ", condition);
}

std::string Behaviour::stored_variable(const Port& port) {
    if (shape_.data.reals && port.type != nullptr && random_.chance(50)) {
        const std::string wider =
            first_variable([&](const DataType& type) { return &type != port.type && fits_type(*port.type, type); });
        if (!wider.empty()) return wider;
    }
    return first_variable([&](const DataType& type) { return &type == port.type; });
}

std::string Behaviour::first_variable(const std::function<bool(const DataType&)>& suits) {
    for (const Named& variable : around_.writable) {
        if (!suits(*variable.type)) continue;
        const bool qualified = shape_.qualified_names && !variable.interface.empty() && random_.chance(20);
        return (qualified ? variable.interface + "::" : "") + variable.name;
    }
    return {};
}

/// Returns "" if no communication on the chosen event is possible, because connections exist only for these directions
/// (Cn8, Cn9).
std::string Behaviour::communication() {
    constexpr int call_level = 12;
    const Port port = random_.pick(around_.ports);
    const std::string send = random_.chance(20) ? "send " : "";
    if (!port.receives || port.both_ways) {
        const std::string accepted = filter(port, "to");
        if (port.type == nullptr) return send + port.name + accepted;
        const std::string value = expressions_.operand(*port.type, call_level);
        const bool selection = value.find_first_of(".[") != std::string::npos;
        const std::string sign = random_.chance(90) ? "!" : ".";
        return send + port.name + accepted + sign + (selection && value.front() != '(' ? "(" + value + ")" : value);
    }
    if (!shape_.inputs_in_actions || port.type == nullptr) return {};
    const std::string variable = stored_variable(port);
    return variable.empty() ? "" : fmt::format("{}{}{}?{}", send, port.name, filter(port, "from"), variable);
}

std::string Behaviour::call() {
    const Signature operation = random_.pick(around_.operations);
    std::string arguments;
    for (const DataType* type : operation.parameters) {
        const std::string value = expressions_.expression_text(*type);
        arguments += (arguments.empty() ? "" : ", ") + value;
    }
    const bool qualified = shape_.qualified_names && random_.chance(10);
    return (qualified ? operation.interface + "::" : "") + operation.name + "(" + arguments + ")";
}

std::string Behaviour::duration() {
    std::vector<std::string> known;
    if (shape_.varied_times)
        for (const Named& named : around_.readable)
            if (named.type->form == Form::nat) known.push_back(named.name);
    return known.empty() || random_.chance(70) ? expressions_.number() : random_.pick(known);
}

std::string Behaviour::timed_statement() {
    const std::size_t way = random_.below(4);
    if (way == 0) return "wait(" + duration() + ")";
    if (way == 1) {
        const std::string least = expressions_.number();
        return fmt::format("wait([{}, {}])", least, expressions_.number(std::stoul(least)));
    }
    if (way == 2 && !around_.clocks.empty()) return "#" + random_.pick(around_.clocks);
    const std::string statement = simple_statement();
    return fmt::format("{} <{{ {} }}", statement, duration());
}

}  // namespace robochart::random_models
