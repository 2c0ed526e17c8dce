W336 = the same { $type } of { $id } stands here again
    .label = it moves the object a second time
    .first = the first one
    .help = remove one of the two; where both are meant, a comment between them says so
    .fix = remove the second
