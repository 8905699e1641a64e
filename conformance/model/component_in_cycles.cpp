// SPDX-License-Identifier: Apache-2.0
#include "conformance/model/component_in_cycles.hpp"

#include "conformance/model/normal_form_system.hpp"
#include "conformance/model/register_system.hpp"

namespace robochart::conformance {

std::unique_ptr<CycleSystem> component_in_cycles(ModelGraph& model, const Alphabet& alphabet,
                                                 std::uint32_t cycle_length) {
    if (alphabet.interface().robosim)
        return std::make_unique<RegisterSystem>(model, alphabet, cycle_length, AfterEnd::stop);
    return std::make_unique<NormalFormSystem>(model, alphabet, cycle_length);
}

}  // namespace robochart::conformance
