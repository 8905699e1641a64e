// SPDX-License-Identifier: Apache-2.0
#include "base/repair/repair.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <tuple>

#include "base/diagnostics/fixes.hpp"

namespace robochart::diagnostics {

namespace {

using IsSyntax = std::function<bool(const Rule&)>;

/// The file, code and message of a finding, without its position in the file.
using Said = std::tuple<std::string, std::string, std::string>;

/// Levels of findings. A lower level can hide findings of a higher level: syntax errors hide other errors, and errors
/// hide warnings.
enum class Level : std::size_t { syntax, error, warning };
constexpr std::array levels{Level::syntax, Level::error, Level::warning};

Level level_of(const Rule& rule, const IsSyntax& is_syntax) {
    if (is_syntax(rule)) return Level::syntax;
    return rule.severity == Severity::error ? Level::error : Level::warning;
}

/// The findings in some texts.
struct Faults {
    std::array<std::multiset<Said>, levels.size()> found;
    std::size_t dropped = 0;

    [[nodiscard]] const std::multiset<Said>& at_level(Level level) const {
        return found.at(static_cast<std::size_t>(level));
    }
    [[nodiscard]] std::size_t count() const {
        std::size_t sum = dropped;
        for (const auto& candidates : found) sum += candidates.size();
        return sum;
    }
};

Faults faults_of(const TextReading& reading, const IsSyntax& is_syntax) {
    Faults result;
    for (const Diagnostic& finding : reading.findings.sorted_findings()) {
        if (finding.rule->severity == Severity::note) continue;
        const std::string path = finding.span.is_known() ? reading.sources.path(finding.span.source) : std::string();
        result.found.at(static_cast<std::size_t>(level_of(*finding.rule, is_syntax)))
            .emplace(path, std::string(finding.rule->code), finding.message());
    }
    result.dropped = reading.findings.dropped_count();
    return result;
}

bool includes_all(const std::multiset<Said>& all, const std::multiset<Said>& some) {
    return std::ranges::includes(all, some);
}

/// A fix in a file, with the finding to which it belongs.
struct Candidate {
    std::string path;
    FixIt fix;
    RefusedFix otherwise;
};

/// Returns the text that was first registered under this path, which is the whole file. Later texts under the same path
/// may have blanked parts.
SourceId first_of_path(const SourceManager& sources, SourceId source) {
    const std::string& path = sources.path(source);
    for (std::uint32_t i = 0; i < sources.size(); ++i)
        if (sources.path(SourceId{i}) == path) return SourceId{i};
    return source;
}

std::vector<Candidate> collect_candidates(const TextReading& reading, const Texts& texts, Level level,
                                          const IsSyntax& is_syntax) {
    Diagnostics fixable;
    std::set<SourceId> sources;
    for (Diagnostic finding : reading.findings.sorted_findings()) {
        if (level_of(*finding.rule, is_syntax) != level || finding.fixes.empty() ||
            !finding.fixes.front().span.is_known())
            continue;
        SourceId& source = finding.fixes.front().span.source;
        source = first_of_path(reading.sources, source);
        if (!texts.contains(reading.sources.path(source))) continue;
        finding.span.source = source;
        sources.insert(source);
        fixable.report(*finding.rule, finding.span, finding.arguments) = finding;
    }
    std::vector<Candidate> result;
    for (const SourceId source : sources)
        for (FixIt& fix : certain_fixes(fixable, source)) {
            const Span place{source, fix.span.begin, fix.span.end};
            RefusedFix otherwise{reading.sources.path_and_line(place), {}, fix.replacement};
            for (const Diagnostic& finding : fixable.sorted_findings())
                if (!finding.fixes.empty() && finding.fixes.front().span == fix.span &&
                    finding.fixes.front().replacement == fix.replacement)
                    otherwise.code = finding.rule->code;
            result.push_back({reading.sources.path(source), std::move(fix), std::move(otherwise)});
        }
    return result;
}

Texts apply_candidates(const Texts& texts, const std::vector<Candidate>& all) {
    std::map<std::string, std::vector<FixIt>> fixes;
    for (const Candidate& candidate : all) fixes[candidate.path].push_back(candidate.fix);
    Texts result = texts;
    for (auto& [path, list] : fixes) {
        std::ranges::stable_sort(list, {}, [](const FixIt& fix) { return fix.span.begin; });
        result[path] = apply_fixes(texts.at(path), list);
    }
    return result;
}

/// Applies the fixes of one level. It repeats this as long as applied fixes uncover further fixes.
class Repairer {
public:
    Repairer(Texts& texts, Level level, const ReadTexts& read, const IsSyntax& is_syntax)
        : texts_(texts), level_(level), read_(read), is_syntax_(is_syntax) {}

    void run(Repaired& result) {
        for (bool again = true; again && ++rounds_ <= most_rounds;) {
            again = apply_round() || with_what_follows();
            result.made += made_.size();
            made_.clear();
        }
        for (const Candidate& candidate : refused_) result.refused.push_back(candidate.otherwise);
    }

private:
    static constexpr int most_rounds = 20;

    /// Applies the fixes of the current findings. Returns true if a fix was applied.
    bool apply_round() {
        before_ = texts_;
        refused_.clear();
        const std::unique_ptr<TextReading> reading = read_(texts_);
        now_ = faults_of(*reading, is_syntax_);
        const std::vector<Candidate> all = collect_candidates(*reading, texts_, level_, is_syntax_);
        try_fixes(all);
        return !made_.empty();
    }

    void try_fixes(std::span<const Candidate> group) {
        if (group.empty()) return;
        Texts with = texts_with(group);
        Faults then = faults_of(*read_(with), is_syntax_);
        if (is_better(then, group.size())) {
            made_.insert(made_.end(), group.begin(), group.end());
            texts_ = std::move(with);
            now_ = std::move(then);
        } else if (group.size() == 1) {
            refused_.push_back(group.front());
        } else {
            const std::size_t half = group.size() / 2;
            try_fixes(group.first(half));
            try_fixes(group.subspan(half));
        }
    }

    /// Tries each refused fix together with the fixes that it uncovers, because a fix may uncover another mistake that
    /// can be fixed. Returns true if fixes were applied.
    bool with_what_follows() {
        for (const Candidate& first : refused_) {
            constexpr int most_steps = 4;
            std::vector<Candidate> done{first};
            Texts with = texts_with(done);
            for (int step = 0; step < most_steps; ++step) {
                const std::unique_ptr<TextReading> reading = read_(with);
                Faults then = faults_of(*reading, is_syntax_);
                if (is_better(then, 1)) {
                    texts_ = std::move(with);
                    made_ = std::move(done);
                    return true;
                }
                const std::vector<Candidate> next = collect_candidates(*reading, with, level_, is_syntax_);
                if (next.empty()) break;
                with = apply_candidates(with, next);
                done.insert(done.end(), next.begin(), next.end());
            }
        }
        return false;
    }

    /// Returns the texts at the beginning of the round, with the fixes applied so far in this round and the fixes of
    /// this group.
    [[nodiscard]] Texts texts_with(std::span<const Candidate> group) const {
        std::vector<Candidate> all = made_;
        all.insert(all.end(), group.begin(), group.end());
        return apply_candidates(before_, all);
    }

    /// Returns true if the findings `then`, after this many further fixes, are better than the present findings. If
    /// there are hundreds of findings, not all of them are stored, so only their numbers are compared.
    [[nodiscard]] bool is_better(const Faults& then, std::size_t fixes) const {
        if (now_.dropped > 0 || then.dropped > 0) return then.count() + fixes <= now_.count();
        for (const Level level : levels) {
            if (!includes_all(now_.at_level(level), then.at_level(level))) return false;
            if (level == level_) break;
        }
        return then.at_level(level_).size() + fixes <= now_.at_level(level_).size();
    }

    Texts& texts_;
    Level level_;
    const ReadTexts& read_;
    const IsSyntax& is_syntax_;
    int rounds_ = 0;
    Texts before_;
    Faults now_;
    std::vector<Candidate> made_;     ///< fixes of this round
    std::vector<Candidate> refused_;  ///< fixes of this round
};

}  // namespace

Repaired repair(const Texts& texts, const ReadTexts& read, const IsSyntax& is_syntax) {
    Repaired result;
    Texts now = texts;
    for (const Level level : levels) Repairer(now, level, read, is_syntax).run(result);
    for (const auto& [path, text] : now)
        if (texts.at(path) != text) result.texts.emplace(path, text);
    return result;
}

}  // namespace robochart::diagnostics
