// Values as FDR prints them.
#pragma once

#include <string>

#include "checker/cspm/eval/code.hpp"

namespace robochart::cspm {

/// Prints the values of a program; owns nothing.
class ValueText {
public:
    explicit ValueText(const Program& program) : program_(program) {}

    [[nodiscard]] std::string operator()(Value value) const;
    /// Appends the values; very many are cut short.
    void items(const Values& values, const char* open, const char* separator, const char* close,
               std::string& out) const;

private:
    void print(Value value, std::string& out) const;

    const Program& program_;
};

}  // namespace robochart::cspm
