W333 = the union { $id } has the { $one } { $one-id } twice in one place: its copy { $two-id } is not moved
    .label = this copy stays where it was made
    .one = the { $one }
    .help = move the copy, as with `{ $two-id } -1 x y z`, or leave it out of the union
W333-same = the { $type } { $id } is of { $one-id } and { $one-id }: it is the same as { $one-id } alone
    .label = the same object again
    .help = name another object here, or use { $one-id } instead of { $id }
