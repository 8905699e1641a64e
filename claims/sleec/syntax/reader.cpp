// SPDX-License-Identifier: Apache-2.0
// See reader.hpp.
#include "claims/sleec/syntax/reader.hpp"

#include "claims/sleec/syntax/parser.hpp"

namespace robochart::sleec {

RuleFile read(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
              diagnostics::Diagnostics& diagnostics) {
    return Parser(lex(sources.source_text(source), source, diagnostics), diagnostics).parse_file();
}

}  // namespace robochart::sleec
