// SPDX-License-Identifier: Apache-2.0
// Writes types as text in the notation of FDR's manual: {Int}, <Int>, (Int, Bool), (Int) -> Proc, Int => Event, a =>*
// Event.
#include <algorithm>

#include "checker/cspm/types/type.hpp"

namespace robochart::cspm::types {

namespace {

// Precedences. A dotted type binds more tightly than a dotable. A dotable that is an argument of another dotable gets
// parentheses.
enum Binding : int { loosest = 0, dot_part = 1, tightest = 2 };

constexpr std::size_t longest_text = 300;
constexpr unsigned deepest_text = 40;

constexpr Constraint all_constraints[] = {can_input, can_equal, can_order, can_collect, can_yield};

}  // namespace

std::string constraint_name(Constraint constraint) {
    switch (constraint) {
        case can_equal:
            return "Eq";
        case can_order:
            return "Ord";
        case can_input:
            return "Complete";
        case can_collect:
            return "Set";
        case can_yield:
            return "Yieldable";
    }
    return "";
}

// Returns the name of a variable. New variables get the names a, b, ..., z, a1, b1, ...
std::string TypeWriter::variable(TypeId type) {
    const auto found = std::ranges::find(seen_, type, &std::pair<TypeId, std::string>::first);
    if (found != seen_.end()) return found->second;
    const auto taken = [&](const std::string& name) {
        return std::ranges::find(seen_, name, &std::pair<TypeId, std::string>::second) != seen_.end();
    };
    std::string name;
    if (store_.node(type).rigid) {
        name = store_.rigid_name(type);
    } else {
        do {
            name = std::string(1, static_cast<char>('a' + next_ % 26)) + (next_ < 26 ? "" : std::to_string(next_ / 26));
            ++next_;
        } while (taken(name));
    }
    seen_.emplace_back(type, name);
    return name;
}

void TypeWriter::write_list(const std::vector<TypeId>& types, std::string& out) {
    for (std::size_t i = 0; i < types.size(); ++i) {
        if (i > 0) out += ", ";
        write(types[i], loosest, out);
    }
}

void TypeWriter::write(TypeId type, int binding, std::string& out) {
    type = store_.head(type);
    if (out.size() > longest_text || depth_ > deepest_text) {
        if (!out.ends_with("...")) out += "...";
        return;
    }
    ++depth_;
    const std::vector<TypeId> args = store_.arguments(type);
    const TypeKind kind = store_.node(type).kind;
    const bool dotted = kind == TypeKind::dotable || kind == TypeKind::extendable;
    const bool parentheses = (dotted && binding > loosest) || (kind == TypeKind::dot && binding > dot_part);
    if (parentheses) out += '(';
    switch (kind) {
        case TypeKind::variable:
            out += variable(type);
            break;
        case TypeKind::integer:
            out += "Int";
            break;
        case TypeKind::boolean:
            out += "Bool";
            break;
        case TypeKind::character:
            out += "Char";
            break;
        case TypeKind::process:
            out += "Proc";
            break;
        case TypeKind::event:
            out += "Event";
            break;
        case TypeKind::datatype:
            out += store_.datatype_name(store_.node(type).first);
            break;
        case TypeKind::set:
            out += '{';
            write(args[0], loosest, out);
            out += '}';
            break;
        case TypeKind::sequence:
            out += '<';
            write(args[0], loosest, out);
            out += '>';
            break;
        case TypeKind::map:
            out += "(| ";
            write(args[0], dot_part, out);
            out += " => ";
            write(args[1], loosest, out);
            out += " |)";
            break;
        case TypeKind::tuple:
            out += '(';
            write_list(args, out);
            out += ')';
            break;
        case TypeKind::function:
            out += '(';
            write_list({args.begin(), args.end() - 1}, out);
            out += ") -> ";
            write(args.back(), loosest, out);
            break;
        case TypeKind::dot:
            for (std::size_t i = 0; i < args.size(); ++i) {
                if (i > 0) out += '.';
                write(args[i], tightest, out);
            }
            break;
        case TypeKind::dotable:
            write(args[0], dot_part, out);
            out += " => ";
            write(args[1], loosest, out);
            break;
        case TypeKind::extendable:
            write(args[1], dot_part, out);
            out += " =>* ";
            write(args[0], loosest, out);
            break;
        case TypeKind::complete:
            break;
    }
    if (parentheses) out += ')';
    --depth_;
}

std::string TypeWriter::type_text(TypeId type) {
    std::string result;
    write(type, loosest, result);
    return result;
}

std::string TypeWriter::with_constraints(TypeId type) {
    const std::string body = type_text(type);
    std::vector<std::string> constraints;
    for (const auto& [variable, name] : seen_) {
        const Constraints held = store_.node(variable).constraints;
        for (const Constraint constraint : all_constraints) {
            if ((held & constraint) == 0) continue;
            if (constraint == can_collect && (held & can_equal) != 0) continue;
            constraints.push_back(constraint_name(constraint) + " " + name);
        }
    }
    if (constraints.empty()) return body;
    std::string result = constraints.size() > 1 ? "(" : "";
    for (std::size_t i = 0; i < constraints.size(); ++i) result += (i > 0 ? ", " : "") + constraints[i];
    return result + (constraints.size() > 1 ? ") => " : " => ") + body;
}

}  // namespace robochart::cspm::types
