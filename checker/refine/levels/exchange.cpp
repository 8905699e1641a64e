// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/levels/exchange.hpp"

namespace robochart::refine {

void Exchange::count_messages(const Messages& out) {
    ++traffic_.rounds;
    for (unsigned to = 0; to < ranks(); ++to) {
        if (to == rank() || out.sizes[to] == 0) continue;
        ++traffic_.messages;
        traffic_.bytes += out.sizes[to] * sizeof(lts::Word);
    }
}

}  // namespace robochart::refine
