;;; zpg-mode.el --- Scenes in the ZPG scene language -*- lexical-binding: t; -*-

;; Version: 0.1.0
;; Package-Requires: ((emacs "28.1") (eglot "1.9"))
;; Keywords: languages

;;; Commentary:

;; Colours for scenes, and `zpg lsp' by way of eglot.

;;; Code:

(declare-function eglot-current-server "eglot")
(declare-function eglot--signal-textDocument/didChange "eglot")
(declare-function eglot--TextDocumentIdentifier "eglot")
(declare-function eglot--pos-to-lsp-position "eglot")
(declare-function eglot--apply-text-edits "eglot")
(declare-function jsonrpc-request "jsonrpc")

(defvar zpg-mode-syntax-table
  (let ((table (make-syntax-table)))
    ;; A comment begins and ends with the same sign.
    (modify-syntax-entry ?# "!" table)
    (modify-syntax-entry ?\" "\"" table)
    (modify-syntax-entry ?- "_" table)
    (modify-syntax-entry ?. "_" table)
    table)
  "Syntax of scenes.")

(defun zpg--unclosed ()
  "Return where the comment begins that nobody closes, if there is one."
  (save-excursion
    (save-restriction
      (widen)
      (goto-char (point-min))
      (let (found)
        (while (and (not found) (re-search-forward "[#\"]" nil t))
          (let ((at (1- (point))))
            (cond
             ((eq (char-after at) ?\") (re-search-forward "\"" (line-end-position) t))
             ((not (search-forward "#" nil t)) (setq found at)))))
        found))))

(defvar-local zpg--unclosed-at (make-marker)
  "Where the comment begins that nobody closed after the last change.")

(defun zpg-syntax-propertize (start end)
  "Have an unclosed comment between START and END end with its line."
  (let ((at (zpg--unclosed)))
    (when (and at (<= start at) (< at end))
      (save-excursion
        (goto-char at)
        (let ((eol (line-end-position)))
          (when (< eol (point-max))
            (put-text-property eol (1+ eol) 'syntax-table (string-to-syntax "!"))))))))

(defun zpg--after-change (&rest _)
  "Forget what was known of comments from where one has been closed or opened."
  (let ((old (marker-position zpg--unclosed-at))
        (new (save-match-data (zpg--unclosed))))
    (unless (eq old new)
      (set-marker zpg--unclosed-at new)
      (let ((from (min (or old new) (or new old))))
        (syntax-ppss-flush-cache from)
        (font-lock-flush from)))))

(defvar zpg-mode-font-lock-keywords
  '(("^[ \t]*\\([0-9]+\\)[ \t]+\\(-?[0-9]+\\)\\_>"
     (1 font-lock-function-name-face)
     (2 font-lock-type-face))
    ("\\_<[-+]?\\(?:[0-9]+\\.?[0-9]*\\|\\.[0-9]+\\)\\(?:[eE][-+]?[0-9]+\\)?\\_>"
     . font-lock-constant-face))
  "What is coloured in scenes besides comments.")

(defun zpg--comment (mode beg end)
  "Have the server comment the lines from BEG to END.
MODE is \"out\", \"in\" or \"toggle\"."
  (let ((server (and (fboundp 'eglot-current-server) (eglot-current-server))))
    (unless server
      (user-error "The server of zpg comments out: M-x eglot starts it"))
    (eglot--signal-textDocument/didChange)
    (eglot--apply-text-edits
     (jsonrpc-request
      server :zpg/comment
      (list :textDocument (eglot--TextDocumentIdentifier)
            :ranges (vector (list :start (eglot--pos-to-lsp-position beg)
                                  :end (eglot--pos-to-lsp-position end)))
            :mode mode)))))

(defun zpg-comment-region (beg end &optional arg)
  "Comment out the lines from BEG to END, or in where all are commented out.
Comments do not nest, so those within are kept in another form.
With a list as ARG, as \\[universal-argument] makes it, comment in."
  (zpg--comment (if (consp arg) "in" "toggle") beg end))

(defun zpg-uncomment-region (beg end &optional _arg)
  "Comment in the lines from BEG to END."
  (zpg--comment "in" beg end))

;;;###autoload
(define-derived-mode zpg-mode prog-mode "ZPG"
  "Major mode for scenes in the ZPG scene language."
  (setq-local comment-start "# ")
  (setq-local comment-end " #")
  (setq-local comment-start-skip "#[ \t]*")
  ;; `comment-dwim', `comment-line' and others call these.
  (setq-local comment-region-function #'zpg-comment-region)
  (setq-local uncomment-region-function #'zpg-uncomment-region)
  (setq-local syntax-propertize-function #'zpg-syntax-propertize)
  (setq zpg--unclosed-at (copy-marker (zpg--unclosed)))
  (add-hook 'after-change-functions #'zpg--after-change nil t)
  (setq-local font-lock-defaults '(zpg-mode-font-lock-keywords)))

;;;###autoload
(add-to-list 'auto-mode-alist '("\\.zpg\\'" . zpg-mode))

(defvar eglot-server-programs)
(with-eval-after-load 'eglot
  (add-to-list 'eglot-server-programs '(zpg-mode . ("zpg" "lsp"))))

(provide 'zpg-mode)
;;; zpg-mode.el ends here
