;;; Runs in batch, with the scene in SCENE and zpg in the PATH; ends with 1 at the first step that fails. -*- lexical-binding: t -*-

(require 'cl-lib)
(unless (require 'eglot nil t)
  ;; Debian's packages are not on the path under -Q.
  (let ((default-directory "/usr/share/emacs/site-lisp/elpa/"))
    (normal-top-level-add-subdirs-to-load-path))
  (require 'eglot))
(require 'flymake)
(require 'zpg-mode)

(setq eglot-sync-connect 20
      eglot-confirm-server-initiated-edits nil
      eglot-send-changes-idle-time 0
      eglot-autoshutdown nil
      flymake-no-changes-timeout 0.1)

(defun test-wait (what check)
  (let ((end (+ (float-time) 20)) result)
    (while (not (setq result (funcall check)))
      (when (> (float-time) end) (error "Timed out: %s" what))
      (accept-process-output nil 0.05))
    result))

(defmacro test-step (name &rest body)
  `(condition-case e
       (progn ,@body (message "ok - %s" ,name))
     (error (message "not ok - %s: %S" ,name e) (kill-emacs 1))))

(defun test-line (n)
  (save-excursion
    (goto-char (point-min))
    (forward-line (1- n))
    (buffer-substring-no-properties (point) (line-end-position))))

(defun test-errors ()
  (flymake-start)
  (cl-remove-if-not
   (lambda (d) (eq (flymake-diagnostic-type d) 'eglot-error))
   (flymake-diagnostics)))

(find-file (getenv "SCENE"))
(test-step "mode" (cl-assert (eq major-mode 'zpg-mode)))
(test-step "connect"
           (apply #'eglot (eglot--guess-contact))
           (cl-assert (eglot-managed-p)))
(test-step "diagnostics"
           (flymake-mode 1)
           (let ((all (test-wait "diagnostics" #'test-errors)))
             (cl-assert (string-match-p "decimal comma" (flymake-diagnostic-text (car all))))))
(test-step "hover"
           (goto-char (point-min))
           (let ((hover (jsonrpc-request (eglot--current-server-or-lose) :textDocument/hover
                                         (eglot--TextDocumentPositionParams))))
             (cl-assert (string-match-p "sphere.*ball" (plist-get (plist-get hover :contents) :value)))))
(test-step "completion"
           (goto-char (point-min))
           (forward-line 4)
           (forward-char 7)
           (let ((found (eglot-completion-at-point)))
             (cl-assert (>= (length (all-completions "" (nth 2 found))) 2))))
(test-step "fix"
           (let* ((d (car (test-errors)))
                  (all (eglot-code-actions (flymake-diagnostic-beg d) (flymake-diagnostic-end d) "quickfix"))
                  (fix (seq-find (lambda (a) (eq t (plist-get a :isPreferred))) all)))
             (cl-assert fix)
             (if (fboundp 'eglot-execute)
                 (eglot-execute (eglot--current-server-or-lose) fix)
               (eglot--apply-workspace-edit (plist-get fix :edit)))
             (cl-assert (string-match-p "0\\.5" (test-line 3)))))
(test-step "rename"
           ;; Emacs says what has changed when it is idle, which it never is in batch.
           (eglot--signal-textDocument/didChange)
           (goto-char (point-min))
           (eglot-rename "77")
           (cl-assert (string-match-p "-101 77 3" (test-line 5))))
(test-step "format"
           (eglot--signal-textDocument/didChange)
           (eglot-format-buffer)
           (cl-assert (equal (test-line 1) "77 11  0 1 0  1  # ball #")))
(test-step "definition"
           (eglot--signal-textDocument/didChange)
           (goto-char (point-min))
           (forward-line 4)
           (forward-char 7)
           (xref-find-definitions (thing-at-point 'symbol))
           (cl-assert (= 1 (line-number-at-pos))))
(test-step "save and end"
           (save-buffer)
           (eglot-shutdown (eglot--current-server-or-lose)))
(kill-emacs 0)
