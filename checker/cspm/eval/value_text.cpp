// Values as FDR prints them.
#include "checker/cspm/eval/value_text.hpp"

#include "checker/cspm/types/builtins.hpp"
#include "diagnostics/escape.hpp"

namespace robochart::cspm {

std::string ValueText::operator()(Value value) const {
    std::string result;
    print(value, result);
    return result;
}

void ValueText::items(const Values& values, const char* open, const char* separator, const char* close,
                      std::string& out) const {
    constexpr std::size_t longest = 1000;
    out += open;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0) out += separator;
        if (out.size() > longest) {
            out += "...";
            break;
        }
        print(values[i], out);
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

void ValueText::print(Value value, std::string& out) const {
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
            return items(value->items, "(", ", ", ")", out);
        case Kind::sequence:
            if (!is_text(value)) return items(value->items, "<", ", ", ">", out);
            out += text_literal(value);
            return;
        case Kind::set:
            return items(value->items, "{", ", ", "}", out);
        case Kind::map:
            out += "(|";
            for (std::size_t i = 0; i + 1 < value->items.size(); i += 2) {
                out += i > 0 ? ", " : " ";
                print(value->items[i], out);
                out += " => ";
                print(value->items[i + 1], out);
            }
            out += " |)";
            return;
        case Kind::head:
            out += program_.heads[static_cast<std::size_t>(value->number)].name;
            return;
        case Kind::dot:
            return items(value->items, "", ".", "", out);
        case Kind::process:
            out += "<process>";
            return;
        case Kind::function: {
            out += value->function->name;
            const std::size_t environment = value->function->environment;
            if (value->items.size() > environment) {
                const auto first = value->items.begin() + static_cast<std::ptrdiff_t>(environment);
                items({first, value->items.end()}, "(", ",", ")", out);
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
                for (const Value item : value->items[0]->items) items({item}, "", "", " ^ ", out);
            out += "<...>";
            return;
        case Kind::processes:
            out += "Proc";
            return;
        case Kind::datatype:
            out += program_.globals[static_cast<std::size_t>(value->number)].function.name;
            return;
        case Kind::sequences_over:
            return items(value->items, "Seq(", ", ", ")", out);
        case Kind::subsets_of:
            return items(value->items, "Set(", ", ", ")", out);
        case Kind::united:
            return items(value->items, "Union({", ", ", "})", out);
        case Kind::maps_over:
            return items(value->items, "Map(", ", ", ")", out);
        case Kind::group:
            out += "<environment>";
            return;
        case Kind::thunk: {
            const Value result = static_cast<const Thunk&>(*value).result;
            if (result != nullptr)
                print(result, out);
            else
                out += "_";
            return;
        }
    }
}

}  // namespace robochart::cspm
