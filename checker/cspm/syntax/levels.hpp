// SPDX-License-Identifier: Apache-2.0
// Defines the precedence of every operator of CSPM for the reader and the printer, lowest first. It is the table of
// FDR's own grammar (libcspm, Parser.ppy).
#pragma once

namespace robochart::cspm {

enum Level : int {
    lowest_level = 0,        ///< lambda, let, if, replicated forms: they end as late as possible
    hiding_level = 1,        ///< \ |\ left-associative
    interleave_level = 2,    ///< ||| left-associative
    parallel_level = 3,      ///< [|A|] [A||B] [a<->b] [|A|> not associative
    internal_level = 4,      ///< |~| left-associative
    external_level = 5,      ///< [] [+A+] left-associative
    interrupt_level = 6,     ///< /\ /+A+\ left-associative
    sliding_level = 7,       ///< [> left-associative
    sequential_level = 8,    ///< ; left-associative
    prefix_level = 9,        ///< & -> right-associative
    field_level = 11,        ///< operand of ! ? $
    dot_level_expr = 12,     ///< . right-associative
    restriction_level = 14,  ///< operand after the colon of ?x:S
    or_level = 14,
    and_level = 15,
    not_level = 16,
    compare_level = 17,  ///< not associative
    sum_level = 18,
    product_level = 19,
    length_level = 20,
    concat_level_expr = 21,
    postfix_level = 22,  ///< f(x), P[[a <- b]]
    atom_level = 23,
};

}  // namespace robochart::cspm
