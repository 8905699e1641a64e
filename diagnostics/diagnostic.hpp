// Diagnostics as data: a rule from a table, a place, arguments; drawing is elsewhere (render.hpp).
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/budget.hpp"
#include "diagnostics/source.hpp"

namespace robochart::diagnostics {

/// How bad a finding is.
enum class Severity { note, warning, error };

/// One row of a rule table. All views point at static storage.
struct Rule {
    std::string_view code;  ///< published code where there is one (STM6, J1), else ours (RC-P01, CSPM-T03)
    Severity severity = Severity::error;
    std::string_view message;      ///< fmt pattern, filled with the diagnostic's arguments in order
    std::string_view explanation;  ///< what `explain CODE` prints: the rule, the reason, an example
};

/// Points at another place that matters, or, where the span is unknown, says more about the finding itself.
struct Note {
    Span span;
    std::string message;
};

/// A certain fix: replace the span's text.
struct FixIt {
    Span span;
    std::string replacement;
    std::string title;
};

/// One finding. `rule` is never null.
struct Diagnostic {
    const Rule* rule = nullptr;
    Span span;
    std::vector<std::string> arguments;
    std::vector<Note> notes;
    std::vector<FixIt> fixes;

    /// The rule's pattern with the arguments filled in.
    [[nodiscard]] std::string message() const;
};

/// Collects diagnostics in any order; hands them out sorted by source, place, code.
class Diagnostics {
public:
    /// Findings kept of each severity; later ones are counted only.
    static constexpr std::size_t max_kept = 200;

    /// Adds a finding. The reference is valid until the next `report`; use it to attach notes and fixes.
    Diagnostic& report(const Rule& rule, Span span, std::vector<std::string> arguments = {});

    /// The limits of the run in which things are found: phases that report here poll here. It outlives them.
    void within(Budget* budget) { budget_ = budget; }
    [[nodiscard]] Budget* budget() const { return budget_; }
    /// To be called in every loop whose length comes from the input. Throws LimitReached.
    void poll() const {
        if (budget_ != nullptr) budget_->poll();
    }

    /// Later warnings of this code are neither kept nor counted; errors always are.
    void allow(std::string code) { allowed_.insert(std::move(code)); }

    /// Takes over the findings of another.
    void add(const Diagnostics& other);
    /// Those about these texts, under the same limits and allowances.
    [[nodiscard]] Diagnostics about(const std::set<SourceId>& texts) const;
    [[nodiscard]] std::vector<Diagnostic> sorted() const;
    [[nodiscard]] std::size_t errors() const { return errors_; }
    [[nodiscard]] std::size_t warnings() const { return warnings_; }
    [[nodiscard]] bool ok() const { return errors_ == 0; }
    /// Was an error found in this text?
    [[nodiscard]] bool has_errors_in(SourceId source) const { return wrong_.contains(source); }
    [[nodiscard]] bool empty() const { return items_.empty(); }
    /// How many were counted but not kept.
    [[nodiscard]] std::size_t dropped() const { return dropped_; }

private:
    Budget* budget_ = nullptr;
    std::vector<Diagnostic> items_;
    Diagnostic overflow_;
    std::set<std::string, std::less<>> allowed_;
    std::set<SourceId> wrong_;
    std::size_t errors_ = 0;
    std::size_t warnings_ = 0;
    std::size_t dropped_ = 0;
};

}  // namespace robochart::diagnostics
