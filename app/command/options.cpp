// SPDX-License-Identifier: Apache-2.0
#include "app/command/options.hpp"

namespace robochart::app {

driver::ClaimUse claim_use(Verb verb) {
    switch (verb) {
        case Verb::verify:
        case Verb::check:
            return driver::ClaimUse::decide;
        case Verb::emit_csp:
            return driver::ClaimUse::write;
        case Verb::emit_cpp:
        case Verb::emit_monitor:
        case Verb::emit_tests:
        case Verb::emit_rst:
        case Verb::conform:
        case Verb::draw:
        case Verb::rules:
        case Verb::simulate:
        case Verb::step:
        case Verb::tune:
            return driver::ClaimUse::ignore;
        case Verb::emit_prism:
        case Verb::cspm:
        case Verb::explain:
        case Verb::format:
        case Verb::init:
        case Verb::lsp:
        case Verb::prism:
        case Verb::validate:
        case Verb::help:
        case Verb::version:
            return driver::ClaimUse::read;
    }
    return driver::ClaimUse::read;
}

namespace {

/// True if the verb generates code for components of RoboSim, or runs them. Claims of .rsa files do not depend on this.
bool handles_robosim(Verb verb) {
    switch (verb) {
        case Verb::verify:
        case Verb::emit_cpp:
        case Verb::emit_monitor:
        case Verb::emit_tests:
        case Verb::conform:
        case Verb::simulate:
        case Verb::step:
            return true;
        case Verb::check:
        case Verb::emit_csp:
        case Verb::emit_prism:
        case Verb::emit_rst:
        case Verb::cspm:
        case Verb::draw:
        case Verb::explain:
        case Verb::format:
        case Verb::init:
        case Verb::lsp:
        case Verb::prism:
        case Verb::rules:
        case Verb::tune:
        case Verb::validate:
        case Verb::help:
        case Verb::version:
            return false;
    }
    return false;
}

}  // namespace

void set_verb(Options& options, Verb verb) {
    options.verb = verb;
    options.load.claims = claim_use(verb);
    options.load.robosim = handles_robosim(verb);
}

}  // namespace robochart::app
