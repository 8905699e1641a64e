// SPDX-License-Identifier: Apache-2.0
// The base class of the parsers of claims and of SLEEC. It contains a position in a list of tokens, and reports errors
// there.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/advice/advice.hpp"
#include "base/words/words.hpp"

namespace robochart::words {

/// How a word may be used.
enum class WordUse : std::uint8_t {
    name,
    connective,  ///< may be a name, but is probably a keyword where another token was expected
    reserved,    ///< cannot be a name
};

class Cursor {
protected:
    using Words = std::vector<std::string>;
    /// Thrown after an error in the text has been reported.
    struct SyntaxError {};

    /// `most_levels`: the maximal depth of the recursion while parsing.
    Cursor(std::vector<Token> tokens, diagnostics::Diagnostics& diagnostics, const Findings& findings,
           std::span<const diagnostics::Advice> advice, unsigned most_levels)
        : tokens_(std::move(tokens)),
          diagnostics_(diagnostics),
          findings_(findings),
          advice_(advice),
          most_levels_(most_levels) {}
    Cursor(const Cursor&) = delete;
    Cursor& operator=(const Cursor&) = delete;
    virtual ~Cursor() = default;

    [[nodiscard]] virtual WordUse use_of(std::string_view word) const = 0;

    /// Counts one more level of recursion during its lifetime.
    class Depth {
    public:
        explicit Depth(Cursor& cursor) : cursor_(cursor) { cursor.enter_level(); }
        ~Depth() { --cursor_.depth_; }
        Depth(const Depth&) = delete;
        Depth& operator=(const Depth&) = delete;

    private:
        Cursor& cursor_;
    };
    void enter_level();

    [[nodiscard]] const Token& peek(std::size_t ahead = 0) const;
    [[nodiscard]] bool is_at(std::string_view text, std::size_t ahead = 0) const;
    [[nodiscard]] bool at_name(std::size_t ahead = 0) const;
    [[nodiscard]] bool at_end() const { return peek().kind == Tok::end; }
    const Token& take_token();
    bool accept(std::string_view text);
    diagnostics::Span expect(std::string_view text);
    Name simple_name(std::string_view what);
    Name qualified_name(std::string_view what);
    [[nodiscard]] diagnostics::Span span_since(diagnostics::Span from) const;
    /// Reports an error and throws. `words`: the words that are allowed here; the one nearest to the word found is
    /// suggested.
    [[noreturn]] void fail(std::string_view expected, const Words& words = {});

    std::vector<Token> tokens_;
    diagnostics::Diagnostics& diagnostics_;
    std::size_t at_ = 0;
    unsigned depth_ = 0;

private:
    [[nodiscard]] diagnostics::AdviceWord advice_word(std::ptrdiff_t ahead) const;

    const Findings& findings_;
    std::span<const diagnostics::Advice> advice_;
    unsigned most_levels_;
};

}  // namespace robochart::words
