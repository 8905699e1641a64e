// SPDX-License-Identifier: Apache-2.0
// Inserts arguments into the message of a rule, and stores findings in a stable order.
#include "base/diagnostics/diagnostic.hpp"

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "base/diagnostics/containers.hpp"
#include "base/diagnostics/utf8.hpp"

namespace robochart::diagnostics {

std::string Diagnostic::message() const {
    fmt::dynamic_format_arg_store<fmt::format_context> store;
    for (const std::string& argument : arguments) store.push_back(argument);
    return fmt::vformat(fmt::string_view(rule->message.data(), rule->message.size()), store);
}

namespace {

/// Shortens a very long argument: people read messages, so only its beginning is shown. It is cut between two
/// characters.
void shorten_argument(std::string& argument) {
    constexpr std::size_t max_shown = 1000;
    if (argument.size() <= max_shown) return;
    argument.resize(beginning_of(argument, max_shown).size());
    argument += "...";
}

}  // namespace

Diagnostic& Diagnostics::report(const Rule& rule, Span span, std::vector<std::string> arguments) {
    std::ranges::for_each(arguments, shorten_argument);
    Diagnostic finding{&rule, span, std::move(arguments), {}, {}};
    if (rule.severity == Severity::warning && allowed_.contains(rule.code)) {
        overflow_ = std::move(finding);
        return overflow_;
    }
    if (rule.severity == Severity::error) ++errors_;
    if (rule.severity == Severity::warning) ++warnings_;
    if (rule.severity == Severity::error && span.is_known()) wrong_.insert(span.source);
    // Each severity has its own limit, so that many warnings cannot hide an error.
    std::size_t like_this = 0;
    if (rule.severity == Severity::error) like_this = errors_;
    if (rule.severity == Severity::warning) like_this = warnings_;
    if (like_this > max_kept) {
        ++dropped_;
        overflow_ = std::move(finding);
        return overflow_;
    }
    items_.push_back(std::move(finding));
    return items_.back();
}

void Diagnostics::add(const Diagnostics& other) {
    const auto stored_count = [&](Severity severity) {
        return static_cast<std::size_t>(std::ranges::count_if(
            other.items_, [&](const Diagnostic& finding) { return finding.rule->severity == severity; }));
    };
    for (const Diagnostic& finding : other.items_) report(*finding.rule, finding.span, finding.arguments) = finding;
    errors_ += other.errors_ - stored_count(Severity::error);
    warnings_ += other.warnings_ - stored_count(Severity::warning);
    dropped_ += other.dropped_;
    wrong_.insert(other.wrong_.begin(), other.wrong_.end());
}

Diagnostics Diagnostics::findings_in_texts(const std::set<SourceId>& texts) const {
    Diagnostics result;
    result.budget_ = budget_;
    result.allowed_ = allowed_;
    for (const Diagnostic& finding : items_)
        if (texts.contains(finding.span.source))
            result.report(*finding.rule, finding.span, finding.arguments) = finding;
    return result;
}

std::string Diagnostics::first_error() const {
    for (const Diagnostic& finding : sorted_findings())
        if (finding.rule->severity == Severity::error) return finding.message();
    return "";
}

std::vector<Diagnostic> Diagnostics::sorted_findings() const {
    std::vector<Diagnostic> result = items_;
    const auto key = [](const Diagnostic& d) {
        return std::make_tuple(d.span.source, d.span.begin, d.span.end, d.rule->code);
    };
    std::ranges::stable_sort(result, [&](const Diagnostic& a, const Diagnostic& b) { return key(a) < key(b); });
    // Constructs that are processed twice, for the timed and the untimed semantics, report the same note twice.
    const auto noted = [](const Diagnostic& a, const Diagnostic& b) {
        return a.rule == b.rule && a.rule->severity == Severity::note && a.span.source == b.span.source &&
               a.span.begin == b.span.begin && a.span.end == b.span.end && a.arguments == b.arguments;
    };
    erase_repeated(result, noted);
    return result;
}

}  // namespace robochart::diagnostics
