// SPDX-License-Identifier: Apache-2.0
// Decides by the form of an expression whether it denotes a process. The evaluator does not evaluate a call or constant
// that denotes a process, even as an argument. It creates a term that contains only the name and the arguments.
#pragma once

#include "checker/cspm/eval/code.hpp"

namespace robochart::cspm {

/// Decides which expressions denote processes. Function::process caches the answers. The object itself stores only how
/// many queries are nested.
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
