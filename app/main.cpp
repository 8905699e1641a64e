// robochart-verify: the command.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>

#include "app/options.hpp"
#include "app/verbs.hpp"

namespace {

using robochart::app::Exit;

Exit run(const robochart::app::Options& options) {
    using robochart::app::Verb;
    if (options.verb == Verb::cspm) return robochart::app::run_cspm(options);
    if (options.verb == Verb::lsp) return robochart::app::run_lsp();
    if (options.verb == Verb::explain) return robochart::app::run_explain(options);
    if (options.verb == Verb::format) return robochart::app::run_format(options);
    if (options.verb == Verb::simulate) return robochart::app::run_simulate(options);
    if (options.verb == Verb::validate) return robochart::app::run_validate(options);
    return robochart::app::run_model(options);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const robochart::app::Parsed parsed = robochart::app::parse_command_line(argc, argv);
        if (!parsed.options) {
            fmt::print(parsed.exit == Exit::success ? stdout : stderr, "{}", parsed.message);
            return static_cast<int>(parsed.exit);
        }
        return static_cast<int>(run(*parsed.options));
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "robochart-verify: out of memory\n");
        return static_cast<int>(Exit::inconclusive);
    } catch (const std::exception& error) {
        fmt::print(stderr, "robochart-verify: a fault of this program: {}\nplease report it with the model that shows it\n", error.what());
        return static_cast<int>(Exit::internal);
    }
}
