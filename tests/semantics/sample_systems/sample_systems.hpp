// SPDX-License-Identifier: Apache-2.0
// Provides hand-written IR of the corpus models, for tests of components that read the IR, without the parser. The IR
// equals the result of lowering the corpus (tests/semantics/lower/lower_corpus_test.cpp compares the dumps).
#pragma once

#include "semantics/ir/ir.hpp"

namespace robochart::ir::samples {

/// Returns corpus/aggregation/aggregation.rct: operations MoveClockwise and RotateClockwise, machine AggregationFSM,
/// controller AggregationController, module Aggregation, no properties. Spans are unknown.
[[nodiscard]] System aggregation();

/// The ids that lowering gives to the built-in types, in this order in every System.
struct CoreTypes {
    TypeId boolean{0};
    TypeId nat{1};
    TypeId integer{2};
    TypeId real{3};
    TypeId string{4};
};

}  // namespace robochart::ir::samples
