// SPDX-License-Identifier: Apache-2.0
// Parses declarations and assertions, and checks which kinds of declarations a list allows.
#include <algorithm>
#include <array>
#include <map>

#include "base/diagnostics/spelling.hpp"
#include "checker/cspm/syntax/parser.hpp"
#include "checker/cspm/syntax/rules.hpp"

namespace robochart::cspm {

std::vector<DeclPtr> Parser::parse_script() {
    std::vector<DeclPtr> result;
    skip_newlines();
    while (!at_end()) {
        std::vector<DeclPtr> more = parse_declarations(Place::top, &Parser::at_end);
        result.insert(result.end(), more.begin(), more.end());
    }
    return result;
}

void Parser::skip_newlines() {
    while (accept(Tok::newline)) {
    }
}

// Parses declarations until `done` returns true. Catches errors, so that only one malformed declaration is skipped. In
// a `let`, passes the error on: the whole declaration that contains the `let` is skipped.
std::vector<DeclPtr> Parser::parse_declarations(Place place, bool (Parser::*done)() const) {
    std::vector<DeclPtr> result;
    skip_newlines();
    while (!(this->*done)()) {
        const Span from = peek().span;
        try {
            DeclPtr decl = parse_declaration(place);
            report_misplaced(*decl, place, diagnostics_);
            result.push_back(std::move(decl));
            if (!(this->*done)()) expect(Tok::newline);
        } catch (const SyntaxError&) {
            if (place == Place::let) throw;
            skip_malformed_declaration(from, done);
        }
        skip_newlines();
    }
    check_annotations(result);
    return result;
}

namespace {
constexpr std::size_t widest_margin = 200;

// Returns the column of the token, counted from 0, but at most `most`.
std::size_t width_before(const Token& token, std::size_t most) {
    std::size_t result = 0;
    while (result < most && result < token.span.begin && *(token.text.data() - result - 1) != '\n') ++result;
    return result;
}
}  // namespace

// Skips a malformed declaration: continues at the next line that is not indented more than the declaration.
void Parser::skip_malformed_declaration(Span from, bool (Parser::*done)() const) {
    open_sequences_ = 0;
    const auto first =
        std::ranges::lower_bound(tokens_, from.begin, {}, [](const Token& token) { return token.span.begin; });
    const bool known = first != tokens_.end() && !first->text.empty();
    const std::size_t limit = known ? width_before(*first, widest_margin) : 0;
    if (peek().span.begin == from.begin) take_token();
    while (!at_end()) {
        const bool line_start = at_ > 0 && tokens_[at_ - 1].kind == Tok::newline;
        if (line_start || at_token(Tok::r_brace)) {
            const bool outermost = !peek().text.empty() && width_before(peek(), limit + 1) <= limit;
            if (outermost || (this->*done)()) return;
        }
        take_token();
    }
}

DeclPtr Parser::parse_declaration(Place place) {
    const Depth guard(*this);
    switch (peek().kind) {
        case Tok::kw_channel:
            return parse_channel();
        case Tok::kw_datatype:
            return parse_datatype(DeclKind::datatype);
        case Tok::kw_subtype:
            return parse_datatype(DeclKind::subtype);
        case Tok::kw_nametype:
            return parse_nametype();
        case Tok::kw_module:
            return parse_module();
        case Tok::kw_instance:
            return parse_instance();
        case Tok::kw_timed:
            return parse_timed(place);
        case Tok::kw_transparent:
            return parse_name_list(DeclKind::transparent);
        case Tok::kw_external:
            return parse_name_list(DeclKind::external);
        case Tok::kw_assert:
            return parse_assertion();
        case Tok::print:
            return parse_print();
        case Tok::include:
            return parse_include();
        default:
            return annotation_ahead() ? parse_annotation() : parse_definition();
    }
}

bool Parser::annotation_ahead() const {
    std::size_t ahead = 0;
    while (peek(ahead).kind == Tok::identifier && peek(ahead + 1).kind == Tok::comma) ahead += 2;
    return peek(ahead).kind == Tok::identifier && peek(ahead + 1).kind == Tok::of_type;
}

// Parses a definition: f(p, q)(r) = e, or pattern = e.
DeclPtr Parser::parse_definition() {
    const Span from = peek().span;
    DeclNode result;
    if (at_token(Tok::identifier) && peek(1).kind == Tok::l_paren) {
        result.kind = DeclKind::function;
        result.names = {name_token()};
        while (accept(Tok::l_paren)) {
            result.patterns.push_back(at_token(Tok::r_paren) ? std::vector<PatternPtr>{} : parse_patterns());
            expect(Tok::r_paren);
        }
    } else {
        result.kind = DeclKind::value;
        result.patterns = {{parse_pattern()}};
    }
    expect(Tok::equals);
    result.body = parse_expression();
    return finish_node(std::move(result), from);
}

std::vector<std::string> Parser::parse_names() {
    std::vector<std::string> result{name_token()};
    while (accept(Tok::comma)) result.push_back(name_token());
    return result;
}

DeclPtr Parser::parse_channel() {
    const Span from = take_token().span;
    DeclNode result;
    result.kind = DeclKind::channel;
    result.names = parse_names();
    const bool typed =
        at_token(Tok::identifier) || at_token(Tok::l_brace) || at_token(Tok::l_paren) || at_token(Tok::dot);
    if (typed) fail("':'", "the type of a channel is written after a `:`, as in `channel c : T`", peek().span);
    if (accept(Tok::colon)) result.body = parse_expression();
    return finish_node(std::move(result), from);
}

DeclPtr Parser::parse_datatype(DeclKind kind) {
    const Span from = take_token().span;
    DeclNode result;
    result.kind = kind;
    result.names = {name_token()};
    expect(Tok::equals);
    do {
        const Span start = peek().span;
        Constructor constructor;
        constructor.name = name_token();
        if (accept(Tok::dot)) constructor.fields = parse_expression();
        constructor.span = span_since(start);
        result.constructors.push_back(std::move(constructor));
    } while (accept(Tok::pipe));
    return finish_node(std::move(result), from);
}

DeclPtr Parser::parse_nametype() {
    const Span from = take_token().span;
    DeclNode result;
    result.kind = DeclKind::nametype;
    result.names = {name_token()};
    expect(Tok::equals);
    result.body = parse_expression();
    return finish_node(std::move(result), from);
}

DeclPtr Parser::parse_module() {
    const Span from = take_token().span;
    DeclNode result;
    result.kind = DeclKind::module;
    result.names = {name_token()};
    if (accept(Tok::l_paren)) {
        result.parameters = parse_names();
        expect(Tok::r_paren);
    }
    expect(Tok::newline);
    result.decls = parse_declarations(Place::module, &Parser::at_exports);
    expect(Tok::kw_exports);
    expect(Tok::newline);
    result.exports = parse_declarations(Place::module, &Parser::at_endmodule);
    expect(Tok::kw_endmodule);
    return finish_node(std::move(result), from);
}

DeclPtr Parser::parse_instance() {
    const Span from = take_token().span;
    DeclNode result;
    result.kind = DeclKind::instance;
    result.names = {name_token()};
    expect(Tok::equals);
    result.text = parse_qualified_name();
    if (accept(Tok::l_paren)) {
        do result.arguments.push_back(parse_expression());
        while (accept(Tok::comma));
        expect(Tok::r_paren);
    }
    return finish_node(std::move(result), from);
}

DeclPtr Parser::parse_timed(Place place) {
    const Span from = take_token().span;
    DeclNode result;
    result.kind = DeclKind::timed;
    if (accept(Tok::l_paren)) {
        result.body = parse_expression();
        expect(Tok::r_paren);
    }
    expect(Tok::l_brace);
    result.decls = parse_declarations(timed_inside(place), &Parser::at_brace);
    expect(Tok::r_brace);
    return finish_node(std::move(result), from);
}

DeclPtr Parser::parse_name_list(DeclKind kind) {
    const Span from = take_token().span;
    DeclNode result;
    result.kind = kind;
    result.names = parse_names();
    return finish_node(std::move(result), from);
}

DeclPtr Parser::parse_annotation() {
    const Span from = peek().span;
    DeclNode result;
    result.kind = DeclKind::annotation;
    result.names = parse_names();
    expect(Tok::of_type);
    result.text = parse_type_scheme();
    return finish_node(std::move(result), from);
}

DeclPtr Parser::parse_print() {
    const Span from = take_token().span;
    DeclNode result;
    result.kind = DeclKind::print;
    result.body = parse_expression();
    return finish_node(std::move(result), from);
}

DeclPtr Parser::parse_include() {
    const Token& token = take_token();
    DeclNode result;
    result.kind = DeclKind::include;
    result.names = {std::string(token.text)};
    return finish_node(std::move(result), token.span);
}

// ---------------------------------------------------------------- assertions

namespace {

struct Refinement {
    Tok token;
    Model model;
};
constexpr std::array refinements{Refinement{Tok::refines_t, Model::traces},
                                 Refinement{Tok::refines_f, Model::failures},
                                 Refinement{Tok::refines_fd, Model::failures_divergences},
                                 Refinement{Tok::refines_v, Model::revivals},
                                 Refinement{Tok::refines_vd, Model::revivals_divergences},
                                 Refinement{Tok::refines_r, Model::refusals},
                                 Refinement{Tok::refines_rd, Model::refusals_divergences}};

struct ModelName {
    std::string_view text;
    Model model;
};
constexpr std::array model_names{ModelName{"T", Model::traces},
                                 ModelName{"F", Model::failures},
                                 ModelName{"FD", Model::failures_divergences},
                                 ModelName{"V", Model::revivals},
                                 ModelName{"VD", Model::revivals_divergences},
                                 ModelName{"R", Model::refusals},
                                 ModelName{"RD", Model::refusals_divergences}};

struct PropertyName {
    std::string_view text;
    AssertionKind kind;
};
constexpr std::array property_names{PropertyName{"deadlock free", AssertionKind::deadlock_free},
                                    PropertyName{"deadlock-free", AssertionKind::deadlock_free},
                                    PropertyName{"divergence free", AssertionKind::divergence_free},
                                    PropertyName{"divergence-free", AssertionKind::divergence_free},
                                    PropertyName{"livelock free", AssertionKind::divergence_free},
                                    PropertyName{"livelock-free", AssertionKind::divergence_free},
                                    PropertyName{"deterministic", AssertionKind::deterministic},
                                    PropertyName{"has trace", AssertionKind::has_trace}};

struct PropertyText {
    std::string words;
    std::string model;
};

// Splits the text `:[words [M]]:` into its parts.
PropertyText split_property(std::string_view text) {
    PropertyText result;
    text.remove_prefix(2);
    text = text.substr(0, text.rfind(']'));
    if (const std::size_t open = text.find('['); open != std::string_view::npos) {
        const std::string_view model = text.substr(open + 1);
        result.model = model.substr(0, model.find(']'));
        text = text.substr(0, open);
    }
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return result;
    result.words = text.substr(first, text.find_last_not_of(" \t") + 1 - first);
    return result;
}

bool is_option(const PropertyText& text) {
    return text.words == "tau priority" || text.words == "tau priority over" || text.words == "partial order reduce";
}

}  // namespace

DeclPtr Parser::parse_assertion() {
    const Span from = take_token().span;
    DeclNode result;
    result.kind = DeclKind::assertion;
    Assertion& assertion = result.assertion;
    assertion.negated = accept(Tok::kw_not);
    assertion.specification = parse_expression();
    const auto* refinement = std::ranges::find(refinements, peek().kind, &Refinement::token);
    if (refinement != refinements.end()) {
        take_token();
        assertion.model = refinement->model;
        assertion.implementation = parse_expression();
    } else if (at_token(Tok::property)) {
        parse_assertion_property(assertion, take_token());
    } else {
        fail("a refinement or a property");
    }
    parse_assertion_options(assertion);
    return finish_node(std::move(result), from);
}

void Parser::unknown_property(Span span, const std::string& words) {
    std::vector<std::string> names;
    for (const PropertyName& property : property_names) names.emplace_back(property.text);
    diagnostics::Diagnostic& finding = diagnostics_.report(rules::bad_property, span, {words});
    if (const std::string meant = diagnostics::nearest_spelling(words, names); !meant.empty())
        finding.notes.push_back({span, "did you mean '" + meant + "'?"});
    throw SyntaxError{};
}

void Parser::parse_assertion_property(Assertion& assertion, const Token& property) {
    const PropertyText text = split_property(property.text);
    const auto* found = std::ranges::find(property_names, text.words, &PropertyName::text);
    if (found == property_names.end()) unknown_property(property.span, text.words);
    assertion.kind = found->kind;
    if (!text.model.empty()) {
        const auto* model = std::ranges::find(model_names, text.model, &ModelName::text);
        if (model == model_names.end()) fail(rules::bad_property, property.span, {text.model});
        assertion.model = model->model;
    }
    if (assertion.kind == AssertionKind::has_trace) assertion.implementation = parse_trace();
}

ExprPtr Parser::parse_trace() {
    if (!at_token(Tok::less) && !at_token(Tok::empty_sequence)) fail("a sequence of events");
    return parse_angle_brackets();
}

void Parser::parse_assertion_options(Assertion& assertion) {
    while (at_token(Tok::property)) {
        const Token& token = take_token();
        const PropertyText text = split_property(token.text);
        if (!is_option(text)) fail(rules::bad_property, token.span, {text.words});
        const bool order = text.words == "partial order reduce";
        if (order ? assertion.partial_order : assertion.tau_priority != nullptr) {
            fail(rules::option_repeated, token.span, {text.words});
        }
        if (order)
            assertion.partial_order = true;
        else
            assertion.tau_priority = parse_expression();
    }
}

// ---------------------------------------------------------------- allowed kinds of declarations

namespace {

std::string_view kind_name(DeclKind kind) {
    switch (kind) {
        case DeclKind::function:
            return "a function";
        case DeclKind::value:
            return "a value";
        case DeclKind::channel:
            return "a channel";
        case DeclKind::datatype:
            return "a datatype";
        case DeclKind::subtype:
            return "a subtype";
        case DeclKind::nametype:
            return "a nametype";
        case DeclKind::module:
            return "a module";
        case DeclKind::instance:
            return "a module instance";
        case DeclKind::timed:
            return "a timed section";
        case DeclKind::transparent:
            return "a transparent function";
        case DeclKind::external:
            return "an external function";
        case DeclKind::annotation:
            return "a type annotation";
        case DeclKind::print:
            return "a print statement";
        case DeclKind::assertion:
            return "an assertion";
        case DeclKind::include:
            return "an include";
    }
    return "?";
}

bool allowed_in_let(DeclKind kind) {
    return kind == DeclKind::function || kind == DeclKind::value || kind == DeclKind::timed ||
           kind == DeclKind::transparent || kind == DeclKind::external || kind == DeclKind::annotation;
}

}  // namespace

Place timed_inside(Place outer) {
    switch (outer) {
        case Place::let:
            return Place::let;
        case Place::module:
        case Place::timed_in_module:
            return Place::timed_in_module;
        case Place::top:
        case Place::timed:
            break;
    }
    return Place::timed;
}

// Implements the rules of FDR's front end (libcspm, Parser.ppy).
std::string forbidden_place(DeclKind kind, Place place) {
    const bool asks = kind == DeclKind::assertion || kind == DeclKind::print;
    switch (place) {
        case Place::top:
            return "";
        case Place::module:
        case Place::timed_in_module:
            return asks ? "in a module" : "";
        case Place::timed:
            return kind == DeclKind::print ? "in a timed section" : "";
        case Place::let:
            return allowed_in_let(kind) ? "" : "in a let";
    }
    return "";
}

void report_misplaced(const Decl& decl, Place place, diagnostics::Diagnostics& diagnostics) {
    if (const std::string where = forbidden_place(decl.kind, place); !where.empty())
        diagnostics.report(rules::misplaced_declaration, decl.span, {std::string(kind_name(decl.kind)), where});
}

namespace {

std::vector<std::string> names_declared_by(const Decl& decl) {
    if (decl.kind == DeclKind::value && decl.patterns[0][0]->kind == PatternKind::name) {
        return {decl.patterns[0][0]->text};
    }
    if (decl.kind == DeclKind::datatype) {
        std::vector<std::string> result;
        for (const Constructor& constructor : decl.constructors) result.push_back(constructor.name);
        return result;
    }
    if (decl.kind == DeclKind::function || decl.kind == DeclKind::nametype || decl.kind == DeclKind::channel) {
        return decl.names;
    }
    return {};
}

}  // namespace

// Reports annotations whose names are not declared in the same list, and declarations with several annotations.
void Parser::check_annotations(const std::vector<DeclPtr>& decls) {
    std::map<std::string, const Decl*> annotated;
    for (const DeclPtr& decl : decls) {
        if (decl->kind != DeclKind::annotation) continue;
        for (const std::string& name : decl->names) {
            if (!annotated.emplace(name, decl.get()).second) {
                diagnostics_.report(rules::annotation_repeated, decl->span, {name});
            }
        }
    }
    if (annotated.empty()) return;
    for (const DeclPtr& decl : decls) {
        std::size_t found = 0;
        for (const std::string& name : names_declared_by(*decl)) {
            found += annotated.erase(name);
            if (decl->kind == DeclKind::channel && found > 1) {
                diagnostics_.report(rules::annotation_repeated, decl->span, {name});
            }
        }
    }
    for (const auto& [name, decl] : annotated) diagnostics_.report(rules::annotation_unused, decl->span, {name});
}

}  // namespace robochart::cspm
