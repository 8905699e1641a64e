// Prints and reads values in a console program. Numbers are written as usual, declared types and values with parts as
// in logs (robochart/trace.hpp): Red, (0.5,true), <1,2>. Delivered with generated code. Copyright: see LICENSE
// (Apache-2.0).
#ifndef ROBOCHART_CONSOLE_VALUES_HPP
#define ROBOCHART_CONSOLE_VALUES_HPP

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>

#include "robochart/trace.hpp"

namespace robochart {

/// Collects the text that is traced.
class WordTracer final : public Tracer {
public:
    void text(const char* piece) noexcept override { said += piece; }
    std::string said;
};

template <class T>
std::string show_value(const T& value) {
    if constexpr (std::is_arithmetic_v<T>) {
        std::ostringstream text;
        text << std::boolalpha << value;
        return text.str();
    } else {
        WordTracer words;
        log_value(words, value);
        return words.said;
    }
}

/// A text that is read from left to right.
class Words {
public:
    explicit Words(std::string_view text) : text_(text) {}

    [[nodiscard]] bool done() const { return at_ == text_.size(); }
    [[nodiscard]] bool take(char c) {
        const bool found = at_ < text_.size() && text_[at_] == c;
        if (found) ++at_;
        return found;
    }
    /// Returns the text up to a character that separates values, or up to the end.
    [[nodiscard]] std::string_view word() {
        const std::size_t begin = at_;
        while (at_ < text_.size() && std::string_view(",()<>{}\"").find(text_[at_]) == std::string_view::npos) ++at_;
        return text_.substr(begin, at_ - begin);
    }
    /// Returns a character of a quoted string, or the one that `\` and three octal digits encode. Returns -1 at the end
    /// of the string.
    [[nodiscard]] int character() {
        if (at_ >= text_.size() || text_[at_] == '"') return -1;
        const int first = digit(1), second = digit(2), third = digit(3);
        if (text_[at_] != '\\' || first < 0 || first > 3 || second < 0 || third < 0)
            return static_cast<unsigned char>(text_[at_++]);
        at_ += 4;
        return first * 64 + second * 8 + third;
    }

private:
    [[nodiscard]] int digit(std::size_t ahead) const {
        const char c = at_ + ahead < text_.size() ? text_[at_ + ahead] : ' ';
        return c >= '0' && c <= '7' ? c - '0' : -1;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

template <class T, std::enable_if_t<std::is_arithmetic_v<T>, int> = 0>
bool read_part(Words& in, T& value) {
    std::istringstream input{std::string(in.word())};
    return static_cast<bool>(input >> std::boolalpha >> value) && (input >> std::ws).eof();
}

/// Reads items; `add` reads one item and stores it.
template <class Add>
bool read_list(Words& in, char open, char close, const Add& add) {
    if (!in.take(open)) return false;
    if (in.take(close)) return true;
    do
        if (!add()) return false;
    while (in.take(','));
    return in.take(close);
}

template <class T, std::size_t capacity>
bool read_part(Words& in, Sequence<T, capacity>& value) {
    return read_list(in, '<', '>', [&] {
        T item{};
        if (!read_part(in, item) || value.size() == capacity) return false;
        value.append(item);
        return true;
    });
}
template <class T, std::size_t capacity>
bool read_part(Words& in, Set<T, capacity>& value) {
    return read_list(in, '{', '}', [&] {
        T item{};
        if (!read_part(in, item)) return false;
        value.insert(item);
        return value.contains(item);
    });
}

/// Reads a row of items. A single item has no parentheses.
template <class Item>
bool read_row(Words& in, std::size_t count, const Item& item) {
    if (count > 1 && !in.take('(')) return false;
    for (std::size_t i = 0; i < count; ++i)
        if ((i > 0 && !in.take(',')) || !item(i)) return false;
    return count == 1 || in.take(')');
}

template <class T, std::size_t length>
bool read_part(Words& in, Vector<T, length>& value) {
    return read_row(in, length, [&](std::size_t i) { return read_part(in, value.data()[i]); });
}
template <class T, std::size_t height, std::size_t width>
bool read_part(Words& in, Matrix<T, height, width>& value) {
    return read_row(in, height, [&](std::size_t row) {
        return read_row(in, width, [&](std::size_t i) { return read_part(in, value.data()[row * width + i]); });
    });
}
template <class A, class B, int shape>
bool read_part(Words& in, Pair<A, B, shape>& value) {
    return in.take('(') && read_part(in, value.item_1) && in.take(',') && read_part(in, value.item_2) && in.take(')');
}
template <std::size_t longest>
bool read_part(Words& in, String<longest>& value) {
    if (!in.take('"')) return false;
    std::string text;
    for (int c = in.character(); c > 0; c = in.character()) text += static_cast<char>(c);
    value = String<longest>::of(text.c_str());
    return text.size() <= longest && in.take('"');
}

/// Returns true if the whole text is one value. Otherwise returns false, and `value` is unchanged.
template <class T>
[[maybe_unused]] bool read_value(const std::string& text, T& value) {
    Words in(text);
    T read{};
    if (!read_part(in, read) || !in.done()) return false;
    value = read;
    return true;
}

}  // namespace robochart

#endif
