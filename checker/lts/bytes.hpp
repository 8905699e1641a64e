// Numbers as bytes, for what one program sends another: seven bits a byte, the lowest first.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace robochart::lts {

class ByteWriter {
public:
    void number(std::uint64_t value);
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

/// Bytes that are not what they should be.
class BadBytes : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Every function throws BadBytes where the bytes are at their end or no number of the kind asked for.
class ByteReader {
public:
    /// The bytes outlive the reader.
    explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}
    std::uint64_t number();
    /// Below `end`, which is at most 2^32.
    std::uint32_t below(std::uint64_t end);
    /// Any number of 32 bits.
    std::uint32_t word() { return below(std::uint64_t{1} << 32U); }
    /// How many things follow, each of at least one byte.
    std::size_t count();
    void finish() const;

private:
    std::string_view bytes_;
};

}  // namespace robochart::lts
