// SPDX-License-Identifier: Apache-2.0
#include "conformance/traces/decompress.hpp"

#include <fmt/format.h>

#include <array>
#include <memory>

#ifdef ROBOCHART_ZSTD
#include <zstd.h>
#endif
#ifdef ROBOCHART_LZ4
#include <lz4frame.h>
#endif

namespace robochart::conformance {

namespace {

#if defined(ROBOCHART_ZSTD) || defined(ROBOCHART_LZ4)

/// Collects decompressed bytes up to the declared number.
class DecompressedBytes {
public:
    DecompressedBytes(std::uint64_t size, diagnostics::Pollable& limits) : size_(size), limits_(limits) {}

    [[nodiscard]] char* buffer() { return block_.data(); }
    [[nodiscard]] std::size_t capacity() const { return block_.size(); }
    void take(std::size_t count) {
        limits_.poll();
        if (count > size_ - bytes_.size())
            throw DecompressionFault(fmt::format("the decompressed chunk has more than the declared {} bytes", size_));
        bytes_.append(block_.data(), count);
    }
    std::string finish() {
        if (bytes_.size() != size_)
            throw DecompressionFault(
                fmt::format("the decompressed chunk has {} bytes, but should have {}", bytes_.size(), size_));
        return std::move(bytes_);
    }

private:
    std::uint64_t size_;
    diagnostics::Pollable& limits_;
    std::array<char, std::size_t{1} << 16U> block_{};
    std::string bytes_;
};

[[noreturn]] void throw_damaged(const char* format, const char* cause) {
    throw DecompressionFault(fmt::format("the {} data of a chunk is damaged: {}", format, cause));
}

#endif

#ifdef ROBOCHART_ZSTD
std::string decompress_zstd(std::string_view bytes, std::uint64_t size, diagnostics::Pollable& limits) {
    const std::unique_ptr<ZSTD_DStream, std::size_t (*)(ZSTD_DStream*)> stream(ZSTD_createDStream(), ZSTD_freeDStream);
    if (stream == nullptr) throw std::bad_alloc();
    DecompressedBytes output(size, limits);
    ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
    std::size_t expected = 0;  // 0: a frame is complete
    bool more = !bytes.empty();
    while (more) {
        ZSTD_outBuffer out{output.buffer(), output.capacity(), 0};
        expected = ZSTD_decompressStream(stream.get(), &out, &in);
        if (ZSTD_isError(expected) != 0) throw_damaged("zstd", ZSTD_getErrorName(expected));
        output.take(out.pos);
        more = in.pos < in.size || (expected != 0 && out.pos == out.size);
    }
    if (expected != 0) throw_damaged("zstd", "it is truncated");
    return output.finish();
}
#endif

#ifdef ROBOCHART_LZ4
std::string decompress_lz4(std::string_view bytes, std::uint64_t size, diagnostics::Pollable& limits) {
    LZ4F_dctx* made = nullptr;
    if (LZ4F_isError(LZ4F_createDecompressionContext(&made, LZ4F_VERSION)) != 0) throw std::bad_alloc();
    const std::unique_ptr<LZ4F_dctx, LZ4F_errorCode_t (*)(LZ4F_dctx*)> context(made, LZ4F_freeDecompressionContext);
    DecompressedBytes output(size, limits);
    std::size_t expected = 0;  // 0: a frame is complete
    bool more = !bytes.empty();
    while (more) {
        std::size_t written = output.capacity(), read = bytes.size();
        expected = LZ4F_decompress(context.get(), output.buffer(), &written, bytes.data(), &read, nullptr);
        if (LZ4F_isError(expected) != 0) throw_damaged("lz4", LZ4F_getErrorName(expected));
        bytes.remove_prefix(read);
        output.take(written);
        more = !bytes.empty() || (expected != 0 && written > 0);
    }
    if (expected != 0) throw_damaged("lz4", "it is truncated");
    return output.finish();
}
#endif

}  // namespace

bool can_decompress([[maybe_unused]] std::string_view compression) {
#ifdef ROBOCHART_ZSTD
    if (compression == "zstd") return true;
#endif
#ifdef ROBOCHART_LZ4
    if (compression == "lz4") return true;
#endif
    return false;
}

std::string decompress(std::string_view compression, [[maybe_unused]] std::string_view bytes, std::uint64_t size,
                       [[maybe_unused]] diagnostics::Pollable& limits) {
    if (compression != "zstd" && compression != "lz4")
        throw DecompressionFault(
            fmt::format("the compression `{}` is none of the MCAP specification", compression.substr(0, 40)));
    if (size > most_chunk_bytes)
        throw DecompressionFault(
            fmt::format("a chunk should have {} bytes; at most {} are read", size, most_chunk_bytes));
#ifdef ROBOCHART_ZSTD
    if (compression == "zstd") return decompress_zstd(bytes, size, limits);
#endif
#ifdef ROBOCHART_LZ4
    if (compression == "lz4") return decompress_lz4(bytes, size, limits);
#endif
    throw DecompressionFault(
        fmt::format("a chunk is compressed ({0}), and this program was built without the package lib{0}-dev: build it "
                    "with the package, or convert the file, for example with `mcap decompress`",
                    compression));
}

}  // namespace robochart::conformance
