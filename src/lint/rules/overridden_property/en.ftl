W334 = this { $change } of { $id } has no effect: another one follows before { $id } is used
    .label = this is overridden
    .second = by this
    .help = remove one of the two, or give the second to the object that it is meant for
    .fix = write { $number } in the second
