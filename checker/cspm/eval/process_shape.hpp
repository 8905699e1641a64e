// Whether an expression plainly denotes a process, from its shape alone. Such a call or constant becomes a
// term by name wherever it occurs, so that a process passed as an argument is not evaluated.
#pragma once

#include "checker/cspm/eval/code.hpp"

namespace robochart::cspm {

/// Owns only the depth of the present question; answers are kept with the functions.
class ProcessShape {
public:
    explicit ProcessShape(const Program& program) : program_(program) {}

    [[nodiscard]] bool makes_process(const Function& function);

private:
    bool makes_process(const Code& code);
    bool makes_process(const Code& name, std::size_t groups);

    const Program& program_;
    unsigned open_ = 0;  ///< questions that have not been answered yet
};

}  // namespace robochart::cspm
