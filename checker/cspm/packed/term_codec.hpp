// SPDX-License-Identifier: Apache-2.0
// Encodes process terms as bytes that depend only on their contents, and not on the order in which terms and values
// were created. Two terms have the same bytes only if they are equal. A reader finds the end of a term without further
// data, so zeros may follow it in a row.
//
// A call is encoded as its definition and arguments, and a prefix as its place in the script and the values that it
// uses. Other operators are written before their operands. The resolver numbers definitions and places, so loading
// the same script again gives the same numbers. Sets of events and renamings are written as numbers
// (packed_parts.hpp).
#pragma once

#include <vector>

#include "checker/cspm/eval/code.hpp"
#include "checker/cspm/eval/process_terms.hpp"
#include "checker/cspm/packed/bytes.hpp"
#include "checker/cspm/packed/packed_parts.hpp"
#include "checker/process/term.hpp"

namespace robochart::cspm {

/// Writes and reads the terms and values of one store. Throws NotPacked for terms and values without a packed form:
/// compressions and their states, infinite sequences, and sets of processes. The order of such sets depends on when the
/// processes were created.
class TermCodec {
public:
    /// Creates a codec. It knows only expressions that have been compiled before.
    TermCodec(const Program& program, ValueStore& store, process::TermStore& terms, ProcessTerms& processes,
              PackedParts& parts);

    void write(process::TermId term, Bytes& out);
    [[nodiscard]] process::TermId read(ByteReader& in);
    /// Writes a shared value (Object::shared in eval/value.hpp).
    void write(Value value, Bytes& out);
    [[nodiscard]] Value read_value(ByteReader& in);
    /// Skips a term without creating it.
    void skip(ByteReader& in);

    // The following functions read and write the parts of calls and prefixes without creating terms.
    /// The number of values that the function already has, and the number of arguments in its last group.
    struct CallShape {
        std::size_t given;
        std::size_t arguments;
    };
    [[nodiscard]] static CallShape shape(const Function& function);
    /// Writes the beginning of a call. After it, the caller must write the values that the function already has, and
    /// then the arguments.
    static void begin_call(const Function& function, Bytes& out);
    /// Reads the function of a call whose operator byte has been read. Returns null for calls of any other form; only
    /// `read` supports them.
    [[nodiscard]] const Function* call_head(ByteReader& in) const;
    static void begin_operator(process::Op op, Bytes& out) { out.push_back(static_cast<std::uint8_t>(op)); }

private:
    void write_call(const process::Term& term, Bytes& out);
    void write_prefix(const process::Term& term, Bytes& out);
    void write_children(const process::Term& term, Bytes& out);
    void write_values(const Values& values, std::size_t from, Bytes& out);
    [[nodiscard]] process::TermId read_call(ByteReader& in);
    [[nodiscard]] process::TermId read_prefix(ByteReader& in);
    [[nodiscard]] process::TermId read_operator(process::Op op, ByteReader& in);
    [[nodiscard]] std::uint32_t read_part(process::Op op, ByteReader& in);
    [[nodiscard]] Values read_values(std::size_t count, ByteReader& in);
    void skip_value(ByteReader& in);
    void skip_values(std::size_t count, ByteReader& in);
    void skip_prefix(ByteReader& in);
    [[nodiscard]] std::size_t values_of_prefix(PrefixKind kind, std::uint64_t place) const;

    const Program& program_;
    ValueStore& store_;
    process::TermStore& terms_;
    ProcessTerms& processes_;
    PackedParts& parts_;
    std::vector<const Function*> functions_;  // by number
    std::vector<const Group*> groups_;        // by number
    unsigned depth_ = 0;
    unsigned inside_sets_ = 0;
};

}  // namespace robochart::cspm
