// robochart-verify: the command.
#include "app/command/options.hpp"
#include "app/command/run.hpp"
#include "app/verbs/verbs.hpp"

namespace {

using robochart::app::Exit;

Exit run(const robochart::app::Options& options) {
    using robochart::app::Verb;
    if (options.verb == Verb::cspm) return robochart::app::run_cspm(options);
    if (options.verb == Verb::lsp) return robochart::app::run_lsp();
    if (options.verb == Verb::explain) return robochart::app::run_explain(options);
    if (options.verb == Verb::draw) return robochart::app::run_draw(options);
    if (options.verb == Verb::format) return robochart::app::run_format(options);
    if (options.verb == Verb::init) return robochart::app::run_init(options);
    if (options.verb == Verb::prism) return robochart::app::run_prism(options);
    if (options.verb == Verb::rules) return robochart::app::run_rules(options);
    if (options.verb == Verb::simulate) return robochart::app::run_simulate(options);
    if (options.verb == Verb::step) return robochart::app::run_step(options);
    if (options.verb == Verb::tune) return robochart::app::run_tune(options);
    if (options.verb == Verb::validate) return robochart::app::run_validate(options);
    return robochart::app::run_model(options);
}

}  // namespace

int main(int argc, char** argv) {
    return robochart::app::run_command("robochart-verify", argc, argv, run);
}
