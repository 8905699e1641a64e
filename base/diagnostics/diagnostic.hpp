// SPDX-License-Identifier: Apache-2.0
// Represents diagnostics as data: a rule from a table, a place, and arguments. render.hpp draws them.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics/budget.hpp"
#include "base/diagnostics/source.hpp"

namespace robochart::diagnostics {

/// The severity of a finding.
enum class Severity { note, warning, error };

/// One row of a rule table. All views point at static storage.
struct Rule {
    /// The published code of the rule if it has one (STM6, J1), otherwise a code of this project (RC-P01, CSPM-T03).
    std::string_view code;
    Severity severity = Severity::error;
    std::string_view message;  ///< fmt pattern for the arguments of the diagnostic, in order
};

/// Refers to another relevant place. If the span is unknown, the text of the note is added to the message of the
/// finding.
struct Note {
    Span span;
    std::string message;
};

/// A fix that replaces the text of a span.
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

    /// Returns the rule's pattern with the arguments inserted.
    [[nodiscard]] std::string message() const;
};

/// Collects diagnostics in any order. Returns them sorted by source, place and code.
class Diagnostics {
public:
    /// How many findings of each severity are stored; later findings are only counted.
    static constexpr std::size_t max_kept = 200;

    /// Adds a finding and returns it, so that notes and fixes can be added. The reference is valid until the next
    /// `report`.
    Diagnostic& report(const Rule& rule, Span span, std::vector<std::string> arguments = {});

    /// Sets the budget of the run. Phases that report here poll it, so it must outlive them.
    void set_budget(Budget* budget) { budget_ = budget; }
    [[nodiscard]] Budget* budget() const { return budget_; }
    /// Every loop whose length depends on the input must call this function. Throws LimitReached.
    void poll() const {
        if (budget_ != nullptr) budget_->poll();
    }

    /// From now on, warnings with this code are neither stored nor counted. Errors with this code are not suppressed.
    void allow_code(std::string code) { allowed_.insert(std::move(code)); }

    /// Adds the findings of another collection.
    void add(const Diagnostics& other);
    /// Returns the findings about these texts. The result has the same budget and allowed codes.
    [[nodiscard]] Diagnostics findings_in_texts(const std::set<SourceId>& texts) const;
    [[nodiscard]] std::vector<Diagnostic> sorted_findings() const;
    [[nodiscard]] std::size_t error_count() const { return errors_; }
    /// Returns the message of the first error in the order of `sorted_findings`, or "" if there is no error.
    [[nodiscard]] std::string first_error() const;
    [[nodiscard]] std::size_t warning_count() const { return warnings_; }
    [[nodiscard]] bool ok() const { return errors_ == 0; }
    /// Returns true if an error was found in this text.
    [[nodiscard]] bool has_errors_in(SourceId source) const { return wrong_.contains(source); }
    [[nodiscard]] bool empty() const { return items_.empty(); }
    /// Returns the number of findings that were counted but not stored.
    [[nodiscard]] std::size_t dropped_count() const { return dropped_; }

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
