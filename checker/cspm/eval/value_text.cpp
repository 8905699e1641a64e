// SPDX-License-Identifier: Apache-2.0
// Prints values as FDR does.
#include "checker/cspm/eval/value_text.hpp"

#include <limits>

#include "base/diagnostics/escape.hpp"
#include "checker/cspm/types/builtins.hpp"

namespace robochart::cspm {

namespace {

constexpr std::size_t longest_in_messages = 1000;

}  // namespace

std::string ValueText::operator()(Value value) const {
    std::string result;
    print(value, longest_in_messages, result);
    return result;
}

std::string ValueText::full_text(Value value) const {
    std::string result;
    print(value, std::numeric_limits<std::size_t>::max(), result);
    return result;
}

void ValueText::items(const Values& values, const char* open, const char* separator, const char* close,
                      std::string& out) const {
    list(values, open, separator, close, longest_in_messages, out);
}

void ValueText::list(const Values& values, const char* open, const char* separator, const char* close,
                     std::size_t longest, std::string& out) const {
    out += open;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0) out += separator;
        if (out.size() > longest) {
            out += "...";
            break;
        }
        print(values[i], longest, out);
    }
    out += close;
}

namespace {

bool is_text(Value value) {
    if (value->items.empty()) return false;
    for (const Value item : value->items) {
        if (item->kind != Kind::character) return false;
    }
    return true;
}

std::string text_literal(Value value) {
    std::string text;
    for (const Value item : value->items) text += static_cast<char>(item->number);
    return diagnostics::cspm_string(text);
}

}  // namespace

void ValueText::print(Value value, std::size_t longest, std::string& out) const {
    switch (value->kind) {
        case Kind::integer:
            out += std::to_string(value->number);
            return;
        case Kind::boolean:
            out += value->number != 0 ? "true" : "false";
            return;
        case Kind::character:
            out += diagnostics::cspm_character(static_cast<char>(value->number));
            return;
        case Kind::tuple:
            return list(value->items, "(", ", ", ")", longest, out);
        case Kind::sequence:
            if (!is_text(value)) return list(value->items, "<", ", ", ">", longest, out);
            out += text_literal(value);
            return;
        case Kind::set:
            return list(value->items, "{", ", ", "}", longest, out);
        case Kind::map:
            out += "(|";
            for (std::size_t i = 0; i + 1 < value->items.size(); i += 2) {
                out += i > 0 ? ", " : " ";
                print(value->items[i], longest, out);
                out += " => ";
                print(value->items[i + 1], longest, out);
            }
            out += " |)";
            return;
        case Kind::head:
            out += program_.heads[static_cast<std::size_t>(value->number)].name;
            return;
        case Kind::dot:
            return list(value->items, "", ".", "", longest, out);
        case Kind::process:
            out += "<process>";
            return;
        case Kind::function: {
            out += value->function->name;
            const std::size_t environment = value->function->environment;
            if (value->items.size() > environment) {
                const auto first = value->items.begin() + static_cast<std::ptrdiff_t>(environment);
                list({first, value->items.end()}, "(", ",", ")", longest, out);
            }
            return;
        }
        case Kind::builtin:
            out += builtin_name(static_cast<Builtin>(value->number)).name;
            return;
        case Kind::integers:
            out += "Int";
            return;
        case Kind::integers_from:
            out += "{" + std::to_string(value->number) + "..}";
            return;
        case Kind::sequence_from:
            out += "<" + std::to_string(value->number) + "..>";
            return;
        case Kind::stream:
            if (value->items[0]->kind == Kind::sequence)
                for (const Value item : value->items[0]->items) list({item}, "", "", " ^ ", longest, out);
            out += "<...>";
            return;
        case Kind::processes:
            out += "Proc";
            return;
        case Kind::datatype:
            out += program_.globals[static_cast<std::size_t>(value->number)].function.name;
            return;
        case Kind::sequences_over:
            return list(value->items, "Seq(", ", ", ")", longest, out);
        case Kind::subsets_of:
            return list(value->items, "Set(", ", ", ")", longest, out);
        case Kind::united:
            return list(value->items, "Union({", ", ", "})", longest, out);
        case Kind::maps_over:
            return list(value->items, "Map(", ", ", ")", longest, out);
        case Kind::group:
            out += "<environment>";
            return;
        case Kind::thunk: {
            const Value result = static_cast<const Thunk&>(*value).result;
            if (result != nullptr)
                print(result, longest, out);
            else
                out += "_";
            return;
        }
    }
}

}  // namespace robochart::cspm
