// SPDX-License-Identifier: Apache-2.0
// Decompresses chunks of MCAP files: Zstandard (RFC 8878), and frames of LZ4 (the LZ4 frame format 1.6), which are the
// compressions of the MCAP specification. Each needs a library that a build uses if it is installed.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/diagnostics/pollable.hpp"

namespace robochart::conformance {

/// The largest chunk, in decompressed bytes. Recorders write chunks of a few megabytes.
inline constexpr std::uint64_t most_chunk_bytes = std::uint64_t{256} << 20U;

/// Thrown if bytes cannot be decompressed: the compression is unknown or its library is missing, the bytes are damaged,
/// or there are more or fewer decompressed bytes than declared.
struct DecompressionFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Whether this build can read the compression, "zstd" or "lz4".
[[nodiscard]] bool can_decompress(std::string_view compression);

/// The decompressed bytes, `size` in number. Memory grows only with the bytes that are there, and `limits` are polled.
/// Throws DecompressionFault.
[[nodiscard]] std::string decompress(std::string_view compression, std::string_view bytes, std::uint64_t size,
                                     diagnostics::Pollable& limits);

}  // namespace robochart::conformance
