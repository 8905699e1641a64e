// Generated code of many components as one source: a compiler's start and the headers cost more than a small machine.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cpp_emit/emit.hpp"
#include "cpp_emit/load/shared_library.hpp"
#include "cpp_emit/runtime/explore_abi.h"

namespace robochart::conformance {

/// The cores and exploration interfaces of all as one source, each in a namespace of its own; the entry of the i-th is
/// `robochart_explore_i`, and compilers place what they say of it in "candidate_i.cpp".
[[nodiscard]] std::vector<cpp_emit::OutputFile> batch_files(const std::vector<const cpp_emit::Emission*>&);
/// The source among these files.
inline constexpr const char* batch_source = "batch.cpp";

/// Which of `count` a compiler that failed on a batch has found errors in, with the first one each; "": none there.
[[nodiscard]] std::vector<std::string> errors_by_candidate(const std::string& compiler_words, std::size_t count);

/// Controllers compiled together and loaded.
class CodeBatch {
public:
    /// On failure returns nothing and sets `error` to the compiler's words.
    static std::unique_ptr<CodeBatch> build(const std::vector<const cpp_emit::Emission*>&,
                                            const cpp_emit::BuildOptions&, std::string& error);
    /// The exploration interface of one; null, with `fault` saying why, if it cannot be used.
    [[nodiscard]] const rc_interface* code(std::size_t index, std::string& fault) const;

private:
    CodeBatch() = default;

    std::unique_ptr<cpp_emit::SharedLibrary> library_;
};

}  // namespace robochart::conformance
