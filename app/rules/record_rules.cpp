// SPDX-License-Identifier: Apache-2.0
#include "app/rules/record_rules.hpp"

#include <vector>

#include "app/command/recording.hpp"
#include "app/command/run.hpp"
#include "claims/sleec/syntax/printer.hpp"

namespace robochart::app {

void record_rules(const driver::LoadedRules& loaded, const Options& options) {
    record_texts(loaded.sources, options);
    if (!loaded.rules) return;
    std::vector<RecordedConstant> constants;
    for (const sleec::Constant& constant : loaded.rules->file->constants)
        constants.push_back({loaded.path, constant.name.text, sleec::print(constant.value), ValueSource::model});
    options.run->recorder().add_constants(constants);
}

}  // namespace robochart::app
