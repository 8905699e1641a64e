// SPDX-License-Identifier: Apache-2.0
// Decides by the form of an expression whether it denotes a process. Such a call or constant becomes a term by name
// everywhere, so that a process passed as an argument is not evaluated.
#pragma once

#include "checker/cspm/eval/code.hpp"

namespace robochart::cspm {

/// Stores only the depth of the current query; answers are stored in the functions.
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
