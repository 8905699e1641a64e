// SPDX-License-Identifier: Apache-2.0
#include "checker/certify/certificate.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>
#include <vector>

#include "base/cache/sha256.hpp"
#include "base/diagnostics/files.hpp"
#include "checker/certify/process_text.hpp"
#include "checker/certify/term_text.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "checker/refine/search/budget.hpp"

namespace robochart::certify {
namespace {

using cspm::Assertion;
using cspm::AssertionKind;

constexpr const char* refinement_in_divergences = "refinement in the failures-divergences model";

/// A claim in the words of a certificate, or the reason why there are no certificates for it.
struct Words {
    std::optional<std::string> claim;
    std::string reason;
};

/// Returns the model of the assertion in words; "" if it is not supported. The default is failures-divergences.
std::string model_words(const Assertion& assertion) {
    switch (assertion.model) {
        case cspm::Model::traces:
            return "traces model";
        case cspm::Model::failures:
            return "failures model";
        case cspm::Model::none:
        case cspm::Model::failures_divergences:
            return "failures-divergences model";
        default:
            return "";
    }
}

Words claim_words(const Assertion& assertion) {
    const bool divergence =
        assertion.model == cspm::Model::none || assertion.model == cspm::Model::failures_divergences;
    const std::string model = model_words(assertion);
    if (model.empty()) return {std::nullopt, "there are no certificates for this model"};
    if (assertion.kind == AssertionKind::refinement)
        return {fmt::format("{}refinement in the {}", assertion.negated ? "no " : "", model), ""};
    if (assertion.negated) return {std::nullopt, "it rests on an assertion about one process that fails"};
    switch (assertion.kind) {
        case AssertionKind::refinement:
            break;
        case AssertionKind::deadlock_free:
            return {divergence ? "deadlock and divergence freedom" : "deadlock freedom", ""};
        case AssertionKind::divergence_free:
            return {"divergence freedom", ""};
        case AssertionKind::deterministic:  // in T, the check is the same as in F
            return {fmt::format("determinism in the {}", divergence ? model : "failures model"), ""};
        case AssertionKind::has_trace:
            if (assertion.model == cspm::Model::traces) return {"the events are a trace", ""};
            return {std::nullopt, "there are no certificates for `has trace` in the models F and FD"};
    }
    return {std::nullopt, "there are no certificates for this kind of assertion"};
}

std::string claim_text(const std::string& words, const ClaimLines& lines, const Certificate& parts) {
    std::string text = fmt::format(
        "robochart-verify certificate 1\nclaim: {}\nassertion: {}\nsource: {}\nsource-sha256: {}\n"
        "level: {}, unreduced\nspecification-sha256: {}\nimplementation-sha256: {}\n",
        words, one_line(lines.assertion), one_line(lines.source), lines.source_digest, level_name(parts.level),
        parts.specification.empty() ? "-" : diagnostics::sha256(parts.specification),
        diagnostics::sha256(parts.implementation));
    return text + fmt::format("end-sha256: {}\n", diagnostics::sha256(text));
}

CertificateResult none(std::string reason) {
    return {std::nullopt, std::move(reason)};
}

/// A process of a claim.
struct Side {
    process::TermId term;
    diagnostics::Span span;
};

/// Returns the text of the term that an expression denotes. An error in a definition that no state reaches, and which
/// the search has not evaluated, is a reason for the product level.
TermText text_of_term(cspm::Session& session, const Side& side, const refine::Limits& limits,
                      diagnostics::Pollable& budget) {
    const auto has_few_states = [&](process::TermId term) {
        return explored_graph(*session.whole_system(term, side.span, limits), budget).has_value();
    };
    try {
        return term_text(session.terms(), side.term, has_few_states, budget);
    } catch (const cspm::EvaluationError& error) {
        return {std::nullopt, error.what()};
    } catch (const process::SemanticsError& error) {
        return {std::nullopt, error.what()};
    }
}

/// Replaces the compiled processes of a certificate by their terms if all of them can be written.
void replace_by_terms(cspm::Session& session, const std::vector<Side>& sides, const refine::Limits& limits,
                      diagnostics::Pollable& budget, Certificate& certificate) {
    std::vector<std::string> texts;
    for (const Side& side : sides) {
        TermText text = text_of_term(session, side, limits, budget);
        certificate.why_product = text.reason;
        if (!text.text) return;
        texts.push_back(std::move(*text.text));
    }
    certificate.level = Level::term;
    if (sides.size() == 2) certificate.specification = std::move(texts.front());
    certificate.implementation = std::move(texts.back());
}

/// Returns a certificate without a claim, or none if a process is too large. It contains the terms of the sides if
/// `highest` permits this and all terms can be written, and the compiled processes otherwise. There are two sides if
/// the claim is about a refinement.
std::optional<Certificate> certificate_of(cspm::Session& session, const std::vector<Side>& sides,
                                          const refine::Limits& limits, diagnostics::Pollable& budget, Level highest) {
    std::vector<std::string> texts;
    for (const Side& side : sides) {
        std::optional<std::string> text =
            process_text(*session.whole_system(side.term, side.span, limits), session.terms(), budget);
        if (!text) return std::nullopt;
        texts.push_back(std::move(*text));
    }
    Certificate result;
    result.level = Level::product;
    if (sides.size() == 2) result.specification = std::move(texts.front());
    result.implementation = std::move(texts.back());
    if (highest == Level::term) replace_by_terms(session, sides, limits, budget, result);
    return result;
}

/// Adds the claim to a certificate that has its other files.
CertificateResult with_claim(const std::string& words, const std::string& assertion, const std::string& source,
                             const cspm::Session& session, Certificate certificate) {
    const std::string digest = diagnostics::sha256(cspm::print(session.script()));
    certificate.claim = claim_text(words, {assertion, source, digest}, certificate);
    return {std::move(certificate), ""};
}

CertificateResult too_large() {
    return none(fmt::format("a process that is not compiled has more than {} states", most_explicit_states));
}

CertificateResult make_from_sides(const std::string& words, cspm::Session& session, const cspm::Decl& declaration,
                                  const std::string& source, const refine::Limits& limits, Level highest) {
    refine::Budget budget(limits, refine::Progress::Phase::compiling);
    const Assertion& assertion = declaration.assertion;
    std::vector<cspm::ExprPtr> expressions{assertion.specification};
    if (assertion.kind == AssertionKind::refinement) expressions.push_back(assertion.implementation);
    std::vector<Side> sides;
    for (const cspm::ExprPtr& expression : expressions)
        sides.push_back({session.side(expression, declaration, limits), expression->span});
    std::optional<Certificate> result = certificate_of(session, sides, limits, budget, highest);
    if (!result) return too_large();
    if (assertion.kind == AssertionKind::has_trace)
        result->specification = event_list_text(session.event_table(), session.trace(declaration));
    return with_claim(words, cspm::print(declaration), source, session, std::move(*result));
}

CertificateResult make_from_goal(cspm::Session& session, const StaysPossible& claim, const std::string& source,
                                 const refine::Limits& limits, Level highest) {
    refine::Budget budget(limits, refine::Progress::Phase::compiling);
    const Side side{session.process(claim.process, limits), claim.process->span};
    std::optional<Certificate> result = certificate_of(session, {side}, limits, budget, highest);
    if (!result) return too_large();
    const process::EventSet goal = session.events(claim.goal);
    result->specification = event_list_text(session.event_table(), {goal.begin(), goal.end()});
    const std::string statement =
        fmt::format("an event of {} stays possible in {}", cspm::print(claim.goal), cspm::print(claim.process));
    return with_claim("one of the events stays possible", statement, source, session, std::move(*result));
}

}  // namespace

const char* level_name(Level level) {
    return level == Level::term ? "term" : "product";
}

CertificateResult make_certificate(cspm::Session& session, const cspm::Decl& assertion, const std::string& source,
                                   const refine::Limits& limits, Level highest) {
    Words words = claim_words(assertion.assertion);
    if (!words.claim) return none(words.reason);
    if (assertion.assertion.tau_priority) *words.claim += " under tau priority";
    try {
        return make_from_sides(*words.claim, session, assertion, source, limits, highest);
    } catch (const process::Interrupted& limit) {
        return none(limit.what());
    }
}

CertificateResult make_certificate(cspm::Session& session, const StaysPossible& claim, const std::string& source,
                                   const refine::Limits& limits, Level highest) {
    try {
        return make_from_goal(session, claim, source, limits, highest);
    } catch (const process::Interrupted& limit) {
        return none(limit.what());
    }
}

Certificate refinement_certificate(const ClaimLines& lines, std::string specification, std::string implementation) {
    Certificate result;
    result.level = Level::product;
    result.specification = std::move(specification);
    result.implementation = std::move(implementation);
    result.claim = claim_text(refinement_in_divergences, lines, result);
    return result;
}

std::string write_certificate(const std::string& root, const std::string& folder, const Certificate& certificate,
                              diagnostics::Budget* budget) {
    const auto write = [&](const std::string& file, const std::string& text) {
        return diagnostics::write_below(root, fmt::format("{}/{}", folder, file), text, budget);
    };
    std::string error;
    if (!certificate.specification.empty()) error = write("specification.txt", certificate.specification);
    if (error.empty()) error = write("implementation.txt", certificate.implementation);
    for (const FurtherFile& file : certificate.further)
        if (error.empty()) error = write(file.path, file.text);
    if (error.empty()) error = write("claim.txt", certificate.claim);
    return error;
}

std::string folder_name(const std::string& number, const std::string& title) {
    constexpr std::size_t longest = 60;
    std::string name = number;
    bool gap = true;
    for (const char c : title) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (plain && gap) name += '-';
        if (plain) name += c;
        gap = !plain;
        if (name.size() >= longest) break;
    }
    return name;
}

}  // namespace robochart::certify
