// SPDX-License-Identifier: Apache-2.0
// Reads and writes messages on a byte stream (LSP 3.17, base protocol): `Content-Length: N`, an empty line, N bytes.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

namespace robochart::lsp {

/// The largest accepted message, in bytes.
inline constexpr std::size_t max_message = 64U << 20U;

/// The next item of the stream.
struct Frame {
    enum class Kind { message, fault, end };
    Kind kind = Kind::end;
    std::string text;  ///< the message, or the description of a fault
};

/// Splits a stream into frames. After a fault, reading continues at the next header; the bytes before it are dropped.
class FrameReader {
public:
    explicit FrameReader(std::istream& in) : in_(in) {}
    [[nodiscard]] Frame next_frame();

private:
    enum class Line { text, empty, end };
    Line read_line(std::string& line);
    /// Parses one header line; sets `fault` if it is wrong.
    void read_header(const std::string& line, std::string& fault);
    [[nodiscard]] Frame read_body();

    std::istream& in_;
    std::size_t length_ = 0;
    bool has_length_ = false;
    std::string rejected_;  ///< the reason why a complete message is rejected
    bool lost_ = false;     ///< true after a fault, until the next header is found
};

/// Writes one message and flushes.
void write_frame(std::ostream& out, std::string_view text);

}  // namespace robochart::lsp
