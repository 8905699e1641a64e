// SPDX-License-Identifier: Apache-2.0
// Parses the items of files. See parser.hpp.
#include "prism/syntax/parser.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/escape.hpp"
#include "prism/syntax/rules.hpp"

namespace robochart::prism {
namespace {

std::string describe_found(const Token& token) {
    if (token.kind == Tok::end) return "the end of the text";
    std::string text(token.text.substr(0, 40));
    if (token.kind == Tok::quoted)
        return fmt::format("\"{}\"", diagnostics::escape_for_display(diagnostics::ForeignText(text)));
    return fmt::format("'{}'", text);
}

/// Returns the name of an unsupported kind of model by its keyword, or "" for other words.
std::string_view other_kind(std::string_view word) {
    if (word == "ctmc" || word == "stochastic") return "continuous-time Markov chains (ctmc)";
    if (word == "pta" || word == "popta") return "probabilistic timed automata (pta, popta)";
    if (word == "pomdp") return "partially observable models (pomdp)";
    if (word == "smg" || word == "csg" || word == "tsg" || word == "stpg") return "stochastic games";
    return "";
}

}  // namespace

void Parser::enter_recursion() {
    if (depth_ >= max_depth) fail(rules::too_deep, peek().span, {fmt::format("{}", max_depth)});
    ++depth_;
}

const Token& Parser::peek(std::size_t ahead) const {
    return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
}

bool Parser::at_text(std::string_view text, std::size_t ahead) const {
    const Token& token = peek(ahead);
    return token.text == text && (token.kind == Tok::word || token.kind == Tok::symbol);
}

const Token& Parser::take_token() {
    const Token& token = peek();
    if (at_ + 1 < tokens_.size()) ++at_;
    return token;
}

bool Parser::accept(std::string_view text) {
    if (!at_text(text)) return false;
    take_token();
    return true;
}

Span Parser::expect(std::string_view text) {
    if (!at_text(text)) fail(fmt::format("'{}'", text));
    return take_token().span;
}

Name Parser::parse_identifier(std::string_view what) {
    if (peek().kind != Tok::word || is_reserved(peek().text)) fail(what);
    const Token& token = take_token();
    return {std::string(token.text), token.span};
}

Name Parser::parse_letter_or_identifier(std::string_view what) {
    const Token& token = peek();
    if (token.kind != Tok::word || token.text.size() != 1) return parse_identifier(what);
    take_token();
    return {std::string(token.text), token.span};
}

Name Parser::parse_quoted(std::string_view what) {
    if (peek().kind != Tok::quoted) fail(what);
    const Token& token = take_token();
    return {std::string(token.text), token.span};
}

Span Parser::span_since(Span from) const {
    return diagnostics::join_spans(from, tokens_[at_ == 0 ? 0 : at_ - 1].span);
}

void Parser::fail(std::string_view expected) {
    const Token& token = peek();
    const bool reserved = token.kind == Tok::word && is_reserved(token.text);
    auto& finding =
        diagnostics_.report(rules::unexpected_token, token.span, {std::string(expected), describe_found(token)});
    if (reserved && expected.find("name") != std::string_view::npos)
        finding.notes.push_back({{}, fmt::format("'{}' is a word of the language and cannot be a name", token.text)});
    throw SyntaxError{};
}

void Parser::fail(const diagnostics::Rule& rule, Span span, std::vector<std::string> arguments) {
    diagnostics_.report(rule, span, std::move(arguments));
    throw SyntaxError{};
}

void Parser::fail_unsupported(std::string_view what, Span span) {
    fail(rules::not_supported, span, {std::string(what)});
}

void Parser::skip_to(std::initializer_list<std::string_view> stops) {
    while (!at_end()) {
        if (peek().kind == Tok::word && std::ranges::find(stops, peek().text) != stops.end()) return;
        if (take_token().text == ";") return;
    }
}

template <class Piece>
void Parser::parse_with_recovery(const Piece& piece, std::initializer_list<std::string_view> stops) {
    const std::size_t before = at_;
    try {
        piece();
    } catch (const SyntaxError&) {
        depth_ = 0;
        if (at_ == before && !at_end()) take_token();
        skip_to(stops);
    }
}

ModelFile Parser::model() {
    ModelFile file;
    while (!at_end()) {
        diagnostics_.poll();
        // If the head of a module or of a rewards structure is malformed, the whole item is skipped.
        std::string_view end;
        if (at_text("module")) end = "endmodule";
        if (at_text("rewards")) end = "endrewards";
        const std::size_t errors = diagnostics_.error_count();
        parse_with_recovery([&] { parse_item(file); },
                            {"const", "formula", "global", "init", "label", "module", "rewards", "system"});
        if (end.empty() || diagnostics_.error_count() == errors || tokens_[at_ - 1].text == end) continue;
        while (!at_end() && !at_text("module") && !at_text("rewards") && take_token().text != end) {
        }
    }
    file.end = peek().span;
    return file;
}

void Parser::parse_item(ModelFile& file) {
    if (at_text("const") || at_text("rate") || at_text("prob")) return parse_constant(file.constants);
    if (at_text("formula")) return file.formulas.push_back(parse_formula());
    if (at_text("label")) return file.labels.push_back(parse_label());
    if (at_text("module")) return parse_module(file);
    if (at_text("rewards")) return parse_rewards(file);
    if (at_text("init")) return parse_initial_states(file);
    if (at_text("system")) return parse_composition(file);
    if (accept("global")) return file.globals.push_back(parse_variable());
    for (const std::string_view left : {"endmodule", "endrewards", "endinit", "endsystem"})
        if (at_text(left)) fail("a declaration");
    if (at_text("observables") || at_text("observable"))
        fail_unsupported("observables (partially observable models)", peek().span);
    if (at_text("func")) fail_unsupported("functions of one's own (func)", peek().span);
    parse_kind_of_model(file);
}

void Parser::parse_kind_of_model(ModelFile& file) {
    const Span span = peek().span;
    const bool chain = at_text("dtmc") || at_text("probabilistic");
    const std::string_view other = other_kind(peek().text);
    if (!chain && !at_text("mdp") && !at_text("nondeterministic") && other.empty()) fail("a declaration");
    take_token();
    if (!other.empty()) diagnostics_.report(rules::not_supported, span, {std::string(other)});
    if (file.kind_given) diagnostics_.report(rules::given_twice, span, {"the type of the model"});
    file.kind = chain ? ModelKind::dtmc : ModelKind::mdp;
    file.kind_given = true;
}

/// Parses `const [int|double|bool] n [= e];`. `rate` and `prob` are double.
void Parser::parse_constant(std::vector<Constant>& constants) {
    Constant constant;
    const bool old_form = !at_text("const");
    take_token();
    if (old_form) constant.type = Type::real;
    if (accept("double") || accept("rate") || accept("prob"))
        constant.type = Type::real;
    else if (accept("bool"))
        constant.type = Type::boolean;
    else
        (void)accept("int");
    constant.name = parse_identifier("the name of a constant");
    if (accept("=")) constant.value = parse_expression();
    expect(";");
    constants.push_back(std::move(constant));
}

Definition Parser::parse_formula() {
    Definition result;
    expect("formula");
    result.name = parse_identifier("the name of a formula");
    expect("=");
    result.body = parse_expression();
    expect(";");
    return result;
}

Definition Parser::parse_label() {
    Definition result;
    expect("label");
    result.name = parse_quoted("the name of a label in double quotes");
    expect("=");
    result.body = parse_expression();
    expect(";");
    return result;
}

/// Parses `x : [lo..hi] | bool | int [init e];`
Variable Parser::parse_variable() {
    Variable result;
    result.name = parse_identifier("the name of a variable");
    expect(":");
    if (accept("[")) {
        result.low = parse_expression();
        expect("..");
        result.high = parse_expression();
        expect("]");
    } else if (accept("bool")) {
        result.type = Type::boolean;
    } else if (!accept("int")) {
        if (at_text("clock")) fail_unsupported("clocks (probabilistic timed automata)", peek().span);
        if (at_text("double")) fail_unsupported("variables of type double", peek().span);
        fail("a range [low..high], bool or int");
    }
    if (accept("init")) result.initial = parse_expression();
    expect(";");
    return result;
}

void Parser::parse_module(ModelFile& file) {
    expect("module");
    Module module;
    module.name = parse_letter_or_identifier("the name of a module");
    if (accept("=")) {
        module.base = parse_letter_or_identifier("the name of a module");
        expect("[");
        module.renamings = parse_renamings("=", "]");
        expect("endmodule");
    } else {
        parse_module_body(module);
    }
    file.modules.push_back(std::move(module));
}

void Parser::parse_module_body(Module& module) {
    while (!accept("endmodule")) {
        if (at_end() || at_text("module") || at_text("rewards") || at_text("system"))
            fail("a declaration, a command or 'endmodule'");
        diagnostics_.poll();
        parse_with_recovery(
            [&] {
                if (at_text("invariant")) fail_unsupported("invariants (probabilistic timed automata)", peek().span);
                if (at_text("["))
                    module.commands.push_back(parse_command());
                else if (peek().kind == Tok::word && at_text(":", 1))
                    module.variables.push_back(parse_variable());
                else
                    fail("a declaration, a command or 'endmodule'");
            },
            {"endmodule", "module", "rewards", "system"});
    }
}

std::vector<Renaming> Parser::parse_renamings(std::string_view between, std::string_view end) {
    std::vector<Renaming> result;
    while (!at_text(end)) {
        Renaming renaming;
        // Functions may be renamed, although their names are reserved words.
        const auto side = [&] {
            const bool function = at_text("min") || at_text("max");
            if (!function) return parse_identifier("a name");
            const Token& token = take_token();
            return Name{std::string(token.text), token.span};
        };
        renaming.from = side();
        if (between == "<-") {
            expect("<");
            expect("-");
        } else {
            expect(between);
        }
        renaming.to = side();
        result.push_back(std::move(renaming));
        if (!accept(",")) break;
    }
    expect(end);
    return result;
}

/// Parses `[act] guard -> upd;` or `... -> p1:upd + p2:upd + ...;`
Command Parser::parse_command() {
    Command result;
    const Span from = expect("[");
    if (!at_text("]")) result.action = parse_letter_or_identifier("the name of an action");
    expect("]");
    result.guard = parse_expression();
    expect("->");
    do result.branches.push_back(parse_branch());
    while (accept("+"));
    result.span = span_since(from);
    expect(";");
    return result;
}

/// Parses a branch. An update begins with `true` or `(x'`; anything else is a probability.
Branch Parser::parse_branch() {
    if (at_text("[")) fail_unsupported("intervals of probabilities", peek().span);
    const bool at_update = (at_text("(") && peek(1).kind == Tok::word && at_text("'", 2)) ||
                           (at_text("true") && (at_text(";", 1) || at_text("+", 1)));
    if (at_update) return parse_update(nullptr);
    ExprPtr probability = parse_expression();
    expect(":");
    return parse_update(std::move(probability));
}

Branch Parser::parse_update(ExprPtr probability) {
    Branch result;
    const Span from = probability ? probability->span : peek().span;
    result.probability = std::move(probability);
    if (!accept("true")) {
        do result.assignments.push_back(parse_assignment());
        while (accept("&"));
    }
    result.span = span_since(from);
    return result;
}

Assignment Parser::parse_assignment() {
    Assignment result;
    expect("(");
    result.variable = parse_identifier("the name of a variable");
    expect("'");
    expect("=");
    result.value = parse_expression();
    expect(")");
    return result;
}

void Parser::parse_rewards(ModelFile& file) {
    expect("rewards");
    RewardStructure result;
    if (peek().kind == Tok::quoted) result.name = parse_quoted("a name");
    while (!accept("endrewards")) {
        if (at_end() || at_text("module") || at_text("rewards")) fail("a reward or 'endrewards'");
        parse_with_recovery([&] { result.items.push_back(parse_reward_item()); }, {"endrewards", "module", "rewards"});
    }
    file.rewards.push_back(std::move(result));
}

RewardItem Parser::parse_reward_item() {
    RewardItem item;
    const Span from = peek().span;
    if (accept("[")) {
        item.transition = true;
        if (!at_text("]")) item.action = parse_letter_or_identifier("the name of an action");
        expect("]");
    }
    item.guard = parse_expression();
    expect(":");
    item.value = parse_expression();
    item.span = span_since(from);
    expect(";");
    return item;
}

void Parser::parse_initial_states(ModelFile& file) {
    const Span span = expect("init");
    ExprPtr states = parse_expression();
    expect("endinit");
    if (file.initial) diagnostics_.report(rules::given_twice, span, {"init ... endinit"});
    file.initial = std::move(states);
}

void Parser::parse_composition(ModelFile& file) {
    const Span span = expect("system");
    if (peek().kind == Tok::quoted) fail_unsupported("several system blocks with names", peek().span);
    CompositionPtr system = parse_parallel();
    expect("endsystem");
    if (file.system) diagnostics_.report(rules::given_twice, span, {"system ... endsystem"});
    file.system = std::move(system);
}

CompositionPtr Parser::make_composition(Composition composition) {
    for (const CompositionPtr& part : composition.parts)
        composition.height = std::max(composition.height, part->height + 1);
    return std::make_shared<const Composition>(std::move(composition));
}

/// Parses `a || b`, `a ||| b`, `a |[x,y]| b`. The operators have equal precedence and are left-associative.
CompositionPtr Parser::parse_parallel() {
    CompositionPtr left = parse_composed();
    while (accept("|")) {
        Composition next;
        if (accept("[")) {
            next.kind = Composition::Kind::on_actions;
            do next.actions.push_back(parse_letter_or_identifier("the name of an action"));
            while (accept(","));
            expect("]");
            expect("|");
        } else {
            expect("|");
            next.kind = accept("|") ? Composition::Kind::interleaved : Composition::Kind::common;
        }
        next.parts = {left, parse_composed()};
        left = make_composition(std::move(next));
        if (left->height > max_depth) fail(rules::too_deep, peek().span, {fmt::format("{}", max_depth)});
    }
    return left;
}

CompositionPtr Parser::parse_composed() {
    CompositionPtr part = parse_composed_operand();
    for (;;) {
        Composition next;
        if (accept("/")) {
            next.kind = Composition::Kind::hide;
            expect("{");
            do next.actions.push_back(parse_letter_or_identifier("the name of an action"));
            while (accept(","));
            expect("}");
        } else if (accept("{")) {
            next.kind = Composition::Kind::rename;
            next.renamings = parse_renamings("<-", "}");
        } else {
            return part;
        }
        next.parts = {part};
        part = make_composition(std::move(next));
        if (part->height > max_depth) fail(rules::too_deep, peek().span, {fmt::format("{}", max_depth)});
    }
}

CompositionPtr Parser::parse_composed_operand() {
    const Depth depth(*this);
    if (accept("(")) {
        CompositionPtr inner = parse_parallel();
        expect(")");
        return inner;
    }
    Composition leaf;
    leaf.module = parse_letter_or_identifier("the name of a module or '('");
    return make_composition(std::move(leaf));
}

PropertyFile Parser::properties() {
    PropertyFile file;
    while (!at_end()) {
        diagnostics_.poll();
        parse_with_recovery(
            [&] {
                if (accept(";")) return;
                if (at_text("const")) return parse_constant(file.constants);
                if (at_text("label")) return file.labels.push_back(parse_label());
                Property property;
                if (peek().kind == Tok::quoted && at_text(":", 1)) {
                    property.name = parse_quoted("a name");
                    expect(":");
                }
                property.expression = parse_expression();
                // Semicolons are optional at the end of a line.
                if (!accept(";") && !at_end() && !peek().line_begins) fail("';'");
                file.properties.push_back(std::move(property));
            },
            {"const", "label"});
    }
    return file;
}

ExprPtr Parser::lone_expression() {
    ExprPtr result;
    const Within whole_text(*this, in_brackets);
    parse_with_recovery(
        [&] {
            result = parse_expression();
            (void)accept(";");
            if (!at_end()) fail("the end of the text");
        },
        {});
    return diagnostics_.ok() ? result : nullptr;
}

}  // namespace robochart::prism
