// Structure of emitted scripts.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "checker/cspm/reader.hpp"
#include "csp_emit/emit.hpp"
#include "diagnostics/render.hpp"
#include "tests/semantics/sample_systems.hpp"

namespace robochart::csp_emit {
namespace {

TEST(Script, ReadsBackEqual) {
    const ir::System system = ir::samples::aggregation();
    for (const Time time : {Time::untimed, Time::timed}) {
        diagnostics::SourceManager sources;
        diagnostics::Diagnostics diagnostics;
        const auto instantiation = ir::instantiate(system, {}, diagnostics);
        const Emission emission = emit(system, instantiation, time, {true}, sources, diagnostics);
        EXPECT_TRUE(diagnostics.empty()) << render_text(sources, diagnostics);
        const std::string text = cspm::print(emission.script);
        if (std::getenv("SHOW") != nullptr) std::cout << text;
        const auto source = sources.add("printed.csp", text);
        const cspm::Script again = cspm::read(sources, source, diagnostics);
        EXPECT_TRUE(diagnostics.empty()) << render_text(sources, diagnostics);
        EXPECT_TRUE(equal(emission.script, again));
    }
}

}  // namespace
}  // namespace robochart::csp_emit
