// Declares strings as values of fixed size. They use no heap, and equal texts have equal bytes. Delivered with the
// generated code. Copyright: see LICENSE (Apache-2.0).
#ifndef ROBOCHART_TEXT_HPP
#define ROBOCHART_TEXT_HPP

#include <cstddef>

namespace robochart {

/// A text of at most `longest` characters, terminated by zero. Further characters are dropped.
template <std::size_t longest>
class String {
public:
    [[nodiscard]] static constexpr String of(const char* text) noexcept {
        String result;
        for (std::size_t i = 0; i < longest && text[i] != '\0'; ++i) result.character_[i] = text[i];
        return result;
    }
    [[nodiscard]] constexpr const char* c_str() const noexcept { return character_; }
    friend constexpr bool operator==(const String& a, const String& b) noexcept {
        for (std::size_t i = 0; i < longest; ++i)
            if (a.character_[i] != b.character_[i]) return false;
        return true;
    }
    friend constexpr bool operator!=(const String& a, const String& b) noexcept { return !(a == b); }
    friend constexpr bool operator<(const String& a, const String& b) noexcept {
        for (std::size_t i = 0; i < longest; ++i)
            if (a.character_[i] != b.character_[i])
                return static_cast<unsigned char>(a.character_[i]) < static_cast<unsigned char>(b.character_[i]);
        return false;
    }

private:
    char character_[longest + 1]{};
};

}  // namespace robochart

#endif
