// SPDX-License-Identifier: Apache-2.0
// Parses with the precedences of FDR's grammar (libcspm, Parser.ppy). `.` binds most tightly. `=>`, `=>*` and `->` are
// right-associative.
#include "checker/cspm/types/written_type.hpp"

#include <array>

#include "base/diagnostics/scanner.hpp"

namespace robochart::cspm::types {

namespace {

class TypeReader : diagnostics::Scanner {
public:
    explicit TypeReader(std::string_view text) : Scanner(text) { skip_spaces(); }

    WrittenScheme read_scheme() {
        WrittenScheme result;
        const std::size_t start = at_;
        const bool group = accept("(");
        if (read_constraint(result)) {
            while (group && accept(",")) read_constraint(result);
            if (group) accept(")");
            accept("=>");
        } else {
            at_ = start;
        }
        result.type = read_whole_type();
        return result;
    }

private:
    // Reads a constraint such as `Eq a`: two adjacent names.
    bool read_constraint(WrittenScheme& scheme) {
        static constexpr std::array<Constraint, 5> all{can_equal, can_order, can_input, can_collect, can_yield};
        const std::string first = read_name();
        const std::string second = read_name();
        if (first.empty() || second.empty()) return false;
        for (const Constraint constraint : all) {
            if (constraint_name(constraint) == first) scheme.constraints.emplace_back(constraint, second);
        }
        return true;
    }

    WrittenType read_whole_type() {
        bool grouped = false;
        WrittenType left = read_dotted(grouped);
        if (accept("->")) return read_function(std::move(left), grouped);
        if (accept("=>*")) return {TypeKind::extendable, "", {std::move(left), read_whole_type()}};
        if (accept("=>")) return {TypeKind::dotable, "", {std::move(left), read_whole_type()}};
        return left;
    }

    // Reads a function type after its arguments. In (A, B) -> C, the arguments are the types in parentheses.
    WrittenType read_function(WrittenType arguments, bool grouped) {
        WrittenType result{TypeKind::function, "", {}};
        if (grouped && arguments.kind == TypeKind::tuple) {
            result.args = std::move(arguments.args);
        } else {
            result.args.push_back(std::move(arguments));
        }
        result.args.push_back(read_whole_type());
        return result;
    }

    WrittenType read_dotted(bool& grouped) {
        WrittenType first = read_operand(grouped);
        if (!looking_at(".")) return first;
        grouped = false;
        WrittenType result{TypeKind::dot, "", {std::move(first)}};
        bool ignored = false;
        while (accept(".")) result.args.push_back(read_operand(ignored));
        return result;
    }

    WrittenType read_operand(bool& grouped) {
        if (accept("{")) return read_until_bracket(TypeKind::set, "}");
        if (accept("<")) return read_until_bracket(TypeKind::sequence, ">");
        if (accept("(|")) {
            bool ignored = false;
            WrittenType result{TypeKind::map, "", {read_dotted(ignored)}};
            accept("=>");
            result.args.push_back(read_whole_type());
            accept("|)");
            return result;
        }
        if (accept("(")) return read_parenthesis(grouped);
        return {TypeKind::variable, read_name(), {}};
    }

    WrittenType read_until_bracket(TypeKind kind, std::string_view close) {
        WrittenType result{kind, "", {read_whole_type()}};
        accept(close);
        return result;
    }

    // Reads a type in parentheses. (T) is T itself. (T, U) is a tuple, or the arguments of a function.
    WrittenType read_parenthesis(bool& grouped) {
        grouped = true;
        WrittenType result{TypeKind::tuple, "", {}};
        if (!looking_at(")")) result.args.push_back(read_whole_type());
        while (accept(",")) result.args.push_back(read_whole_type());
        accept(")");
        if (result.args.size() != 1) return result;
        if (looking_at("->")) return result;
        WrittenType only = std::move(result.args.front());
        return only;
    }

    void skip_spaces() {
        skip_while([](char c) { return c == ' '; });
    }
    bool accept(std::string_view token) {
        if (token == "=>" && looking_at("=>*")) return false;
        if (!Scanner::accept(token)) return false;
        skip_spaces();
        return true;
    }
    std::string read_name() {
        const std::size_t start = at_;
        skip_while([](char c) { return diagnostics::continues_name(c) || c == '\'' || c == ':'; });
        std::string result(text_from(start));
        skip_spaces();
        return result;
    }
};

}  // namespace

WrittenScheme read_type(std::string_view text) {
    return TypeReader(text).read_scheme();
}

}  // namespace robochart::cspm::types
