// Values as FDR prints them.
#pragma once

#include <string>

#include "checker/cspm/eval/code.hpp"

namespace robochart::cspm {

/// Prints the values of a program; owns nothing.
class ValueText {
public:
    explicit ValueText(const Program& program) : program_(program) {}

    /// For messages: very long text is cut, and what has not been evaluated is left out.
    [[nodiscard]] std::string operator()(Value value) const;
    /// For messages, appended.
    void items(const Values& values, const char* open, const char* separator, const char* close,
               std::string& out) const;
    /// All of it: the names of events and what `show` gives are data.
    [[nodiscard]] std::string whole(Value value) const;

private:
    /// A list that begins beyond `longest` characters is cut.
    void print(Value value, std::size_t longest, std::string& out) const;
    void list(const Values& values, const char* open, const char* separator, const char* close, std::size_t longest,
              std::string& out) const;

    const Program& program_;
};

}  // namespace robochart::cspm
