// SPDX-License-Identifier: Apache-2.0
// Lists the targets, one row per fuzzer.
#include "tests/fuzz/targets/targets.hpp"

#include <array>

namespace robochart::fuzz {

std::span<const Target> targets() {
    static constexpr std::array table = {
        Target{"model", run_model},         Target{"assertions", run_assertions}, Target{"script", run_script},
        Target{"semantics", run_semantics}, Target{"editor", run_editor},         Target{"stream", run_stream},
        Target{"mcap", run_mcap},
    };
    return table;
}

}  // namespace robochart::fuzz
