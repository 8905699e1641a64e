// SPDX-License-Identifier: Apache-2.0
// Decides by the form of an expression whether it denotes a process. A call or constant that denotes a process is not
// evaluated, even if it is passed as an argument: it becomes a term that contains only its name and arguments.
#pragma once

#include "checker/cspm/eval/code.hpp"

namespace robochart::cspm {

/// Decides which expressions denote processes. The functions store the answers (Function::process). The object itself
/// stores only the depth of the current query.
class ProcessShape {
public:
    explicit ProcessShape(const Program& program) : program_(program) {}

    [[nodiscard]] bool makes_process(const Function& function);

private:
    bool makes_process(const Code& code);
    bool makes_process(const Code& name, std::size_t groups);

    const Program& program_;
    unsigned open_ = 0;  ///< number of unanswered queries
};

}  // namespace robochart::cspm
