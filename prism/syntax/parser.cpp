// SPDX-License-Identifier: Apache-2.0
// Parses tokens and the items of files. See parser.hpp.
#include "prism/syntax/parser.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "prism/syntax/rules.hpp"
#include "base/diagnostics/escape.hpp"

namespace robochart::prism {
namespace {

std::string found(const Token& token) {
    if (token.kind == Tok::end) return "the end of the text";
    std::string text(token.text.substr(0, 40));
    if (token.kind == Tok::quoted) return fmt::format("\"{}\"", diagnostics::shown(diagnostics::ForeignText(text)));
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

void Parser::deeper() {
    if (depth_ >= max_depth) fail(rules::too_deep, peek().span, {fmt::format("{}", max_depth)});
    ++depth_;
}

const Token& Parser::peek(std::size_t ahead) const {
    return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
}

bool Parser::at(std::string_view text, std::size_t ahead) const {
    const Token& token = peek(ahead);
    return token.text == text && (token.kind == Tok::word || token.kind == Tok::symbol);
}

const Token& Parser::take() {
    const Token& token = peek();
    if (at_ + 1 < tokens_.size()) ++at_;
    return token;
}

bool Parser::accept(std::string_view text) {
    if (!at(text)) return false;
    take();
    return true;
}

Span Parser::expect(std::string_view text) {
    if (!at(text)) fail(fmt::format("'{}'", text));
    return take().span;
}

Name Parser::identifier(std::string_view what) {
    if (peek().kind != Tok::word || is_reserved(peek().text)) fail(what);
    const Token& token = take();
    return {std::string(token.text), token.span};
}

Name Parser::letter_or_identifier(std::string_view what) {
    const Token& token = peek();
    if (token.kind != Tok::word || token.text.size() != 1) return identifier(what);
    take();
    return {std::string(token.text), token.span};
}

Name Parser::quoted(std::string_view what) {
    if (peek().kind != Tok::quoted) fail(what);
    const Token& token = take();
    return {std::string(token.text), token.span};
}

Span Parser::since(Span from) const {
    return diagnostics::join(from, tokens_[at_ == 0 ? 0 : at_ - 1].span);
}

void Parser::fail(std::string_view expected) {
    const Token& token = peek();
    const bool reserved = token.kind == Tok::word && is_reserved(token.text);
    auto& finding = diagnostics_.report(rules::unexpected_token, token.span, {std::string(expected), found(token)});
    if (reserved && expected.find("name") != std::string_view::npos)
        finding.notes.push_back({{}, fmt::format("'{}' is a word of the language, which names nothing", token.text)});
    throw SyntaxError{};
}

void Parser::fail(const diagnostics::Rule& rule, Span span, std::vector<std::string> arguments) {
    diagnostics_.report(rule, span, std::move(arguments));
    throw SyntaxError{};
}

void Parser::refuse(std::string_view what, Span span) {
    fail(rules::not_supported, span, {std::string(what)});
}

void Parser::skip(std::initializer_list<std::string_view> stops) {
    while (!at_end()) {
        if (peek().kind == Tok::word && std::ranges::find(stops, peek().text) != stops.end()) return;
        if (take().text == ";") return;
    }
}

template <class Piece>
void Parser::guarded(const Piece& piece, std::initializer_list<std::string_view> stops) {
    const std::size_t before = at_;
    try {
        piece();
    } catch (const SyntaxError&) {
        depth_ = 0;
        if (at_ == before && !at_end()) take();
        skip(stops);
    }
}

ModelFile Parser::model() {
    ModelFile file;
    while (!at_end()) {
        diagnostics_.poll();
        // If the head of a module or of a rewards structure is malformed, the whole item is skipped.
        const std::string_view end = at("module") ? "endmodule" : at("rewards") ? "endrewards" : "";
        const std::size_t errors = diagnostics_.errors();
        guarded([&] { item(file); }, {"const", "formula", "global", "init", "label", "module", "rewards", "system"});
        if (end.empty() || diagnostics_.errors() == errors || tokens_[at_ - 1].text == end) continue;
        while (!at_end() && !at("module") && !at("rewards") && take().text != end) {
        }
    }
    file.end = peek().span;
    return file;
}

void Parser::item(ModelFile& file) {
    if (at("const") || at("rate") || at("prob")) return constant(file.constants);
    if (at("formula")) return file.formulas.push_back(formula());
    if (at("label")) return file.labels.push_back(label());
    if (at("module")) return module(file);
    if (at("rewards")) return rewards(file);
    if (at("init")) return initial_states(file);
    if (at("system")) return composition(file);
    if (accept("global")) return file.globals.push_back(variable());
    for (const std::string_view left : {"endmodule", "endrewards", "endinit", "endsystem"})
        if (at(left)) fail("a declaration");
    if (at("observables") || at("observable")) refuse("observables (partially observable models)", peek().span);
    if (at("func")) refuse("functions of one's own (func)", peek().span);
    kind_of_model(file);
}

void Parser::kind_of_model(ModelFile& file) {
    const Span span = peek().span;
    const bool chain = at("dtmc") || at("probabilistic");
    const std::string_view other = other_kind(peek().text);
    if (!chain && !at("mdp") && !at("nondeterministic") && other.empty()) fail("a declaration");
    take();
    if (!other.empty()) diagnostics_.report(rules::not_supported, span, {std::string(other)});
    if (file.kind_given) diagnostics_.report(rules::given_twice, span, {"the type of the model"});
    file.kind = chain ? ModelKind::dtmc : ModelKind::mdp;
    file.kind_given = true;
}

/// `const [int|double|bool] n [= e];`, `rate` and `prob` are double.
void Parser::constant(std::vector<Constant>& constants) {
    Constant constant;
    const bool old_form = !at("const");
    take();
    if (old_form) constant.type = Type::real;
    if (accept("double") || accept("rate") || accept("prob"))
        constant.type = Type::real;
    else if (accept("bool"))
        constant.type = Type::boolean;
    else
        (void)accept("int");
    constant.name = identifier("the name of a constant");
    if (accept("=")) constant.value = expression();
    expect(";");
    constants.push_back(std::move(constant));
}

Definition Parser::formula() {
    Definition result;
    expect("formula");
    result.name = identifier("the name of a formula");
    expect("=");
    result.body = expression();
    expect(";");
    return result;
}

Definition Parser::label() {
    Definition result;
    expect("label");
    result.name = quoted("the name of a label in double quotes");
    expect("=");
    result.body = expression();
    expect(";");
    return result;
}

/// `x : [lo..hi] | bool | int [init e];`
Variable Parser::variable() {
    Variable result;
    result.name = identifier("the name of a variable");
    expect(":");
    if (accept("[")) {
        result.low = expression();
        expect("..");
        result.high = expression();
        expect("]");
    } else if (accept("bool")) {
        result.type = Type::boolean;
    } else if (!accept("int")) {
        if (at("clock")) refuse("clocks (probabilistic timed automata)", peek().span);
        if (at("double")) refuse("variables of type double", peek().span);
        fail("a range [low..high], bool or int");
    }
    if (accept("init")) result.initial = expression();
    expect(";");
    return result;
}

void Parser::module(ModelFile& file) {
    expect("module");
    Module module;
    module.name = letter_or_identifier("the name of a module");
    if (accept("=")) {
        module.base = letter_or_identifier("the name of a module");
        expect("[");
        module.renamings = renamings("=", "]");
        expect("endmodule");
    } else {
        module_body(module);
    }
    file.modules.push_back(std::move(module));
}

void Parser::module_body(Module& module) {
    while (!accept("endmodule")) {
        if (at_end() || at("module") || at("rewards") || at("system")) fail("a declaration, a command or 'endmodule'");
        diagnostics_.poll();
        guarded(
            [&] {
                if (at("invariant")) refuse("invariants (probabilistic timed automata)", peek().span);
                if (at("["))
                    module.commands.push_back(command());
                else if (peek().kind == Tok::word && at(":", 1))
                    module.variables.push_back(variable());
                else
                    fail("a declaration, a command or 'endmodule'");
            },
            {"endmodule", "module", "rewards", "system"});
    }
}

std::vector<Renaming> Parser::renamings(std::string_view between, std::string_view end) {
    std::vector<Renaming> result;
    while (!at(end)) {
        Renaming renaming;
        // Functions may be renamed, although their names are reserved words.
        const auto side = [&] {
            const bool function = at("min") || at("max");
            if (!function) return identifier("a name");
            const Token& token = take();
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

/// `[act] guard -> upd;` or `... -> p1:upd + p2:upd + ...;`
Command Parser::command() {
    Command result;
    const Span from = expect("[");
    if (!at("]")) result.action = letter_or_identifier("the name of an action");
    expect("]");
    result.guard = expression();
    expect("->");
    do result.branches.push_back(branch());
    while (accept("+"));
    result.span = since(from);
    expect(";");
    return result;
}

/// An update begins with `true` or `(x'`; anything else is a probability.
Branch Parser::branch() {
    if (at("[")) refuse("intervals of probabilities", peek().span);
    const bool at_update =
        (at("(") && peek(1).kind == Tok::word && at("'", 2)) || (at("true") && (at(";", 1) || at("+", 1)));
    if (at_update) return update(nullptr);
    ExprPtr probability = expression();
    expect(":");
    return update(std::move(probability));
}

Branch Parser::update(ExprPtr probability) {
    Branch result;
    const Span from = probability ? probability->span : peek().span;
    result.probability = std::move(probability);
    if (!accept("true")) {
        do result.assignments.push_back(assignment());
        while (accept("&"));
    }
    result.span = since(from);
    return result;
}

Assignment Parser::assignment() {
    Assignment result;
    expect("(");
    result.variable = identifier("the name of a variable");
    expect("'");
    expect("=");
    result.value = expression();
    expect(")");
    return result;
}

void Parser::rewards(ModelFile& file) {
    expect("rewards");
    RewardStructure result;
    if (peek().kind == Tok::quoted) result.name = quoted("a name");
    while (!accept("endrewards")) {
        if (at_end() || at("module") || at("rewards")) fail("a reward or 'endrewards'");
        guarded([&] { result.items.push_back(reward_item()); }, {"endrewards", "module", "rewards"});
    }
    file.rewards.push_back(std::move(result));
}

RewardItem Parser::reward_item() {
    RewardItem item;
    const Span from = peek().span;
    if (accept("[")) {
        item.transition = true;
        if (!at("]")) item.action = letter_or_identifier("the name of an action");
        expect("]");
    }
    item.guard = expression();
    expect(":");
    item.value = expression();
    item.span = since(from);
    expect(";");
    return item;
}

void Parser::initial_states(ModelFile& file) {
    const Span span = expect("init");
    ExprPtr states = expression();
    expect("endinit");
    if (file.initial) diagnostics_.report(rules::given_twice, span, {"init ... endinit"});
    file.initial = std::move(states);
}

void Parser::composition(ModelFile& file) {
    const Span span = expect("system");
    if (peek().kind == Tok::quoted) refuse("several system blocks with names", peek().span);
    CompositionPtr system = parallel();
    expect("endsystem");
    if (file.system) diagnostics_.report(rules::given_twice, span, {"system ... endsystem"});
    file.system = std::move(system);
}

CompositionPtr Parser::make(Composition composition) {
    for (const CompositionPtr& part : composition.parts)
        composition.height = std::max(composition.height, part->height + 1);
    return std::make_shared<const Composition>(std::move(composition));
}

/// `a || b`, `a ||| b`, `a |[x,y]| b`; equal precedence, left-associative.
CompositionPtr Parser::parallel() {
    CompositionPtr left = composed();
    while (accept("|")) {
        Composition next;
        if (accept("[")) {
            next.kind = Composition::Kind::on_actions;
            do next.actions.push_back(letter_or_identifier("the name of an action"));
            while (accept(","));
            expect("]");
            expect("|");
        } else {
            expect("|");
            next.kind = accept("|") ? Composition::Kind::interleaved : Composition::Kind::common;
        }
        next.parts = {left, composed()};
        left = make(std::move(next));
        if (left->height > max_depth) fail(rules::too_deep, peek().span, {fmt::format("{}", max_depth)});
    }
    return left;
}

CompositionPtr Parser::composed() {
    CompositionPtr part = composed_operand();
    for (;;) {
        Composition next;
        if (accept("/")) {
            next.kind = Composition::Kind::hide;
            expect("{");
            do next.actions.push_back(letter_or_identifier("the name of an action"));
            while (accept(","));
            expect("}");
        } else if (accept("{")) {
            next.kind = Composition::Kind::rename;
            next.renamings = renamings("<-", "}");
        } else {
            return part;
        }
        next.parts = {part};
        part = make(std::move(next));
        if (part->height > max_depth) fail(rules::too_deep, peek().span, {fmt::format("{}", max_depth)});
    }
}

CompositionPtr Parser::composed_operand() {
    const Depth depth(*this);
    if (accept("(")) {
        CompositionPtr inner = parallel();
        expect(")");
        return inner;
    }
    Composition leaf;
    leaf.module = letter_or_identifier("the name of a module or '('");
    return make(std::move(leaf));
}

PropertyFile Parser::properties() {
    PropertyFile file;
    while (!at_end()) {
        diagnostics_.poll();
        guarded(
            [&] {
                if (accept(";")) return;
                if (at("const")) return constant(file.constants);
                if (at("label")) return file.labels.push_back(label());
                Property property;
                if (peek().kind == Tok::quoted && at(":", 1)) {
                    property.name = quoted("a name");
                    expect(":");
                }
                property.expression = expression();
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
    guarded(
        [&] {
            result = expression();
            (void)accept(";");
            if (!at_end()) fail("the end of the text");
        },
        {});
    return diagnostics_.ok() ? result : nullptr;
}

}  // namespace robochart::prism
