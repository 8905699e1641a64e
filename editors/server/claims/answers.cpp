// SPDX-License-Identifier: Apache-2.0
// Reports the findings about claims files, and answers requests.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>

#include "claims/syntax/layout.hpp"
#include "claims/syntax/lexer.hpp"
#include "editors/server/claims/claim_texts.hpp"
#include "editors/server/documents/text_difference.hpp"

namespace robochart::lsp {
namespace {

struct Keyword {
    std::string_view word, meaning;
};
/// The words of claims with their meaning (docs/claims.md).
constexpr std::array<Keyword, 53> keywords{{
    {"after", "the scope begins behind this event"},
    {"always", "`always P`: P holds at the end of each instant, when time passes"},
    {"and", "both conditions"},
    {"any", "`any call`, `any input`: all calls or all inputs, but those behind `but`"},
    {"assume", "`assume NAME : obstacle leads to clear within 60 s`: runs that break it are not considered"},
    {"at", "`at least D after`, `at most N`, `at least every D`"},
    {"before", "the scope ends before this event; `leads to B before C`: no C comes before the B"},
    {"but", "the exceptions of `any call` and `any input`"},
    {"call", "the calls of an operation"},
    {"can", "`can take E within D`: if E is raised, the machine offers to take it at most D later"},
    {"claim", "`claim NAME [of COMPONENT] : [scope ,] body`"},
    {"constant", "`with constant C of COMPONENT set to V`: the claim is about this value of the constant"},
    {"cycle", "`in a cycle with E`: each control cycle in which E is raised"},
    {"drops", "`order COMPONENT : E drops F`: in a cycle with E, F counts as not raised"},
    {"each", "`after each E`: the scope begins anew after each E"},
    {"enter", "`enter STATE`: the beginning of `in STATE`"},
    {"every", "`E at least every D`: the next E comes at most D later"},
    {"first", "`after first E`: the scope begins once; `order MACHINE : E first`: before other events"},
    {"for", "`for D after E`: from an E until D after the last E, the instant at D included"},
    {"h", "hours"},
    {"import", "`import PACKAGE::*`: the claims are about components of this package"},
    {"in", "`in STATE`: the state is active; `in E`: the input; `in any D`: in each window of this length"},
    {"input", "`any input`: all inputs"},
    {"last", "`last E`: the value that E carried last; a condition with it is false before the first E"},
    {"leads", "`A leads to B within D`: after each A, a B comes at most D later; one B answers all A before it"},
    {"least", "`at least D after`: not sooner; exactly D is allowed"},
    {"leave", "`leave STATE`: the end of `in STATE`"},
    {"min", "minutes"},
    {"most", "`at most N E`: a count in the scope"},
    {"ms", "milliseconds"},
    {"never", "the event does not come in the scope"},
    {"not", "the negation of a condition"},
    {"of", "`claim NAME of COMPONENT`: a module, a controller or a machine"},
    {"only", "`A only after B`: no A before the first B"},
    {"or", "events or conditions, one of them"},
    {"order", "`order MACHINE : E first`: the code tries the transitions with trigger E first"},
    {"out", "the output of this name"},
    {"package", "the package of the file"},
    {"possible", "some run has this event in the scope"},
    {"raised", "an input is present in a cycle, also if the controller does not take it"},
    {"s", "seconds"},
    {"set", "`with constant C of COMPONENT set to V`"},
    {"start", "the beginning of the run"},
    {"take", "`can take E`"},
    {"terminate", "the end of the component"},
    {"to", "`A leads to B`"},
    {"unit", "`unit 0.1 s`: the length of a time unit, once for a project"},
    {"units", "time units of the model"},
    {"unless", "this event also ends what is owed"},
    {"until", "the scope ends before this event, which need not come"},
    {"while", "`while P`: the scope lasts as long as P holds"},
    {"with", "a condition on the values of the event, or `with constant C of COMPONENT set to V`"},
    {"within", "at most so much later; exactly so much is allowed"},
}};

std::string direction_text(const claims::Channel& channel) {
    switch (channel.kind) {
        case claims::ChannelKind::input:
            return "input";
        case claims::ChannelKind::output:
            return "output";
        case claims::ChannelKind::call:
            break;
    }
    return "operation of the platform";
}

std::string type_names(const claims::Channel& channel, const ir::System& system) {
    std::vector<std::string> names;
    for (const ir::TypeId type : channel.types) names.push_back(system.type(type).name);
    return names.empty() ? "" : fmt::format("({})", fmt::join(names, ", "));
}

std::string shown_lines(std::vector<std::string> lines) {
    constexpr std::size_t most = 6;
    if (lines.size() > most) lines.resize(most);
    return fmt::format("{}", fmt::join(lines, "\n\n"));
}

/// Returns one line for each component that has the name: "`goTo(nat)`: operation of the platform of p::Patrol".
std::string about_channels(const std::string& name, const ClaimedModels& models) {
    std::vector<std::string> lines;
    for (const claims::Component& component : models.components)
        for (const claims::Channel& channel : component.channels)
            if (channel.name == name)
                lines.push_back(fmt::format("`{}{}`: {} of {}", name, type_names(channel, models.system),
                                            direction_text(channel), component.path));
    return shown_lines(std::move(lines));
}

/// "`patience`: constant of p::Patrol, nat", one line for each component that has the constant.
std::string about_constants(const std::string& name, const ClaimedModels& models) {
    std::vector<std::string> lines;
    for (const claims::Component& component : models.components)
        for (const claims::ComponentConstant& constant : component.constants)
            if (constant.name == name)
                lines.push_back(fmt::format("`{}`: constant of {}, {}", name, component.path,
                                            models.system.type(constant.type).name));
    return shown_lines(std::move(lines));
}

const claims::Claim* claim_named(const claims::ClaimFile& file, const std::string& name) {
    const auto found = std::ranges::find(file.claims, name, [](const claims::Claim& claim) { return claim.name.text; });
    return found == file.claims.end() ? nullptr : &*found;
}

/// Returns the declarations of events and operations with this name.
std::vector<Span> declarations_of(const std::string& name, const ir::System& system) {
    std::vector<Span> result;
    const auto add = [&](const auto& list) {
        for (const auto& declared : list)
            if (declared.name == name && declared.origin.span.is_known() &&
                std::ranges::find(result, declared.origin.span) == result.end())
                result.push_back(declared.origin.span);
    };
    for (const ir::Module& module : system.modules) {
        add(module.platform.events);
        add(module.platform.operations);
        add(module.platform.constants);
    }
    for (const ir::Controller& controller : system.controllers) {
        add(controller.events);
        add(controller.operations);
        add(controller.constants);
    }
    for (const ir::Machine& machine : system.machines) {
        add(machine.events);
        add(machine.operations);
        add(machine.constants);
    }
    return result;
}

}  // namespace

Json ClaimTexts::findings_in(TextDocument& document) {
    return list_findings(document, reading_of(document).findings);
}

Json ClaimTexts::hover(const Request& request) {
    const ClaimReading& reading = reading_of(request.document);
    const ClaimWord word = claim_word_at(request.document, request.offset);
    Hover hover;
    hover.place = word.span;
    if (const claims::Claim* const claim = claim_named(*reading.file, word.text))
        hover.text = fmt::format("claim `{}`: {}", claim->name.text, claim->wording);
    if (hover.text.empty() && reading.models != nullptr) hover.text = about_channels(word.text, *reading.models);
    if (hover.text.empty() && reading.models != nullptr) hover.text = about_constants(word.text, *reading.models);
    const auto keyword = std::ranges::find(keywords, word.text, &Keyword::word);
    if (hover.text.empty() && keyword != keywords.end()) hover.text = keyword->meaning;
    return hover_answer(request, std::move(hover), reading.findings.sorted_findings());
}

Json ClaimTexts::definition(const Request& request) {
    const ClaimReading& reading = reading_of(request.document);
    const ClaimWord word = claim_word_at(request.document, request.offset);
    if (const claims::Claim* const claim = claim_named(*reading.file, word.text))
        return Json::array({location_in(request.document, claim->name.span)});
    if (reading.models == nullptr || word.text.empty()) return {};
    Json result = Json::array();
    const SourceManager& sources = reading.models->sources;
    for (const Span span : declarations_of(word.text, reading.models->system))
        result.push_back(Json::object({{"uri", uri_of_path(sources.path(span.source))},
                                       {"range", lsp_range(sources, span, session_.client.encoding)}}));
    return result;
}

Json ClaimTexts::completion(const Request& request) {
    const TextDocument& document = request.document;
    const ClaimReading& reading = reading_of(request.document);
    const ClaimWord word = claim_word_at(document, request.offset);
    const Json edited =
        lsp_range(document.sources, {document.source, word.span.begin, request.offset}, session_.client.encoding);
    const std::string_view before =
        std::string_view(document.sources.source_text(document.source)).substr(0, word.span.begin);
    constexpr int keyword = 14, event = 23, method = 2, module = 9, state = 20, variable = 6;
    Json items = Json::array();
    std::set<std::string> seen;
    const auto add = [&](const std::string& text, int kind, const std::string& detail) {
        if (!seen.insert(text).second) return;
        items.push_back(Json::object({{"label", text},
                                      {"kind", kind},
                                      {"detail", detail},
                                      {"textEdit", Json::object({{"range", edited}, {"newText", text}})}}));
    };
    const NamePlace place = name_place(before);
    const bool component = place.word == "of";
    const bool names_state = place.word == "in" || place.word == "enter" || place.word == "leave";
    if (reading.models != nullptr && names_state)
        for (const std::string& path : states_after(place.qualifier, *reading.models)) add(path, state, "state");
    if (!place.qualifier.empty()) return Json::object({{"isIncomplete", false}, {"items", std::move(items)}});
    const bool constant = place.word == "constant";
    if (reading.models != nullptr && constant)
        for (const claims::Component& of : reading.models->components)
            for (const claims::ComponentConstant& known : of.constants)
                add(known.name, variable, fmt::format("constant of {}", of.path));
    const bool other = !component && !constant;
    if (reading.models != nullptr && other)
        for (const ir::Machine& machine : reading.models->system.machines)
            for (const ir::Variable& known : machine.variables)
                add(known.name, variable, fmt::format("variable of {}", machine.name));
    if (reading.models != nullptr)
        for (const claims::Component& of : reading.models->components) {
            if (component) add(of.path, module, "");
            for (const claims::Channel& channel : of.channels)
                if (other)
                    add(channel.name, channel.kind == claims::ChannelKind::call ? method : event,
                        direction_text(channel) + type_names(channel, reading.models->system));
        }
    if (other)
        for (const Keyword& known : keywords) add(std::string(known.word), keyword, std::string(known.meaning));
    return Json::object({{"isIncomplete", false}, {"items", std::move(items)}});
}

Json ClaimTexts::document_symbols(const Request& request) {
    const TextDocument& document = request.document;
    constexpr int property = 7;
    Json result = Json::array();
    for (const claims::Claim& claim : reading_of(request.document).file->claims) {
        const Json range = lsp_range(document.sources, claim.span, session_.client.encoding);
        const Json name = lsp_range(document.sources, claim.name.span, session_.client.encoding);
        result.push_back(Json::object({{"name", claim.name.text},
                                       {"detail", claim.wording},
                                       {"kind", property},
                                       {"range", range},
                                       {"selectionRange", name}}));
    }
    return result;
}

Json ClaimTexts::formatting(const Request& request) {
    const TextDocument& document = request.document;
    diagnostics::Diagnostics ignored;
    return formatting_edits(document.sources, document.source,
                            claims::format(document.sources, document.source, ignored), session_.client.encoding);
}

/// Accepts only names of claims, because names of events belong to the model.
Json ClaimTexts::prepare_rename(const Request& request) {
    const ClaimWord word = claim_word_at(request.document, request.offset);
    const claims::Claim* const claim = claim_named(*reading_of(request.document).file, word.text);
    if (claim == nullptr || !(claim->name.span == word.span))
        throw Refusal(ErrorCode::request_failed,
                      "only the names of claims are renamed here; rename others in the model");
    return lsp_range(request.document.sources, word.span, session_.client.encoding);
}

Json ClaimTexts::rename(const Request& request) {
    const Json range = prepare_rename(request);
    const std::string name(request.params["newName"].text());
    diagnostics::Diagnostics findings;
    const auto tokens = claims::lex(name, request.document.source, findings);
    if (!findings.ok() || tokens.size() != 2 || tokens.front().kind != claims::Tok::word ||
        tokens.front().text.find(':') != std::string_view::npos)
        throw Refusal(ErrorCode::request_failed, fmt::format("`{}` is no name of a claim", name));
    if (claim_named(*reading_of(request.document).file, name) != nullptr)
        throw Refusal(ErrorCode::request_failed, fmt::format("another claim is called `{}`", name));
    return Json::object(
        {{"changes",
          Json::object({{request.document.uri, Json::array({Json::object({{"range", range}, {"newText", name}})})}})}});
}

Json ClaimTexts::code_actions(const Request& request) {
    const TextDocument& document = request.document;
    Json result = Json::array();
    for (const diagnostics::Diagnostic& finding : reading_of(request.document).findings.sorted_findings())
        for (const diagnostics::FixIt& fix : finding.fixes) {
            const Json range = lsp_range(document.sources, fix.span, session_.client.encoding);
            const Json edit = Json::object({{"range", range}, {"newText", fix.replacement}});
            result.push_back(Json::object(
                {{"title", fix.title},
                 {"kind", "quickfix"},
                 {"edit", Json::object({{"changes", Json::object({{document.uri, Json::array({edit})}})}})}}));
        }
    return result;
}

}  // namespace robochart::lsp
