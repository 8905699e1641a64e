// SPDX-License-Identifier: Apache-2.0
// Tests logs in MCAP files. The test writes the files byte by byte, as the MCAP specification describes the records.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/diagnostics/splitmix64.hpp"
#include "conformance/traces/decompress.hpp"
#include "conformance/traces/mcap.hpp"
#include "cpp_emit/runtime/mcap_writer.hpp"

namespace robochart::conformance {
namespace {

using namespace std::string_literals;

const std::string file_magic = "\x89MCAP0\r\n";

std::string little(std::uint64_t number, std::size_t size) {
    std::string bytes;
    for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(number >> (8 * i));
    return bytes;
}
std::string text_field(const std::string& text) {
    return little(text.size(), 4) + text;
}
std::string record(int code, const std::string& content) {
    return static_cast<char>(code) + little(content.size(), 8) + content;
}
std::string schema(int id, const std::string& name) {
    return record(
        3, little(static_cast<std::uint64_t>(id), 2) + text_field(name) + text_field("ros2msg") + text_field(""));
}
std::string channel(int id, int schema_id, const std::string& topic, const std::string& encoding) {
    return record(4, little(static_cast<std::uint64_t>(id), 2) + little(static_cast<std::uint64_t>(schema_id), 2) +
                         text_field(topic) + text_field(encoding) + little(0, 4));
}
std::string message(int id, const std::string& data) {
    return record(5, little(static_cast<std::uint64_t>(id), 2) + little(0, 20) + data);
}
std::string chunk(const std::string& records, std::uint32_t crc, const std::string& compression = "") {
    return record(6, little(0, 16) + little(records.size(), 8) + little(crc, 4) + text_field(compression) +
                         little(records.size(), 8) + records);
}
std::string end_of_data(std::uint32_t crc = 0) {
    return record(15, little(crc, 4));
}
std::string whole(const std::string& records, std::uint32_t crc = 0) {
    return file_magic + record(1, text_field("ros2") + text_field("test")) + records + end_of_data(crc) +
           record(2, little(0, 20)) + file_magic;
}
const std::string plain = channel(1, 0, "log", "robochart-trace");

/// Returns the log, or "BYTE: error".
std::string read(const std::string& bytes) {
    try {
        return read_mcap(bytes, diagnostics::unlimited);
    } catch (const McapFault& fault) {
        return std::to_string(fault.at) + ": " + fault.what();
    }
}
/// Computes the CRC-32 bit by bit, from its definition.
std::uint32_t crc_of(const std::string& bytes) {
    std::uint32_t crc = ~0U;
    for (const char byte : bytes) {
        crc ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) crc = (crc & 1U) != 0 ? (crc >> 1U) ^ 0xEDB88320U : crc >> 1U;
    }
    return ~crc;
}

TEST(Mcap, HasALogInTheMessagesOfAChannel) {
    EXPECT_EQ(
        read(whole(plain + message(1, "robochart-trace 1\n") + message(1, "component M\nrun 1") + message(1, "tock"))),
        "robochart-trace 1\ncomponent M\nrun 1\ntock\n");
    // The records are in a chunk with a checksum, together with other channels and records.
    const std::string records = schema(2, "std_msgs/msg/String") + schema(3, "std_msgs/msg/Empty") +
                                channel(7, 2, "/robot/trace", "cdr") + channel(8, 2, "/robot/state", "cdr") +
                                channel(9, 3, "/trace", "cdr");
    const std::string low = "\0\1\0\0\6\0\0\0tock\n\0"s, high = "\0\0\0\0\0\0\0\6tock\n\0"s;
    const std::string messages = message(8, "x") + message(7, low) + message(9, "x") + message(7, high);
    EXPECT_EQ(crc_of("123456789"), 0xCBF43926U);  // the check value of this CRC
    EXPECT_EQ(read(whole(record(12, "metadata") + chunk(records + messages, crc_of(records + messages)))),
              "tock\ntock\n");
    EXPECT_EQ(read(whole(chunk(records, 0) + chunk(messages, 0) + record(200, "of a later version"))), "tock\ntock\n");
    const std::string before = file_magic + record(1, text_field("ros2") + text_field("test")) + records + messages;
    EXPECT_EQ(read(whole(records + messages, crc_of(before))), "tock\ntock\n");
}

TEST(Mcap, IsRefusedWithThePlaceOfTheError) {
    const auto expect = [](const std::string& bytes, const std::string& error) { EXPECT_EQ(read(bytes), error); };
    expect("", "0: the file does not begin as an MCAP file");
    expect("robochart-trace 1\n", "0: the file does not begin as an MCAP file");
    expect(file_magic, "8: the file ends before its record DataEnd");
    const std::size_t begin = whole("").find(end_of_data());
    const std::string place = std::to_string(begin) + ": ";
    // The length of a record exceeds the file.
    expect(file_magic + "\5" + little(~0ULL, 8) + "x",
           "17: a record has 18446744073709551615 bytes, but only 1 are left");
    expect(whole("\0"s + little(0, 8)), place + "a record has the code 0");
    expect(whole(plain + message(2, "tock")),
           std::to_string(begin + plain.size() + 9) + ": a message is of channel 2, which is not declared");
    expect(whole(plain + channel(1, 0, "other", "robochart-trace")),
           std::to_string(begin + plain.size() + 9) + ": channel 1 is declared twice, differently");
    expect(whole(record(4, little(1, 2))), std::to_string(begin + 11) + ": a channel has 2 bytes, but only 0 are left");
    expect(whole(record(4, little(1, 4) + little(0xFFFFFFFFU, 4))),
           std::to_string(begin + 17) + ": the topic of a channel has 4294967295 bytes, but only 0 are left");
    const std::string two = plain + channel(2, 0, "second", "robochart-trace") + message(1, "tock");
    expect(whole(two + message(2, "tock")), std::to_string(begin + two.size() + 9) +
                                                ": several channels have messages with logs: write the channel of one "
                                                "robot into the file");
    const std::string inside = plain + message(1, "tock");
    const std::string chunk_place = std::to_string(begin + 9) + ": ";
    expect(whole(chunk(inside, crc_of(inside) ^ 1U)), chunk_place + "the checksum of a chunk is wrong");
    expect(whole(chunk(end_of_data(), 0)),
           std::to_string(begin + 9 + 40) + ": a chunk contains a record with the code 15");
    expect(whole(chunk(chunk("", 0), 0)),
           std::to_string(begin + 9 + 40) + ": a chunk contains a record with the code 6");
    expect(whole(inside, 1), std::to_string(begin + inside.size()) + ": the checksum of the file is wrong");
    const std::string good = whole(inside);
    expect(good.substr(0, good.size() - 1),
           std::to_string(good.size() - 1) + ": the file does not end as an MCAP file");
    EXPECT_NE(read(whole(plain)).find("no channel has messages with a log"), std::string::npos);
    const std::string texts = schema(1, "std_msgs/msg/String") + channel(1, 1, "trace", "cdr");
    const std::string text_place = std::to_string(begin + texts.size() + 9 + 22) + ": ";
    expect(whole(texts + message(1, "\0\1\0\0\4\0\0\0tock"s)), text_place + "a text does not end with a zero byte");
    expect(whole(texts + message(1, "\0\3\0\0\1\0\0\0\0"s)), text_place + "a message is not in plain CDR");
    expect(whole(texts + message(1, "\0\1\0\0\xff\xff\xff\xff\0"s)),
           std::to_string(begin + texts.size() + 9 + 22 + 8) + ": a text has 4294967295 bytes, but only 1 are left");
}

std::string compressed_chunk(const std::string& compression, const std::string& data, std::uint64_t size,
                             std::uint32_t crc) {
    return record(
        6, little(0, 16) + little(size, 8) + little(crc, 4) + text_field(compression) + little(data.size(), 8) + data);
}
/// A frame of Zstandard whose only block is not compressed (RFC 8878, 3.1.1): single segment, content size in 2 bytes.
std::string zstd_frame(const std::string& bytes) {
    return little(0xFD2FB528U, 4) + '\x60' + little(bytes.size() - 256, 2) + little(bytes.size() * 8 + 1, 3) + bytes;
}
/// A frame with a block that repeats one byte (RLE).
std::string zstd_repeated(char byte, std::uint64_t count) {
    return little(0xFD2FB528U, 4) + '\x00' + '\x58' + little(count * 8 + 3, 3) + byte;
}
/// A frame of LZ4 whose only block is not compressed: version 1, independent blocks of at most 64 KiB. The byte after
/// the descriptor is the second byte of its XXH32.
std::string lz4_frame(const std::string& bytes) {
    return little(0x184D2204U, 4) + '\x60' + '\x40' + '\x82' + little(bytes.size() | 0x80000000U, 4) + bytes +
           little(0, 4);
}

TEST(Mcap, MayHaveCompressedChunks) {
    const std::string inside = plain + message(1, "robochart-trace 1") + message(1, std::string(300, 'x'));
    const std::uint32_t crc = crc_of(inside);
    for (const auto& [compression, data] :
         std::vector<std::pair<std::string, std::string>>{{"zstd", zstd_frame(inside)}, {"lz4", lz4_frame(inside)}}) {
        if (!can_decompress(compression)) {
            EXPECT_NE(read(whole(compressed_chunk(compression, data, inside.size(), crc)))
                          .find("built without the package lib" + compression + "-dev"),
                      std::string::npos);
            continue;
        }
        const auto error_of = [&](const std::string& bytes, std::uint64_t size, std::uint32_t checksum) {
            return read(whole(compressed_chunk(compression, bytes, size, checksum)));
        };
        EXPECT_EQ(error_of(data, inside.size(), crc), "robochart-trace 1\n" + std::string(300, 'x') + "\n");
        EXPECT_NE(error_of(data, inside.size(), crc ^ 1U).find("the checksum of a chunk is wrong"), std::string::npos);
        EXPECT_NE(error_of(data, inside.size() - 1, crc).find("more than the declared"), std::string::npos);
        EXPECT_NE(error_of(data, inside.size() + 1, crc).find("but should have"), std::string::npos);
        EXPECT_NE(error_of(data, 1ULL << 40U, crc).find("at most 268435456 are read"), std::string::npos);
        EXPECT_NE(error_of("", inside.size(), crc).find("has 0 bytes, but should have"), std::string::npos);
        EXPECT_NE(error_of(data + "rubbish", inside.size(), crc).find("is damaged"), std::string::npos);
        for (std::size_t length = 1; length < data.size(); ++length)
            EXPECT_NE(error_of(data.substr(0, length), inside.size(), crc).find("chunk"), std::string::npos) << length;
        std::string faulty = data;
        faulty[0] = 'x';
        EXPECT_NE(error_of(faulty, inside.size(), crc).find("is damaged"), std::string::npos);
        // an error in the records has its own place
        const std::string wrong = message(7, std::string(300, 'x'));
        EXPECT_NE(error_of(compression == "zstd" ? zstd_frame(wrong) : lz4_frame(wrong), wrong.size(), 0)
                      .find("byte 9 of a decompressed chunk: a message is of channel 7"),
                  std::string::npos);
    }
    EXPECT_NE(read(whole(compressed_chunk("brotli", "x", 1, 0))).find("the compression `brotli`"), std::string::npos);
}

/// Data that decompresses to more than the chunk declares is refused before it is all there.
TEST(Mcap, ChunksDoNotGrowBeyondTheirSize) {
    if (!can_decompress("zstd")) GTEST_SKIP() << "this program was built without libzstd-dev";
    std::string bomb;
    for (int i = 0; i < 10'000; ++i) bomb += zstd_repeated('\0', 128 * 1024);  // 1.2 GiB
    EXPECT_NE(read(whole(compressed_chunk("zstd", bomb, 1000, 0))).find("more than the declared 1000 bytes"),
              std::string::npos);
}

/// The reader reads all texts that the writer of generated controllers and simulations writes.
TEST(Mcap, IsWritten) {
    McapWriter writer("/trace");
    std::string file = writer.begin();
    EXPECT_NE(read(file + writer.end()).find("no channel has messages with a log"), std::string::npos);
    std::string expected;
    for (const std::string& text :
         {"robochart-trace 1\ncomponent M\n"s, "run 1\na? tock\n"s, std::string(100'000, 'y')}) {
        file += writer.chunk(text, 1'000'000'000);
        expected += text + (text.ends_with('\n') ? "" : "\n");
        EXPECT_EQ(read(file + writer.end()), expected);
    }
    const std::string good = file + writer.end();
    EXPECT_TRUE(good.starts_with(file_magic + record(1, text_field("ros2") + text_field("robochart-verify"))));
    EXPECT_TRUE(good.ends_with(end_of_data(crc_of(file)) + record(2, little(0, 20)) + file_magic));
    for (std::size_t at = 0; at < file.size(); at += 97) {
        std::string bad = good;
        bad[at] = static_cast<char>(bad[at] ^ 1);
        EXPECT_THROW((void)read_mcap(bad, diagnostics::unlimited), McapFault) << at;
    }
}

/// Every prefix of a file is refused. A file with a changed byte is refused if it has checksums.
TEST(Mcap, ThatIsChangedIsRefused) {
    const std::string inside = plain + message(1, "robochart-trace 1") + message(1, "component M\nrun 1\ntock");
    const std::string before =
        file_magic + record(1, text_field("ros2") + text_field("test")) + chunk(inside, crc_of(inside));
    const std::string good = whole(chunk(inside, crc_of(inside)), crc_of(before));
    EXPECT_EQ(read(good), "robochart-trace 1\ncomponent M\nrun 1\ntock\n");
    for (std::size_t length = 0; length < good.size(); ++length)
        EXPECT_THROW((void)read_mcap(good.substr(0, length), diagnostics::unlimited), McapFault) << length;
    for (std::size_t at = 0; at < before.size(); ++at)
        for (const char change : {'\1', '\x80', '\xff'}) {
            std::string bad = good;
            bad[at] = static_cast<char>(bad[at] ^ change);
            EXPECT_THROW((void)read_mcap(bad, diagnostics::unlimited), McapFault) << at;
        }
    std::uint64_t state = 1;
    for (int round = 0; round < 20000; ++round) {
        std::string bytes = whole(inside);
        for (std::uint64_t changes = 1 + diagnostics::splitmix64(state) % 8; changes > 0; --changes)
            bytes[diagnostics::splitmix64(state) % bytes.size()] = static_cast<char>(diagnostics::splitmix64(state));
        EXPECT_LE(read(bytes).size(), bytes.size() + 200);
    }
}

}  // namespace
}  // namespace robochart::conformance
