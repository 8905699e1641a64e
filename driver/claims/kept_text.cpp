// SPDX-License-Identifier: Apache-2.0
#include "driver/claims/kept_text.hpp"

#include <fmt/format.h>

#include "base/diagnostics/text.hpp"

namespace robochart::driver {
namespace {

/// Returns the reason as text; `expr` is the expression that causes it.
std::string reason_text(ir::KeepReason why, const std::string& expr) {
    using enum ir::KeepReason;
    switch (why) {
        case type:
            return "functions, relations and matrices have no classes";
        case other_place:
            return "data of another type share the values, or a controller or platform initialises them";
        case part:
            return fmt::format("an assignment of `{}` changes a part of the value", expr);
        case selector:
            return fmt::format("`{}` selects the part that an assignment changes", expr);
        case other_data:
            return fmt::format("`{}` also reads other data", expr);
        case clock:
            return fmt::format("`{}` also reads a clock", expr);
        case undefined:
            return fmt::format("`{}` may be undefined", expr);
        case time:
            return fmt::format("`{}` is a time", expr);
        case probability:
            return fmt::format("`{}` is a probability", expr);
        case contract:
            return fmt::format("`{}` is a precondition or postcondition of an operation", expr);
        case form:
            return fmt::format("`{}` is neither linear nor about windows of the first 4095 places, and {}", expr,
                               ir::has_solver() ? "Z3 finds no classes" : "this program was built without Z3");
        case conditions:
            return "there are more than 64 conditions";
        case classes:
            return "there are more than 256 classes";
        case numbers:
            return "the conditions read more than 8 numbers of one value";
        case extremes:
            return "conditions read least numbers of windows, and also greatest ones";
        case points:
            return "for some combination of answers, no decimal numbers are found";
        case computed:
            return fmt::format("`{}` computes a value, and a condition reads it", expr);
        case from_carriers:
            return fmt::format("`{}` is computed from carriers", expr);
        case computed_from:
            return fmt::format("`{}` computes a value of data that keep their carriers", expr);
        case observed:
            return "claims compare the values, and there are few";
    }
    return "";
}

}  // namespace

KeptDataReport described(const diagnostics::SourceManager& sources, const ir::KeptData& data) {
    const diagnostics::Span span = data.keep.span;
    std::string expr, place;
    if (span.is_known()) {
        expr = diagnostics::on_one_line(sources.source_text(span.source).substr(span.begin, span.end - span.begin));
        place = sources.path_and_line(span);
    }
    return {data.places, reason_text(data.keep.why, expr), place};
}

}  // namespace robochart::driver
