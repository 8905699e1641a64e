// How tightly CSPM's operators bind, loosest first: the table of FDR's own grammar (libcspm, Parser.ppy).
// Shared by the reader and the printer.
#pragma once

namespace robochart::cspm {

enum Level : int {
    lowest_level = 0,        ///< lambda, let, if, replicated forms: they reach as far right as they can
    hiding_level = 1,        ///< \ |\ to the left
    interleave_level = 2,    ///< ||| to the left
    parallel_level = 3,      ///< [|A|] [A||B] [a<->b] [|A|> do not associate
    internal_level = 4,      ///< |~| to the left
    external_level = 5,      ///< [] [+A+] to the left
    interrupt_level = 6,     ///< /\ /+A+\ to the left
    sliding_level = 7,       ///< [> to the left
    sequential_level = 8,    ///< ; to the left
    prefix_level = 9,        ///< & -> to the right
    field_level = 11,        ///< what follows ! ? $
    dot_level_expr = 12,     ///< . to the right
    restriction_level = 14,  ///< what follows the colon of ?x:S
    or_level = 14,
    and_level = 15,
    not_level = 16,
    compare_level = 17,  ///< do not associate
    sum_level = 18,
    product_level = 19,
    length_level = 20,
    concat_level_expr = 21,
    postfix_level = 22,  ///< f(x), P[[a <- b]]
    atom_level = 23,
};

}  // namespace robochart::cspm
