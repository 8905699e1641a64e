// SPDX-License-Identifier: Apache-2.0
// Certificates of assertions that hold (docs/certificates.md). A certificate contains the claim and the compiled
// processes of both sides, without reductions. A separate program, proved correct in Coq, finds the proof in the
// certificate or rejects the certificate (checker/certify/certifier). Its result does not depend on the correctness of
// this code.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/diagnostics/budget.hpp"
#include "checker/cspm/session.hpp"

namespace robochart::certify {

/// The files of a certificate.
struct Certificate {
    std::string claim;           ///< claim.txt
    std::string specification;   ///< specification.txt; "" for a property of one process
    std::string implementation;  ///< implementation.txt
};

/// A certificate, or the reason why there is none.
struct CertificateResult {
    std::optional<Certificate> certificate;
    std::string reason;  ///< "" if there is a certificate
};

/// Compiles the processes of an assertion again, without minimisation, and returns its certificate. It does not check
/// that the assertion holds. `source` names the claim of the assertion and its place. Passes on evaluation errors.
[[nodiscard]] CertificateResult make_certificate(cspm::Session& session, const cspm::Decl& assertion,
                                                 const std::string& source, const refine::Limits& limits);

/// Writes a certificate to a folder below `root`. The claim is written last and contains the digests of the other
/// files, so that an incomplete folder of a stopped run is not mistaken for a certificate. Returns the cause in words
/// on failure, "" on success.
[[nodiscard]] std::string write_certificate(const std::string& root, const std::string& folder,
                                            const Certificate& certificate, diagnostics::Budget* budget);

/// The name of a certificate's folder: the number and the letters and digits of the title.
[[nodiscard]] std::string folder_name(const std::string& number, const std::string& title);

}  // namespace robochart::certify
