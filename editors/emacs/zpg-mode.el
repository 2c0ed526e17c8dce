;;; zpg-mode.el --- Scenes in the ZPG scene language -*- lexical-binding: t; -*-

;; Version: 0.1.0
;; Package-Requires: ((emacs "28.1") (eglot "1.9"))
;; Keywords: languages

;;; Commentary:

;; Colours for scenes, and `zpg lsp' by way of eglot.

;;; Code:

(defvar zpg-mode-syntax-table
  (let ((table (make-syntax-table)))
    ;; A comment begins and ends with the same sign.
    (modify-syntax-entry ?# "!" table)
    (modify-syntax-entry ?\" "\"" table)
    (modify-syntax-entry ?- "_" table)
    (modify-syntax-entry ?. "_" table)
    table)
  "Syntax of scenes.")

(defvar zpg-mode-font-lock-keywords
  '(("^[ \t]*\\([0-9]+\\)[ \t]+\\(-?[0-9]+\\)\\_>"
     (1 font-lock-function-name-face)
     (2 font-lock-type-face))
    ("\\_<[-+]?\\(?:[0-9]+\\.?[0-9]*\\|\\.[0-9]+\\)\\(?:[eE][-+]?[0-9]+\\)?\\_>"
     . font-lock-constant-face))
  "What is coloured in scenes besides comments.")

;;;###autoload
(define-derived-mode zpg-mode prog-mode "ZPG"
  "Major mode for scenes in the ZPG scene language."
  (setq-local comment-start "# ")
  (setq-local comment-end " #")
  (setq-local comment-start-skip "#[ \t]*")
  (setq-local font-lock-defaults '(zpg-mode-font-lock-keywords)))

;;;###autoload
(add-to-list 'auto-mode-alist '("\\.zpg\\'" . zpg-mode))

(defvar eglot-server-programs)
(with-eval-after-load 'eglot
  (add-to-list 'eglot-server-programs '(zpg-mode . ("zpg" "lsp"))))

(provide 'zpg-mode)
;;; zpg-mode.el ends here
