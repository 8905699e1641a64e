// SPDX-License-Identifier: Apache-2.0
// Precedences as in FDR's grammar (libcspm, Parser.ppy): `.` is highest; `=>`, `=>*` and `->` are right-associative.
#include "checker/cspm/types/written_type.hpp"

#include <array>
#include <cctype>

namespace robochart::cspm::types {

namespace {

class TypeReader {
public:
    explicit TypeReader(std::string_view text) : text_(text) { skip_spaces(); }

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
    // `Eq a`: two adjacent names.
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

    // (A, B) -> C: the types in the parentheses are the arguments.
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
        if (!peek(".")) return first;
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

    // (T) is a group; (T, U) is a tuple, or the arguments of a function.
    WrittenType read_parenthesis(bool& grouped) {
        grouped = true;
        WrittenType result{TypeKind::tuple, "", {}};
        if (!peek(")")) result.args.push_back(read_whole_type());
        while (accept(",")) result.args.push_back(read_whole_type());
        accept(")");
        if (result.args.size() != 1) return result;
        if (peek("->")) return result;
        WrittenType only = std::move(result.args.front());
        return only;
    }

    void skip_spaces() {
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    }
    [[nodiscard]] bool peek(std::string_view token) const { return text_.substr(at_).starts_with(token); }
    bool accept(std::string_view token) {
        if (!peek(token)) return false;
        if (token == "=>" && peek("=>*")) return false;
        at_ += token.size();
        skip_spaces();
        return true;
    }
    std::string read_name() {
        const std::size_t start = at_;
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_' && c != '\'' && c != ':') break;
            ++at_;
        }
        std::string result(text_.substr(start, at_ - start));
        skip_spaces();
        return result;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace

WrittenScheme read_type(std::string_view text) {
    return TypeReader(text).read_scheme();
}

}  // namespace robochart::cspm::types
