// The few functions of the tree itself.
#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

std::string QualifiedName::text() const {
    std::string out;
    for (const std::string& part : parts) out += (out.empty() ? "" : "::") + part;
    return out;
}

}  // namespace robochart::frontend
