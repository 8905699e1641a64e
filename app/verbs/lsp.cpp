// SPDX-License-Identifier: Apache-2.0
// The verb `lsp`: runs the language server on standard input and output.
#include <iostream>

#include "app/verbs/verbs.hpp"
#include "editors/server/server.hpp"

namespace robochart::app {

/// Returns one of the two exit codes of the protocol: 0 after `shutdown`, 1 otherwise.
Exit run_lsp() {
    std::ios::sync_with_stdio(false);
    std::cin.tie(nullptr);
    return lsp::serve(std::cin, std::cout) == 0 ? Exit::success : Exit::failed;
}

}  // namespace robochart::app
