// SPDX-License-Identifier: Apache-2.0
// Compiles generated code of many components as one source, because starting a compiler and parsing the headers takes
// longer than compiling a small machine.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cpp_emit/emit.hpp"
#include "cpp_emit/load/shared_library.hpp"
#include "cpp_emit/runtime/explore_abi.h"

namespace robochart::conformance {

/// Writes all cores and exploration interfaces into one source, each in its own namespace. The entry of the i-th
/// candidate is `robochart_explore_i`, and compilers report its errors in "candidate_i.cpp".
[[nodiscard]] std::vector<cpp_emit::OutputFile> batch_files(const std::vector<const cpp_emit::Emission*>&);
/// The name of the source that `batch_files` returns.
inline constexpr const char* batch_source = "batch.cpp";

/// Returns the first error of each of `count` candidates in the output of a compiler that failed on a batch. The text
/// is "" for a candidate without an error.
[[nodiscard]] std::vector<std::string> errors_by_candidate(const std::string& compiler_words, std::size_t count);

/// Controllers that were compiled together and are loaded.
class CodeBatch {
public:
    /// Compiles and loads the controllers. On failure returns null and sets `error` to the compiler's output.
    static std::unique_ptr<CodeBatch> build(const std::vector<const cpp_emit::Emission*>&,
                                            const cpp_emit::BuildOptions&, std::string& error);
    /// Returns the exploration interface of one controller. If it cannot be used, returns null and sets `fault` to the
    /// reason.
    [[nodiscard]] const rc_interface* code_at(std::size_t index, std::string& fault) const;

private:
    CodeBatch() = default;

    std::unique_ptr<cpp_emit::SharedLibrary> library_;
};

}  // namespace robochart::conformance
