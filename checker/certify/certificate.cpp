// SPDX-License-Identifier: Apache-2.0
#include "checker/certify/certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "base/cache/sha256.hpp"
#include "base/diagnostics/files.hpp"
#include "checker/certify/process_text.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "checker/refine/search/budget.hpp"

namespace robochart::certify {
namespace {

using cspm::Assertion;
using cspm::AssertionKind;

/// Returns the text that states the claim of the assertion in a certificate. Returns no value if certificates do not
/// support this kind of assertion.
std::optional<std::string> claim_words(const Assertion& assertion) {
    const bool divergence =
        assertion.model == cspm::Model::none || assertion.model == cspm::Model::failures_divergences;
    switch (assertion.kind) {
        case AssertionKind::refinement:
            if (assertion.model == cspm::Model::traces) return "refinement in the traces model";
            if (assertion.model == cspm::Model::failures) return "refinement in the failures model";
            if (divergence) return "refinement in the failures-divergences model";
            return std::nullopt;
        case AssertionKind::deadlock_free:
            return divergence ? "deadlock and divergence freedom" : "deadlock freedom";
        case AssertionKind::divergence_free:
            return "divergence freedom";
        case AssertionKind::deterministic:
        case AssertionKind::has_trace:
            break;
    }
    return std::nullopt;
}

std::string claim_text(const std::string& words, const cspm::Session& session, const cspm::Decl& assertion,
                       const std::string& source, const Certificate& parts) {
    std::string text = fmt::format(
        "robochart-verify certificate 1\nclaim: {}\nassertion: {}\nsource: {}\nsource-sha256: {}\n"
        "level: product, unreduced\nspecification-sha256: {}\nimplementation-sha256: {}\n",
        words, one_line(cspm::print(assertion)), one_line(source), diagnostics::sha256(cspm::print(session.script())),
        parts.specification.empty() ? "-" : diagnostics::sha256(parts.specification),
        diagnostics::sha256(parts.implementation));
    return text + fmt::format("end-sha256: {}\n", diagnostics::sha256(text));
}

/// Returns true if the declaration is inside a module or a timed section.
bool is_nested(const std::vector<cspm::DeclPtr>& declarations, const cspm::Decl& searched, bool inside) {
    return std::ranges::any_of(declarations, [&](const cspm::DeclPtr& one) {
        return (inside && one.get() == &searched) || is_nested(one->decls, searched, true) ||
               is_nested(one->exports, searched, true);
    });
}

CertificateResult none(std::string reason) {
    return {std::nullopt, std::move(reason)};
}

CertificateResult make_from_sides(const std::string& words, cspm::Session& session, const cspm::Decl& assertion,
                                  const std::string& source, const refine::Limits& limits) {
    refine::Budget budget(limits, refine::Progress::Phase::compiling);
    const auto text_of = [&](const cspm::ExprPtr& expression) {
        const std::unique_ptr<lts::TransitionSystem> side = session.whole_system(expression, limits);
        side->set_budget(budget);
        const auto text = process_text(*side, session.terms(), budget);
        side->set_budget(diagnostics::unlimited);
        return text;
    };
    const bool refinement = assertion.assertion.kind == AssertionKind::refinement;
    const std::optional<ProcessText> first = text_of(assertion.assertion.specification);
    const std::optional<ProcessText> second = refinement ? text_of(assertion.assertion.implementation) : std::nullopt;
    if (!first || (refinement && !second))
        return none(fmt::format("a process that is not compiled has more than {} states", most_explicit_states));
    Certificate result;
    result.specification = refinement ? first->text : "";
    result.implementation = refinement ? second->text : first->text;
    result.claim = claim_text(words, session, assertion, source, result);
    return {std::move(result), ""};
}

}  // namespace

CertificateResult make_certificate(cspm::Session& session, const cspm::Decl& assertion, const std::string& source,
                                   const refine::Limits& limits) {
    const std::optional<std::string> words = claim_words(assertion.assertion);
    if (!words) return none("there are no certificates for this kind of assertion");
    if (assertion.assertion.negated)
        return none("it rests on an assertion that fails, and certificates say that assertions hold");
    if (assertion.assertion.tau_priority) return none("there are no certificates for `tau priority`");
    if (is_nested(session.script().decls, assertion, false))
        return none("there are no certificates for assertions inside modules and timed sections");
    try {
        return make_from_sides(*words, session, assertion, source, limits);
    } catch (const process::Interrupted& limit) {
        return none(limit.what());
    }
}

std::string write_certificate(const std::string& root, const std::string& folder, const Certificate& certificate,
                              diagnostics::Budget* budget) {
    const auto write = [&](const char* file, const std::string& text) {
        return diagnostics::write_below(root, fmt::format("{}/{}", folder, file), text, budget);
    };
    std::string error;
    if (!certificate.specification.empty()) error = write("specification.txt", certificate.specification);
    if (error.empty()) error = write("implementation.txt", certificate.implementation);
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
