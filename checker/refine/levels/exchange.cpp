#include "checker/refine/levels/exchange.hpp"

namespace robochart::refine {

void Exchange::count(const std::vector<Words>& out) {
    ++traffic_.rounds;
    for (unsigned to = 0; to < out.size(); ++to) {
        if (to == rank() || out[to].empty()) continue;
        ++traffic_.messages;
        traffic_.bytes += out[to].size() * sizeof(lts::Word);
    }
}

}  // namespace robochart::refine
