// SPDX-License-Identifier: Apache-2.0
// Defines libFuzzer's entry point for one target. A violated property ends the program like a crash.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/targets/targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string complaint =
        robochart::fuzz::ROBOCHART_FUZZ_RUN(std::string_view(reinterpret_cast<const char*>(data), size));
    if (complaint.empty()) return 0;
    std::fprintf(stderr, "broken promise: %s\n", complaint.c_str());
    std::abort();
}
