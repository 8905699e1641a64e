// SPDX-License-Identifier: Apache-2.0
// Prints values as FDR does.
#pragma once

#include <string>

#include "checker/cspm/eval/code.hpp"

namespace robochart::cspm {

/// Prints the values of a program.
class ValueText {
public:
    explicit ValueText(const Program& program) : program_(program) {}

    /// Returns the text for messages. Very long text is truncated, and unevaluated parts are left out.
    [[nodiscard]] std::string operator()(Value value) const;
    /// Appends a list of values in the form used in messages.
    void items(const Values& values, const char* open, const char* separator, const char* close,
               std::string& out) const;
    /// Returns the complete text. It is not shortened, because it is used for names of events and for the results of
    /// `show`.
    [[nodiscard]] std::string full_text(Value value) const;

private:
    /// Appends the text of a value. Lists that begin after `longest` characters are truncated.
    void print(Value value, std::size_t longest, std::string& out) const;
    void list(const Values& values, const char* open, const char* separator, const char* close, std::size_t longest,
              std::string& out) const;

    const Program& program_;
};

}  // namespace robochart::cspm
