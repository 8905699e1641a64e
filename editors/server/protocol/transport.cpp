// SPDX-License-Identifier: Apache-2.0
// Reads and writes frames. A faulty header is skipped up to the next header.
#include "editors/server/protocol/transport.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <istream>
#include <ostream>

namespace robochart::lsp {

namespace {

/// The longest stored header line; the rest of a longer line is dropped.
constexpr std::size_t max_line = 4096;

std::string lower(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

std::string_view trim_blanks(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    return text;
}

std::string printable_start(std::string_view line) {
    std::string result;
    for (const char c : line.substr(0, 40)) result += c >= 0x20 && c < 0x7F ? c : '?';
    return result;
}

}  // namespace

FrameReader::Line FrameReader::read_line(std::string& line) {
    line.clear();
    int c = 0;
    while ((c = in_.get()) != std::istream::traits_type::eof() && c != '\n')
        if (line.size() < max_line) line += static_cast<char>(c);
    if (c == std::istream::traits_type::eof()) return Line::end;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    return line.empty() ? Line::empty : Line::text;
}

void FrameReader::read_header(const std::string& line, std::string& fault) {
    const std::size_t colon = line.find(':');
    const std::string name = lower(line.substr(0, colon));
    if (colon == std::string::npos) {
        fault = fmt::format("a header line without a colon: `{}`", printable_start(line));
    } else if (name == "content-length") {
        const std::string_view digits = trim_blanks(std::string_view(line).substr(colon + 1));
        const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), length_);
        has_length_ = code == std::errc() && end == digits.data() + digits.size() && !digits.empty();
        if (!has_length_) fault = fmt::format("Content-Length is no length: `{}`", printable_start(digits));
        if (has_length_ && length_ > max_message)
            fault = fmt::format("a message of {} bytes; at most {} are accepted", length_, max_message);
    } else if (name == "content-type") {
        const std::string type = lower(line);
        if (type.find("charset") != std::string::npos && type.find("utf-8") == std::string::npos &&
            type.find("utf8") == std::string::npos)
            rejected_ = fmt::format("the charset must be utf-8: `{}`", printable_start(line));
    }
}

Frame FrameReader::read_body() {
    std::string text;
    // Reads in pieces, so that a large length alone does not allocate memory.
    constexpr std::size_t piece = 1U << 16U;
    while (text.size() < length_) {
        const std::size_t requested = std::min(piece, length_ - text.size());
        const std::size_t had = text.size();
        text.resize(had + requested);
        in_.read(text.data() + had, static_cast<std::streamsize>(requested));
        const auto got = static_cast<std::size_t>(in_.gcount());
        if (got < requested)
            return {Frame::Kind::fault,
                    fmt::format("the stream ended after {} of {} bytes of a message", had + got, length_)};
    }
    return {Frame::Kind::message, std::move(text)};
}

Frame FrameReader::next_frame() {
    std::string line;
    std::string fault;
    has_length_ = false;
    rejected_.clear();
    bool any = false;
    while (fault.empty()) {
        switch (read_line(line)) {
            case Line::end:
                if ((any || !line.empty()) && !lost_) return {Frame::Kind::fault, "the stream ended inside a header"};
                return {};
            case Line::empty:
                if (has_length_) {
                    lost_ = false;
                    Frame frame = read_body();
                    if (!rejected_.empty()) return {Frame::Kind::fault, rejected_};
                    return frame;
                }
                if (any && !lost_) fault = "a header without Content-Length";
                break;
            case Line::text:
                if (lost_ && !has_length_ && lower(line).rfind("content-length:", 0) != 0) break;
                any = true;
                read_header(line, fault);
                break;
        }
    }
    lost_ = true;
    return {Frame::Kind::fault, std::move(fault)};
}

void write_frame(std::ostream& out, std::string_view text) {
    out << "Content-Length: " << text.size() << "\r\n\r\n" << text << std::flush;
}

}  // namespace robochart::lsp
