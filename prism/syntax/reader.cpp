// SPDX-License-Identifier: Apache-2.0
// See reader.hpp.
#include "prism/syntax/reader.hpp"

#include "prism/syntax/parser.hpp"

namespace robochart::prism {
namespace {

Parser parser(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
              diagnostics::Diagnostics& diagnostics) {
    return {lex(sources.source_text(source), source, diagnostics), diagnostics};
}

}  // namespace

ModelFile read_model(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                     diagnostics::Diagnostics& diagnostics) {
    return parser(sources, source, diagnostics).model();
}

PropertyFile read_properties(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                             diagnostics::Diagnostics& diagnostics) {
    return parser(sources, source, diagnostics).properties();
}

ExprPtr read_expression(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                        diagnostics::Diagnostics& diagnostics) {
    return parser(sources, source, diagnostics).lone_expression();
}

}  // namespace robochart::prism
