// SPDX-License-Identifier: Apache-2.0
// Writes certificates of assertions that hold (docs/certificates.md). A certificate contains the claim, and the terms
// or the compiled processes that the claim is about, without reductions. A separate program, which was proved correct
// in Coq, finds the proof in the certificate or rejects the certificate (checker/certify/certifier). Its result does
// not depend on the correctness of this code.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/budget.hpp"
#include "checker/cspm/session.hpp"

namespace robochart::certify {

/// What a certificate is about: the terms of the script, or the processes to which they were compiled.
enum class Level { term, product };

/// Returns "term" or "product".
[[nodiscard]] const char* level_name(Level level);

/// A file of a certificate that robochart-certify does not read.
struct FurtherFile {
    std::string path;  ///< below the folder of the certificate
    std::string text;
};

/// The contents of the files of a certificate.
struct Certificate {
    Level level = Level::term;
    std::string why_product;                ///< why the terms could not be written; "" at the term level
    std::string claim;                      ///< claim.txt
    std::string specification;              ///< specification.txt; "" for most properties of one process
    std::string implementation;             ///< implementation.txt
    std::vector<FurtherFile> further = {};  ///< for conformance: the code and the states of its table
};

/// The lines of a claim that its processes do not determine.
struct ClaimLines {
    std::string assertion;      ///< as printed
    std::string source;         ///< names the claim and its place
    std::string source_digest;  ///< SHA-256 of the script
};

/// A certificate, or the reason why there is no certificate.
struct CertificateResult {
    std::optional<Certificate> certificate;
    std::string reason;  ///< "" if there is a certificate
};

/// Compiles the processes of an assertion again, without minimisation, and returns its certificate. The certificate is
/// at the term level if all terms can be written (term_text.hpp) and `highest` permits it. Does not check that the
/// assertion holds. `source` names the claim of the assertion and its place. Passes on evaluation errors.
[[nodiscard]] CertificateResult make_certificate(cspm::Session& session, const cspm::Decl& assertion,
                                                 const std::string& source, const refine::Limits& limits,
                                                 Level highest = Level::term);

/// Returns the certificate of a refinement in the failures-divergences model between two processes that are given as
/// text (process_text.hpp). Does not check that the refinement holds.
[[nodiscard]] Certificate refinement_certificate(const ClaimLines& lines, std::string specification,
                                                 std::string implementation);

/// The claim that after each trace, an event of the goal can still happen.
struct StaysPossible {
    cspm::ExprPtr process;
    cspm::ExprPtr goal;  ///< a set of events
};

/// Does the same for this claim, which no assertion states.
[[nodiscard]] CertificateResult make_certificate(cspm::Session& session, const StaysPossible& claim,
                                                 const std::string& source, const refine::Limits& limits,
                                                 Level highest = Level::term);

/// Writes a certificate to a folder below `root`. The claim is written last and contains the digests of the other
/// files. So an incomplete folder of a run that was stopped is not taken for a certificate. Returns "" on success, and
/// the cause of the failure otherwise.
[[nodiscard]] std::string write_certificate(const std::string& root, const std::string& folder,
                                            const Certificate& certificate, diagnostics::Budget* budget);

/// Returns the name of a certificate's folder. It consists of the number, and of the letters and digits of the title.
[[nodiscard]] std::string folder_name(const std::string& number, const std::string& title);

}  // namespace robochart::certify
