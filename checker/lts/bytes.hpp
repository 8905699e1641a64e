// SPDX-License-Identifier: Apache-2.0
// Encodes numbers as bytes for messages between programs. Each byte contains seven bits of the number, and the first
// byte contains the lowest bits (LEB128).
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace robochart::lts {

class ByteWriter {
public:
    void write_number(std::uint64_t value);
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

/// Thrown if bytes do not encode the expected data.
class BadBytes : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Reads numbers from bytes. A function throws BadBytes if no bytes are left, or if the next bytes do not encode a
/// number of the expected kind.
class ByteReader {
public:
    /// The bytes must outlive the reader.
    explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}
    std::uint64_t read_number();
    /// Reads a number below `end`, which is at most 2^32.
    std::uint32_t read_below(std::uint64_t end);
    /// Reads any number of 32 bits.
    std::uint32_t read_word() { return read_below(std::uint64_t{1} << 32U); }
    /// Reads the number of items that follow. Each item must have at least one byte.
    std::size_t read_count();
    void expect_end() const;

private:
    std::string_view bytes_;
};

}  // namespace robochart::lts
