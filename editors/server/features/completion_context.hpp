// SPDX-License-Identifier: Apache-2.0
// Determines what is allowed at a place in a text that is being written. It uses the tokens before the place instead of
// the tree, because a text that is being written usually has syntax errors.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "editors/server/protocol/positions.hpp"
#include "frontend/syntax/lexer.hpp"

namespace robochart::lsp {

/// The kind of body that contains the place.
enum class Block {
    file,
    interface,
    platform,
    controller,
    module,
    machine,
    operation,
    function,
    state,
    transition,
    type,     ///< the body of a datatype or enumeration
    bracket,  ///< a set, or a deadline
};

struct Enclosing {
    Block block = Block::file;
    Span name;              ///< the owner of the body; unknown for brackets and the file
    std::size_t begin = 0;  ///< index of the first token inside
};

/// The construct that the grammar expects at the place.
enum class Wanted {
    nothing,       ///< no construct: a new name, a comment or a string
    member,        ///< the beginning of a member of the body
    continuation,  ///< after a complete operand: an infix operator or the next member
    source,        ///< a node that a transition may leave
    target,        ///< a node that a transition may enter
    event,
    interface,
    type,
    reference,  ///< the target of `sref n =` and similar; `word` is the keyword
    clock,
    state,     ///< the state of sinceEntry
    variable,  ///< a variable that receives a value
    expression,
    statement,
    branch,  ///< after `then` or `else`: a statement or an expression
    connection_node,
    connection_event,  ///< an event of the node `path`
    import,
    component,  ///< a component that an assertion names
    property,   ///< a property, after `is` in an assertion
    rule,       ///< a rule, after `conforms to` in an assertion
};

/// The context of a completion. In `value`, a step from a value to a part of this value is a field's name, or "" for an
/// index.
struct CompletionContext {
    Wanted expected = Wanted::nothing;
    std::vector<Enclosing> enclosing;    ///< outermost first; the file is always included
    Span prefix;                         ///< the letters already written
    std::vector<std::string> qualifier;  ///< `A`, `B` of `A::B::`
    std::vector<std::string> value;      ///< `a`, "", `f` of `a[1].f.`: a field is expected
    std::vector<std::string> path;       ///< connection_event: the node's name
    std::string word;                    ///< reference: the keyword; transition members: the last clause written
    std::vector<std::string> bound;      ///< variables of binders before the place
};

/// Determines the context from the words before an offset.
[[nodiscard]] CompletionContext context_at(const SourceManager&, SourceId, bool is_assertions, std::uint32_t offset);

}  // namespace robochart::lsp
