W327 = this { $type } moves nothing
    .label = everything stays where it is
    .help = write the numbers that were meant, or remove the record
    .fix = remove the record
