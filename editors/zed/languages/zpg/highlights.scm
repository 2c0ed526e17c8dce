(comment) @comment
(void) @punctuation.special
(record id: (id) @function)
(record type: (type) @type)
(reference) @variable.parameter
(number) @number
(colour) @constant
(angle) @number.float
(file) @string.special.path
(separator) @punctuation.delimiter
(word) @error
