// SPDX-License-Identifier: Apache-2.0
#include "conformance/traces/mcap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "conformance/traces/decompress.hpp"

namespace robochart::conformance {

namespace {

constexpr std::string_view mcap_magic("\x89MCAP0\r\n", 8);

/// Computes the CRC-32 of zlib, as MCAP uses it.
std::uint32_t mcap_crc(std::string_view bytes) {
    static constexpr auto table = [] {
        std::array<std::uint32_t, 256> rows{};
        for (std::uint32_t i = 0; i < 256; ++i) {
            std::uint32_t row = i;
            for (int bit = 0; bit < 8; ++bit) row = (row >> 1U) ^ ((row & 1U) != 0 ? 0xEDB88320U : 0U);
            rows[i] = row;
        }
        return rows;
    }();
    std::uint32_t crc = 0xFFFFFFFFU;
    for (const char byte : bytes) crc = (crc >> 8U) ^ table[(crc ^ static_cast<unsigned char>(byte)) & 0xFFU];
    return ~crc;
}

/// Reads the content of a record, or a sequence of records, from its front. Before a length is used, it is compared
/// with the number of bytes that are left.
class McapPiece {
public:
    McapPiece(std::string_view bytes, std::uint64_t offset) : bytes_(bytes), offset_(offset) {}

    [[nodiscard]] bool is_empty() const { return bytes_.empty(); }
    [[nodiscard]] std::uint64_t offset() const { return offset_; }
    [[nodiscard]] std::string_view rest() const { return bytes_; }

    std::string_view take(std::uint64_t length, std::string_view what) {
        if (length > bytes_.size())
            throw McapFault(fmt::format("{} has {} bytes, but only {} are left", what, length, bytes_.size()), offset_);
        const std::string_view head = bytes_.substr(0, static_cast<std::size_t>(length));
        bytes_.remove_prefix(head.size());
        offset_ += head.size();
        return head;
    }
    /// Reads a number of `size` bytes, the lowest byte first.
    std::uint64_t number(std::size_t size, std::string_view what) {
        std::uint64_t result = 0;
        const std::string_view digits = take(size, what);
        for (std::size_t i = size; i-- > 0;) result = (result << 8U) | static_cast<unsigned char>(digits[i]);
        return result;
    }
    std::string_view text(std::string_view what) { return take(number(4, what), what); }

private:
    std::string_view bytes_;
    std::uint64_t offset_;
};

class McapReader {
public:
    McapReader(std::string_view bytes, diagnostics::Pollable& limits) : bytes_(bytes), limits_(limits) {}

    std::string read() {
        McapPiece file(bytes_, 0);
        if (file.take(std::min(bytes_.size(), mcap_magic.size()), "the beginning") != mcap_magic)
            throw McapFault("the file does not begin as an MCAP file", 0);
        while (!ended_) {
            if (file.is_empty()) throw McapFault("the file ends before its record DataEnd", file.offset());
            read_record(file, false);
        }
        if (!bytes_.ends_with(mcap_magic) || bytes_.size() < 2 * mcap_magic.size())
            throw McapFault("the file does not end as an MCAP file", bytes_.size());
        if (channel_name_.empty())
            throw McapFault(
                "no channel has messages with a log: their encoding is `robochart-trace`, or their schema is "
                "std_msgs/msg/String and their topic is `trace` or ends with `/trace`",
                bytes_.size());
        return std::move(text_);
    }

private:
    enum class Encoding { plain, cdr };
    struct Channel {
        std::string topic;
        std::optional<Encoding> encoding;  ///< the encoding of a log
    };

    static constexpr std::uint64_t code_schema = 3, code_channel = 4, code_message = 5, code_chunk = 6,
                                   code_data_end = 15;

    void read_record(McapPiece& records, bool in_chunk) {
        limits_.poll();
        const std::uint64_t begin = records.offset();
        const std::uint64_t code = records.number(1, "a record");
        const std::uint64_t length = records.number(8, "a record");
        const std::uint64_t at = records.offset();
        McapPiece content(records.take(length, "a record"), at);
        if (code == 0) throw McapFault("a record has the code 0", begin);
        if (in_chunk && code != code_schema && code != code_channel && code != code_message)
            throw McapFault(fmt::format("a chunk contains a record with the code {}", code), begin);
        if (code == code_schema) read_schema(content);
        if (code == code_channel) read_channel(content);
        if (code == code_message) read_message(content);
        if (code == code_chunk) read_chunk(content);
        if (code == code_data_end) read_end(content, begin);
    }

    void read_schema(McapPiece content) {
        const std::uint64_t id = content.number(2, "a schema");
        schemas_[id] = std::string(content.text("the name of a schema"));
    }

    void read_channel(McapPiece content) {
        const std::uint64_t begin = content.offset();
        const std::uint64_t id = content.number(2, "a channel");
        const std::uint64_t schema = content.number(2, "a channel");
        Channel channel{std::string(content.text("the topic of a channel")), std::nullopt};
        const std::string_view encoding = content.text("the encoding of a channel");
        const bool named = channel.topic == "trace" || channel.topic.ends_with("/trace");
        const auto found = schemas_.find(schema);
        const bool string = found != schemas_.end() && found->second == "std_msgs/msg/String";
        if (encoding == "robochart-trace") channel.encoding = Encoding::plain;
        if (encoding == "cdr" && string && named) channel.encoding = Encoding::cdr;
        const auto [known, fresh] = channels_.try_emplace(id, channel);
        if (!fresh && (known->second.topic != channel.topic || known->second.encoding != channel.encoding))
            throw McapFault(fmt::format("channel {} is declared twice, differently", id), begin);
    }

    void read_message(McapPiece content) {
        const std::uint64_t begin = content.offset();
        const std::uint64_t id = content.number(2, "a message");
        (void)content.take(20, "the times of a message");
        const auto found = channels_.find(id);
        if (found == channels_.end())
            throw McapFault(fmt::format("a message is of channel {}, which is not declared", id), begin);
        const Channel& channel = found->second;
        if (!channel.encoding) return;
        if (!log_) {
            log_ = id;
            channel_name_ = channel.topic.empty() ? "log" : channel.topic;
        } else if (*log_ != id) {
            throw McapFault("several channels have messages with logs: write the channel of one robot into the file",
                            begin);
        }
        const std::string_view text = *channel.encoding == Encoding::cdr ? cdr_string(content) : content.rest();
        text_ += text;
        if (!text.ends_with('\n')) text_ += '\n';
    }

    /// Reads a string in CDR (OMG DDS-XTYPES 7.4; rosidl). It begins with four bytes. The second of them is 1 if the
    /// lowest byte comes first. The length, which includes the zero at the end, and the characters follow.
    static std::string_view cdr_string(McapPiece content) {
        const std::uint64_t begin = content.offset();
        const std::string_view head = content.take(4, "a message");
        if (head[0] != 0 || (head[1] != 0 && head[1] != 1)) throw McapFault("a message is not in plain CDR", begin);
        std::uint64_t length = content.number(4, "a text");
        if (head[1] == 0)
            length =
                ((length & 0xFFU) << 24U) | ((length & 0xFF00U) << 8U) | ((length >> 8U) & 0xFF00U) | (length >> 24U);
        std::string_view text = content.take(length, "a text");
        if (text.empty() || text.back() != '\0') throw McapFault("a text does not end with a zero byte", begin);
        text.remove_suffix(1);
        return text;
    }

    void read_chunk(McapPiece content) {
        const std::uint64_t begin = content.offset();
        (void)content.take(16, "the times of a chunk");
        const std::uint64_t size = content.number(8, "a chunk");
        const std::uint64_t crc = content.number(4, "a chunk");
        const std::string_view compression = content.text("the compression of a chunk");
        const std::uint64_t length = content.number(8, "a chunk");
        const std::uint64_t at = content.offset();
        const std::string_view bytes = content.take(length, "the records of a chunk");
        if (!compression.empty()) return read_compressed(compression, bytes, size, crc, begin);
        if (length != size)
            throw McapFault(fmt::format("a chunk without compression has {} bytes, but should have {}", length, size),
                            begin);
        if (crc != 0 && crc != mcap_crc(bytes)) throw McapFault("the checksum of a chunk is wrong", begin);
        McapPiece records(bytes, at);
        while (!records.is_empty()) read_record(records, true);
    }

    /// An error in the records has the place of the chunk, and its own place in the message.
    void read_compressed(std::string_view compression, std::string_view bytes, std::uint64_t size, std::uint64_t crc,
                         std::uint64_t begin) {
        std::string plain;
        try {
            plain = decompress(compression, bytes, size, limits_);
        } catch (const DecompressionFault& fault) {
            throw McapFault(fault.what(), begin);
        }
        if (crc != 0 && crc != mcap_crc(plain)) throw McapFault("the checksum of a chunk is wrong", begin);
        McapPiece records(plain, 0);
        try {
            while (!records.is_empty()) read_record(records, true);
        } catch (const McapFault& fault) {
            throw McapFault(fmt::format("byte {} of a decompressed chunk: {}", fault.at, fault.what()), begin);
        }
    }

    void read_end(McapPiece content, std::uint64_t begin) {
        const std::uint64_t crc = content.number(4, "the record DataEnd");
        if (crc != 0 && crc != mcap_crc(bytes_.substr(0, static_cast<std::size_t>(begin))))
            throw McapFault("the checksum of the file is wrong", begin);
        ended_ = true;
    }

    std::string_view bytes_;
    diagnostics::Pollable& limits_;
    std::map<std::uint64_t, std::string> schemas_;
    std::map<std::uint64_t, Channel> channels_;
    std::optional<std::uint64_t> log_;  ///< the channel of the log
    std::string channel_name_;
    std::string text_;
    bool ended_ = false;
};

}  // namespace

bool is_mcap(std::string_view bytes) {
    return bytes.starts_with(mcap_magic);
}

bool is_log_path(const std::string& path) {
    const std::filesystem::path extension = std::filesystem::path(path).extension();
    return extension == ".trace" || extension == ".mcap";
}

std::string read_mcap(std::string_view bytes, diagnostics::Pollable& limits) {
    return McapReader(bytes, limits).read();
}

std::unique_ptr<std::istream> open_log(const std::string& path, diagnostics::Pollable& limits) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return nullptr;
    auto file = std::make_unique<std::ifstream>(path, std::ios::binary);
    if (!file->is_open()) return nullptr;
    std::string head(mcap_magic.size(), '\0');
    file->read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(file->gcount()));
    file->clear();
    file->seekg(0);
    if (!is_mcap(head)) {
        if (std::filesystem::path(path).extension() == ".mcap")
            throw McapFault("at byte 0: the file does not begin as an MCAP file", 0);
        return file;
    }
    std::ostringstream bytes;
    bytes << file->rdbuf();
    try {
        return std::make_unique<std::istringstream>(read_mcap(bytes.str(), limits));
    } catch (const McapFault& fault) {
        throw McapFault(fmt::format("at byte {}: {}", fault.at, fault.what()), fault.at);
    }
}

}  // namespace robochart::conformance
