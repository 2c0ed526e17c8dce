(record) @fold
(comment) @fold
