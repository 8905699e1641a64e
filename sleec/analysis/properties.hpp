// Concerns and purposes (LEGOS): whether something that must be impossible, or possible, is possible while all rules
// are kept; and whether a rule can be broken while all others are. docs/rules-language.md, "Concerns and purposes",
// "Questions about rules".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sleec/analysis/conflicts.hpp"

namespace robochart::sleec {

/// What comes in a history, and when.
struct Happening {
    std::int64_t second = 0;
    std::size_t event = 0;
    Valuation values;
    bool named = false;  ///< the property is about this occurrence
};

/// Whether a history keeps all rules in which the property comes about.
struct PropertyAnswer {
    Answer possible = Answer::no;
    std::vector<Happening>
        history;         ///< possible: one that does; behind it nothing new comes, or what is at its end again
    std::string reason;  ///< not decided: why
    std::uint64_t states = 0;
};

/// All rules of the file are kept, its assumptions among them.
[[nodiscard]] PropertyAnswer possible(const CheckedRules& rules, const CheckedProperty& property,
                                      const AnalysisOptions& options);

/// Whether all that `rule` asks for follows from the other rules together: no history keeps them and breaks it.
struct Implication {
    Answer implied = Answer::no;
    std::vector<std::size_t> by;  ///< implied: rules that imply it, none of which can be left out
    std::string reason;           ///< not decided: why
};
/// A rule whose trigger the others exclude is not said to be implied: their conflict is reported.
[[nodiscard]] Implication implied(const CheckedRules& rules, std::size_t rule, const AnalysisOptions& options);

/// Rules none of which can be left out for the property to stay impossible; of a property that is. Rules that are not
/// decided count as needed.
[[nodiscard]] std::vector<std::size_t> excluding(const CheckedRules& rules, const CheckedProperty& property,
                                                 const AnalysisOptions& options);

}  // namespace robochart::sleec
