// SPDX-License-Identifier: Apache-2.0
#include "app/verbs/verbs.hpp"
#include "driver/claims/certificates.hpp"

namespace robochart::app {

void require_empty_certificates(const Options& options) {
    if (options.claims.certificates.empty()) return;
    const std::string why = driver::why_not_empty(options.claims.certificates);
    if (!why.empty()) throw UsageError("--certify: " + why);
}

Exit run_verb(const Options& options) {
    switch (options.verb) {
        case Verb::cspm:
            return run_cspm(options);
        case Verb::lsp:
            return run_lsp();
        case Verb::explain:
            return run_explain(options);
        case Verb::draw:
            return run_draw(options);
        case Verb::format:
            return run_format(options);
        case Verb::init:
            return run_init(options);
        case Verb::prism:
            return run_prism(options);
        case Verb::rules:
            return run_rules(options);
        case Verb::simulate:
            return run_simulate(options);
        case Verb::step:
            return run_step(options);
        case Verb::tune:
            return run_tune(options);
        case Verb::validate:
            return run_validate(options);
        case Verb::verify:
        case Verb::check:
        case Verb::emit_csp:
        case Verb::emit_cpp:
        case Verb::emit_monitor:
        case Verb::emit_prism:
        case Verb::emit_tests:
        case Verb::emit_rst:
        case Verb::conform:
        case Verb::help:
        case Verb::version:
            break;
    }
    return run_model(options);
}

}  // namespace robochart::app
