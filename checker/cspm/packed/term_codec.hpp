// SPDX-License-Identifier: Apache-2.0
// Encodes process terms as bytes, by content. Equal terms have equal bytes and different terms have different bytes,
// independently of the order in which terms and values were created. The encoding of a term determines where it ends,
// so zeros may follow it in a row.
//
// A call is encoded as its definition and arguments, a prefix as its place in the script and the values that it uses.
// Other operators are written before their operands. The numbers of definitions and places come from the resolver, so
// they are the same whenever the same script is loaded. Sets of events and renamings are written as numbers
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
/// compressions and their states, infinite sequences, and sets of processes, whose order depends on the order in which
/// the processes were created.
class TermCodec {
public:
    /// All expressions must be compiled before the codec is created.
    TermCodec(const Program& program, ValueStore& store, process::TermStore& terms, ProcessTerms& processes,
              PackedParts& parts);

    void write(process::TermId term, Bytes& out);
    [[nodiscard]] process::TermId read(ByteReader& in);
    /// `value` must be shared (Value in eval/value.hpp).
    void write(Value value, Bytes& out);
    [[nodiscard]] Value read_value(ByteReader& in);
    /// Skips a term.
    void skip(ByteReader& in);

    // The following functions read and write the parts of calls and prefixes without terms.
    /// The number of values that the function has already received, and the number of arguments in its last group.
    struct CallShape {
        std::size_t given;
        std::size_t arguments;
    };
    [[nodiscard]] static CallShape shape(const Function& function);
    /// Writes the beginning of a call. The caller then writes the values: first those given before, then the arguments.
    static void begin_call(const Function& function, Bytes& out);
    /// Reads the function of a call, after the operator. Null if the call has another form, which only `read` supports.
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
