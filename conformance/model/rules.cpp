#include "conformance/model/rules.hpp"

#include <array>

namespace robochart::conformance::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule log_syntax{"RC-L01", Severity::error, "expected {}, found {}",
                      "A log of runs begins with `robochart-trace 1`, a header, and then runs: `run NAME`, and in each "
                      "cycle what was read "
                      "(`seeRobot?`), what was written (`Move!0.5`), and `tock` for every time unit (docs/traces.md)."};
const Rule log_name{"RC-L02", Severity::error, "{} has no {} '{}'; it has {}",
                    "A log speaks of the component's inputs (events it receives, variables written from outside) and "
                    "outputs (operations "
                    "it calls, events it sends, variables it writes) by their names in the model."};
const Rule log_value{
    "RC-L03", Severity::error, "{} carries {}, found {}",
    "An event without value is `e?` or `e!`, one with a value `e?v` or `e!v`; an operation has a `!v` for each "
    "parameter. Numbers are decimal, truth values `true` and `false`, literals of enumerations by their names, values "
    "with parts `(1,true)`, `<1,2>`, `{Red,Green}`."};
const Rule log_of_other{
    "RC-L04", Severity::error, "the log is of {}, the model is read as {}",
    "A log says which component it comes from and how many time units a control cycle has. It is compared with that "
    "component of the model, in cycles of that length (`--component`, `--cycle`)."};

std::span<const Rule* const> all() {
    static constexpr std::array table = {&log_syntax, &log_name, &log_value, &log_of_other};
    return table;
}

}  // namespace robochart::conformance::rules
