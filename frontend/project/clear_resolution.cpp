// SPDX-License-Identifier: Apache-2.0
// See clear_resolution.hpp. The old pointers in the fields are not followed, because they may point into files that no
// longer exist.
#include "frontend/project/clear_resolution.hpp"

#include "frontend/syntax/file_visitor.hpp"

namespace robochart::frontend {

namespace {

struct Reset {
    void visit(Import&) {}
    void visit(Context&) {}
    void visit(Simulation& simulation) { simulation.subject_path = {}; }
    void visit(TypeDeclaration&) {}
    void visit(EnumLiteral&) {}
    void visit(OperationSignature&) {}
    void visit(Clock&) {}
    void visit(State&) {}
    void visit(CspBlock& block) { block.associated_paths.clear(); }
    void visit(Assertion& assertion) {
        assertion.subject_path = {};
        assertion.other_path = {};
        assertion.state = nullptr;
        assertion.clock = nullptr;
        assertion.missed = nullptr;
    }
    void visit(AssertionParameter& parameter) {
        parameter.context_path = {};
        parameter.target = nullptr;
    }
    void visit(Function& function) { function.result = nullptr; }
    void visit(InterfaceClause& clause) { clause.target = nullptr; }
    void visit(Variable& variable) { variable.type = nullptr; }
    void visit(Event& event) { event.type = nullptr; }
    void visit(Reference& reference) { reference.target = nullptr; }
    void visit(Connection& connection) {
        for (Connection::End* end : {&connection.from, &connection.to}) end->node_target = end->event_target = nullptr;
    }
    void visit(Transition& transition) {
        transition.source = transition.target = nullptr;
        for (Transition::Reset& reset : transition.resets) reset.clock = nullptr;
    }
    void visit(TypeExpr& type) {
        type.target = nullptr;
        type.type = nullptr;
    }
    void visit(Expr& expr) {
        expr.target = nullptr;
        expr.type = nullptr;
    }
    void visit(Communication& communication) {
        communication.event_target = communication.variable_target = communication.from_target = nullptr;
    }
    void visit(Stmt& statement) { statement.declaration = nullptr; }
};

}  // namespace

void reset(File& file) {
    Reset visitor;
    Traversal(visitor).visit_file(file);
}

void reset(Model& model) {
    for (auto& file : model.files) reset(*file);
}

}  // namespace robochart::frontend
