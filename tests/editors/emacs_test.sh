#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The configuration for Emacs in docs/lsp.md, in Emacs without a terminal: it opens a model with a finding, and the
# finding is displayed. Argument: the program. Exit code 77 (skipped) without Emacs with eglot.
set -euo pipefail
program="$(realpath "$1")"
cd "$(dirname "$0")/../.."
command -v emacs >/dev/null || { echo "emacs is not installed" >&2; exit 77; }
emacs --batch --eval "(progn (package-initialize) (unless (require 'eglot nil t) (kill-emacs 77)))" || exit 77
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/bin" "$folder/model"
ln -s "$program" "$folder/bin/robochart-verify"
awk '/^```elisp/ { inside = 1; next } /^```/ { inside = 0 } inside' docs/lsp.md >"$folder/init.el"
test -s "$folder/init.el"
echo 'interface I { var x : Lost }' >"$folder/model/a.rct"
cat >"$folder/try.el" <<'LISP'
(package-initialize)
(require 'eglot)
(setq eglot-sync-connect 30 eglot-connect-timeout 30)
(load (expand-file-name "init.el" (getenv "FOLDER")))
(find-file (expand-file-name "model/a.rct" (getenv "FOLDER")))
(unless (eq major-mode 'robochart-mode) (error "the mode is %s" major-mode))
;; In batch mode no idle timer runs, so what the hook would have started is started here.
(unless (eglot-current-server) (apply #'eglot (eglot--guess-contact)))
(flymake-mode 1)
(let ((end (+ (float-time) 30)))
  (while (and (< (float-time) end) (null (flymake-diagnostics)))
    (flymake-start)
    (accept-process-output nil 0.1)))
(unless (flymake-diagnostics) (error "no finding arrived"))
(princ (flymake-diagnostic-text (car (flymake-diagnostics))))
LISP
FOLDER="$folder" HOME="$folder" PATH="$folder/bin:$PATH" timeout 90 emacs --batch -l "$folder/try.el" >"$folder/out" 2>"$folder/log" ||
  { tail -20 "$folder/log" >&2; exit 1; }
grep -q "Lost" "$folder/out" || { cat "$folder/out" "$folder/log" >&2; exit 1; }
