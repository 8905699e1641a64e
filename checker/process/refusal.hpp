// SPDX-License-Identifier: Apache-2.0
// Handles work that fails because the process cannot be evaluated or is too large to be explored. Such a process is
// called refused.
#pragma once

#include <exception>
#include <new>
#include <stdexcept>

#include "base/diagnostics/budget.hpp"

namespace robochart::process {

/// Returns the result of `work`, or a default-constructed one if the process is refused. Interruptions, lack of memory
/// and internal errors are not refusals: their exceptions leave the function.
template <typename Work>
auto unless_refused(const Work& work) -> decltype(work()) {
    try {
        return work();
    } catch (const diagnostics::LimitReached&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::logic_error&) {
        throw;  // an internal error
    } catch (const std::exception&) {
        return {};
    }
}

}  // namespace robochart::process
