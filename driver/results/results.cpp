// SPDX-License-Identifier: Apache-2.0
#include "driver/results/results.hpp"

#include <array>

namespace robochart::driver {

std::string_view name_of(Answer answer) {
    constexpr std::array<std::string_view, 7> names{"holds", "fails",       "inconclusive", "no check",
                                                    "error", "not checked", "value"};
    return names[static_cast<std::size_t>(answer)];
}

std::string_view answer_word(Answer answer) {
    return answer == Answer::fails ? "FAILS" : name_of(answer);
}

void set_place(const diagnostics::SourceManager& sources, diagnostics::Span span, AssertionReport& report) {
    report.place = sources.path_and_line(span);
    report.region = region_of(sources, span);
}

}  // namespace robochart::driver
