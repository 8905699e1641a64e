// Writes logs as MCAP files, the format of rosbag2's recordings (MCAP specification, version 0 of the format): one
// channel with messages std_msgs/msg/String in CDR, in chunks with checksums. Delivered with the generated code.
// Copyright: see LICENSE (Apache-2.0).
#ifndef ROBOCHART_MCAP_WRITER_HPP
#define ROBOCHART_MCAP_WRITER_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace robochart {

/// Makes the bytes of an MCAP file in this order: `begin`, `chunk` any number of times, `end`. The file is complete
/// after each chunk if `end` follows it, so a program may write `end` after each chunk and overwrite it by the next one.
class McapWriter {
public:
    explicit McapWriter(std::string topic) : topic_(std::move(topic)) {}

    /// The magic bytes, and the records Header, Schema and Channel.
    std::string begin() {
        std::string bytes = magic();
        add_record(bytes, 1, text_field("ros2") + text_field("robochart-verify"));
        const std::string definition = "string data\n";
        add_record(bytes, 3,
                   number(schema, 2) + text_field("std_msgs/msg/String") + text_field("ros2msg") +
                       text_field(definition));
        add_record(bytes, 4,
                   number(channel, 2) + number(schema, 2) + text_field(topic_) + text_field("cdr") + number(0, 4));
        add_to_crc(file_crc_, bytes);
        return bytes;
    }

    /// A chunk with one message. `nanoseconds` is the time of the message.
    std::string chunk(const std::string& text, std::uint64_t nanoseconds) {
        std::string message = number(channel, 2) + number(sequence_++, 4) + number(nanoseconds, 8) +
                              number(nanoseconds, 8);
        message += std::string("\0\1\0\0", 4) + number(text.size() + 1, 4) + text + '\0';
        std::string records;
        add_record(records, 5, message);
        std::uint32_t crc = empty_crc;
        add_to_crc(crc, records);
        std::string bytes;
        add_record(bytes, 6,
                   number(nanoseconds, 8) + number(nanoseconds, 8) + number(records.size(), 8) + number(~crc, 4) +
                       text_field("") + number(records.size(), 8) + records);
        add_to_crc(file_crc_, bytes);
        return bytes;
    }

    /// The records DataEnd and Footer, and the magic bytes. There is no summary section.
    std::string end() const {
        std::string bytes;
        add_record(bytes, 15, number(~file_crc_, 4));
        add_record(bytes, 2, number(0, 8) + number(0, 8) + number(0, 4));
        return bytes + magic();
    }

private:
    static constexpr std::uint64_t schema = 1, channel = 1;
    static constexpr std::uint32_t empty_crc = 0xFFFFFFFFU;

    static std::string magic() { return std::string("\x89MCAP0\r\n", 8); }

    /// Numbers begin with their lowest byte.
    static std::string number(std::uint64_t value, std::size_t size) {
        std::string bytes;
        for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(static_cast<unsigned char>(value >> (8 * i)));
        return bytes;
    }
    static std::string text_field(const std::string& text) { return number(text.size(), 4) + text; }
    static void add_record(std::string& bytes, int code, const std::string& content) {
        bytes += static_cast<char>(code);
        bytes += number(content.size(), 8);
        bytes += content;
    }
    /// The CRC-32 of zlib, without the final complement.
    static void add_to_crc(std::uint32_t& crc, const std::string& bytes) {
        for (const char byte : bytes) {
            crc ^= static_cast<unsigned char>(byte);
            for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
        }
    }

    std::string topic_;
    std::uint64_t sequence_ = 0;
    std::uint32_t file_crc_ = empty_crc;  ///< of all bytes so far
};

}  // namespace robochart

#endif
